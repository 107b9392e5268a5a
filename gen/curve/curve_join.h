/* How smoothly two curves join. Part of the curve kernel, called by its users only
 * (tests/unit/curve/test_curve_geometry.c); surf/spline/surface_join.c is its like for surfaces. */
#ifndef LAM_CURVE_CURVE_JOIN_H
#define LAM_CURVE_CURVE_JOIN_H

#include "core/model.h"

/* What two curves share where one ends and the next begins. G1: Q' = alpha P' with alpha > 0. G2:
 * also Q'' = alpha^2 P'' + beta P', which says that the curvature vectors agree; C2 is alpha = 1,
 * beta = 0. (That the second derivatives point the same way is not enough for G2.) */
typedef struct lam_join {
  int parametric, geometric; /* the largest n <= 2 with C^n and G^n; -1: the curves do not meet */
  const char *name[2];       /* "C1" and "G2", for instance; "none" for -1 */
  double alpha, beta;        /* best fit along P'; NaN where P' is zero */
  double gap;                /* |Q - P|, m */
  double kink;               /* angle between the tangents, rad */
  double curvature_gap;      /* |curvature vector of Q - that of P|, 1/m */
  double derivative_gap[2];  /* |Q' - P'| and |Q'' - P''|, m per parameter */
  /* The first condition that fails, for C^n and for G^n, as a sentence; NULL when none does. */
  const char *fails[2];
} lam_join;

/* Compares two ends. Static texts; nothing is allocated.
 *
 * end, start  point, first and second derivative of the first curve at its end and of the second
 *             at its start
 * size        extent of the curves, m
 * tolerance   relative: lengths to size, angles in radians, derivatives to their own size,
 *             curvatures to 1 / size or the curvature, whichever is larger */
lam_join lam_join_test(const lam_vec3 end[3], const lam_vec3 start[3], double size,
                       double tolerance);
/* The end of the first curve against the start of the second; size is the largest distance of a
 * control point from the end that joins. */
lam_join lam_join_curves(const lam_spline_curve *first, const lam_spline_curve *second,
                         double tolerance);

#endif
