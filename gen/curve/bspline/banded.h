/* Banded linear systems as splines give them: totally positive or positive definite, so elimination
 * needs no row exchanges (de Boor, A Practical Guide to Splines, ch. XIII). */
#ifndef LAM_CURVE_BSPLINE_BANDED_H
#define LAM_CURVE_BSPLINE_BANDED_H

#include "core/arena.h"
#include <stdbool.h>

typedef struct lam_banded {
  int n, half;    /* entries (i, j) with |i - j| <= half */
  double *values; /* n x (2 half + 1) */
} lam_banded;

/* A zero matrix, n x n, owned by the arena. half >= 0: how many diagonals lie on each side of the
 * main one. */
lam_banded lam_banded_make(lam_arena *arena, int n, int half);
/* The entry (i, j). Precondition: |i - j| <= half. */
static inline double *lam_banded_at(const lam_banded *a, int i, int j) {
  return a->values + (size_t)i * (2 * a->half + 1) + (j - i + a->half);
}

/* Factors a in place. False when a pivot is zero to rounding (16 epsilon of its row); a is
 * spoiled then. */
bool lam_banded_factor(lam_banded *a);
/* Replaces b, n rows of `dimension` numbers, by the solution x of A x = b. Precondition:
 * lam_banded_factor returned true. */
void lam_banded_solve(const lam_banded *a, int dimension, double *b);

#endif
