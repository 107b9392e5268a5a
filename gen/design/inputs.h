/* What a design names outside itself, read: plain data, put together by library/sources.c before
 * design/pipeline_run.c builds. */
#ifndef LAM_DESIGN_INPUTS_H
#define LAM_DESIGN_INPUTS_H

#include "core/model.h"
#include "surf/spline/surface_inputs.h"

/* Zeroed: nothing was read. What the design needs and is not here is an error of the build. Kept by
 * pointer: it has to live as long as the model. */
typedef struct lam_inputs {
  lam_surface_inputs surface;   /* of the file that the surface names */
  const lam_mesh *net;          /* of net.from: a file, or another design's finished net; NULL */
  int net_note_count;           /* what was found in that file, for the report: sentences */
  const char *const *net_notes; /* net_note_count */
  const lam_trimesh *reference; /* of net.reference; NULL */
} lam_inputs;

#endif
