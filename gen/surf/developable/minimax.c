/* The largest |K| is made least: as p rises to some thousands, the minimum of log ||K||_p over a
 * grid with the edges leads to that of the maximum. Over N places of equal weight the norm is at
 * most N^(1/p) times less than the maximum; the last power leaves about a ten-thousandth. High
 * powers take in places of a finer grid, those near the largest value, chosen anew until no other
 * place has risen above them. Nothing is gained any more where the bound is met that the boundary
 * sets at its corners. */
#include "surf/developable/developable_parts.h"

enum { COARSE = 48, FINE = 256, MOST_CHOICES = 5 };
static const double first_power = 4, last_power = 16384, factor = 4, fine_from = 1024;
static const double bound_from = 256; /* before, other maxima are still being lowered */
static const double nothing =
    1e-12; /* K^p of the places that are left out, against that of the largest */

/* Places per span where a single patch has `along`. */
static int per_span(const lam_spline_surface *s, int along) {
  int degree = s->degree[0] > s->degree[1] ? s->degree[0] : s->degree[1],
      each = along / lam_spline_spans(s) + 1;
  return each > 2 * degree + 4 ? each : 2 * degree + 4;
}

static double largest(const lam_developing *d, const lam_gauss_norm *norm) {
  return lam_gauss_norm_eval(norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL).max;
}

/* The minimum of one power over the places of a norm. */
static void lower(lam_developing *d, const lam_gauss_norm *norm) {
  lam_gauss_value here = lam_gauss_norm_eval(norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL);
  d->norm = norm;
  d->area = here.area;
  d->scale = here.max;
  lam_developable_newton(d, 0);
}

static void lower_with_peaks(lam_developing *d, const lam_spline_surface *s,
                             const lam_gauss_norm *coarse) {
  double below = 0;
  for (int k = 0; k < MOST_CHOICES; k++) {
    lam_gauss_norm peaks =
        lam_gauss_norm_closed(d->arena, s, per_span(s, FINE), d->x, pow(nothing, 1 / d->power));
    if (largest(d, &peaks) <= below * (1 + 1e-6)) break;
    lam_gauss_norm both = lam_gauss_norm_join(d->arena, coarse, &peaks);
    lower(d, &both);
    below = d->scale;
  }
}

void lam_developable_minimax(lam_developing *d, const lam_spline_surface *s) {
  bool curved = lam_developing_curved(d);
  d->result->norm = d->scale;
  if (!curved) return;
  const lam_gauss_norm *before = d->norm,
                       coarse = lam_gauss_norm_closed(d->arena, s, per_span(s, COARSE), NULL, 0);
  double bound = lam_developable_bound(d->arena, s);
  d->logarithm = true;
  for (double p = first_power; p <= last_power; p *= factor) {
    lam_arena_mark mark = lam_arena_mark_get(d->arena);
    d->power = p;
    if (p < fine_from)
      lower(d, &coarse);
    else
      lower_with_peaks(d, s, &coarse);
    lam_arena_release(d->arena, mark);
    if (p >= bound_from && d->scale <= bound * (1 + 1e-6)) break;
  }
  d->norm = before;
  d->result->norm = d->scale;
}
