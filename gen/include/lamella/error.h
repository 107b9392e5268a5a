/* Statuses and messages. Every function that can fail returns a status; what a person should read
 * about it stands in the session's messages (lam_session_messages). */
#ifndef LAMELLA_ERROR_H
#define LAMELLA_ERROR_H

#include <lamella/api.h>

LAM_BEGIN_DECLS

typedef enum lam_status {
  LAM_OK = 0,
  LAM_BAD_INPUT,       /* the input is wrong: see the messages */
  LAM_IO,              /* a file could not be read or written */
  LAM_NO_MEMORY,       /* memory ran out; the session stays usable */
  LAM_MISSING_PROGRAM, /* an outside program is not installed */
  LAM_FAILED           /* an outside library or program failed */
} lam_status;

/* Where something stands in an input file. Line and column count from 1; 0 means unknown. file may
 * be NULL. */
typedef struct lam_location {
  const char *file;
  int line, column;
} lam_location;

/* One message: a line for a person, without a newline. Owned by the session. */
typedef struct lam_error {
  lam_location location;
  const char *key;  /* dotted path in a design, such as parts[0].height; NULL when none applies */
  const char *text; /* what was given, what is expected; never NULL */
  struct lam_error *next; /* the next message, or NULL */
} lam_error;

/* A few words for a status, such as "bad input"; "unknown status" for other numbers. A static text.
 * Any thread. */
LAM_API const char *lam_status_text(lam_status status);

/* The entry of names that is nearest to given (few letters differ, case ignored, or given is its
 * beginning), for a suggestion; NULL when none is near. names: NULL-terminated. Any thread. */
LAM_API const char *lam_did_you_mean(const char *given, const char *const *names);

LAM_END_DECLS

#endif
