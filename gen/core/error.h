/* Messages for the person who wrote the input. Collected, so that all of them can be shown at once;
 * kept in the order in which they were added. A message is one line. Added to in every folder that
 * reads input; shown by library and cli. */
#ifndef LAM_CORE_ERROR_H
#define LAM_CORE_ERROR_H

#include "core/arena.h"
#include <lamella/error.h>

/* So many messages are kept: nobody reads more, and an input could make millions. */
enum { LAM_MOST_MESSAGES = 20 };

/* Begins zeroed but for arena. */
typedef struct lam_errors {
  lam_arena *arena; /* owns the messages */
  int count;        /* of all that were added; LAM_MOST_MESSAGES are kept, and one that says so */
  lam_error *first, *last; /* NULL while there are none */
  lam_status status; /* of a failure that is not the input's fault (LAM_IO, ...); LAM_OK: none */
} lam_errors;

/* What the messages amount to: LAM_OK without any, the status when one is set, else
 * LAM_BAD_INPUT. */
lam_status lam_errors_status(const lam_errors *errors);

/* Puts the path of what was being made before the keys of all messages after `last` (NULL: all):
 * "height" becomes "parts[0].height", no key "parts[0]"; a key that begins with the path stays. */
void lam_errors_prefix(lam_errors *errors, const lam_error *last, const char *path);
/* Takes all messages after `last` (NULL: all) out of the list; returns the first, or NULL. */
lam_error *lam_errors_take(lam_errors *errors, lam_error *last);

/* Adds a message, formatted as by printf.
 *
 *   location  where in the input; location.file may be NULL, line and column 0
 *   key       dotted path in a design, such as parts[0].height; may be NULL
 *
 * All texts are copied into errors->arena. Control characters become spaces, so that the message
 * stays one line. */
void lam_error_add(lam_errors *errors, lam_location location, const char *key, const char *format,
                   ...) __attribute__((format(printf, 4, 5)));

#endif
