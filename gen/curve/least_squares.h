/* Spline curves near points (Piegl & Tiller, The NURBS Book, 9.4.1). lam_fit_knots is used by
 * surf/spline/spline_near.c too; the fits are part of the curve kernel. */
#ifndef LAM_CURVE_LEAST_SQUARES_H
#define LAM_CURVE_LEAST_SQUARES_H

#include "curve/curve.h"

/* How far the points are from the curve at their parameters, m. */
typedef struct lam_fit_error {
  double max, rms;
} lam_fit_error;

/* count + degree + 1 clamped knots for n ascending parameters t, so that every piece holds about
 * as many of them; owned by the arena. Preconditions: degree < count <= n. */
double *lam_fit_knots(lam_arena *arena, int degree, int count, int n, const double *t);

/* The curve with `count` control points through the first and the last of n points and nearest to
 * all others at parameters t (sum of squares).
 *
 * knots  count + degree + 1; NULL: chosen by lam_fit_knots
 * t      n parameters, increasing, spanning the domain of the knots
 * curve  not set when the result is false
 * error  may be NULL
 *
 * False when the knots leave a function without points. Preconditions: degree < count <= n. */
bool lam_fit_curve(lam_arena *arena, int degree, int count, const double *knots, int n,
                   const double *t, const lam_vec3 *points, lam_spline_curve *curve,
                   lam_fit_error *error);
/* The same with the fewest control points (of those that were tried: one more at a time) whose
 * largest error is at most tolerance (m); count = n interpolates, so there is one. error may be
 * NULL. */
lam_spline_curve lam_fit_curve_within(lam_arena *arena, int degree, double tolerance, int n,
                                      const double *t, const lam_vec3 *points,
                                      lam_fit_error *error);

#endif
