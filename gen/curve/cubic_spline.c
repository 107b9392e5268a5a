/* C2 interpolating cubics in the form of points and second derivatives. Called by
 * surf/kinds/revolution.c and net/kinds/molding_net.c. */
#include "curve/cubic_spline.h"

/* The second half of solve_seconds: the unknowns of the tridiagonal system from the last to the
 * first, then M_0 and M_last. start = h_0/h_1, end = h_last-1/h_last-2. */
static void substitute_back(int last, int dimension, const double *diagonal, const double *upper,
                            double start, double end, double *second) {
  for (int i = last - 1; i > 0; i--)
    for (int d = 0; d < dimension; d++) {
      double next = i < last - 1 ? upper[i] * second[(i + 1) * dimension + d] : 0;
      second[i * dimension + d] = (second[i * dimension + d] - next) / diagonal[i];
    }

  for (int d = 0; d < dimension; d++) {
    double *m = second + d;
    m[0] = (1 + start) * m[dimension] - start * m[2 * dimension];
    m[last * dimension] = (1 + end) * m[(last - 1) * dimension] - end * m[(last - 2) * dimension];
  }
}

/* The second derivatives M_i at the points. With h_i = t_i+1 - t_i, the first derivative is
 * continuous at t_i when
 *   h_i-1 M_i-1 + 2 (h_i-1 + h_i) M_i + h_i M_i+1
 *     = 6 ((x_i+1 - x_i) / h_i - (x_i - x_i-1) / h_i-1).
 * Not-a-knot: the third derivative is continuous at t_1, so
 *   M_0 = (1 + h_0/h_1) M_1 - (h_0/h_1) M_2,
 * and likewise at the other end. M_0 and M_last are eliminated, and the tridiagonal rest is
 * solved (de Boor, A Practical Guide to Splines, ch. IV). Precondition: count >= 4. */
static void solve_seconds(lam_arena *arena, int count, int dimension, const double *t,
                          const double *x, double *second) {
  int last = count - 1;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *diagonal = LAM_NEW(arena, double, count), *upper = LAM_NEW(arena, double, count);
  double start = (t[1] - t[0]) / (t[2] - t[1]),
         end = (t[last] - t[last - 1]) / (t[last - 1] - t[last - 2]);

  /* Elimination, row by row as the rows are made. */
  for (int i = 1; i < last; i++) {
    double before = t[i] - t[i - 1], after = t[i + 1] - t[i], lower = before;
    diagonal[i] = 2 * (before + after);
    upper[i] = after;
    if (i == 1) {
      diagonal[i] += before * (1 + start);
      upper[i] -= before * start;
    }
    if (i == last - 1) {
      diagonal[i] += after * (1 + end);
      lower -= after * end;
    }

    double factor = i == 1 ? 0 : lower / diagonal[i - 1];
    if (i > 1) diagonal[i] -= factor * upper[i - 1];

    for (int d = 0; d < dimension; d++) {
      const double *a = x + (i - 1) * dimension + d, *b = a + dimension, *c = b + dimension;
      double right = 6 * ((*c - *b) / after - (*b - *a) / before);
      second[i * dimension + d] = right - (i > 1 ? factor * second[(i - 1) * dimension + d] : 0);
    }
  }

  substitute_back(last, dimension, diagonal, upper, start, end, second);
  lam_arena_release(arena, mark);
}

/* Three points: the second derivative of the parabola, the same everywhere. */
static void parabola_seconds(int dimension, const double *t, const double *x, double *second) {
  for (int d = 0; d < dimension; d++) {
    double rise = (x[2 * dimension + d] - x[dimension + d]) / (t[2] - t[1]) -
                  (x[dimension + d] - x[d]) / (t[1] - t[0]);
    for (int i = 0; i < 3; i++) second[i * dimension + d] = 2 * rise / (t[2] - t[0]);
  }
}

/* The line through two points has no second derivative: the arena gives zeros. */
lam_spline lam_spline_make(lam_arena *arena, int count, int dimension, const double *t,
                           const double *values) {
  double *second = LAM_NEW(arena, double, count *dimension);
  if (count == 3) parabola_seconds(dimension, t, values, second);
  if (count > 3) solve_seconds(arena, count, dimension, t, values, second);
  return (lam_spline){count, dimension, t, values, second};
}

/* Bisection for the piece, then with a = 1 - b the share of its start:
 *   x = a x0 + b x1 + h^2/6 ((a^3 - a) M0 + (b^3 - b) M1). */
void lam_spline_eval(const lam_spline *spline, double t, double *x, double *dx, double *ddx) {
  int low = 0, high = spline->count - 1, n = spline->dimension;
  while (high - low > 1) {
    int middle = low + (high - low) / 2;
    if (t < spline->t[middle])
      high = middle;
    else
      low = middle;
  }

  double h = spline->t[low + 1] - spline->t[low], b = (t - spline->t[low]) / h, a = 1 - b;

  for (int d = 0; d < n; d++) {
    double x0 = spline->values[low * n + d], x1 = spline->values[(low + 1) * n + d];
    double m0 = spline->second[low * n + d], m1 = spline->second[(low + 1) * n + d];
    x[d] = a * x0 + b * x1 + h * h / 6 * (a * (a * a - 1) * m0 + b * (b * b - 1) * m1);
    dx[d] = (x1 - x0) / h + h / 6 * ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1);
    ddx[d] = a * m0 + b * m1;
  }
}
