/* Approximately developable surfaces from a start: which method, which quadrature and which
 * powers follow each other. Called by developable.c, by the benchmark and by the tests. The
 * methods stand in developable_newton.c, developable_paper.c and minimax.c, their common steps
 * in developing.c. */
#include "surf/developable/developable_parts.h"
#include <string.h>

/* Gauss points per span of the last steps: `along` on a single patch, always more than the degree
 * asks for. */
static int default_points(const lam_spline_surface *s, int along) {
  int spans = lam_spline_spans(s);
  return lam_developing_nodes(s, (along + spans - 1) / spans);
}

/* Minimax starts from a minimum that Newton's method finds, too. */
static bool by_newton(const lam_developable_options *options) {
  return options->method == LAM_DEVELOPABLE_NEWTON || options->method == LAM_DEVELOPABLE_MINIMAX;
}

/* Minimizes the norm of the current power and quadrature from d->x. */
static void minimize(lam_developing *d, const lam_developable_options *options,
                     int gauss_newton_steps) {
  if (by_newton(options))
    lam_developable_newton(d, gauss_newton_steps);
  else
    lam_developable_paper(d, options->method == LAM_DEVELOPABLE_TRUST_REGION);
}

/* The minima of powers 4, 8, 16 ... lead to that of a high power. Ends early at a surface that is
 * developable to rounding. */
static void raise_power(lam_developing *d, const lam_developable_options *options) {
  d->logarithm = by_newton(options);
  for (double p = fmin(4, options->power); lam_developing_curved(d);
       p = fmin(2 * p, options->power)) {
    d->power = p;
    minimize(d, options, 0);
    if (p >= options->power) return;
  }
}

/* The diagonal of the box around count points. */
static double box_size(int count, const lam_vec3 *x) {
  lam_vec3 low = x[0], high = x[0];
  for (int i = 1; i < count; i++) {
    low = lam_v3(fmin(low.x, x[i].x), fmin(low.y, x[i].y), fmin(low.z, x[i].z));
    high = lam_v3(fmax(high.x, x[i].x), fmax(high.y, x[i].y), fmax(high.z, x[i].z));
  }
  return lam_distance(low, high);
}

/* Minimizes power 2; Newton's method gets a start from the quick norm, with half the nodes in each
 * direction. */
static void mean_square(lam_developing *d, const lam_developable_options *options,
                        const lam_gauss_norm *quick) {
  const lam_gauss_norm *last = d->norm;
  int most = d->max_iterations;
  if (by_newton(options)) {
    d->norm = quick;
    d->max_iterations = most < 60 ? most : 60; /* it is only a start */
    minimize(d, options, 8);
  }

  d->norm = last;
  d->max_iterations = most;
  minimize(d, options, 0);
}

/* The state of a minimization that begins at the surface's own points. */
static lam_developing begin(lam_arena *arena, const lam_spline_surface *surface,
                            const lam_developable_options *options, const lam_gauss_norm *norm,
                            lam_developable_result *result) {
  int total = surface->count[0] * surface->count[1];
  lam_developing d = {.arena = arena, .norm = norm, .total = total, .power = 2, .result = result};
  d.x = LAM_NEW(arena, lam_vec3, total);
  d.trial = LAM_NEW(arena, lam_vec3, total);
  d.max_iterations = options->max_iterations ? options->max_iterations : 500;
  memcpy(d.x, surface->points, (size_t)total * sizeof *d.x);
  d.size = box_size(total, d.x);

  lam_gauss_value start = lam_gauss_norm_eval(norm, d.x, 2, 1, LAM_ORDER_VALUE, NULL, NULL);
  d.area = start.area;
  d.scale = sqrt(start.power);
  return d;
}

/* The mean square first, then the power or the maximum that is asked for. */
lam_developable_result lam_developable_solve(lam_arena *arena, lam_spline_surface *surface,
                                             lam_developable_options options) {
  lam_developable_result result = {.converged = true, .reason = "there is no inner control point"};
  bool minimax = options.method == LAM_DEVELOPABLE_MINIMAX;
  int total = surface->count[0] * surface->count[1];
  int fine = options.points ? options.points : default_points(surface, 32);
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, total);
  memcpy(x, surface->points, (size_t)total * sizeof *x);
  surface->points = x;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_gauss_norm last = lam_gauss_norm_make(arena, surface, fine);
  lam_gauss_norm quick = lam_gauss_norm_make(arena, surface, (fine + 1) / 2);
  lam_developing d = begin(arena, surface, &options, &last, &result);

  /* High powers begin at the minimum of the mean square; they ask for more Gauss points. */
  if (last.unknowns && d.scale > 0) {
    mean_square(&d, &options, &quick);
    if (minimax) {
      lam_developable_minimax(&d, surface);
    } else if (options.power > 2) {
      if (!options.points) last = lam_gauss_norm_make(arena, surface, default_points(surface, 64));
      raise_power(&d, &options);
    }
  }

  if (!(d.scale > 0)) d.scale = 1;
  lam_gauss_value end =
      lam_gauss_norm_eval(&last, d.x, d.power, d.scale, LAM_ORDER_VALUE, NULL, NULL);
  if (!minimax) result.norm = d.scale * pow(end.power, 1 / d.power);
  memcpy(x, d.x, (size_t)total * sizeof *x);
  lam_arena_release(arena, mark);
  return result;
}
