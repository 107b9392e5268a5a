/* The point of a spline curve nearest to a given point. Used by surf/spline/surface_join.c. */
#ifndef LAM_CURVE_CLOSEST_ON_CURVE_H
#define LAM_CURVE_CLOSEST_ON_CURVE_H

#include "curve/curve.h"

typedef struct lam_closest {
  double t, distance; /* parameter; distance to the given point, m */
  lam_vec3 point;
} lam_closest;

/* The nearest of all points: Bezier pieces are halved as long as the box of their control points
 * is nearer than the best point so far, and Newton's method finishes. Of several nearest points
 * one is returned. The arena is only used while it works. Preconditions: lam_spline_curve_problem
 * returns NULL, point is finite. */
lam_closest lam_spline_curve_closest(lam_arena *arena, const lam_spline_curve *curve,
                                     lam_vec3 point);

#endif
