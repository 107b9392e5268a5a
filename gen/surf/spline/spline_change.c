/* Changes of spline surfaces that need not be exact, with bounds; products, images, parameter
 * lines. The line is called by surface_join.c; the others are part of the surface kernel,
 * called by the unit tests. */
#include "surf/spline/spline_edit.h"

/* The largest distance of corresponding points of two nets with the same knots: rows of points of
 * dimension n. */
static double net_gap(const lam_bspline *f, const lam_bspline *g, int n) {
  double most = 0;
  for (size_t i = 0; i < (size_t)f->count * f->dimension; i += (size_t)n) {
    double square = 0;
    for (int c = 0; c < n; c++) square += pow(f->values[i + c] - g->values[i + c], 2);
    most = fmax(most, sqrt(square));
  }
  return most;
}

/* A move d of homogeneous points moves points by at most d times this: (1 + max |P|) / min w
 * (Piegl & Tiller, eq. 5.30). */
static double homogeneous_factor(const lam_spline_surface *s) {
  if (!s->weights) return 1;
  double far = 0, least = INFINITY;
  for (int i = 0; i < s->count[0] * s->count[1]; i++) {
    far = fmax(far, lam_length(s->points[i]));
    least = fmin(least, s->weights[i]);
  }
  return (1 + far) / least;
}

/* The deviation is bounded by the largest distance of the control points over common knots. */
lam_spline_surface lam_spline_surface_reduce(lam_arena *arena, const lam_spline_surface *surface,
                                             int direction, int ends, double *deviation) {
  lam_bspline net = lam_spline_surface_net(arena, surface, direction);
  lam_bspline less = lam_bspline_reduce(arena, net, ends, NULL), both[] = {net, less};
  lam_spline_surface result = lam_spline_surface_from_net(arena, surface, direction, less);

  if (!deviation) return result;
  lam_bspline_match(arena, 2, both);
  double factor = fmax(homogeneous_factor(surface), homogeneous_factor(&result));
  *deviation = factor * net_gap(&both[0], &both[1], surface->weights ? 4 : 3);
  return result;
}

/* Every removal is measured by putting the knot back; the moves add up to at most the
 * tolerance. */
int lam_spline_surface_remove(lam_arena *arena, lam_spline_surface *surface, int direction,
                              double t, int times, double tolerance) {
  lam_bspline net = lam_spline_surface_net(arena, surface, direction), less;
  double factor = homogeneous_factor(surface), left = tolerance;
  int removed = 0, n = surface->weights ? 4 : 3;

  while (removed < times && lam_bspline_remove(arena, net, t, INFINITY, &less, NULL)) {
    lam_bspline again = lam_bspline_insert(arena, less, t, lam_bspline_multiplicity(&net, t));
    double moved = factor * net_gap(&net, &again, n);
    if (!(moved <= left)) break;
    left -= moved;
    net = less;
    removed++;
  }

  if (removed) *surface = lam_spline_surface_from_net(arena, surface, direction, net);
  return removed;
}

/* 1 as a spline with the knots of s. */
static lam_bspline one_like(lam_arena *arena, lam_bspline s) {
  double *ones = LAM_NEW(arena, double, s.count);
  for (int i = 0; i < s.count; i++) ones[i] = 1;
  s.values = ones;
  return s;
}

/* su(u) sv(v) x(u,v), one direction after the other. For a surface without weights. */
static lam_spline_surface multiply(lam_arena *arena, lam_bspline su, lam_bspline sv,
                                   lam_spline_surface s) {
  for (int d = 0; d < 2; d++) {
    lam_bspline net = lam_spline_surface_net(arena, &s, d);
    s = lam_spline_surface_from_net(arena, &s, d, lam_bspline_product(arena, d ? sv : su, net));
  }
  return s;
}

/* As with curves, (w x) s over w: weights are multiplied by 1 with the degrees and the knots of
 * s. */
lam_spline_surface lam_spline_surface_scale(lam_arena *arena, lam_bspline su, lam_bspline sv,
                                            const lam_spline_surface *surface) {
  if (!surface->weights) return multiply(arena, su, sv, *surface);

  int total = surface->count[0] * surface->count[1];
  lam_spline_surface above = *surface, below = *surface; /* w x and (w, 0, 0) */
  lam_vec3 *wx = LAM_NEW(arena, lam_vec3, total), *w = LAM_NEW(arena, lam_vec3, total);
  for (int i = 0; i < total; i++) {
    wx[i] = lam_scale(surface->points[i], surface->weights[i]);
    w[i] = lam_v3(surface->weights[i], 0, 0);
  }
  above.points = wx;
  below.points = w;
  above.weights = below.weights = NULL;

  above = multiply(arena, su, sv, above);
  below = multiply(arena, one_like(arena, su), one_like(arena, sv), below);

  total = above.count[0] * above.count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, total);
  double *weights = LAM_NEW(arena, double, total);
  for (int i = 0; i < total; i++) {
    weights[i] = below.points[i].x;
    points[i] = lam_scale(above.points[i], 1 / weights[i]);
  }

  above.points = points;
  above.weights = weights;
  return above;
}

/* Points are moved as those of a curve; affine maps keep weights and knots. */
lam_spline_surface lam_spline_surface_map(lam_arena *arena, const lam_spline_surface *surface,
                                          lam_pose frame) {
  lam_spline_curve net = {.count = surface->count[0] * surface->count[1],
                          .points = surface->points};
  lam_spline_surface image = *surface;
  image.points = lam_spline_curve_map(arena, net, frame).points;
  return image;
}

/* Only the knots change. */
lam_spline_surface lam_spline_surface_move_domain(lam_arena *arena,
                                                  const lam_spline_surface *surface, int direction,
                                                  double low, double high) {
  lam_spline_surface moved = *surface;
  lam_bspline net = {surface->degree[direction], surface->count[direction], 0,
                     surface->knots[direction], NULL};
  moved.knots[direction] = lam_bspline_move_domain(arena, net, low, high).knots;
  return moved;
}

/* The value of the net at t is the row of homogeneous points of the line. */
lam_spline_curve lam_spline_surface_line(lam_arena *arena, const lam_spline_surface *surface,
                                         int direction, double t) {
  int across = 1 - direction, n = surface->weights ? 4 : 3;
  lam_bspline net = lam_spline_surface_net(arena, surface, direction);

  double *values = LAM_NEW(arena, double, net.dimension);
  lam_bspline_eval(&net, t, 0, values);
  return lam_spline_curve_from_net(arena,
                                   (lam_bspline){surface->degree[across], surface->count[across], n,
                                                 surface->knots[across], values});
}
