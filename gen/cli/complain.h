/* Messages on stderr, the same from every verb. */
#ifndef LAM_CLI_COMPLAIN_H
#define LAM_CLI_COMPLAIN_H

#include <lamella/session.h>

/* Prints the messages of the session's last call, one per line: "file:line:col: key: text". Returns
 * the exit status 2. */
int lam_complain(const lam_session *session);
/* Prints "lamella: text". Returns status, to be used as `return lam_complain_plain(1, ...)`. */
int lam_complain_plain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* The same for a verb, from the messages of the session: "lamella: verb: text", then after (NULL:
 * nothing). */
int lam_complain_verb(int status, const char *verb, const lam_session *session, const char *after);

#endif
