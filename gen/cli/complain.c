#include "cli/complain.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* True when a place such as "--set net.grid" says the key already. */
static bool names_key(const char *file, const char *key) {
  size_t length = strlen(file), ending = strlen(key);
  return length > ending && file[length - ending - 1] == ' ' &&
         strcmp(file + length - ending, key) == 0;
}

int lam_complain(const lam_errors *errors) {
  for (const lam_error *error = errors->first; error; error = error->next) {
    const char *file = error->location.file;
    if (file) fprintf(stderr, "%s:", file);
    if (error->location.line > 0) fprintf(stderr, "%d:", error->location.line);
    if (error->location.line > 0 && error->location.column > 0)
      fprintf(stderr, "%d:", error->location.column);
    if (file || error->location.line > 0) fputc(' ', stderr);
    if (error->key && !(file && names_key(file, error->key))) fprintf(stderr, "%s: ", error->key);
    fprintf(stderr, "%s\n", error->text);
  }
  return 2;
}

int lam_complain_plain(int status, const char *format, ...) {
  va_list arguments;
  fputs("lamella: ", stderr);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  return status;
}
