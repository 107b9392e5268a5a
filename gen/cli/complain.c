/* Printing messages. Called by main.c, arguments.c and the verbs. */
#include "cli/complain.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Whether a file such as "--set net.grid", which stands for an override, says the key already. */
static bool names_key(const char *file, const char *key) {
  size_t length = strlen(file), ending = strlen(key);
  return length > ending && file[length - ending - 1] == ' ' &&
         strcmp(file + length - ending, key) == 0;
}

/* Parts that a message does not have are left out. */
int lam_complain(const lam_session *session) {
  for (const lam_error *error = lam_session_messages(session); error; error = error->next) {
    const lam_location *at = &error->location;
    if (at->file) fprintf(stderr, "%s:", at->file);
    if (at->line > 0) fprintf(stderr, "%d:", at->line);
    if (at->line > 0 && at->column > 0) fprintf(stderr, "%d:", at->column);
    if (at->file || at->line > 0) fputc(' ', stderr);

    bool known = at->file && error->key && names_key(at->file, error->key);
    if (error->key && !known) fprintf(stderr, "%s: ", error->key);
    fprintf(stderr, "%s\n", error->text);
  }
  return 2;
}

/* Printed as it comes: the text may be longer than any buffer. */
int lam_complain_plain(int status, const char *format, ...) {
  va_list arguments;
  fputs("lamella: ", stderr);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  return status;
}

/* Without files and lines: these messages are about what was typed. */
int lam_complain_verb(int status, const char *verb, const lam_session *session, const char *after) {
  for (const lam_error *error = lam_session_messages(session); error; error = error->next)
    fprintf(stderr, "lamella: %s: %s\n", verb, error->text);
  if (after) fprintf(stderr, "%s\n", after);
  return status;
}
