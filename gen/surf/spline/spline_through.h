/* Spline surfaces through a grid of points. Called by surf/kinds/interpolation.c and
 * approximation.c. */
#ifndef LAM_SURF_SPLINE_SPLINE_THROUGH_H
#define LAM_SURF_SPLINE_SPLINE_THROUGH_H

#include "core/model.h"
#include "curve/interpolate.h"

/* Parameters t[d] of the rows of a grid of count[0] x count[1] points (v running fastest), in
 * both directions, owned by the arena: the means of those of its polylines, without polylines
 * of length 0 (Piegl & Tiller, The NURBS Book, A9.3). NULL in a direction where all points of
 * two neighboring rows coincide. */
void lam_grid_parameters(lam_arena *arena, lam_parameters kind, const int count[2],
                         const lam_vec3 *points, const double *t[2]);

/* The surface with x(t[0][i], t[1][j]) = points[i][j]: splines are put through the rows, then
 * through what came out, in the other direction. ends: see lam_interpolate; TANGENTS is not for
 * surfaces. Preconditions: counts >= 2, parameters increase. Owned by the arena. */
lam_spline_surface lam_surface_through(lam_arena *arena, lam_ends ends, const int degree[2],
                                       const int count[2], const double *const t[2],
                                       const lam_vec3 *points);

/* The C1 bicubic surface with x(t[0][i], t[1][j]) = points[i][j] whose rows, columns and twists
 * have Bessel's tangents (lam_interpolate_local in both directions): a point moves only the
 * patches within two rows of it. Preconditions as above. */
lam_spline_surface lam_surface_through_local(lam_arena *arena, const int count[2],
                                             const double *const t[2], const lam_vec3 *points);

#endif
