/* Cubic pieces in their three forms: geometric (Hermite, Ferguson), algebraic and Bezier; all
 * over [0,1]. Exact conversions between them; surf/spline/ferguson.c uses the Bezier form.
 * Nothing here allocates. */
#ifndef LAM_CURVE_HERMITE_H
#define LAM_CURVE_HERMITE_H

#include "core/vec3.h"

/* End points and end derivatives: x(t) = F0 p[0] + F1 p[1] + G0 d[0] + G1 d[1]. */
typedef struct lam_hermite {
  lam_vec3 p[2], d[2];
} lam_hermite;

/* F0, F1, G0, G1 at t:
 *   F0 = 2t^3 - 3t^2 + 1, F1 = -2t^3 + 3t^2, G0 = t^3 - 2t^2 + t, G1 = t^3 - t^2. */
void lam_hermite_basis(double t, double values[4]);
/* The point of the piece at t. */
lam_vec3 lam_hermite_eval(const lam_hermite *piece, double t);

/* The algebraic form x(t) = a[0] + a[1] t + a[2] t^2 + a[3] t^3, and back. */
void lam_hermite_to_algebraic(const lam_hermite *piece, lam_vec3 a[4]);
lam_hermite lam_hermite_from_algebraic(const lam_vec3 a[4]);
/* The Bezier points b[0 .. 3], and back. */
void lam_hermite_to_bezier(const lam_hermite *piece, lam_vec3 b[4]);
lam_hermite lam_hermite_from_bezier(const lam_vec3 b[4]);

/* Between powers and Bernstein polynomials of any degree over [0,1]; coefficients[0 .. degree]
 * are replaced. */
void lam_bernstein_from_powers(int degree, lam_vec3 *coefficients);
void lam_bernstein_to_powers(int degree, lam_vec3 *coefficients);

/* The coefficients a[0 .. count - 1] of the polynomial a[0] + a[1] x + ... through the count
 * points (x[i], y[i]): the line through two, the parabola through three. Newton's divided
 * differences. Preconditions: count >= 1, all x differ, a is not y. */
void lam_polynomial_through(int count, const double *x, const double *y, double *a);

#endif
