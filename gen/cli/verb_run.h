/* What every verb needs around itself. */
#ifndef LAM_CLI_VERB_RUN_H
#define LAM_CLI_VERB_RUN_H

#include "core/arena.h"

/* Runs a verb with an arena of its own and returns its exit status; 1, with a message, when memory
 * runs out. */
int lam_verb_run(int (*verb)(lam_arena *arena, int argc, char **argv), int argc, char **argv);

#endif
