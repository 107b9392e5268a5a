/* Initial nets: sampled from a surface in the parameterization that a net needs. */
#ifndef LAM_NET_TRACE_START_H
#define LAM_NET_TRACE_START_H

#include "mesh/net.h"
#include "surf/placement.h"
#include "surf/surface.h"

struct lam_trace_options; /* net/trace.h */

/* What places a surface: x -> scale * turned(x) + (0, 0, lift). */
typedef struct lam_placement {
  double rotate[3], scale, lift;
  const lam_vec2
      *parameters; /* natural ones of the vertices that were sampled; NULL: in another chart */
} lam_placement;
lam_vec3 lam_placement_apply(const lam_placement *placement, lam_vec3 x);

/* Samples a surface. grid: cells along the families. hole: rings left out around a flat point.
 * Scaled, turned and set on the ground as place says. Where the surface has no such chart in closed
 * form, the lines are traced. Errors (no such lines, unequal grid around a flat point, ...) go to
 * errors; false then. placed: how the surface was placed; may be NULL. */
bool lam_net_start(lam_arena *arena, const lam_surface *surface, lam_chart chart, const int grid[2],
                   int hole, const lam_placement_keys *placing, lam_location location,
                   lam_errors *errors, lam_mesh *mesh, lam_placement *placed);
/* The same with traced lines in any case (lam_trace_net); ranges of u and v are the surface's own
 * then. */
bool lam_net_start_traced(lam_arena *arena, const lam_surface *surface, lam_chart chart,
                          const int grid[2], int hole, const struct lam_trace_options *options,
                          const lam_placement_keys *placing, lam_location location,
                          lam_errors *errors, lam_mesh *mesh, lam_placement *placed);

/* Moves the mesh up or down so that its lowest vertex is at z = 0; returns by how much. */
double lam_mesh_ground(lam_mesh *mesh);
/* Displaces every vertex by a random vector of length up to noise (deterministic in seed). */
void lam_mesh_perturb(lam_mesh *mesh, double noise, int seed);

#endif
