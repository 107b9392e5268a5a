/* The boundary of a spline surface from its four sides, on homogeneous points. Called by
 * least_area.c. */
#include "curve/curve.h"
#include "surf/area/least_area.h"
#include <math.h>

/* The weight of the first (end 0) or last control point of a homogeneous curve. */
static double end_weight(const lam_bspline *net, int end) {
  return net->values[end ? 4 * net->count - 1 : 3];
}

/* The same curve with all weights scaled so that the first is the given one. */
static lam_bspline start_with(lam_arena *arena, lam_bspline net, double first) {
  double *values = LAM_NEW(arena, double, 4 * net.count), factor = first / end_weight(&net, 0);
  for (int i = 0; i < 4 * net.count; i++) values[i] = factor * net.values[i];
  net.values = values;
  return net;
}

/* Scales the weights of the sides so that they agree at three corners; false when the fourth does
 * not agree by itself. */
static bool match_weights(lam_arena *arena, lam_bspline net[LAM_SIDES]) {
  net[1] = start_with(arena, net[1], end_weight(&net[0], 0));
  net[3] = start_with(arena, net[3], end_weight(&net[0], 1));
  net[2] = start_with(arena, net[2], end_weight(&net[1], 1));
  return !(fabs(end_weight(&net[2], 1) / end_weight(&net[3], 1) - 1) > 1e-9);
}

/* Gives opposite sides one degree and the same knots. */
static void match_opposite(lam_arena *arena, lam_bspline net[LAM_SIDES]) {
  for (int d = 0; d < 2; d++) {
    lam_bspline pair[2] = {net[d], net[d + 2]};
    lam_bspline_match(arena, 2, pair);
    net[d] = pair[0];
    net[d + 2] = pair[1];
  }
}

/* Sets the points and weights of side i in the net of a surface. */
static void set_side(lam_arena *arena, lam_bspline net, int i, const lam_spline_surface *surface,
                     lam_vec3 *points, double *weights) {
  int m = surface->count[0], n = surface->count[1];
  lam_spline_curve side = lam_spline_curve_from_net(arena, net);
  for (int k = 0; k < side.count; k++) {
    int at = i % 2 ? (i == 3 ? m - 1 : 0) * n + k : k * n + (i == 2 ? n - 1 : 0);
    points[at] = side.points[k];
    weights[at] = side.weights[k];
  }
}

/* Sides are numbered x(u,0), x(0,v), x(u,1), x(1,v), as lam_sides are. */
bool lam_spline_surface_between(lam_arena *arena, const lam_sides *sides,
                                lam_spline_surface *surface) {
  lam_bspline net[LAM_SIDES];
  for (int i = 0; i < LAM_SIDES; i++) {
    net[i] = lam_spline_curve_net(arena, &sides->side[i], true);
    if (net[i].degree < 3) net[i] = lam_bspline_elevate(arena, net[i], 3);
  }

  if (!match_weights(arena, net)) return false;
  match_opposite(arena, net);

  int m = net[0].count, n = net[1].count;
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, m * n);
  double *weights = LAM_NEW(arena, double, m *n);
  for (int i = 0; i < m * n; i++) weights[i] = 1;

  /* The first sides come last: corners that differ in rounding are theirs. */
  *surface = (lam_spline_surface){
      NULL, {net[0].degree, net[1].degree}, {m, n}, {net[0].knots, net[1].knots}, points, weights};
  for (int i = LAM_SIDES - 1; i >= 0; i--) set_side(arena, net[i], i, surface, points, weights);
  return true;
}
