/* Messages for the person who wrote the input. Collected, so that all of them can be shown at once;
 * kept in the order in which they were added. A message is one line. */
#ifndef LAM_CORE_ERROR_H
#define LAM_CORE_ERROR_H

#include "core/arena.h"
#include <lamella/error.h>

typedef struct lam_errors {
  lam_arena *arena; /* owns the messages */
  int count;
  lam_error *first, *last;
  lam_status status; /* of a failure that is not the input's fault (LAM_IO, ...); LAM_OK: none */
} lam_errors;

/* What the messages amount to: LAM_OK without any, the status when one is set, else LAM_BAD_INPUT. */
lam_status lam_errors_status(const lam_errors *errors);

/* Adds a message. key may be NULL. The texts are copied into the arena. */
void lam_error_add(lam_errors *errors, lam_location location, const char *key, const char *format,
                   ...) __attribute__((format(printf, 4, 5)));

/* The entry of names (NULL-terminated list) nearest to given, or NULL when none is close enough to
 * suggest. */
const char *lam_did_you_mean(const char *given, const char *const *names);

#endif
