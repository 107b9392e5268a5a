/* Initial nets: sampled from a surface in the parameterization that a net needs. Used by
 * design/net_stage.c, design/pipeline_run.c (lam_placement_apply) and bench/bench_run.c. */
#ifndef LAM_NET_TRACE_START_H
#define LAM_NET_TRACE_START_H

#include "mesh/net.h"
#include "surf/placement.h"
#include "surf/surface.h"

struct lam_trace_options; /* net/trace/trace.h */

/* How a surface is placed: x -> scale * turned(x) + (0, 0, lift). */
typedef struct lam_placement {
  double rotate[3]; /* about the x, y and z axis, in this order, radians */
  double scale;
  double lift; /* meters */
  /* Of a traced net (net/trace/trace.h); cells are 0 where nothing was traced. */
  double coverage;
  int cells[2];
  /* natural ones of the vertices that were sampled; NULL: in another chart */
  const lam_vec2 *parameters;
} lam_placement;
lam_vec3 lam_placement_apply(const lam_placement *placement, lam_vec3 x);

/* Samples a surface, then turns, scales and grounds the mesh as placing says. Where the surface
 * has no such chart in closed form, the lines are traced.
 *
 *   grid      cells along the families; around a flat point along the sides of every sector
 *   hole      rings left out around a flat point; 0 where there is none
 *   placing   ranges of the chart, size, rotation
 *   location  of the net in the design, for messages
 *   mesh      out; meters, owned by arena
 *   placed    out: how the surface was placed; may be NULL
 *
 * False, with errors (no such lines, unequal grid around a flat point, ...). */
bool lam_net_start(lam_arena *arena, const lam_surface *surface, lam_chart chart, const int grid[2],
                   int hole, const lam_placement_keys *placing, lam_location location,
                   lam_errors *errors, lam_mesh *mesh, lam_placement *placed);
/* The same with traced lines in any case (lam_trace_net); ranges of u and v are the
 * surface's own then. */
bool lam_net_start_traced(lam_arena *arena, const lam_surface *surface, lam_chart chart,
                          const int grid[2], int hole, const struct lam_trace_options *options,
                          const lam_placement_keys *placing, lam_location location,
                          lam_errors *errors, lam_mesh *mesh, lam_placement *placed);

/* Moves the mesh up or down so that its lowest vertex is at z = 0; returns by how much. */
double lam_mesh_ground(lam_mesh *mesh);
/* Displaces every vertex by a random vector of length up to noise, in the mesh's units. The same
 * seed gives the same displacements. */
void lam_mesh_perturb(lam_mesh *mesh, double noise, int seed);

#endif
