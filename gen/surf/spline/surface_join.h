/* How smoothly two surfaces join along a common side. Part of the surface kernel; no stage of a
 * design calls it, the unit tests do. */
#ifndef LAM_SURF_SPLINE_SURFACE_JOIN_H
#define LAM_SURF_SPLINE_SURFACE_JOIN_H

#include "core/arena.h"
#include "core/model.h"

/* G0: the sides are the same curve. G1: one surface also leaves where the other arrives, in the
 * same tangent plane. G2: also the normal curvatures agree, in every direction. */
typedef struct lam_surface_join {
  int geometric;     /* the largest n <= 2 with G^n; -1: the sides differ */
  const char *name;  /* "G1", for instance; "none" for -1 */
  const char *fails; /* the first condition that fails; NULL when none does */
  double gap;        /* the largest distance of the sides, m */
  double kink; /* the largest angle by which the tangent plane turns, rad; pi where it folds back */
  double curvature_gap; /* the largest difference of normal curvatures, 1/m */
  double parameter[3];  /* where along the first side gap, kink and curvature_gap are largest */
} lam_surface_join;

/* Side sides[0] of the first surface against side sides[1] of the second (0: v low, 1: u low,
 * 2: v high, 3: u high), in either direction and with any parameters, at samples + 1 parameters
 * of the first side. Distances are compared with the size of the first side, angles with 1,
 * curvatures with the larger of their own and 1 / size. NaN where a surface is singular: G1
 * then fails. Precondition: samples >= 1. */
lam_surface_join lam_surface_join_test(lam_arena *arena, const lam_spline_surface *first,
                                       const lam_spline_surface *second, const int sides[2],
                                       int samples, double tolerance);

#endif
