/* Parts are made in the workshop: a row of the part registry reads the net (and parts made before
 * it) and adds parts, crossings and measures. One kind of part per file; the list is
 * fab/registry.c. */
#ifndef LAM_FAB_WORKSHOP_H
#define LAM_FAB_WORKSHOP_H

#include "core/error.h"
#include "core/key.h"
#include "core/model.h"
#include "core/progress.h"
#include "core/stage.h"
#include "fab/material.h"
#include "mesh/net.h"

/* What a lamella grid offers to later parts. */
struct lam_lamella_grid; /* fab/lamella.h */

typedef struct lam_workshop {
  lam_arena *arena;
  lam_errors *errors; /* for input that only shows to be wrong here, such as a joint wider than its
                         spacing */
  const lam_progress *progress;
  const lam_net *net;      /* with final positions in net->mesh.vertices */
  const lam_vec3 *normals; /* unit, per net vertex */
  int part_count, part_capacity;
  lam_part *parts;
  int crossing_count, crossing_capacity;
  lam_crossing *crossings;
  int record_kind_count, record_kind_capacity;
  lam_record_kind *record_kinds;
  int stage_count, stage_capacity;
  lam_stage *stages; /* one per row that was made, and one for the checks */
  const struct lam_lamella_grid *lamella_grid; /* the last one made, or NULL */
  int surface_count, surface_capacity;
  lam_spline_surface
      *surfaces; /* smooth surfaces, placed: that of the design, then those of skins */
  int curve_count, curve_capacity;
  lam_named_curve *curves; /* axes of parts */
} lam_workshop;

typedef struct lam_part_kind {
  lam_row_head head;
  /* Makes the parts. On wrong input adds to workshop->errors and returns. */
  void (*make)(lam_workshop *workshop, const void *params, lam_location location);
} lam_part_kind;

extern const lam_registry lam_part_kinds;

/* Appends (arrays grow in the arena; what is passed is copied shallowly). The returned pointer is
 * valid until the next call. */
lam_part *lam_workshop_part(lam_workshop *workshop, lam_part part);
void lam_workshop_crossing(lam_workshop *workshop, lam_crossing crossing);
void lam_workshop_record_kind(lam_workshop *workshop, lam_record_kind kind);
void lam_workshop_surface(lam_workshop *workshop, lam_spline_surface surface);
/* Adds the smooth curve along a line of the net (lam_polyline_curve); nothing when its vertices are
 * all in one place. name is kept by pointer. */
void lam_workshop_curve(lam_workshop *workshop, const char *name, const lam_polyline *line);
lam_stage *lam_workshop_stage(lam_workshop *workshop, const char *name);
/* The first number of a congruence class that no part has yet. */
int lam_workshop_next_class(const lam_workshop *workshop);
/* Gives a part a copy of facts. */
void lam_part_set_facts(lam_arena *arena, lam_part *part, const lam_fact *facts, int count);
/* Whether the part's solid is closed, oriented outward and in one piece. */
bool lam_part_is_sound(lam_arena *arena, const lam_part *part);
#endif
