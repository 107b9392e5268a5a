#include "fab/workshop.h"

#include "core/mesh.h"
#include "core/topology.h"
#include "net/line_curve.h"
#include <math.h>

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Room for one more item of the given size: the array itself, or a copy twice as large. */
static void *room(lam_arena *arena, void *items, int count, int *capacity, size_t size) {
  if (count < *capacity) return items;
  *capacity = *capacity ? 2 * *capacity : 16;
  void *larger = lam_arena_alloc(arena, (size_t)*capacity, size);
  if (count) memcpy(larger, items, size * (size_t)count);
  return larger;
}

lam_part *lam_workshop_part(lam_workshop *w, lam_part part) {
  w->parts = room(w->arena, w->parts, w->part_count, &w->part_capacity, sizeof part);
  w->parts[w->part_count] = part;
  return &w->parts[w->part_count++];
}

void lam_workshop_crossing(lam_workshop *w, lam_crossing crossing) {
  w->crossings = room(w->arena, w->crossings, w->crossing_count, &w->crossing_capacity, sizeof crossing);
  w->crossings[w->crossing_count++] = crossing;
}

void lam_workshop_record_kind(lam_workshop *w, lam_record_kind kind) {
  w->record_kinds = room(w->arena, w->record_kinds, w->record_kind_count, &w->record_kind_capacity, sizeof kind);
  w->record_kinds[w->record_kind_count++] = kind;
}

void lam_workshop_surface(lam_workshop *w, lam_spline_surface surface) {
  w->surfaces = room(w->arena, w->surfaces, w->surface_count, &w->surface_capacity, sizeof surface);
  w->surfaces[w->surface_count++] = surface;
}

void lam_workshop_curve(lam_workshop *w, const char *name, const lam_polyline *line) {
  lam_named_curve curve = {name, line->family, lam_polyline_curve(w->arena, w->net->mesh.vertices, line)};
  if (!curve.spline.count) return;
  w->curves = room(w->arena, w->curves, w->curve_count, &w->curve_capacity, sizeof curve);
  w->curves[w->curve_count++] = curve;
}

int lam_workshop_next_class(const lam_workshop *w) {
  int most = 0;
  for (int i = 0; i < w->part_count; i++)
    if (w->parts[i].congruence > most) most = w->parts[i].congruence;
  return most + 1;
}

void lam_part_set_facts(lam_arena *arena, lam_part *part, const lam_fact *facts, int count) {
  part->facts = LAM_NEW(arena, lam_fact, count);
  part->fact_count = count;
  memcpy(part->facts, facts, sizeof *facts * (size_t)count);
}

bool lam_part_is_sound(lam_arena *arena, const lam_part *part) {
  const lam_trimesh *solid = &part->solid;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_topology topology;
  int *component = LAM_NEW(arena, int, solid->triangle_count);
  int(*fan)[3] = (int(*)[3])lam_arena_alloc(arena, (size_t)solid->triangle_count, sizeof *fan);
  bool sound = lam_topology_make(solid, component, fan, &topology) == LAM_OK && topology.closed && topology.oriented &&
               topology.components == 1 && topology.fans == topology.vertices && lam_trimesh_volume(solid) > 0;
  lam_arena_release(arena, mark);
  return sound;
}

lam_stage *lam_workshop_stage(lam_workshop *w, const char *name) {
  w->stages = room(w->arena, w->stages, w->stage_count, &w->stage_capacity, sizeof *w->stages);
  lam_stage *stage = &w->stages[w->stage_count++];
  *stage = (lam_stage){.name = name, .converged = true, .reason = "done", .iterations = -1};
  return stage;
}

void lam_stage_measure_add(lam_arena *arena, lam_stage *stage, lam_measure measure) {
  int capacity = stage->measure_count; /* a stage has few measures: the array is copied for each */
  lam_measure *measures = room(arena, stage->measures, stage->measure_count, &capacity, sizeof *measures);
  measures[stage->measure_count++] = measure;
  stage->measures = measures;
}

void lam_stage_measure(lam_arena *arena, lam_stage *stage, const char *name, const char *unit, double max, double mean,
                       long count) {
  lam_stage_measure_add(arena, stage, (lam_measure){name, unit, NAN, max, mean, count});
}

void lam_stage_note(lam_arena *arena, lam_stage *stage, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  int capacity = stage->note_count;
  const char **notes = room(arena, stage->notes, stage->note_count, &capacity, sizeof *notes);
  notes[stage->note_count++] = lam_arena_copy(arena, text);
  stage->notes = notes;
}
