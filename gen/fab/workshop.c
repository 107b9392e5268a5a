/* The workshop's own functions: what the rows of parts (fab/lamella, fab/parts) call to add
 * what they made, and the one check that all of them make on their solids. */
#include "fab/workshop.h"

#include "core/grow.h"
#include "core/solid/topology.h"
#include "core/solid/triangles.h"
#include "mesh/line_curve.h"

#include <string.h>

lam_part *lam_workshop_part(lam_workshop *w, lam_part part) {
  LAM_APPEND(w->arena, w->parts, w->part_count, w->part_capacity, part);
  return &w->parts[w->part_count - 1];
}

void lam_workshop_crossing(lam_workshop *w, lam_crossing crossing) {
  LAM_APPEND(w->arena, w->crossings, w->crossing_count, w->crossing_capacity, crossing);
}

void lam_workshop_record_kind(lam_workshop *w, lam_record_kind kind) {
  LAM_APPEND(w->arena, w->record_kinds, w->record_kind_count, w->record_kind_capacity, kind);
}

void lam_workshop_surface(lam_workshop *w, lam_spline_surface surface) {
  LAM_APPEND(w->arena, w->surfaces, w->surface_count, w->surface_capacity, surface);
}

/* A line whose vertices coincide gives no curve: nothing is added then. */
void lam_workshop_curve(lam_workshop *w, const char *name, const lam_polyline *line) {
  lam_named_curve curve = {name, line->family,
                           lam_polyline_curve(w->arena, w->net->mesh.vertices, line)};
  if (!curve.spline.count) return;
  LAM_APPEND(w->arena, w->curves, w->curve_count, w->curve_capacity, curve);
}

/* Classes count from 1; 0 means that a part has none. */
int lam_workshop_next_class(const lam_workshop *w) {
  int most = 0;
  for (int i = 0; i < w->part_count; i++)
    if (w->parts[i].congruence > most) most = w->parts[i].congruence;
  return most + 1;
}

/* Facts are rows of literals in their callers: they are copied, their names and units are not. */
void lam_part_set_facts(lam_arena *arena, lam_part *part, const lam_fact *facts, int count) {
  part->facts = LAM_NEW(arena, lam_fact, count);
  part->fact_count = count;
  memcpy(part->facts, facts, sizeof *facts * (size_t)count);
}

/* A vertex with two fans of triangles joins two sheets of the solid in a point: as many fans as
 * vertices means that there is none. */
bool lam_part_is_sound(lam_arena *arena, const lam_part *part) {
  const lam_trimesh *solid = &part->solid;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_topology topology;
  int *component = LAM_NEW(arena, int, solid->triangle_count);
  int(*fan)[3] = (int(*)[3])lam_arena_alloc(arena, (size_t)solid->triangle_count, sizeof *fan);

  lam_status status = lam_topology_make(solid, component, fan, &topology);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(arena);

  bool sound = status == LAM_OK && topology.closed && topology.oriented &&
               topology.components == 1 && topology.fans == topology.vertices &&
               lam_trimesh_volume(solid) > 0;

  lam_arena_release(arena, mark);
  return sound;
}

lam_stage *lam_workshop_stage(lam_workshop *w, const char *name) {
  LAM_APPEND(w->arena, w->stages, w->stage_count, w->stage_capacity, lam_stage_begin(name));
  return &w->stages[w->stage_count - 1];
}
