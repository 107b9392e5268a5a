/* Messages for the person who wrote the input. Collected, so that all of them can be shown at once;
 * kept in the order in which they were added. A message is one line. */
#ifndef LAM_CORE_ERROR_H
#define LAM_CORE_ERROR_H

#include "core/arena.h"

typedef enum lam_status {
  LAM_OK = 0,
  LAM_BAD_INPUT,       /* the input is wrong: see the messages */
  LAM_IO,              /* a file could not be read or written */
  LAM_NO_MEMORY,       /* memory ran out */
  LAM_MISSING_PROGRAM, /* an outside program is not installed */
  LAM_FAILED           /* an outside library or program failed */
} lam_status;

/* Where something stands in an input file. Line and column count from 1; 0 means unknown. file may
 * be NULL. */
typedef struct lam_location {
  const char *file;
  int line, column;
} lam_location;

typedef struct lam_error {
  lam_location location;
  const char *key;  /* dotted path, such as parts[0].height; NULL when none applies */
  const char *text; /* what was given, what is expected */
  struct lam_error *next;
} lam_error;

typedef struct lam_errors {
  lam_arena *arena; /* owns the messages */
  int count;
  lam_error *first, *last;
} lam_errors;

/* Adds a message. key may be NULL. The texts are copied into the arena. */
void lam_error_add(lam_errors *errors, lam_location location, const char *key, const char *format,
                   ...) __attribute__((format(printf, 4, 5)));

/* The entry of names (NULL-terminated list) nearest to given, or NULL when none is close enough to
 * suggest. */
const char *lam_did_you_mean(const char *given, const char *const *names);

#endif
