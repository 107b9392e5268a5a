/* Exact changes of spline surfaces, each as a change of a B-spline whose values are whole rows
 * of homogeneous points. Called by surf/area and the files of surf/spline. */
#include "surf/spline/spline_edit.h"
#include <string.h>

/* Value i of the result is row i of direction `direction`: its points one after the other. */
lam_bspline lam_spline_surface_net(lam_arena *arena, const lam_spline_surface *s, int direction) {
  int n = s->weights ? 4 : 3, across = s->count[1 - direction], along = s->count[direction];
  double *values = LAM_NEW(arena, double, (size_t)along *across *n);

  for (int i = 0; i < along; i++)
    for (int j = 0; j < across; j++) {
      int from = direction ? j * s->count[1] + i : i * s->count[1] + j;
      double *to = values + ((size_t)i * across + j) * n, w = s->weights ? s->weights[from] : 1;
      to[0] = w * s->points[from].x;
      to[1] = w * s->points[from].y;
      to[2] = w * s->points[from].z;
      if (n == 4) to[3] = w;
    }
  return (lam_bspline){s->degree[direction], along, across * n, s->knots[direction], values};
}

/* The way back from rows of homogeneous points to points and weights. */
lam_spline_surface lam_spline_surface_from_net(lam_arena *arena, const lam_spline_surface *like,
                                               int direction, lam_bspline net) {
  int across = like->count[1 - direction], n = net.dimension / across;
  lam_spline_surface s = *like;
  s.degree[direction] = net.degree;
  s.count[direction] = net.count;
  s.knots[direction] = net.knots;

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, (size_t)net.count * across);
  double *weights = n == 4 ? LAM_NEW(arena, double, (size_t)net.count *across) : NULL;
  for (int i = 0; i < net.count; i++)
    for (int j = 0; j < across; j++) {
      const double *from = net.values + ((size_t)i * across + j) * n;
      int to = direction ? j * net.count + i : i * across + j;
      if (weights) weights[to] = from[3];
      points[to] = lam_scale(lam_v3(from[0], from[1], from[2]), weights ? 1 / from[3] : 1);
    }

  s.points = points;
  s.weights = weights;
  return s;
}

/* One more knot than stands at t. */
lam_spline_surface lam_spline_surface_insert(lam_arena *arena, const lam_spline_surface *surface,
                                             int direction, double t) {
  lam_bspline net = lam_spline_surface_net(arena, surface, direction);
  net = lam_bspline_insert(arena, net, t, lam_bspline_multiplicity(&net, t) + 1);
  return lam_spline_surface_from_net(arena, surface, direction, net);
}

/* One direction after the other; a degree that is high enough stays. */
lam_spline_surface lam_spline_surface_elevate(lam_arena *arena, const lam_spline_surface *surface,
                                              const int degree[2]) {
  lam_spline_surface s = *surface;
  for (int d = 0; d < 2; d++) {
    if (degree[d] <= s.degree[d]) continue;
    lam_bspline net = lam_spline_surface_net(arena, &s, d);
    s = lam_spline_surface_from_net(arena, &s, d, lam_bspline_elevate(arena, net, degree[d]));
  }
  return s;
}

/* Cut in one direction; the other keeps its knots. */
lam_spline_surface lam_spline_surface_part(lam_arena *arena, const lam_spline_surface *surface,
                                           int direction, double low, double high) {
  lam_bspline net = lam_spline_surface_net(arena, surface, direction);
  return lam_spline_surface_from_net(arena, surface, direction,
                                     lam_bspline_part(arena, net, low, high));
}

/* Rows in the opposite order. */
lam_spline_surface lam_spline_surface_reverse(lam_arena *arena, const lam_spline_surface *surface,
                                              int direction) {
  lam_bspline net = lam_spline_surface_net(arena, surface, direction);
  return lam_spline_surface_from_net(arena, surface, direction, lam_bspline_reverse(arena, net));
}

/* The net is transposed; knots and degrees change places. */
lam_spline_surface lam_spline_surface_transpose(lam_arena *arena, const lam_spline_surface *s) {
  int m = s->count[0], n = s->count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, (size_t)m * n);
  double *weights = s->weights ? LAM_NEW(arena, double, (size_t)m *n) : NULL;
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      points[j * m + i] = s->points[i * n + j];
      if (weights) weights[j * m + i] = s->weights[i * n + j];
    }
  return (lam_spline_surface){
      s->name, {s->degree[1], s->degree[0]}, {n, m}, {s->knots[1], s->knots[0]}, points, weights};
}

/* The Bezier pieces of one direction of a surface, as surfaces. Sets count. */
static lam_spline_surface *slices(lam_arena *arena, const lam_spline_surface *s, int direction,
                                  int *count) {
  lam_pieces pieces =
      lam_bspline_pieces(arena, lam_spline_surface_net(arena, s, direction), 0, NULL);

  lam_spline_surface *list = LAM_NEW(arena, lam_spline_surface, pieces.count);
  int p = pieces.degree;

  for (int k = 0; k < pieces.count; k++) {
    double *knots = LAM_NEW(arena, double, 2 * p + 2);
    for (int i = 0; i < 2 * p + 2; i++) knots[i] = pieces.breaks[i > p ? k + 1 : k];
    const double *values = pieces.values + (size_t)k * (p + 1) * pieces.dimension;
    list[k] = lam_spline_surface_from_net(arena, s, direction,
                                          (lam_bspline){p, p + 1, pieces.dimension, knots, values});
  }
  *count = pieces.count;
  return list;
}

/* Cut along u, then each piece along v. */
const lam_spline_surface *lam_spline_surface_patches(lam_arena *arena,
                                                     const lam_spline_surface *surface,
                                                     int count[2]) {
  lam_spline_surface *rows = slices(arena, surface, 0, &count[0]), *patches = NULL;
  for (int i = 0; i < count[0]; i++) {
    lam_spline_surface *row = slices(arena, &rows[i], 1, &count[1]);
    if (i == 0) patches = LAM_NEW(arena, lam_spline_surface, count[0] * count[1]);
    memcpy(patches + i * count[1], row, (size_t)count[1] * sizeof *row);
  }
  return patches;
}
