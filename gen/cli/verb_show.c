/* lamella show NAME: the reference page of anything that is listed. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/reference.h>

#include <stdio.h>

static const char usage[] = "usage: lamella show NAME   (a name from lamella list, or design for "
                            "the keys of a design file)";

/* An unknown name is a wrong use, told like one. */
static int show(lam_session *session, int argc, char **argv) {
  const char *name, *text;
  lam_arguments arguments = {usage, NULL, 1, 1, "one name"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &name, &count);
  if (status >= 0) return status;

  lam_status shown = lam_reference_page(session, name, &text);
  if (shown == LAM_BAD_INPUT) return lam_complain_verb(2, "show", session, NULL);
  if (shown == LAM_OK) fputs(text, stdout);
  return lam_verb_status(session, shown);
}

int lam_verb_show(int argc, char **argv) { return lam_verb_run(show, argc, argv); }
