/* LU factors of band matrices without row exchanges. Called where splines are fitted:
 * curve/interpolate.c, curve/least_squares.c and surf/spline. */
#include "curve/bspline/banded.h"
#include <float.h>
#include <math.h>

lam_banded lam_banded_make(lam_arena *arena, int n, int half) {
  return (lam_banded){n, half, LAM_NEW(arena, double, (size_t)n *(2 * half + 1))};
}

/* Doolittle's elimination: afterwards the upper triangle holds U, the lower one the factors of L
 * (its diagonal of ones is not stored). */
bool lam_banded_factor(lam_banded *a) {
  for (int k = 0; k < a->n; k++) {
    double pivot = *lam_banded_at(a, k, k), most = 0;
    int end = k + a->half < a->n - 1 ? k + a->half : a->n - 1;
    for (int j = k; j <= end; j++) most = fmax(most, fabs(*lam_banded_at(a, k, j)));
    if (!(fabs(pivot) > 16 * DBL_EPSILON * most)) return false;

    /* A zero in the column leaves its row as it is: the band is often only partly filled. */
    for (int i = k + 1; i <= end; i++) {
      double factor = *lam_banded_at(a, i, k) /= pivot;
      for (int j = k + 1; factor != 0 && j <= end; j++)
        *lam_banded_at(a, i, j) -= factor * *lam_banded_at(a, k, j);
    }
  }

  return true;
}

/* L y = b forwards, then U x = y backwards; all `dimension` columns of b at once. */
void lam_banded_solve(const lam_banded *a, int dimension, double *b) {
  for (int i = 0; i < a->n; i++)
    for (int j = i > a->half ? i - a->half : 0; j < i; j++)
      for (int d = 0; d < dimension; d++)
        b[i * dimension + d] -= *lam_banded_at(a, i, j) * b[j * dimension + d];

  for (int i = a->n - 1; i >= 0; i--) {
    for (int j = i + 1; j <= i + a->half && j < a->n; j++)
      for (int d = 0; d < dimension; d++)
        b[i * dimension + d] -= *lam_banded_at(a, i, j) * b[j * dimension + d];
    for (int d = 0; d < dimension; d++) b[i * dimension + d] /= *lam_banded_at(a, i, i);
  }
}
