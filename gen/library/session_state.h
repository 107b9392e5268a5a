/* What a session holds, and how every public function begins and ends. For library/ and
 * bench/bench.c only. */
#ifndef LAM_LIBRARY_SESSION_STATE_H
#define LAM_LIBRARY_SESSION_STATE_H

#include "core/error.h"
#include "core/key.h"
#include "core/progress.h"
#include <lamella/session.h>

#include <setjmp.h>

/* What a model was built from, for make rules (write/make_rule.c). A list, the last model first. */
typedef struct lam_origin {
  const struct lam_model *model;
  const char *path; /* of the design; NULL: none */
  int file_count, file_capacity;
  const char **files; /* that it named, directly or through other designs: each once */
  struct lam_origin *next;
} lam_origin;

/* The session of lamella/session.h. */
struct lam_session {
  lam_arena *arena;         /* what the session gave */
  lam_arena *lasting;       /* what lam_session_clear leaves: settings, surfaces that were added */
  lam_errors errors, notes; /* of the last call, in arena */
  lam_progress progress;
  const char *templates; /* NULL: looked for */
  int surface_count, surface_capacity;
  const lam_row_head **surfaces; /* that were added, in lasting */
  lam_origin *origins;           /* of the models that were built */

  /* While a call runs. */
  bool busy;
  lam_arena_mark start; /* where the session's memory stood when it began */
};

/* ---- the frame of a call (session.c) ----
 *
 * A public function is one line of entry, then its work, which a jump may leave:
 *
 *   lam_status lam_something(lam_session *session, ...) {
 *     LAM_ENTER(session);
 *     return lam_session_leave(session, do_something(session, ...));
 *   }
 *
 * do_something is a function of its own, so that no variable of this frame lives across the jump.
 * Memory that ran out releases what the call allocated and returns LAM_NO_MEMORY. */
#define LAM_ENTER(session)                                                                         \
  jmp_buf entry_;                                                                                  \
  lam_session_enter((session), &entry_);                                                           \
  if (setjmp(entry_) != 0) return lam_session_exhausted(session)

/* Begins a call, for LAM_ENTER alone: no messages, and point as the place to jump to when memory
 * runs out; it must live until the call ends. */
void lam_session_enter(lam_session *session, jmp_buf *point);
/* Ends a call. Returns its status when that is not LAM_OK, otherwise that of the messages
 * (lam_errors_status). */
lam_status lam_session_leave(lam_session *session, lam_status status);
/* Ends a call that ran out of memory, for LAM_ENTER alone: frees what it allocated, leaves one
 * static message, and returns LAM_NO_MEMORY. */
lam_status lam_session_exhausted(lam_session *session);

/* ---- what a call may ask ---- */

/* The folder of templates: the one that was set, or the one that is found (templates.h), in the
 * session's memory. NULL: there is none. */
const char *lam_session_templates(lam_session *session);
/* The same for a call that cannot do without: NULL with a message and the status LAM_IO. */
const char *lam_session_needs_templates(lam_session *session);
/* The rows that a parser looks in beside the registries; pointers into the session. */
lam_added_rows lam_session_rows(const lam_session *session);

#endif
