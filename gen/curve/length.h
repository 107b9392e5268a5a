/* Arc length of curves. */
#ifndef LAM_CURVE_LENGTH_H
#define LAM_CURVE_LENGTH_H

#include "curve/curve.h"

/* The integral of |x'| from t0 to t1 (negative when t1 < t0), to about `tolerance` relative to the
 * length: Gauss' rule with 12 places, on intervals that are halved until two halves agree with
 * their whole. */
double lam_curve_length(const lam_curve *curve, double t0, double t1, double tolerance);
/* The parameter at the signed distance `length` along the curve from t0, by Newton's method inside
 * a bracket; at the ends of the curve when it is shorter. */
double lam_curve_at_length(const lam_curve *curve, double t0, double length, double tolerance);

#endif
