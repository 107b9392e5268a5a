/* Degenerate states of a solved net: the solver's convergence does not exclude them.
 * Called by net/optimize.c. */
#include "core/solid/triangles.h"
#include "net/measures/measure.h"

#include <math.h>

/* Diagonal of the box around the vertices. */
static double extent(const lam_net *net, const lam_vec3 *positions) {
  lam_vec3 low, high;
  lam_points_bounds(positions, net->mesh.vertex_count, &low, &high);
  return lam_distance(low, high);
}

/* The first state in this order that holds is named. */
const char *lam_net_degenerate(lam_arena *arena, const lam_net *net, const lam_vec3 *before,
                               const lam_vec3 *after) {
  /* each before and after */
  lam_measure edge[2] = {lam_net_measure_one(arena, net, before, "shortest_edge"),
                         lam_net_measure_one(arena, net, after, "shortest_edge")};
  lam_measure flat[2] = {lam_net_measure_one(arena, net, before, "flatness"),
                         lam_net_measure_one(arena, net, after, "flatness")};
  double size[2] = {extent(net, before), extent(net, after)};

  /* A size that is not a number must not pass: hence the negations. */
  if (!isfinite(lam_net_mean_edge(net, after)))
    return "not a number: vertices have no place any more";
  if (!(size[1] > .05 * size[0]))
    return "shrunk: the net is less than a twentieth of its size at the start";
  if (!(size[1] < 20 * size[0]))
    return "flown apart: the net is more than twenty times its size at the start";

  /* These are held against the start: a plane that was a plane is none. */
  if (!(edge[1].max > .02) && edge[1].max < .2 * edge[0].max)
    return "collapsed: edges have shrunk to nothing";
  if (flat[0].max > 1e-6 && flat[1].max < .05 * flat[0].max) return "flattened: the net is a plane";

  /* Nobody can build these, wherever they come from. */
  double folds = lam_net_measure_one(arena, net, after, "foldovers").max;
  if (folds > 0) return lam_arena_printf(arena, "folded: faces turn over at %.0f edges", folds);
  double covered = lam_net_measure_one(arena, net, after, "overlaps").max;
  if (covered > 0)
    return lam_arena_printf(arena, "lies on itself: %.0f faces are over others", covered);
  return NULL;
}
