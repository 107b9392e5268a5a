/* Progress for a person at a terminal: one line on stderr that is written over. Called by
 * verb_build.c. */
#ifndef LAM_CLI_TERMINAL_H
#define LAM_CLI_TERMINAL_H

#include <lamella/types.h>

/* What was told last. */
typedef struct lam_terminal {
  char stage[64]; /* cut when it is longer */
  double began;   /* seconds: when its first fraction was told */
  double told;    /* seconds: when it was told last */
} lam_terminal;

/* A progress for lam_session_set_progress. It keeps its state in terminal, which has to live as
 * long as the session uses it; nobody is told when quiet, or when stderr is no terminal. */
lam_progress lam_terminal_progress(lam_terminal *terminal, bool quiet);
/* Clears the line, before other messages are printed. */
void lam_terminal_clear(const lam_progress *progress);

#endif
