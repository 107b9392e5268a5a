/* Arc length of curves. */
#ifndef LAM_CURVE_LENGTH_H
#define LAM_CURVE_LENGTH_H

#include "curve/curve.h"

/* The integral of |x'| from t0 to t1, m (negative when t1 < t0), to about `tolerance` relative to
 * the length: Gauss' rule with 12 nodes, on intervals that are halved until two halves agree with
 * their whole. Precondition: t0 and t1 lie in the curve's domain. */
double lam_curve_length(const lam_curve *curve, double t0, double t1, double tolerance);
/* The parameter at the signed distance `length` (m) along the curve from t0, to `tolerance` of
 * the length from t0 to that end of the curve; at the end itself when the curve is shorter.
 * Newton's method inside a bracket. */
double lam_curve_at_length(const lam_curve *curve, double t0, double length, double tolerance);

#endif
