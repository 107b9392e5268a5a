/* Sparse Cholesky behind five functions: analyze once per pattern, factorize and solve every
 * iteration. Used by solver_run.c, surf/flatten, surf/area/area_system.c and
 * surf/asymptotic/conormal_fit.c. The matrix is symmetric positive definite; its lower triangle
 * is given by columns (0-based, rows ascending, diagonal first). */
#ifndef LAM_SOLVE_FACTOR_H
#define LAM_SOLVE_FACTOR_H

#include "core/arena.h"
#include <stdbool.h>

typedef struct lam_factor lam_factor;

/* What the work was, for reports and benchmarks. */
typedef struct lam_factor_stats {
  double flops;            /* of one factorization */
  double entries;          /* of the factor */
  long factorized, solved; /* how often */
} lam_factor_stats;

/* Analyzes a pattern under the given order.
 *
 * arena         closes the factor when it is released; running out of memory jumps to its
 *               recovery point
 * n             unknowns, > 0
 * column_start  n + 1: where columns begin in row
 * row           column_start[n] row indices
 * order         order[k] is the unknown eliminated k-th (lam_factor_order)
 *
 * column_start and row are kept by pointer and must live as long as the factor. */
lam_factor *lam_factor_analyze(lam_arena *arena, int n, const int *column_start, const int *row,
                               const int *order);
/* Factorizes the matrix with these values, column_start[n] numbers on the analyzed pattern.
 * False: not positive definite. */
bool lam_factor_refactor(lam_factor *factor, const double *values);
/* Solves A x = b, n numbers each; x and b may be the same array. Precondition: the last
 * lam_factor_refactor returned true. */
void lam_factor_solve(lam_factor *factor, const double *b, double *x);
/* The counts so far. */
lam_factor_stats lam_factor_get_stats(const lam_factor *factor);
/* Fill-reducing order of a symmetric graph (AMD), order[n]. The neighbors of node i are
 * neighbor[start[i] .. start[i + 1] - 1]; every edge is listed at both of its nodes. n may be 0. */
void lam_factor_order(lam_arena *arena, int n, const int *start, const int *neighbor, int *order);

#endif
