/* The method minimax: the largest |K| is made least. Called by developable_solve.c; each power is
 * minimized by developable_newton.c.
 *
 * As p rises to some thousands, the minimum of log ||K||_p over a grid with the edges leads to that
 * of the maximum. Over N nodes of equal weight the norm is at most N^(1/p) times less than the
 * maximum; the last power leaves about a ten-thousandth. High powers take in nodes of a finer grid,
 * those near the largest value, chosen anew until no other node has risen above them. It stops
 * early where the bound is met that the boundary sets at its corners: nothing is below it. */
#include "surf/developable/developable_parts.h"

/* Nodes along a single patch of the coarse and of the fine grid; how often peaks are chosen. */
enum { COARSE = 48, FINE = 256, MOST_CHOICES = 5 };

/* Powers; from `fine_from` on the peaks of the fine grid are taken in. */
static const double first_power = 4, last_power = 16384, factor = 4, fine_from = 1024;

/* The power from which the bound of the corners is looked at: before, maxima elsewhere are still
 * being lowered. */
static const double bound_from = 256;

/* |K|^p of nodes that are left out, as a share of that of the largest. */
static const double negligible = 1e-12;

/* Nodes per span where a single patch has `along`. */
static int per_span(const lam_spline_surface *s, int along) {
  return lam_developing_nodes(s, along / lam_spline_spans(s) + 1);
}

/* The largest |K| at the nodes of a norm, 1/m^2. */
static double largest(const lam_developing *d, const lam_gauss_norm *norm) {
  return lam_gauss_norm_eval(norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL).max;
}

/* Moves the surface to the minimum of the current power over the nodes of a norm. */
static void lower(lam_developing *d, const lam_gauss_norm *norm) {
  lam_gauss_value here = lam_gauss_norm_eval(norm, d->x, 2, 1, LAM_ORDER_VALUE, NULL, NULL);
  d->norm = norm;
  d->area = here.area;
  d->scale = here.max;
  lam_developable_newton(d, 0);
}

/* The same with the peaks of the fine grid added to the coarse one. Lowering them may raise others:
 * they are chosen anew until none stands above what was reached. */
static void lower_with_peaks(lam_developing *d, const lam_spline_surface *s,
                             const lam_gauss_norm *coarse) {
  double below = 0;
  for (int k = 0; k < MOST_CHOICES; k++) {
    lam_gauss_norm peaks =
        lam_gauss_norm_closed(d->arena, s, per_span(s, FINE), d->x, pow(negligible, 1 / d->power));
    if (largest(d, &peaks) <= below * (1 + 1e-6)) break;

    lam_gauss_norm both = lam_gauss_norm_join(d->arena, coarse, &peaks);
    lower(d, &both);
    below = d->scale;
  }
}

/* Powers 4, 16, 64 ... in turn, each from the minimum of the last. */
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
