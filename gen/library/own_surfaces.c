/* Surfaces through the face: reading one by its keys, evaluating it, adding one's own. Called
 * through lamella/surface.h. */
#include "core/grow.h"
#include "design/design.h"
#include "library/read_files.h"
#include "library/sources.h"
#include "surf/defined.h"

#include <string.h>

/* ---- reading and evaluating ---- */

/* A surface by what would stand after `surface:`: as the design of nothing else. False with
 * messages. */
static bool read_surface(lam_session *session, const char *keys, lam_surface *surface) {
  lam_design *design = LAM_NEW(session->arena, lam_design, 1);
  const char *text =
      lam_arena_printf(session->arena, "{lamella: 1, name: surface, surface: %s}", keys);
  lam_design_source source = {.text = text, .length = strlen(text)};
  lam_origin origin = {0};
  lam_inputs inputs;
  if (!lam_source_parse(session, &source, design) ||
      !lam_sources_read(session, design, &origin, &inputs))
    return false;

  /* What the file holds is put in beside the keys. */
  lam_row row = lam_surface_row_with(session->arena, &design->surface, &inputs.surface);
  *surface = lam_surface_make(session->arena, &row, &session->errors);
  return surface->kind != NULL;
}

/* *out is set when the surface could be made. */
static lam_status read_into(lam_session *session, const char *keys, const lam_surface **out) {
  lam_surface *surface = LAM_NEW(session->arena, lam_surface, 1);
  if (read_surface(session, keys, surface)) *out = surface;
  return LAM_OK;
}

/* Declared, as all functions of the face here, in include/lamella/surface.h. */
lam_status lam_surface_read(lam_session *session, const char *keys, const lam_surface **surface) {
  *surface = NULL;
  LAM_ENTER(session);
  return lam_session_leave(session, read_into(session, keys, surface));
}

void lam_surface_domain(const lam_surface *surface, double u[2], double v[2]) {
  bool closed[2];
  surface->kind->domain(surface->data, LAM_CHART_NATURAL, u, v, closed);
}

void lam_surface_jet(const lam_surface *surface, double u, double v, lam_jet *jet) {
  lam_surface_eval(surface, u, v, jet);
}

/* ---- adding ---- */

/* Whether no surface has the name yet; a message otherwise. */
static bool is_free(lam_session *session, const char *name) {
  lam_added_rows added = lam_session_rows(session);
  const lam_registry *all = lam_registry_with(session->arena, &lam_surfaces, &added);
  if (!lam_registry_find(all, name)) return true;
  lam_error_add(&session->errors, (lam_location){0}, name,
                "there is a surface of this name already");
  return false;
}

/* Makes the surface once with the defaults of its keys: wrong derivatives show then. A surface
 * with a key that must be given is checked when a design gives it. */
static bool works(lam_session *session, const lam_surface_definition *definition) {
  for (int i = 0; i < definition->number_count; i++)
    if (!definition->numbers[i].initial) return true;

  lam_surface surface;
  return read_surface(session, definition->name, &surface);
}

/* A surface that is known while it is tried. */
typedef struct trial {
  lam_session *session;
  bool running;
} trial;

/* Forgets the surface of a trial that goes on, which is the last one of the session. Called by the
 * session's memory, when that runs out. */
static void end_trial(void *handle) {
  trial *t = handle;
  if (t->running) t->session->surface_count--;
  t->running = false;
}

/* The surface is known while it is tried, and forgotten when it does not work or when memory runs
 * out. */
static lam_status add(lam_session *session, const lam_surface_definition *definition) {
  const lam_surface_kind *kind =
      lam_surface_kind_defined(session->lasting, definition, &session->errors);
  if (!kind || !is_free(session, kind->head.name)) return LAM_OK;

  trial *t = LAM_NEW(session->arena, trial, 1);
  t->session = session;
  lam_arena_defer(session->arena, end_trial, t);
  LAM_APPEND(session->lasting, session->surfaces, session->surface_count, session->surface_capacity,
             &kind->head);
  t->running = true;

  if (works(session, definition)) t->running = false;
  end_trial(t);
  return LAM_OK;
}

/* The kind lives in the memory that clearing the session leaves. */
lam_status lam_surface_add(lam_session *session, const lam_surface_definition *definition) {
  LAM_ENTER(session);
  return lam_session_leave(session, add(session, definition));
}
