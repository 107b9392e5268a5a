/* Progress for a person at a terminal: one line on stderr that is written over. Silent otherwise.
 */
#ifndef LAM_CLI_TERMINAL_H
#define LAM_CLI_TERMINAL_H

#include <lamella/types.h>

/* What was told last. */
typedef struct lam_terminal {
  const char *stage;
  double told; /* seconds */
} lam_terminal;

/* A progress that writes into terminal, which outlives it; nobody is told when quiet, or when stderr
 * is no terminal. */
lam_progress lam_terminal_progress(lam_terminal *terminal, bool quiet);
/* Clears the line. */
void lam_terminal_clear(const lam_progress *progress);

#endif
