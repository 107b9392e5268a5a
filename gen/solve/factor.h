/* Sparse Cholesky behind five functions: analyze once per pattern, factorize and solve every
 * iteration. The matrix is symmetric positive definite; its lower triangle is given by columns
 * (0-based, rows ascending, diagonal first). */
#ifndef LAM_SOLVE_FACTOR_H
#define LAM_SOLVE_FACTOR_H

#include "core/arena.h"
#include <stdbool.h>

typedef struct lam_factor lam_factor;

typedef struct lam_factor_stats {
  double flops;   /* of one factorization */
  double entries; /* of the factor */
  long factorized, solved;
} lam_factor_stats;

/* Analyzes the pattern under the given order: order[k] is the unknown eliminated k-th. Closed with
 * the arena. n > 0. */
lam_factor *lam_factor_analyze(lam_arena *arena, int n, const int *column_start, const int *row,
                               const int *order);
/* Factorizes values (on the analyzed pattern). False: not positive definite. */
bool lam_factor_refactor(lam_factor *factor, const double *values);
/* Solves A x = b; x and b may be the same array. Precondition: the last refactor succeeded. */
void lam_factor_solve(lam_factor *factor, const double *b, double *x);
lam_factor_stats lam_factor_get_stats(const lam_factor *factor);
/* Fill-reducing order of a symmetric graph (AMD): neighbors of node i are
 * neighbor[start[i]..start[i+1]-1]. */
void lam_factor_order(lam_arena *arena, int n, const int *start, const int *neighbor, int *order);

/* The dense kernels in use ("Zen", "Haswell", ...), and one line of advice when they do not suit
 * this processor (NULL: they do). Static texts. */
const char *lam_blas_kernel(void);
const char *lam_blas_advice(void);
/* A kernel name to put into OPENBLAS_CORETYPE before the program starts anew, or NULL. */
const char *lam_blas_better_kernel(void);

#endif
