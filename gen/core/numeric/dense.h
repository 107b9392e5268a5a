/* Small dense linear algebra, for systems up to a few hundred unknowns. Matrices are stored by
 * rows. Used by curve (fits, degree reduction) and surf. */
#ifndef LAM_CORE_NUMERIC_DENSE_H
#define LAM_CORE_NUMERIC_DENSE_H

#include "core/arena.h"
#include <stdbool.h>

/* Factors the symmetric positive definite n x n matrix a = L L^T in place; only its lower triangle
 * is read and written. False when a is not positive definite to rounding; a is spoiled then. */
bool lam_cholesky_factor(int n, double *a);
/* Solves L L^T x = b in place of b[n]; factor is what lam_cholesky_factor left. */
void lam_cholesky_solve(int n, const double *factor, double *b);

/* Factors the n x n matrix a = P L U in place with row exchanges, recorded in pivot[n]: step j
 * exchanged rows j and pivot[j]. False when a is singular. */
bool lam_lu_factor(int n, double *a, int *pivot);
/* Solves a x = b in place of b[n]. */
void lam_lu_solve(int n, const double *factor, const int *pivot, double *b);

/* Singular values sigma[n] of the n x n matrix a, descending, and the right singular vectors as
 * columns of v (n x n): a v_k has length sigma_k. One-sided Jacobi rotations: small values come
 * out with full relative accuracy. a is overwritten by a v. */
void lam_singular_values(int n, double *a, double *sigma, double *v);

/* How lam_least_energy ended. */
typedef enum lam_least {
  LAM_LEAST_FOUND,
  LAM_LEAST_CONTRADICTORY, /* no x satisfies the constraints */
  LAM_LEAST_FLAT           /* the energy has no unique minimum on the constraints */
} lam_least;
/* The x[n] that minimizes 1/2 x^T h x + g^T x subject to c x = d. Null-space method: c^T is
 * factored by Householder reflections with column exchanges.
 *
 * h          n x n, symmetric, positive definite on the constraints
 * c, d       m x n and m, of any rank: rows that depend on others are dropped when they agree with
 *            them. Rows of c should be scaled to about 1. May be NULL when m is 0
 * tolerance  what is below counts as zero: lengths of rows, and contradictions
 * x          not h, g, c or d; always set, a minimum when the result is LAM_LEAST_FOUND */
lam_least lam_least_energy(lam_arena *arena, int n, const double *h, const double *g, int m,
                           const double *c, const double *d, double tolerance, double *x);

#endif
