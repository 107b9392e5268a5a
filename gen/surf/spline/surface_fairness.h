/* How fair a surface is, and fairing: what curve/curve_fairness.h does for curves. Part of the
 * surface kernel; no stage of a design calls it, the unit tests do. */
#ifndef LAM_SURF_SPLINE_SURFACE_FAIRNESS_H
#define LAM_SURF_SPLINE_SURFACE_FAIRNESS_H

#include "core/arena.h"
#include "core/model.h"

/* Smaller numbers are fairer. */
typedef struct lam_surface_fairness {
  int inflections;         /* changes of sign of the normal curvature, on all lines together */
  double bending;          /* integral of k1^2 + k2^2 dA */
  double curvature_change; /* integral of |grad H|^2 dA, 1/m^2 */
  double curvature_jump;   /* the largest jump of H across a knot line, 1/m */
} lam_surface_fairness;

/* Measured on parameter lines in the middle of every knot span, at `samples` >= 1 parameters of
 * each span; integrals by Gauss' rule with 6 x 6 nodes per patch. The arena is released to
 * where it was. */
lam_surface_fairness lam_spline_surface_fairness(lam_arena *arena,
                                                 const lam_spline_surface *surface, int samples);

/* What fairing has changed. */
typedef struct lam_surface_fairing {
  lam_surface_fairness before, after;
  double moved; /* the largest move of a control point, m; no surface point moves farther */
} lam_surface_fairing;

/* The surface that minimizes the energy of a thin plate (surf/spline/spline_near.h; parameters
 * scaled to the mean lengths of the surface) plus as much closeness to the given one as keeps
 * every control point within `tolerance` (m) of where it was.
 *
 * ends    the outer `ends` >= 1 rings of control points stay (2: tangent planes too)
 * report  may be NULL
 *
 * Preconditions: no weights, degrees at least 2. Owned by the arena. */
lam_spline_surface lam_surface_fair_by_energy(lam_arena *arena, const lam_spline_surface *surface,
                                              int ends, double tolerance,
                                              lam_surface_fairing *report);

/* Takes away, `steps` times, the single inner knot of either direction where the highest
 * derivative jumps most, and puts it back: the jump is gone, and only the rows of control
 * points that had to move have moved. The outer ring stays, and no control point ends farther
 * than `tolerance` (m) from where it was. Stops early when no jump becomes smaller. report may
 * be NULL. Precondition: no weights. Owned by the arena. */
lam_spline_surface lam_surface_fair_by_knots(lam_arena *arena, const lam_spline_surface *surface,
                                             int steps, double tolerance,
                                             lam_surface_fairing *report);

#endif
