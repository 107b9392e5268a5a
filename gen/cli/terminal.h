/* Progress for a person at a terminal: one line on stderr that is written over. Silent otherwise.
 */
#ifndef LAM_CLI_TERMINAL_H
#define LAM_CLI_TERMINAL_H

#include "core/arena.h"
#include "core/progress.h"
#include <stdbool.h>

/* Telling the stage NULL clears the line. */
lam_progress lam_terminal_progress(lam_arena *arena, bool quiet);

#endif
