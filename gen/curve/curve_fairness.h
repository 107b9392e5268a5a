/* How fair a curve is (curve_fairness.c), and fairing (curve_fairing.c). A planar curve is fair
 * when its curvature is continuous, it has no more inflections than needed, and its curvature
 * changes little. Part of the curve kernel, called by its users only
 * (tests/unit/curve/test_curve_fit.c). */
#ifndef LAM_CURVE_CURVE_FAIRNESS_H
#define LAM_CURVE_CURVE_FAIRNESS_H

#include "curve/curve.h"

typedef struct lam_fairness {
  int inflections; /* changes of the side to which the curve turns, in its plane of best fit */
  double bending;  /* integral of curvature^2 ds, 1/m */
  double curvature_change;    /* integral of (d curvature / ds)^2 ds between the breaks, 1/m^3 */
  double curvature_variation; /* integral of |d curvature| and its jumps at the breaks, 1/m */
  double curvature_jump;      /* the largest jump of the curvature vector at a break, 1/m */
} lam_fairness;
/* Measured on `samples` >= 2 intervals per smooth part, by Gauss' rule with 8 nodes on each. The
 * arena is only used while it works. */
lam_fairness lam_curve_fairness(lam_arena *arena, const lam_curve *curve, int samples);

/* What a fairing did. The functions below take NULL where it is not wanted. */
typedef struct lam_fairing {
  lam_fairness before, after;
  double moved; /* the largest move of a control point, m; no curve point moves farther */
} lam_fairing;

/* The curve that minimizes the integral of |x^(order)|^2 (order 2: bending of a beam; 3: change
 * of its curvature) plus as much closeness to the given one as keeps every control point within
 * `tolerance` (m) of where it was. The first and last `ends` >= 1 control points stay (2: end
 * tangents too). Knots are shared. Preconditions: no weights, 2 <= order <= min(3, degree), count
 * > 2 ends. */
lam_spline_curve lam_fair_by_energy(lam_arena *arena, lam_spline_curve curve, int order, int ends,
                                    double tolerance, lam_fairing *report);
/* Takes away, `steps` times, the single inner knot where the highest derivative jumps most, and
 * puts it back: the jump is gone, and only the one or two control points that had to move have
 * moved (Kjellander 1983; Farin & Sapidis 1989). No control point ends farther than `tolerance`
 * (m) from where it was. Stops early when no jump becomes smaller. Precondition: no weights. */
lam_spline_curve lam_fair_by_knots(lam_arena *arena, lam_spline_curve curve, int steps,
                                   double tolerance, lam_fairing *report);

#endif
