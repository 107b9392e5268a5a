/* What every verb needs around itself: a session, and the exit status of its calls. Used by all
 * verb_*.c, diff_meshes.c and diff_pictures.c. */
#ifndef LAM_CLI_VERB_RUN_H
#define LAM_CLI_VERB_RUN_H

#include <lamella/session.h>

/* Runs a verb with a session of its own, which is freed afterwards, and returns its exit status; 1,
 * with a message, when there is no memory for the session. argv[0] is the verb. */
int lam_verb_run(int (*verb)(lam_session *session, int argc, char **argv), int argc, char **argv);
/* The exit status for the status of a call that read input, with the messages of the session's last
 * call printed: 0 for LAM_OK, 2 for LAM_BAD_INPUT and LAM_IO, otherwise 1. */
int lam_verb_status(const lam_session *session, lam_status status);

#endif
