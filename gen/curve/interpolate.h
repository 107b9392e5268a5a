/* Spline curves through points. Used by least_squares.c, mesh/line_curve.c and
 * surf/spline/spline_through.c. */
#ifndef LAM_CURVE_INTERPOLATE_H
#define LAM_CURVE_INTERPOLATE_H

#include "curve/bspline/parameters.h"
#include "curve/curve.h"

/* What stands in for the conditions that points alone leave open. */
typedef enum lam_ends {
  LAM_ENDS_AVERAGE,    /* none are open: inner knots are averages of the parameters */
  LAM_ENDS_NOT_A_KNOT, /* cubic: the first two pieces are one, and the last two */
  LAM_ENDS_NATURAL,    /* cubic: no second derivative at the ends */
  LAM_ENDS_TANGENTS,   /* cubic: given first derivatives at the ends */
  LAM_ENDS_COUNT
} lam_ends;

/* The spline with f(t[i]) = values[i], i < count.
 *
 * ends    all but AVERAGE give C2 cubics with knots at the parameters. AVERAGE (Piegl & Tiller,
 *         eq. 9.8) gives any degree; NOT_A_KNOT with fewer than 4 points gives the polynomial
 *         through them
 * degree  >= 1, of AVERAGE; lowered to count - 1 where it is higher
 * t       increases
 * values  count x dimension
 * slopes  2 x dimension: the derivatives at both ends for TANGENTS; not read otherwise
 *
 * Precondition: count >= 2. */
lam_bspline lam_interpolate(lam_arena *arena, lam_ends ends, int degree, int count, const double *t,
                            int dimension, const double *values, const double *slopes);
/* The same for points, with parameters chosen; TANGENTS takes the slopes of the local
 * interpolation at the ends. Precondition: neighboring points differ. */
lam_spline_curve lam_interpolate_points(lam_arena *arena, lam_ends ends, int degree,
                                        lam_parameters parameters, int count,
                                        const lam_vec3 *points);

/* The C1 cubic through the points with the derivatives tangents[count]; NULL: those of the
 * parabola through each point and its neighbors (Bessel's tangents). A point moves only the four
 * pieces around it. Preconditions: count >= 2, t[count] increases. */
lam_spline_curve lam_interpolate_local(lam_arena *arena, int count, const double *t,
                                       const lam_vec3 *points, const lam_vec3 *tangents);

#endif
