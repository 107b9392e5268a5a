/* Products of splines, piece by piece. Called by curve/curve_edit.c and by surf/spline.
 *
 * With Bernstein coefficients s_i of degree p and f_j of degree q, the product has the
 * coefficients
 *   c_k = sum_{i+j=k} C(p,i) C(q,j) / C(p+q,k) s_i f_j. */
#include "curve/bspline/basis.h"
#include "curve/bspline/bspline.h"
#include <assert.h>

/* C(n, k); exact, as n is at most LAM_BASIS_MAX_DEGREE. */
static double binomial(int n, int k) {
  double b = 1;
  for (int i = 1; i <= k; i++) b = b * (n - k + i) / i;
  return b;
}

/* Adds the product of two Bezier pieces to product, (p + q + 1) x dimension. */
static void multiply(int p, const double *s, int q, int dimension, const double *f,
                     double *product) {
  for (int i = 0; i <= p; i++)
    for (int j = 0; j <= q; j++) {
      double factor = binomial(p, i) * binomial(q, j) / binomial(p + q, i + j) * s[i];
      for (int d = 0; d < dimension; d++)
        product[(i + j) * dimension + d] += factor * f[j * dimension + d];
    }
}

/* Both factors are cut at the knots of both, so that their pieces correspond. At a knot of
 * multiplicity m a factor of degree p has p - m continuous derivatives; the product of degree p +
 * q keeps as many with multiplicity m + q. */
lam_bspline lam_bspline_product(lam_arena *arena, lam_bspline s, lam_bspline f) {
  int p = s.degree, q = f.degree, degree = p + q, n = f.dimension;
  assert(s.dimension == 1 && degree <= LAM_BASIS_MAX_DEGREE);

  lam_pieces a = lam_bspline_pieces(arena, s, f.count + q + 1, f.knots);
  lam_pieces b = lam_bspline_pieces(arena, f, a.count + 1, a.breaks);

  double *values = LAM_NEW(arena, double, b.count *(degree + 1) * n);
  int *times = LAM_NEW(arena, int, b.count + 1);
  for (int k = 0; k < b.count; k++) {
    multiply(p, a.values + k * (p + 1), q, n, b.values + (size_t)k * (q + 1) * n,
             values + (size_t)k * (degree + 1) * n);
    int from_s = a.multiplicity[k] ? a.multiplicity[k] + q : 0,
        from_f = b.multiplicity[k] ? b.multiplicity[k] + p : 0;
    times[k] = from_s > from_f ? from_s : from_f;
  }

  return lam_bspline_from_pieces(arena, &(lam_pieces){degree, b.count, n, b.breaks, values, times});
}
