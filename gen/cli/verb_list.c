/* lamella list [SECTION]: what there is, by name and title. Called by main.c. */
#include "cli/arguments.h"
#include "cli/complain.h"
#include "cli/verb_run.h"
#include "cli/verbs.h"
#include <lamella/reference.h>

#include <stdio.h>

static const char usage[] =
    "usage: lamella list [surfaces|nets|constraints|measures|parts|materials|formats|designs]";

/* Without a section: all of them. */
static int list(lam_session *session, int argc, char **argv) {
  const char *section = NULL, *text;
  lam_arguments arguments = {usage, NULL, 0, 1, "a section"};
  int count, status = lam_arguments_read(&arguments, argc, argv, &section, &count);
  if (status >= 0) return status;

  lam_status listed = lam_reference_list(session, section, &text);
  if (listed == LAM_BAD_INPUT) return lam_complain_verb(2, "list", session, usage);
  if (listed == LAM_OK) fputs(text, stdout);
  return lam_verb_status(session, listed);
}

int lam_verb_list(int argc, char **argv) { return lam_verb_run(list, argc, argv); }
