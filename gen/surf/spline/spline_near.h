/* Spline surfaces near points: least squares with fairness. Called by
 * surf/kinds/approximation.c. */
#ifndef LAM_SURF_SPLINE_SPLINE_NEAR_H
#define LAM_SURF_SPLINE_SPLINE_NEAR_H

#include "core/arena.h"
#include "core/model.h"

/* The polynomial surface over [0,1]^2 that is sought. */
typedef struct lam_surface_space {
  int degree[2], count[2];
  const double *knots[2]; /* clamped; NULL: evenly spaced */
  double fairness;        /* >= 0, see lam_surface_near */
  double length[2];       /* m: about how long along u and along v; they shape the energy */
} lam_surface_space;

/* The surface that minimizes, over its control points,
 *   mean |x(t_k) - P_k|^2 + fairness * integral r^-2 x_uu^2 + 2 x_uv^2 + r^2 x_vv^2 du dv
 * with r = length[0] / length[1]: least squares and the energy of a thin plate on a rectangle
 * of these lengths. Nothing is met exactly, not even at the corners.
 *
 * n        number of points
 * t        n parameters, from 0 to 1
 * points   n
 * surface  owned by the arena
 *
 * False when there is no unique minimum to rounding: fairness is 0 and a function has no
 * points. Precondition: degrees < counts. */
bool lam_surface_near(lam_arena *arena, const lam_surface_space *space, int n, const lam_vec2 *t,
                      const lam_vec3 *points, lam_spline_surface *surface);

/* Knots for `count` functions in one direction (0: the x of t), so that every span holds about
 * as many of the n parameters; evenly spaced when count > n, or where many parameters are the
 * same. Owned by the arena. */
const double *lam_surface_knots(lam_arena *arena, int degree, int count, int n, const lam_vec2 *t,
                                int direction);

/* Moves every t_k to the nearest point of the surface around it, and returns the largest and
 * the mean distance of the n points, m (mean may be NULL). */
double lam_surface_feet(const lam_spline_surface *surface, int n, const lam_vec3 *points,
                        lam_vec2 *t, double *mean);

/* Parameters t for a cloud of n points without folds, seen along the world axis nearest to the
 * normal of its plane of best fit: from above u runs along x and v along y; steep clouds have v
 * along z, and u along x or y. They fill [0,1]^2. length: the cloud's extents along u and v, m.
 * False when the points lie on a line. */
bool lam_cloud_parameters(int n, const lam_vec3 *points, lam_vec2 *t, double length[2]);

#endif
