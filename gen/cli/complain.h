/* Messages on stderr, the same from every verb. */
#ifndef LAM_CLI_COMPLAIN_H
#define LAM_CLI_COMPLAIN_H

#include "core/error.h"

/* Prints all messages, one per line: "file:line:col: key: text". Returns the exit status 2. */
int lam_complain(const lam_errors *errors);
/* Prints "lamella: text". Returns status, to be used as `return lam_complain_plain(1, ...)`. */
int lam_complain_plain(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
