/* Splines from the values of functions that are splines already: exact conversion by interpolation.
 */
#ifndef LAM_CURVE_BSPLINE_COLLOCATION_H
#define LAM_CURVE_BSPLINE_COLLOCATION_H

#include "core/arena.h"

/* A space of splines: `count` functions of one degree over knots (see curve/basis.h), with as many
 * places (the knot averages) that determine a spline uniquely. */
typedef struct lam_collocation {
  int degree, count;
  const double *knots;
  const double *places; /* count, ascending, from the first to the last knot */
  const double *factor; /* of the values of the functions at the places */
  const int *pivot;
} lam_collocation;

/* Knots are kept by pointer. Precondition: lam_knots_problem returns NULL, and no inner knot is
 * repeated more than degree times. */
lam_collocation lam_collocation_make(lam_arena *arena, int degree, int count, const double *knots);

/* Replaces values at the places, `dimension` numbers for each, by the coefficients of the spline
 * that has them. */
void lam_collocation_solve(lam_arena *arena, const lam_collocation *space, int dimension,
                           double *values);

/* Raises the degree of a Bezier curve in place: values holds degree + 1 points of `dimension`
 * numbers and has room for target + 1. To rounding of every single point, which second derivatives
 * at high degree need. */
void lam_bezier_elevate(int degree, int target, int dimension, double *values);

/* degree + 1 times 0, every inner knot `multiplicity` times, degree + 1 times 1; inner_count
 * ascending inner knots. Sets count to the number of functions. */
const double *lam_knots_repeat(lam_arena *arena, int degree, int inner_count, const double *inner,
                               int multiplicity, int *count);

#endif
