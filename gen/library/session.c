/* Sessions: their memory, their messages, and the beginning and end of every call. Called through
 * lamella/session.h, and by every function of the face (LAM_ENTER). */
#include "core/leftover.h"
#include "library/session_state.h"
#include "library/templates.h"
#include "surf/surface.h"
#include <lamella/lamella.h>

#include <assert.h>
#include <stdlib.h>

/* The message that memory ran out: there is no memory to make one then. Never changed. */
static lam_error out_of_memory = {.text = "out of memory"};

const char *lam_version(void) { return LAM_VERSION; }

/* ---- life ---- */

/* Declared, as all functions of the face here, in include/lamella/session.h. */
lam_status lam_session_new(lam_session **session) {
  *session = NULL;
  lam_session *made = calloc(1, sizeof *made);
  if (!made) return LAM_NO_MEMORY;

  made->arena = lam_arena_new();
  made->lasting = lam_arena_new();
  if (!made->arena || !made->lasting) {
    lam_session_free(made);
    return LAM_NO_MEMORY;
  }
  made->errors.arena = made->notes.arena = made->arena;
  *session = made;
  return LAM_OK;
}

/* A session may be half made (lam_session_new). */
void lam_session_free(lam_session *session) {
  if (!session) return;
  lam_arena_free(session->arena);
  lam_arena_free(session->lasting);
  free(session);
}

/* Whatever points into the memory is forgotten with it. */
void lam_session_clear(lam_session *session) {
  assert(!session->busy);
  lam_arena_release(session->arena, (lam_arena_mark){0});
  session->errors = session->notes = (lam_errors){.arena = session->arena};
  session->origins = NULL;
}

/* ---- the frame of a call ---- */

/* Both arenas jump to the same point; only the memory of the call is given back there. */
void lam_session_enter(lam_session *session, jmp_buf *point) {
  assert(!session->busy && "a call from a callback of the same session");
  session->busy = true;
  session->start = lam_arena_mark_get(session->arena);

  session->errors = session->notes = (lam_errors){.arena = session->arena};
  lam_arena_recover(session->arena, point);
  lam_arena_recover(session->lasting, point);
}

/* The recovery point goes with the frame that it lies in. */
static void end_call(lam_session *session) {
  lam_arena_recover(session->arena, NULL);
  lam_arena_recover(session->lasting, NULL);
  session->busy = false;
}

/* Work that only adds messages returns LAM_OK: the messages decide. */
lam_status lam_session_leave(lam_session *session, lam_status status) {
  end_call(session);
  return status != LAM_OK ? status : lam_errors_status(&session->errors);
}

/* Messages and notes of the call go with its memory; the static message takes their place. */
lam_status lam_session_exhausted(lam_session *session) {
  end_call(session);
  lam_arena_release(session->arena, session->start);

  session->notes = (lam_errors){.arena = session->arena};
  session->errors = session->notes;
  session->errors.first = session->errors.last = &out_of_memory;
  session->errors.count = 1;
  return LAM_NO_MEMORY;
}

/* ---- what a caller sees and sets ---- */

void lam_abandon(void) { lam_leftovers_end(); }

const lam_error *lam_session_messages(const lam_session *session) { return session->errors.first; }
const lam_error *lam_session_notes(const lam_session *session) { return session->notes.first; }

void lam_session_set_progress(lam_session *session, const lam_progress *progress) {
  session->progress = progress ? *progress : (lam_progress){0};
}

/* NULL is copied as NULL. The folder before it stays in the lasting memory. */
static lam_status set_templates(lam_session *session, const char *folder) {
  session->templates = lam_arena_copy(session->lasting, folder);
  return LAM_OK;
}

lam_status lam_session_set_templates(lam_session *session, const char *folder) {
  LAM_ENTER(session);
  return lam_session_leave(session, set_templates(session, folder));
}

const char *lam_session_templates(lam_session *session) {
  return session->templates ? session->templates : lam_template_dir(session->arena);
}

const char *lam_session_needs_templates(lam_session *session) {
  const char *folder = lam_session_templates(session);
  if (folder) return folder;
  lam_error_add(&session->errors, (lam_location){0}, NULL,
                "the templates folder is not found; set LAMELLA_TEMPLATES");
  session->errors.status = LAM_IO;
  return NULL;
}

lam_added_rows lam_session_rows(const lam_session *session) {
  return (lam_added_rows){&lam_surfaces, session->surface_count, session->surfaces};
}
