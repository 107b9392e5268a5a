/* What a design names outside itself, read: plain data, put together by library/sources.c before the
 * pipeline runs. */
#ifndef LAM_DESIGN_INPUTS_H
#define LAM_DESIGN_INPUTS_H

#include "core/model.h"
#include "surf/spline/surface_inputs.h"

/* Zeroed: nothing was read. What the design needs and is not here is an error of the pipeline. */
typedef struct lam_inputs {
  lam_surface_inputs surface;   /* of the file that the surface names */
  const lam_mesh *net;          /* of net.from: a file, or the finished net of another design */
  const lam_trimesh *reference; /* of net.reference */
} lam_inputs;

#endif
