/* What every verb needs around itself: a session. */
#ifndef LAM_CLI_VERB_RUN_H
#define LAM_CLI_VERB_RUN_H

#include <lamella/session.h>

/* Runs a verb with a session of its own and returns its exit status; 1, with a message, when there
 * is no memory for the session. */
int lam_verb_run(int (*verb)(lam_session *session, int argc, char **argv), int argc, char **argv);
/* The exit status of a call that read input: 0, 1 when memory ran out or a program failed, otherwise
 * 2; with the messages printed. */
int lam_verb_status(const lam_session *session, lam_status status);

#endif
