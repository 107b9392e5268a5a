/* Spline curves through points. */
#ifndef LAM_CURVE_INTERPOLATE_H
#define LAM_CURVE_INTERPOLATE_H

#include "curve/bspline/parameters.h"
#include "curve/curve.h"

/* What stands in for the conditions that points alone leave open. */
typedef enum lam_ends {
  LAM_ENDS_AVERAGE,    /* none are open: inner knots are averages of the parameters (Piegl & Tiller,
                          eq. 9.8) */
  LAM_ENDS_NOT_A_KNOT, /* cubic: the first two pieces are one, and the last two */
  LAM_ENDS_NATURAL,    /* cubic: no second derivative at the ends */
  LAM_ENDS_TANGENTS,   /* cubic: given first derivatives at the ends */
  LAM_ENDS_COUNT
} lam_ends;
extern const char *const lam_ends_names[]; /* NULL-terminated */

/* The spline with f(t[i]) = values[i] (count x dimension numbers). All ends but AVERAGE give C2
 * cubics with knots at the parameters; AVERAGE gives any degree, at most count - 1 (it is lowered
 * to that), and NOT_A_KNOT needs 4 points (with fewer it is the polynomial through them). slopes: 2
 * x dimension derivatives for TANGENTS, otherwise NULL. Preconditions: count >= 2, t increases,
 * degree >= 1. */
lam_bspline lam_interpolate(lam_arena *arena, lam_ends ends, int degree, int count, const double *t,
                            int dimension, const double *values, const double *slopes);
/* The same for points, with parameters chosen; TANGENTS takes the slopes of the local
 * interpolation. Neighboring points must differ. */
lam_spline_curve lam_interpolate_points(lam_arena *arena, lam_ends ends, int degree,
                                        lam_parameters parameters, int count,
                                        const lam_vec3 *points);

/* First derivatives at the points: those of the parabola through each point and its neighbors
 * (Bessel's tangents). */
void lam_bessel_tangents(int count, const double *t, const lam_vec3 *points, lam_vec3 *tangents);
/* The C1 cubic through the points with these derivatives (NULL: Bessel's). A point moves only the
 * four pieces around it. */
lam_spline_curve lam_interpolate_local(lam_arena *arena, int count, const double *t,
                                       const lam_vec3 *points, const lam_vec3 *tangents);

#endif
