/* The state of a build, and its stages: for the files pipeline_run.c, stage_clock.c and *_stage.c
 * of design/. */
#ifndef LAM_DESIGN_STAGES_H
#define LAM_DESIGN_STAGES_H

#include "core/stage.h"
#include "design/pipeline.h"
#include "fab/workshop.h"
#include "mesh/net.h"
#include "net/measures/measure.h"
#include "net/trace/start.h"
#include "surf/surface.h"

/* What a build was given, what it has made so far, and its part of the report. */
typedef struct lam_build {
  /* Given; not NULL but for progress. */
  lam_arena *arena; /* owns all that is made */
  const lam_design *design;
  const lam_inputs *inputs;
  const lam_progress *progress; /* NULL: nobody watches */
  lam_errors *errors;
  lam_model *model; /* stages fill what is theirs */

  /* Made. Positions in meters. */
  lam_surface surface;     /* in its own units and axes; kind is NULL: none */
  lam_vec3 surface_origin; /* of those axes, where they are not those of its file */
  lam_net *net;            /* NULL: none */
  lam_measuring measuring; /* of the net */
  lam_vec3 *normals;       /* unit, per vertex of the net */
  lam_placement placement; /* of the surface: where the net stands on it */
  int sampled;             /* vertices of the net as it was sampled, before it was refined */

  /* Reported. */
  int stage_count;
  lam_stage stages[6]; /* surface, net, plots, texture, sheets; parts bring their own */
  double since;        /* when the last stage began (lam_clock_seconds) */
} lam_build;

/* ---- the report (stage_clock.c) ---- */

/* Begins a stage of the report, tells whoever watches, and starts its time. name is kept by
 * pointer. At most six in a build; the stage stays where it is. */
lam_stage *lam_build_stage(lam_build *build, const char *name);
/* Ends the stage that was begun last: sets its seconds. */
void lam_build_stage_end(const lam_build *build, lam_stage *stage);
/* Makes the messages after `last` (NULL: all) the verdict of a stage: it failed, for the first of
 * them, and the others are its notes. They are no messages of the build any more. What is no fault
 * of the input (a file that cannot be read) stays one: false then. */
bool lam_build_stage_fail(const lam_build *build, lam_stage *stage, lam_error *last);

/* ---- the stages ----
 *
 * Called by pipeline_run.c: surface, net, maps, keep_surface, print, parts, keep_lines, sheets.
 * Each bool is false, with messages, when the input is wrong, and true also when the design does
 * not have what the stage makes. After the net, what does not go together with it is no message,
 * but a stage that failed: all else is made and delivered. */

/* net_stage.c: makes the net's start alone, unless the design has neither net nor surface. Called
 * by lam_build_net, and where a design is only checked. */
bool lam_build_start(lam_build *build);
/* surface_stage.c: makes the surface of the design. */
bool lam_build_surface(lam_build *build);
/* ---- the local origin (local_origin.c) ----
 *
 * What was read and lies far away is built about an origin near it, model->origin. */

/* What was read for the surface, about build->surface_origin, which is set. */
lam_surface_inputs lam_build_local_surface(lam_build *build);
/* Sets the model's origin to that of the surface, which the net has been sampled from. */
void lam_build_origin_of_surface(lam_build *build);
/* Sets the model's origin for a mesh that was read, and moves it there. */
void lam_build_local_mesh(lam_build *build, lam_mesh *mesh);
/* The reference about the model's origin; NULL: none was read. */
const lam_trimesh *lam_build_local_reference(const lam_build *build);
/* Names the origin in the report, unless it is (0, 0, 0). */
void lam_build_note_origin(const lam_build *build, lam_stage *stage);

/* ---- more stages ---- */

/* surface_stage.c: adds the surface to the workshop where the net stands, for parts and writers;
 * nothing when it is no spline or there is no net. */
void lam_build_keep_surface(const lam_build *build, lam_workshop *workshop);

/* net_stage.c: makes the net: sampled, traced, read or given, then refined and solved. A design
 * with a surface and no net gets a plain mesh of the surface. */
bool lam_build_net(lam_build *build);

/* plots_stage.c: the color maps of the measures that the design wants drawn. */
bool lam_build_maps(lam_build *build);
/* plots_stage.c: the picture printed on the first surface of the workshop. */
bool lam_build_print(lam_build *build, const lam_workshop *workshop);

/* parts_stage.c: makes the parts of the design, in the workshop, and looks for clashes. */
bool lam_build_parts(lam_build *build, lam_workshop *workshop);
/* written_check.c: tells which solids of the workshop are closed as they were made, but not as
 * files of 32-bit coordinates have them. */
void lam_build_check_written(lam_workshop *workshop);
/* parts_stage.c: adds the lines of the net to the workshop's curves where no part has given
 * axes. */
void lam_build_keep_lines(const lam_build *build, lam_workshop *workshop);
/* parts_stage.c: nests the flat parts of the workshop on sheets. */
bool lam_build_sheets(lam_build *build, const lam_workshop *workshop);

#endif
