/* Splines from the values of functions that are splines already: exact conversion by
 * interpolation. Used by the patches of surf/asymptotic. */
#ifndef LAM_CURVE_BSPLINE_COLLOCATION_H
#define LAM_CURVE_BSPLINE_COLLOCATION_H

#include "core/arena.h"

/* A space of splines: `count` functions of one degree over knots (see curve/bspline/basis.h),
 * with as many nodes (the knot averages) that determine a spline uniquely. */
typedef struct lam_collocation {
  int degree, count;
  const double *knots;
  const double *nodes;  /* count, ascending, from the first to the last knot */
  const double *factor; /* of the values of the functions at the nodes; lam_lu_factor */
  const int *pivot;     /* count; of lam_lu_factor */
} lam_collocation;

/* Makes the space and factors its matrix, count x count. Knots are kept by pointer.
 * Preconditions: degree >= 1, lam_knots_problem returns NULL, and no inner knot is repeated more
 * than degree times. */
lam_collocation lam_collocation_make(lam_arena *arena, int degree, int count, const double *knots);

/* Replaces values at the nodes, count x dimension, by the coefficients of the spline that has
 * them. */
void lam_collocation_solve(lam_arena *arena, const lam_collocation *space, int dimension,
                           double *values);

/* Raises the degree of a Bezier curve in place: values holds degree + 1 points of `dimension`
 * numbers and has room for target + 1. Every point comes out to rounding of its own size, which
 * second derivatives at high degree need. */
void lam_bezier_elevate(int degree, int target, int dimension, double *values);

/* The knots: degree + 1 times 0, every inner knot `multiplicity` times, degree + 1 times 1.
 * inner: inner_count ascending numbers in (0, 1); NULL when there are none. Sets count to the
 * number of functions. */
const double *lam_knots_repeat(lam_arena *arena, int degree, int inner_count, const double *inner,
                               int multiplicity, int *count);

#endif
