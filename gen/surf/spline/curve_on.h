/* Curves on spline surfaces. Part of the surface kernel; no stage of a design calls it, the
 * unit tests do. */
#ifndef LAM_SURF_SPLINE_CURVE_ON_H
#define LAM_SURF_SPLINE_CURVE_ON_H

#include "curve/curve.h"

/* The curve x(u(t), v(t)) with derivatives up to the third, for arc length (curve/length.h),
 * frames (curve/frenet.h) and fairness (curve/curve_fairness.h).
 *
 * surface  kept by pointer
 * plane    gives u as x and v as y of its points; kept by pointer
 *
 * Breaks are the inner knots of `plane`; where it crosses knots of the surface, the curve is as
 * smooth as the surface there. */
lam_curve lam_curve_on_surface(lam_arena *arena, const lam_spline_surface *surface,
                               const lam_spline_curve *plane);

#endif
