/* The point of a spline curve nearest to a given point. */
#ifndef LAM_CURVE_CLOSEST_ON_CURVE_H
#define LAM_CURVE_CLOSEST_ON_CURVE_H

#include "curve/curve.h"

typedef struct lam_closest {
  double t, distance; /* m */
  lam_vec3 point;
} lam_closest;

/* The nearest of all points: Bezier pieces are halved as long as the box of their control points is
 * nearer than the best point so far, and Newton's method finishes. Of several nearest points one is
 * returned. */
lam_closest lam_spline_curve_closest(lam_arena *arena, const lam_spline_curve *curve,
                                     lam_vec3 point);

#endif
