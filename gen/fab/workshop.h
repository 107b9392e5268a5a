/* Parts are made in the workshop: a row of the part registry reads the net (and parts made
 * before it) and adds parts, crossings and measures. One kind of part per file in fab/lamella
 * and fab/parts; the list is fab/parts/part_kinds.c. design/pipeline_run.c opens the workshop and
 * keeps what was made; design/parts_stage.c runs the rows in the order of the design. */
#ifndef LAM_FAB_WORKSHOP_H
#define LAM_FAB_WORKSHOP_H

#include "core/error.h"
#include "core/key.h"
#include "core/model.h"
#include "core/progress.h"
#include "core/stage.h"
#include "fab/material.h"
#include "mesh/net.h"

/* What a lamella grid offers to later parts (node connectors, flat patterns). */
struct lam_lamella_grid; /* fab/lamella/lamella.h */

/* Owned by arena, as is all it points to. Arrays are NULL while their count is 0. */
typedef struct lam_workshop {
  lam_arena *arena;
  lam_errors *errors; /* for input that only here proves wrong: a joint wider than its spacing */
  const lam_progress *progress;
  lam_vec3 origin;         /* of all positions, for places that keys name; meters */
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
  lam_spline_surface *surfaces; /* smooth, placed: that of the design, then those of skins */
  int curve_count, curve_capacity;
  lam_named_curve *curves; /* axes of parts */
} lam_workshop;

/* A row of the registry of parts. */
typedef struct lam_part_kind {
  lam_row_head head;
  /* Makes the parts of one row of the design. params: the row's keys, head.params_size bytes,
   * with defaults filled in; location: of the row, for messages. On wrong input adds to
   * workshop->errors and returns; parts added before that stay. */
  void (*make)(lam_workshop *workshop, const void *params, lam_location location);
  /* Adds a message for keys of row i that go together neither with each other nor with the rows
   * before it, on whatever net. May be NULL: any keys do. */
  void (*check)(const lam_row *rows, int i, lam_errors *errors);
} lam_part_kind;

/* All kinds of parts (fab/parts/part_kinds.c), read by design/design_keys.c and
 * library/reference/sections.c. */
extern const lam_registry lam_part_kinds;

/* Each appends one item to an array of the workshop. What is passed is copied shallowly:
 * strings, meshes and arrays in it are kept by pointer. A returned pointer is valid until the
 * next call of the same function. */
lam_part *lam_workshop_part(lam_workshop *workshop, lam_part part);
void lam_workshop_crossing(lam_workshop *workshop, lam_crossing crossing);
void lam_workshop_record_kind(lam_workshop *workshop, lam_record_kind kind);
void lam_workshop_surface(lam_workshop *workshop, lam_spline_surface surface);
/* Adds the smooth curve along a line of the net (lam_polyline_curve); nothing when its vertices are
 * all in one place. name is kept by pointer. */
void lam_workshop_curve(lam_workshop *workshop, const char *name, const lam_polyline *line);
/* Opens a stage of the report, converged until its owner says otherwise. name is kept by
 * pointer. */
lam_stage *lam_workshop_stage(lam_workshop *workshop, const char *name);
/* The first number of a congruence class that no part has yet: 1 when there are no parts. */
int lam_workshop_next_class(const lam_workshop *workshop);
/* Gives a part a copy of count facts, in place of those it had. */
void lam_part_set_facts(lam_arena *arena, lam_part *part, const lam_fact *facts, int count);
/* Whether the part's solid is closed, oriented outward (its volume is positive), in one piece,
 * and 2-manifold at every vertex (one fan of triangles each). arena is only used for scratch. */
bool lam_part_is_sound(lam_arena *arena, const lam_part *part);

#endif
