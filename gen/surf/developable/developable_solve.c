/* Approximately developable surfaces: the rules and powers that are gone through. */
#include "surf/developable/developable_parts.h"
#include <string.h>

void lam_developing_try(const lam_developing *d, const double *step) {
  for (int i = 0; i < d->total; i++) {
    int k = d->norm->unknown[i];
    d->trial[i] = k < 0 ? d->x[i] : lam_add(d->x[i], lam_v3(step[k], step[k + 1], step[k + 2]));
  }
}

bool lam_developing_sound(const lam_developing *d, const lam_gauss_value *value) {
  return isfinite(value->power) && value->ratio > 1e-4 && value->area < 4 * d->area;
}

int lam_spline_spans(const lam_spline_surface *s) {
  int most = 0;
  for (int d = 0; d < 2; d++) {
    int count = 0;
    for (int k = s->degree[d]; k < s->count[d]; k++) count += s->knots[d][k] < s->knots[d][k + 1];
    most = count > most ? count : most;
  }
  return most;
}

/* Gauss points per span of the last steps: `along` on a single patch, always more than the degree
 * asks for. */
static int default_points(const lam_spline_surface *s, int along) {
  int degree = s->degree[0] > s->degree[1] ? s->degree[0] : s->degree[1],
      spans = lam_spline_spans(s);
  int each = (along + spans - 1) / spans;
  return each > 2 * degree + 4 ? each : 2 * degree + 4;
}

static bool by_newton(const lam_developable_options *options) {
  return options->method == LAM_DEVELOPABLE_NEWTON || options->method == LAM_DEVELOPABLE_MINIMAX;
}

static void minimize(lam_developing *d, const lam_developable_options *options,
                     int gauss_newton_steps) {
  if (by_newton(options))
    lam_developable_newton(d, gauss_newton_steps);
  else
    lam_developable_paper(d, options->method == LAM_DEVELOPABLE_TRUST_REGION);
}

bool lam_developing_curved(lam_developing *d) {
  d->scale = lam_gauss_norm_eval(d->norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL).max;
  return d->scale * d->size * d->size > 1e-10;
}

/* The minima of powers 2, 4, 8 ... lead to that of a high power. */
static void raise_power(lam_developing *d, const lam_developable_options *options) {
  d->logarithm = by_newton(options);
  for (double p = fmin(4, options->power); lam_developing_curved(d);
       p = fmin(2 * p, options->power)) {
    d->power = p;
    minimize(d, options, 0);
    if (p >= options->power) return;
  }
}

/* What the boundary tells of size. */
static double box_size(int count, const lam_vec3 *x) {
  lam_vec3 low = x[0], high = x[0];
  for (int i = 1; i < count; i++) {
    low = lam_v3(fmin(low.x, x[i].x), fmin(low.y, x[i].y), fmin(low.z, x[i].z));
    high = lam_v3(fmax(high.x, x[i].x), fmax(high.y, x[i].y), fmax(high.z, x[i].z));
  }
  return lam_distance(low, high);
}

/* Power 2, by Newton's method with half the places first. */
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
  lam_developing d = {.arena = arena, .norm = &last, .total = total, .power = 2, .result = &result};
  d.x = LAM_NEW(arena, lam_vec3, total);
  d.trial = LAM_NEW(arena, lam_vec3, total);
  d.max_iterations = options.max_iterations ? options.max_iterations : 500;
  memcpy(d.x, x, (size_t)total * sizeof *x);
  d.size = box_size(total, x);
  lam_gauss_value start = lam_gauss_norm_eval(&last, d.x, 2, 1, LAM_ORDER_VALUE, NULL, NULL);
  d.area = start.area;
  d.scale = sqrt(start.power);
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
