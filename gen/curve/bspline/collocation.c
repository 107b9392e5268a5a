/* Interpolation at the knot averages, and two helpers for splines that are put together from
 * Bezier pieces. Called by surf/asymptotic; lam_bezier_elevate by bspline_degree.c too. */
#include "curve/bspline/collocation.h"
#include "core/numeric/dense.h"
#include "curve/bspline/basis.h"

/* Row i of the matrix holds the functions at node i, t_i = (knots[i + 1] + ... + knots[i + p]) /
 * p (the Greville abscissae). It is regular: every node lies in the support of its function
 * (Schoenberg & Whitney, 1953). */
lam_collocation lam_collocation_make(lam_arena *arena, int degree, int count, const double *knots) {
  double *nodes = LAM_NEW(arena, double, count), *matrix = LAM_NEW(arena, double, count *count);
  int *pivot = LAM_NEW(arena, int, count);

  for (int i = 0; i < count; i++) {
    double sum = 0, values[LAM_BASIS_MAX_VALUES];
    for (int k = 1; k <= degree; k++) sum += knots[i + k];
    nodes[i] = sum / degree;
    int span = lam_basis_span(degree, count, knots, nodes[i]);
    lam_basis_eval(degree, knots, span, nodes[i], 0, values);
    for (int k = 0; k <= degree; k++) matrix[i * count + span - degree + k] = values[k];
  }

  lam_lu_factor(count, matrix, pivot);
  return (lam_collocation){degree, count, knots, nodes, matrix, pivot};
}

/* One coordinate at a time, with the factored matrix. */
void lam_collocation_solve(lam_arena *arena, const lam_collocation *space, int dimension,
                           double *values) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *column = LAM_NEW(arena, double, space->count);

  for (int c = 0; c < dimension; c++) {
    for (int i = 0; i < space->count; i++) column[i] = values[i * dimension + c];
    lam_lu_solve(space->count, space->factor, space->pivot, column);
    for (int i = 0; i < space->count; i++) values[i * dimension + c] = column[i];
  }

  lam_arena_release(arena, mark);
}

/* From degree n - 1 to n: b_j = (j b_j-1 + (n - j) b_j) / n, from the last to the first, so that
 * it works in place. */
void lam_bezier_elevate(int degree, int target, int dimension, double *values) {
  for (int n = degree + 1; n <= target; n++)
    for (int c = 0; c < dimension; c++) {
      values[n * dimension + c] = values[(n - 1) * dimension + c];
      for (int j = n - 1; j > 0; j--)
        values[j * dimension + c] =
            (j * values[(j - 1) * dimension + c] + (n - j) * values[j * dimension + c]) / n;
    }
}

/* The knots at 0 are there already: the arena gives zeros. */
const double *lam_knots_repeat(lam_arena *arena, int degree, int inner_count, const double *inner,
                               int multiplicity, int *count) {
  *count = degree + 1 + inner_count * multiplicity;
  double *knots = LAM_NEW(arena, double, *count + degree + 1);
  for (int k = 0; k < inner_count * multiplicity; k++)
    knots[degree + 1 + k] = inner[k / multiplicity];
  for (int k = 0; k <= degree; k++) knots[*count + k] = 1;
  return knots;
}
