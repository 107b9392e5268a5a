/* The state of a build, and its stages. For the files gen/design/build*.c only. */
#ifndef LAM_DESIGN_PIPELINE_H
#define LAM_DESIGN_PIPELINE_H

#include "design/pipeline_run.h"
#include "mesh/net.h"
#include "net/measures/measure.h"
#include "net/measures/measure_map.h"
#include "net/trace/start.h"
#include "surf/placement.h"
#include "surf/surface.h"

typedef struct lam_pipeline {
  lam_arena *arena;
  const lam_design *design;
  const lam_loader *loader;
  const lam_progress *progress;
  lam_errors *errors;
  lam_model *model;
  lam_surface surface;
  lam_net *net;
  lam_measuring measuring; /* of the net */
  lam_vec3 *normals;
  lam_placement placed; /* of the surface */
  int sampled;          /* vertices of the net as it was sampled */
  int stage_count;
  lam_stage stages[4]; /* surface, net, texture, sheets; parts bring their own */
  double since;
} lam_pipeline;

/* A stage of the report begins, and its time; until the next one begins. */
lam_stage *lam_pipeline_stage(lam_pipeline *p, const char *name);
void lam_pipeline_stage_end(const lam_pipeline *p, lam_stage *stage);

/* The net: as it is sampled, traced, read or built, then refined and solved. True also when the
 * design has none. */
bool lam_pipeline_net(lam_pipeline *p);

#endif
