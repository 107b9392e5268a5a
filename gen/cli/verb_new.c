/* lamella new DESIGN [-o FILE]: copies a shipped design to start from, with the files that it
 * names. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/design.h>

#include <stdio.h>

static const char usage[] =
    "usage: lamella new DESIGN [-o FILE]   (lamella list designs shows the names)";

/* The paths that were written go to stdout. */
static int new_design(lam_session *session, int argc, char **argv) {
  const char *name, *target = NULL;
  const lam_option table[] = {{"-o", .value = &target}, {.name = NULL}};
  lam_arguments arguments = {usage, table, 1, 1, "a design"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &name, &count);
  if (status >= 0) return status;

  const char *const *files;
  lam_status copied = lam_design_copy(session, name, target, &files);
  if (copied == LAM_BAD_INPUT) return lam_complain_verb(2, "new", session, NULL);
  if (copied == LAM_IO) return lam_complain_verb(1, "new", session, NULL);
  if (copied != LAM_OK) return lam_verb_status(session, copied);

  for (int i = 0; files[i]; i++) puts(files[i]);
  return 0;
}

int lam_verb_new(int argc, char **argv) { return lam_verb_run(new_design, argc, argv); }
