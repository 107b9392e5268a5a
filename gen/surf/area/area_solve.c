/* First surfaces, and minimization from coarse to fine: chooses among the methods in
 * area_newton.c, majorize.c and lbfgs.c. Called by least_area.c, area_paper.c and the benchmark. */
#include "surf/area/area_parts.h"
#include <string.h>

/* Nodes of the quadrature along a direction, at least: of coarse surfaces, which are only
 * starts, and of the last one. */
enum { coarse = 20, fine = 48 };

lam_least_area_options lam_least_area_defaults(void) {
  return (lam_least_area_options){.method = LAM_LEAST_AREA_NEWTON, .tolerance = 1e-9, .most = 100};
}

/* Whether (i, j) is in the outermost ring of the net. */
static bool on_boundary(const lam_spline_surface *s, int i, int j) {
  return i == 0 || j == 0 || i == s->count[0] - 1 || j == s->count[1] - 1;
}

/* The surface with inner weights of 1 or separable ones; without weights it stays as it is. */
static lam_spline_surface with_weights(lam_arena *arena, const lam_spline_surface *surface,
                                       bool separable) {
  lam_spline_surface result = *surface;
  int m = surface->count[0], n = surface->count[1];
  const double *w = surface->weights;
  if (!w) return result;

  double *weights = LAM_NEW(arena, double, m *n);
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++)
      weights[i * n + j] = on_boundary(surface, i, j) ? w[i * n + j]
                           : separable                ? w[i * n] * w[j] / w[0]
                                                      : 1;
  result.weights = weights;
  return result;
}

lam_spline_surface lam_least_area_unit_weights(lam_arena *arena,
                                               const lam_spline_surface *surface) {
  return with_weights(arena, surface, false);
}
lam_spline_surface lam_least_area_separable_weights(lam_arena *arena,
                                                    const lam_spline_surface *surface) {
  return with_weights(arena, surface, true);
}

/* The energy is quadratic: one Newton step from inner points at the origin. */
lam_spline_surface lam_least_area_dirichlet(lam_arena *arena, const lam_spline_surface *surface) {
  lam_spline_surface result = *surface;
  int all = surface->count[0] * surface->count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  for (int k = 0; k < all; k++)
    if (on_boundary(surface, k / surface->count[1], k % surface->count[1]))
      points[k] = surface->points[k];
  result.points = points;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_area_form *form = lam_area_form_make(arena, surface, 0, lam_area_node_count(surface, fine));
  lam_area_system system = lam_area_system_make(arena, form, 1);
  lam_vec3 *step = LAM_NEW(arena, lam_vec3, system.size);

  lam_area_dirichlet(form, points);
  lam_area_system_factor(&system, form, 0); /* positive definite: the functions are independent */
  lam_area_system_step(arena, &system, form->gradient, step);
  lam_area_move(form, points, 1, step, points);
  lam_arena_release(arena, mark);
  return result;
}

/* Minimizes from the start's own points by the method of the options, with at least `along`
 * nodes along a direction. The area of the result is without the volume of a mean curvature. */
static lam_least_area_result minimize(lam_arena *arena, const lam_spline_surface *start,
                                      const lam_least_area_options *options, int along) {
  int all = start->count[0] * start->count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  memcpy(points, start->points, (size_t)all * sizeof *points);
  lam_least_area_result result = {
      .surface = *start, .reason = "as many steps as allowed", .fall = INFINITY};
  result.surface.points = points;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_area_form *form = lam_area_form_make(arena, start, 0, lam_area_node_count(start, along));
  if (options->method == LAM_LEAST_AREA_NEWTON) lam_area_form_coarsen(arena, form);
  result.area = lam_area_value(form, points);
  form->mean_curvature = options->mean_curvature;

  static void (*const methods[])(lam_arena *, const lam_area_form *, const lam_least_area_options *,
                                 lam_vec3 *, lam_least_area_result *) = {
      lam_area_newton, lam_area_majorize, lam_area_lbfgs};
  methods[options->method](arena, form, options, points, &result);

  form->mean_curvature = 0;
  result.area = lam_area_value(form, points);
  lam_arena_release(arena, mark);
  return result;
}

lam_least_area_result lam_least_area_minimize(lam_arena *arena, const lam_spline_surface *start,
                                              const lam_least_area_options *options) {
  return minimize(arena, start, options, fine);
}

/* Spans 1, 2, 4 ...; the last level has as many as are asked for. */
lam_least_area_result lam_least_area_solve(lam_arena *arena, const lam_spline_surface *boundary,
                                           int spans, const lam_least_area_options *options) {
  lam_spline_surface start = lam_least_area_dirichlet(arena, boundary);
  lam_least_area_options rough = *options; /* the coarse surfaces are only starts */
  rough.accept_saddles = true;
  rough.tolerance = spans > 1 && options->tolerance < 1e-5 ? 1e-5 : options->tolerance;

  lam_least_area_result sum =
      minimize(arena, &start, spans > 1 ? &rough : options, spans > 1 ? coarse : fine);
  for (int level = 2, last = 1; last < spans; last = level, level *= 2) {
    if (level > spans) level = spans;
    lam_spline_surface finer = lam_spline_surface_refine(arena, &sum.surface, level);
    lam_least_area_result next =
        minimize(arena, &finer, level == spans ? options : &rough, level == spans ? fine : coarse);

    next.iterations += sum.iterations;
    next.evaluations += sum.evaluations;
    next.saddles += sum.saddles;
    sum = next;
  }
  return sum;
}
