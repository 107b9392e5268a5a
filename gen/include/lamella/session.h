/* A session: what one thread does with the library, its memory and its messages.
 *
 * Memory: everything that a session gives (designs, models, texts, meshes) belongs to it and lives
 * until lam_session_clear or lam_session_free. Memory that runs out ends a call with LAM_NO_MEMORY;
 * what earlier calls gave stays good, and the session can go on.
 *
 * Threads: a session belongs to one thread at a time; different sessions run in different threads.
 * What a session gave may be read by any thread while it lives. Nothing of the host is left changed
 * by a call: no thread counts, locale, signal handlers or floating-point modes. A call that starts
 * from a callback of the same session is a mistake. */
#ifndef LAMELLA_SESSION_H
#define LAMELLA_SESSION_H

#include <lamella/error.h>
#include <lamella/types.h>

LAM_BEGIN_DECLS

typedef struct lam_session lam_session;

/* ---- life ---- */

/* A new session in *session, to be freed with lam_session_free; NULL with LAM_NO_MEMORY, the only
 * failure. */
LAM_API lam_status lam_session_new(lam_session **session);
/* Frees the session and all that it gave. NULL is allowed. */
LAM_API void lam_session_free(lam_session *session);
/* Frees all that the session gave, and its messages and notes; surfaces that were added and
 * settings stay. For programs that build one design after the other. */
LAM_API void lam_session_clear(lam_session *session);

/* ---- messages ---- */

/* The messages of the last call that took the session and returned a status, in the order in which
 * they arose: the first one, or NULL when there is none. They live as long as what the session
 * gives. */
LAM_API const lam_error *lam_session_messages(const lam_session *session);
/* What the last call left out and why, such as a picture because POV-Ray is missing: notes are no
 * errors. The first one, or NULL. They live as long. */
LAM_API const lam_error *lam_session_notes(const lam_session *session);

/* ---- settings ---- */

/* Whom long calls tell what they are doing; the struct is copied, its context is kept by pointer.
 * progress may be NULL: nobody. */
LAM_API void lam_session_set_progress(lam_session *session, const lam_progress *progress);

/* The folder of templates: designs to start from, OpenSCAD modules, POV-Ray scenes. By default
 * $LAMELLA_TEMPLATES, or templates/ beside the build folder or share/lamella/templates beside the
 * lib folder that the library lies in. folder is copied, and not looked at until it is needed;
 * NULL: the default again. LAM_NO_MEMORY is the only failure. */
LAM_API lam_status lam_session_set_templates(lam_session *session, const char *folder);

/* ---- the end of the process ---- */

/* For a handler of signals that end the program (SIGINT, SIGTERM, ...): kills the outside programs
 * that calls have started, and removes their temporary files. Async-signal-safe; nothing of the
 * library may be called afterwards. The library sets no handlers itself. Without this, programs end
 * with the thread that called, and the next build removes what is left in its folder. */
LAM_API void lam_abandon(void);

/* ---- linear algebra ---- */

/* The instruction set that factorizations use on this processor ("avx512", "avx2", "neon",
 * "plain"). All give the same bits. A static text. Any thread. */
LAM_API const char *lam_kernels(void);

LAM_END_DECLS

#endif
