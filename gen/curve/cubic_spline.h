/* Interpolating cubic splines, twice continuously differentiable, with values of any dimension.
 * Used for profiles (surf/kinds/revolution.c) and for trajectories (net/kinds/molding_net.c). */
#ifndef LAM_CURVE_CUBIC_SPLINE_H
#define LAM_CURVE_CUBIC_SPLINE_H

#include "core/arena.h"

typedef struct lam_spline {
  int count, dimension;
  const double *t;      /* count parameters, increasing */
  const double *values; /* count * dimension: the points, one after the other */
  const double *second; /* count * dimension: second derivatives at the points */
} lam_spline;

/* The cubic spline through the points with not-a-knot ends (the first two pieces are one cubic,
 * and the last two); the parabola through three points, the line through two. t[count] and
 * values[count x dimension] are kept by pointer and must live as long as the spline.
 * Preconditions: count >= 2, t increases. */
lam_spline lam_spline_make(lam_arena *arena, int count, int dimension, const double *t,
                           const double *values);

/* Value, first and second derivative at t, `dimension` entries each. Beyond the ends the end
 * pieces continue. */
void lam_spline_eval(const lam_spline *spline, double t, double *x, double *dx, double *ddx);

#endif
