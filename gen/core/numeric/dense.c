/* Factorizations of small dense matrices, and quadratic programs with equality constraints.
 * Called by curve/curve_fairing.c, curve/bspline and surf. */
#include "core/numeric/dense.h"
#include <math.h>
#include <string.h>

/* Row by row: L_ij = (a_ij - sum_k<j L_ik L_jk) / L_jj. A pivot below 1e-15 of its diagonal entry
 * counts as zero. */
bool lam_cholesky_factor(int n, double *a) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      const double *p = a + (size_t)i * n, *q = a + (size_t)j * n;
      double sum = p[j];
      for (int k = 0; k < j; k++) sum -= p[k] * q[k];

      if (i > j)
        a[(size_t)i * n + j] = sum / q[j];
      else if (sum > 1e-15 * fabs(p[j]))
        a[(size_t)i * n + j] = sqrt(sum);
      else
        return false;
    }
  return true;
}

/* L y = b forwards, L^T x = y backwards. */
void lam_cholesky_solve(int n, const double *factor, double *b) {
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) b[i] -= factor[(size_t)i * n + k] * b[k];
    b[i] /= factor[(size_t)i * n + i];
  }
  for (int i = n - 1; i >= 0; i--) {
    b[i] /= factor[(size_t)i * n + i];
    for (int k = 0; k < i; k++) b[k] -= factor[(size_t)i * n + k] * b[i];
  }
}

/* Exchanges `count` numbers. */
static void exchange(double *a, double *b, int count) {
  for (int k = 0; k < count; k++) {
    double kept = a[k];
    a[k] = b[k];
    b[k] = kept;
  }
}

/* Gauss' elimination with partial pivoting: L (without its diagonal of ones) below, U above. */
bool lam_lu_factor(int n, double *a, int *pivot) {
  for (int j = 0; j < n; j++) {
    int best = j;
    for (int i = j + 1; i < n; i++)
      if (fabs(a[(size_t)i * n + j]) > fabs(a[(size_t)best * n + j])) best = i;
    pivot[j] = best;
    if (best != j) exchange(a + (size_t)j * n, a + (size_t)best * n, n);

    double *top = a + (size_t)j * n;
    if (top[j] == 0) return false;

    for (int i = j + 1; i < n; i++) {
      double *row = a + (size_t)i * n;
      row[j] /= top[j];
      for (int k = j + 1; k < n; k++) row[k] -= row[j] * top[k];
    }
  }
  return true;
}

/* The row exchanges, then L y = b forwards and U x = y backwards. */
void lam_lu_solve(int n, const double *factor, const int *pivot, double *b) {
  for (int i = 0; i < n; i++) exchange(b + i, b + pivot[i], 1);
  for (int i = 0; i < n; i++)
    for (int k = 0; k < i; k++) b[i] -= factor[(size_t)i * n + k] * b[k];
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) b[i] -= factor[(size_t)i * n + k] * b[k];
    b[i] /= factor[(size_t)i * n + i];
  }
}

/* Turns columns p and q of a (n rows) by the angle with cosine c and sine s. */
static void turn_columns(int n, double *a, int p, int q, double c, double s) {
  for (int i = 0; i < n; i++) {
    double x = a[i * n + p], y = a[i * n + q];
    a[i * n + p] = c * x - s * y;
    a[i * n + q] = s * x + c * y;
  }
}

/* The dot product of columns p and q of a, n x n. */
static double column_product(int n, const double *a, int p, int q) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i * n + p] * a[i * n + q];
  return sum;
}

/* Hestenes' method: pairs of columns are turned until all are orthogonal; then their lengths are
 * the singular values (Golub & Van Loan, Matrix Computations, ch. 8). */
void lam_singular_values(int n, double *a, double *sigma, double *v) {
  for (int i = 0; i < n * n; i++) v[i] = i % (n + 1) == 0;

  bool turned = true;
  for (int sweep = 0; turned && sweep < 60; sweep++) {
    turned = false;
    for (int p = 0; p < n; p++)
      for (int q = p + 1; q < n; q++) {
        double pp = column_product(n, a, p, p), qq = column_product(n, a, q, q),
               pq = column_product(n, a, p, q);
        if (fabs(pq) <= 1e-15 * sqrt(pp * qq)) continue;

        /* The angle that makes the two columns orthogonal. */
        double z = (qq - pp) / (2 * pq), t = copysign(1, z) / (fabs(z) + hypot(1, z)),
               c = 1 / hypot(1, t);
        turn_columns(n, a, p, q, c, c * t);
        turn_columns(n, v, p, q, c, c * t);
        turned = true;
      }
  }

  /* Descending, columns along with them. */
  for (int k = 0; k < n; k++) sigma[k] = sqrt(column_product(n, a, k, k));
  for (int k = 0; k < n; k++)
    for (int l = k + 1; l < n; l++)
      if (sigma[l] > sigma[k]) {
        exchange(sigma + k, sigma + l, 1);
        for (int i = 0; i < n; i++) {
          exchange(a + i * n + k, a + i * n + l, 1);
          exchange(v + i * n + k, v + i * n + l, 1);
        }
      }
}

/* Applies the reflection 1 - 2 w w^T / w^T w, w != 0, to x. */
static void reflect(int n, const double *w, double *x) {
  double square = 0, product = 0;
  for (int i = 0; i < n; i++) {
    square += w[i] * w[i];
    product += w[i] * x[i];
  }
  for (int i = 0; i < n; i++) x[i] -= 2 * product / square * w[i];
}

/* The longest of rows first .. m - 1, of which the entries from `first` on count. Returns its index
 * (first when all are zero) and its length. */
static int longest_row(int n, int m, const double *rows, int first, double *length) {
  int best = first;
  double longest = 0;
  for (int i = first; i < m; i++) {
    double square = 0;
    for (int k = first; k < n; k++) square += rows[(size_t)i * n + k] * rows[(size_t)i * n + k];
    if (square > longest) {
      longest = square;
      best = i;
    }
  }
  *length = sqrt(longest);
  return best;
}

/* The constraints c x = d, as c^T = Q R with the rows of c exchanged: rows[k] becomes row k of R^T,
 * reflectors[k] one factor of Q. The work stops at the first row shorter than tolerance; returns
 * the rank. */
static int reduce_rows(int n, int m, double *rows, double *d, double tolerance,
                       double *reflectors) {
  int rank = 0;
  for (; rank < m && rank < n; rank++) {
    double length;
    int best = longest_row(n, m, rows, rank, &length);
    if (length <= tolerance) break;
    exchange(rows + (size_t)rank * n, rows + (size_t)best * n, n);
    exchange(d + rank, d + best, 1);

    double *row = rows + (size_t)rank * n, *w = reflectors + (size_t)rank * n;
    for (int k = rank; k < n; k++) w[k] = row[k];
    w[rank] += copysign(length, w[rank]);
    for (int i = rank; i < m; i++) reflect(n - rank, w + rank, rows + (size_t)i * n + rank);
  }
  return rank;
}

/* y = Q y, with Q given by the first `rank` reflectors. */
static void apply_reflectors(int n, int rank, const double *reflectors, double *y) {
  for (int k = rank - 1; k >= 0; k--) reflect(n - k, reflectors + (size_t)k * n + k, y + k);
}

/* An x that satisfies the constraints: R^T y = d forwards, x = Q y with zeros behind the rank. x is
 * zero before. False when a dependent row contradicts those before it. */
static bool satisfy(int n, int m, int rank, const double *rows, const double *d,
                    const double *reflectors, double tolerance, double *x) {
  bool agrees = true;
  for (int i = 0; i < m; i++) {
    double sum = d[i];
    for (int k = 0; k < i && k < rank; k++) sum -= rows[(size_t)i * n + k] * x[k];
    if (i < rank)
      x[i] = sum / rows[(size_t)i * n + i];
    else if (fabs(sum) > tolerance * (1 + fabs(d[i])))
      agrees = false;
  }
  apply_reflectors(n, rank, reflectors, x);
  return agrees;
}

/* The energy on the null space: reduced = Z^T h Z (lower triangle) and step = -Z^T (g + h x), with
 * the `left` rows of null as columns of Z. product: n numbers, scratch. */
static void reduce_energy(int n, int left, const double *h, const double *g, const double *null,
                          const double *x, double *product, double *reduced, double *step) {
  for (int j = 0; j < left; j++) {
    const double *z = null + (size_t)j * n;
    for (int i = 0; i < n; i++) {
      product[i] = 0;
      for (int k = 0; k < n; k++) product[i] += h[(size_t)i * n + k] * z[k];
    }

    for (int i = j; i < left; i++)
      for (int k = 0; k < n; k++)
        reduced[(size_t)i * left + j] += null[(size_t)i * n + k] * product[k];
    for (int k = 0; k < n; k++) step[j] -= z[k] * g[k] + product[k] * x[k];
  }
}

/* x = x0 + Z s with x0 on the constraints: s minimizes 1/2 s^T Z^T h Z s + s^T Z^T (g + h x0)
 * (Nocedal & Wright, Numerical Optimization, 16.2). */
lam_least lam_least_energy(lam_arena *arena, int n, const double *h, const double *g, int m,
                           const double *c, const double *d, double tolerance, double *x) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *rows = LAM_NEW(arena, double, m *n), *right = LAM_NEW(arena, double, m),
         *w = LAM_NEW(arena, double, m *n);
  for (int i = 0; i < m * n; i++) rows[i] = c[i];
  for (int i = 0; i < m; i++) right[i] = d[i];
  int rank = reduce_rows(n, m, rows, right, tolerance, w), left = n - rank;

  memset(x, 0, (size_t)n * sizeof *x);
  bool agrees = satisfy(n, m, rank, rows, right, w, tolerance, x);
  lam_least result = agrees ? LAM_LEAST_FOUND : LAM_LEAST_CONTRADICTORY;

  /* The columns of Q that the constraints leave free. */
  double *null = LAM_NEW(arena, double, left *n);
  for (int j = 0; j < left; j++) {
    null[(size_t)j * n + rank + j] = 1;
    apply_reflectors(n, rank, w, null + (size_t)j * n);
  }

  double *reduced = LAM_NEW(arena, double, left *left), *step = LAM_NEW(arena, double, left);
  reduce_energy(n, left, h, g, null, x, LAM_NEW(arena, double, n), reduced, step);
  if (agrees && !lam_cholesky_factor(left, reduced)) result = LAM_LEAST_FLAT;
  if (result == LAM_LEAST_FOUND) {
    lam_cholesky_solve(left, reduced, step);
    for (int j = 0; j < left; j++)
      for (int k = 0; k < n; k++) x[k] += step[j] * null[(size_t)j * n + k];
  }

  lam_arena_release(arena, mark);
  return result;
}
