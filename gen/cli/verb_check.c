/* lamella check DESIGN [--set KEY=VALUE]...: reads a design, finds everything wrong with it, and
 * says what would be built. Called by main.c. */
#include "cli/arguments.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/design.h>

#include <stdio.h>

static const char usage[] = "usage: lamella check DESIGN.yaml [--set KEY=VALUE]...";

/* Mistakes go to stderr, the description of a design without any to stdout. */
static int check(lam_session *session, int argc, char **argv) {
  const char *overrides[argc], *path; /* no more overrides than arguments */
  lam_design_source source = {.overrides = overrides};
  const lam_option table[] = {{"--set", .values = overrides, .count = &source.override_count},
                              {.name = NULL}};
  lam_arguments arguments = {usage, table, 1, 1, "a design file"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &path, &count);
  if (status >= 0) return status;

  const lam_design *design;
  const char *text;
  source.path = path;
  lam_status checked = lam_design_check(session, &source, &design);
  if (checked == LAM_OK) checked = lam_design_describe(session, design, &text);
  if (checked == LAM_OK) fputs(text, stdout);
  return lam_verb_status(session, checked);
}

int lam_verb_check(int argc, char **argv) { return lam_verb_run(check, argc, argv); }
