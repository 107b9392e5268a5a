/* Cubic pieces in their three forms, and polynomials in powers and Bernstein polynomials. The
 * Bezier form is called by surf/spline/ferguson.c; the rest is part of the curve kernel and
 * called by its users only (tests/unit/curve/test_curve_geometry.c). */
#include "curve/hermite.h"

/* F0, F1, G0, G1 in factored form: free of cancellation at both ends. */
void lam_hermite_basis(double t, double values[4]) {
  double s = 1 - t;
  values[0] = s * s * (1 + 2 * t);
  values[1] = t * t * (3 - 2 * t);
  values[2] = s * s * t;
  values[3] = -s * t * t;
}

/* F0 p0 + F1 p1 + G0 d0 + G1 d1. */
lam_vec3 lam_hermite_eval(const lam_hermite *piece, double t) {
  double f[4];
  lam_hermite_basis(t, f);
  lam_vec3 x = lam_along(lam_scale(piece->p[0], f[0]), f[1], piece->p[1]);
  return lam_along(lam_along(x, f[2], piece->d[0]), f[3], piece->d[1]);
}

/* a2 = 3 (p1 - p0) - 2 d0 - d1, a3 = d0 + d1 - 2 (p1 - p0). */
void lam_hermite_to_algebraic(const lam_hermite *piece, lam_vec3 a[4]) {
  lam_vec3 rise = lam_sub(piece->p[1], piece->p[0]), sum = lam_add(piece->d[0], piece->d[1]);
  a[0] = piece->p[0];
  a[1] = piece->d[0];
  a[2] = lam_sub(lam_scale(rise, 3), lam_add(sum, piece->d[0]));
  a[3] = lam_sub(sum, lam_scale(rise, 2));
}

/* x(1) is the sum of the coefficients, x'(1) = a1 + 2 a2 + 3 a3. */
lam_hermite lam_hermite_from_algebraic(const lam_vec3 a[4]) {
  lam_vec3 end = lam_add(lam_add(a[0], a[1]), lam_add(a[2], a[3]));
  lam_vec3 slope = lam_along(lam_along(a[1], 2, a[2]), 3, a[3]);
  return (lam_hermite){{a[0], end}, {a[1], slope}};
}

/* The inner points lie a third of the end derivatives away from the ends. */
void lam_hermite_to_bezier(const lam_hermite *piece, lam_vec3 b[4]) {
  b[0] = piece->p[0];
  b[1] = lam_along(piece->p[0], 1.0 / 3, piece->d[0]);
  b[2] = lam_along(piece->p[1], -1.0 / 3, piece->d[1]);
  b[3] = piece->p[1];
}

lam_hermite lam_hermite_from_bezier(const lam_vec3 b[4]) {
  return (lam_hermite){{b[0], b[3]},
                       {lam_scale(lam_sub(b[1], b[0]), 3), lam_scale(lam_sub(b[3], b[2]), 3)}};
}

/* t^i = sum_{j >= i} C(j,i) / C(n,i) B_j. So c_i is divided by C(n,i) first; the sums with the
 * factors C(j,i) are built up as in Pascal's triangle, by additions of neighbors only. */
void lam_bernstein_from_powers(int degree, lam_vec3 *c) {
  double binomial = 1;
  for (int i = 0; i <= degree; i++) {
    c[i] = lam_scale(c[i], 1 / binomial);
    binomial = binomial * (degree - i) / (i + 1);
  }

  for (int k = 1; k <= degree; k++)
    for (int j = degree; j >= k; j--) c[j] = lam_add(c[j], c[j - 1]);
}

/* The steps of lam_bernstein_from_powers undone, in reverse order. */
void lam_bernstein_to_powers(int degree, lam_vec3 *c) {
  for (int k = degree; k >= 1; k--)
    for (int j = k; j <= degree; j++) c[j] = lam_sub(c[j], c[j - 1]);

  double binomial = 1;
  for (int i = 0; i <= degree; i++) {
    c[i] = lam_scale(c[i], binomial);
    binomial = binomial * (degree - i) / (i + 1);
  }
}

/* Divided differences in place; then Newton's nested form a_k + (x - x_k)(...) is turned into
 * powers, from the inside out. */
void lam_polynomial_through(int count, const double *x, const double *y, double *a) {
  for (int i = 0; i < count; i++) a[i] = y[i];
  for (int k = 1; k < count; k++)
    for (int i = count - 1; i >= k; i--) a[i] = (a[i] - a[i - 1]) / (x[i] - x[i - k]);

  for (int k = count - 2; k >= 0; k--)
    for (int i = k; i < count - 1; i++) a[i] -= x[k] * a[i + 1];
}
