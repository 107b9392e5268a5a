/* Messages on stderr, the same from every verb. Used by main.c, arguments.c and the verbs. */
#ifndef LAM_CLI_COMPLAIN_H
#define LAM_CLI_COMPLAIN_H

#include <lamella/session.h>

/* Prints the messages of the session's last call, one per line: "file:line:col: key: text". Returns
 * the exit status 2. */
int lam_complain(const lam_session *session);
/* Prints "lamella: text", formatted as by printf. Returns status, to be used as `return
 * lam_complain_plain(1, ...)`. */
int lam_complain_plain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Prints the messages of the session's last call for a verb, one per line: "lamella: verb: text",
 * then after on a line of its own (NULL: nothing). Returns status. */
int lam_complain_verb(int status, const char *verb, const lam_session *session, const char *after);

#endif
