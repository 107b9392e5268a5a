/* The state of a build, and its stages: for the files pipeline_run.c and *_stage.c of design/. */
#ifndef LAM_DESIGN_STAGES_H
#define LAM_DESIGN_STAGES_H

#include "core/stage.h"
#include "design/pipeline.h"
#include "fab/workshop.h"
#include "mesh/net.h"
#include "net/measures/measure.h"
#include "net/trace/start.h"
#include "surf/surface.h"

typedef struct lam_build {
  lam_arena *arena;
  const lam_design *design;
  const lam_inputs *inputs;
  const lam_progress *progress;
  lam_errors *errors;
  lam_model *model;
  lam_surface surface;
  lam_net *net;            /* NULL: none */
  lam_measuring measuring; /* of the net */
  lam_vec3 *normals;       /* unit, per vertex of the net */
  lam_placement placement; /* of the surface */
  int sampled;             /* vertices of the net as it was sampled */
  int stage_count;
  lam_stage stages[4]; /* surface, net, texture, sheets; parts bring their own */
  double since;        /* when the stage began */
} lam_build;

/* A stage of the report begins, and its time, until the next one begins; pipeline_clock.c. */
lam_stage *lam_build_stage(lam_build *build, const char *name);
void lam_build_stage_end(const lam_build *build, lam_stage *stage);

/* The stages, in this order. Each returns false with messages when the input is wrong, and true also
 * when the design does not have what it makes. */

/* surface_stage.c: the surface; then, where the net stands, as a spline for parts and writers. */
bool lam_build_surface(lam_build *build);
void lam_build_keep_surface(const lam_build *build, lam_workshop *workshop);
/* net_stage.c: the net as it is sampled, traced, read or given, then refined and solved. */
bool lam_build_net(lam_build *build);
/* plots_stage.c: color maps of measures; a picture printed on the surface. */
bool lam_build_maps(lam_build *build);
bool lam_build_print(lam_build *build, const lam_workshop *workshop);
/* parts_stage.c: the rows of parts; lines of the net where no part gives axes; sheets. */
bool lam_build_parts(lam_build *build, lam_workshop *workshop);
void lam_build_keep_lines(const lam_build *build, lam_workshop *workshop);
bool lam_build_sheets(lam_build *build, const lam_workshop *workshop);

#endif
