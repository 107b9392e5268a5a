/* Splines as Bezier pieces and back. Called by bspline_degree.c and bspline_product.c, which work
 * piece by piece, by curve/curve_edit.c, curve/closest_on_curve.c, and by surf. */
#include "curve/bspline/basis.h"
#include "curve/bspline/bspline.h"
#include <string.h>

/* Whether t is in the list. */
static int contains(const double *list, int count, double t) {
  for (int i = 0; i < count; i++)
    if (list[i] == t) return 1;
  return 0;
}

/* The distinct knots of the domain and the further breaks, ascending. */
static int list_breaks(const lam_bspline *f, int extra_count, const double *extra, double *breaks) {
  double low = f->knots[f->degree], high = f->knots[f->count];
  int count = 0, e = 0;
  for (int i = f->degree; i <= f->count; i++) {
    for (; e < extra_count && extra[e] < f->knots[i]; e++)
      if (extra[e] > low && extra[e] < high && !contains(breaks, count, extra[e]))
        breaks[count++] = extra[e];
    if (count == 0 || f->knots[i] > breaks[count - 1]) breaks[count++] = f->knots[i];
  }
  return count;
}

/* Every break becomes a knot of multiplicity p: then the coefficients between two breaks are the
 * Bezier points of the piece (Piegl & Tiller, The NURBS Book, 5.3). */
lam_pieces lam_bspline_pieces(lam_arena *arena, lam_bspline f, int extra_count,
                              const double *extra) {
  int p = f.degree, n = f.dimension;
  double *breaks = LAM_NEW(arena, double, f.count + extra_count + 1);
  int count = list_breaks(&f, extra_count, extra, breaks) - 1;
  int *times = LAM_NEW(arena, int, count + 1);
  for (int k = 1; k < count; k++) times[k] = lam_bspline_multiplicity(&f, breaks[k]);
  times[0] = times[count] = p + 1;

  f = lam_bspline_clamp(arena, f);
  f = lam_bspline_insert_all(arena, f, count - 1, breaks + 1, p);

  /* Degree 0: insertion to multiplicity 0 does nothing, a piece is one value. */
  double *values = LAM_NEW(arena, double, count *(p + 1) * n);
  for (int k = 0; k < count; k++)
    memcpy(values + k * (p + 1) * n, f.values + k * (p > 0 ? p : 1) * n,
           (size_t)((p + 1) * n) * sizeof *values);

  return (lam_pieces){p, count, n, breaks, values, times};
}

/* The value of the symmetric multi-affine form (blossom) of Bezier piece k at `degree` arguments:
 * de Casteljau's algorithm with a different argument in every step. result: dimension; work:
 * degree + 1 points. */
static void eval_blossom(const lam_pieces *pieces, int k, const double *arguments, double *result,
                         double *work) {
  int p = pieces->degree, n = pieces->dimension;
  double low = pieces->breaks[k], size = pieces->breaks[k + 1] - low;
  memcpy(work, pieces->values + (size_t)k * (p + 1) * n, (size_t)((p + 1) * n) * sizeof *work);
  for (int r = 0; r < p; r++) {
    double t = (arguments[r] - low) / size;
    for (int i = 0; i < (p - r) * n; i++) work[i] = (1 - t) * work[i] + t * work[i + n];
  }
  memcpy(result, work, (size_t)n * sizeof *work);
}

/* Each coefficient is the blossom of a piece at the inner knots of its function (L. Ramshaw,
 * 1987); the piece in which the average of these knots lies is one that the function reaches. */
lam_bspline lam_bspline_from_pieces(lam_arena *arena, const lam_pieces *pieces) {
  int p = pieces->degree, n = pieces->dimension, count = p + 1;
  for (int k = 1; k < pieces->count; k++) count += pieces->multiplicity[k];
  double *knots = LAM_NEW(arena, double, count + p + 1), *values = LAM_NEW(arena, double, count *n);
  double *work = LAM_NEW(arena, double, (p + 1) * n);

  int at = 0;
  for (int k = 0; k <= pieces->count; k++) {
    int times = k == 0 || k == pieces->count ? p + 1 : pieces->multiplicity[k];
    for (int i = 0; i < times; i++) knots[at++] = pieces->breaks[k];
  }

  for (int i = 0, k = 0; i < count; i++) {
    double average = 0;
    for (int r = 1; r <= p; r++) average += knots[i + r] / p;
    while (k < pieces->count - 1 && pieces->breaks[k + 1] <= average) k++;
    eval_blossom(pieces, k, knots + i + 1, values + i * n, work);
  }

  return (lam_bspline){p, count, n, knots, values};
}
