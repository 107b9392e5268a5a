/* The energy of a thin plate as a quadratic form of a control net, and the inner points of
 * least energy. Called by surf/asymptotic (patch.c, conormal_patch.c). */
#include "surf/spline/thin_plate.h"
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include <string.h>

/* Point j stands at an inner knot repeated `degree` times. */
static bool at_joint(int degree, int count, const double *knots, int j) {
  return degree > 1 && j >= 2 && j < count - 2 && knots[j + 1] == knots[j + degree];
}

/* The inner rows from the free ones: identity, but at a joint of pieces of widths h and k,
 * where the derivative is continuous, row j = (k row j-1 + h row j+1) / (h + k). inner: the
 * number of free rows. */
static const double *make_lift(lam_arena *arena, int degree, int count, const double *knots,
                               int *inner) {
  int columns = 0, column = 0;
  for (int j = 2; j < count - 2; j++) columns += !at_joint(degree, count, knots, j);

  double *lift = LAM_NEW(arena, double, count *columns);
  for (int j = 2; j < count - 2; j++)
    if (at_joint(degree, count, knots, j)) {
      double h = knots[j + 1] - knots[j], k = knots[j + degree + 1] - knots[j + degree];
      lift[j * columns + column - 1] = k / (h + k);
      lift[j * columns + column] = h / (h + k);
    } else {
      lift[j * columns + column++] = 1;
    }

  *inner = columns;
  return lift;
}

/* product (rows x columns) += factor a (rows x middle) b (middle x columns). */
static void multiply(int rows, int middle, int columns, double factor, const double *a,
                     const double *b, double *product) {
  for (int i = 0; i < rows; i++)
    for (int k = 0; k < middle; k++) {
      double value = factor * a[i * middle + k];
      for (int j = 0; value != 0 && j < columns; j++)
        product[i * columns + j] += value * b[k * columns + j];
    }
}

/* The Gram matrix between free rows: lift^T gram lift. */
static double *reduce(lam_arena *arena, int count, int inner, const double *gram,
                      const double *lift) {
  double *half = LAM_NEW(arena, double, count *inner),
         *result = LAM_NEW(arena, double, inner *inner);
  multiply(count, count, inner, 1, gram, lift, half);
  for (int i = 0; i < inner; i++)
    for (int k = 0; k < count; k++)
      for (int j = 0; j < inner; j++)
        result[i * inner + j] += lift[k * inner + i] * half[k * inner + j];
  return result;
}

/* The energy of the inner points is the sum of Kronecker products G2 x G0 + 2 G1 x G1 + G0 x G2
 * of the reduced matrices; its lower triangle is factored. */
bool lam_thin_plate_make(lam_arena *arena, const int degree[2], const int count[2],
                         const double *const knots[2], lam_thin_plate *plate) {
  double *g[2][3];
  for (int d = 0; d < 2; d++) {
    plate->count[d] = count[d];
    plate->lift[d] = make_lift(arena, degree[d], count[d], knots[d], &plate->inner[d]);
    for (int k = 0; k < 3; k++) {
      plate->gram[d][k] = lam_spline_gram(arena, degree[d], count[d], knots[d], k);
      g[d][k] = reduce(arena, count[d], plate->inner[d], plate->gram[d][k], plate->lift[d]);
    }
  }

  int m = plate->inner[0], n = plate->inner[1];
  double *matrix = LAM_NEW(arena, double, (m * n) * (m * n));
  for (int i = 0; i < m * n; i++)
    for (int j = 0; j <= i; j++) {
      int a = (i / n) * m + j / n, b = (i % n) * n + j % n;
      matrix[(size_t)i * m * n + j] =
          g[0][2][a] * g[1][0][b] + 2 * g[0][1][a] * g[1][1][b] + g[0][0][a] * g[1][2][b];
    }

  plate->factor = matrix;
  return lam_cholesky_factor(m * n, matrix);
}

/* product = sum of factor Gk a G(2-k), with factors 1, 2, 1. */
void lam_thin_plate_apply(lam_arena *arena, const lam_thin_plate *plate, const double *net,
                          double *product) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int m = plate->count[0], n = plate->count[1];
  memset(product, 0, (size_t)(m * n) * sizeof *product);
  for (int k = 0; k < 3; k++) {
    double *half = LAM_NEW(arena, double, m *n);
    multiply(m, m, n, k == 1 ? 2 : 1, plate->gram[0][k], net, half);
    multiply(m, n, n, 1, half, plate->gram[1][2 - k], product);
  }
  lam_arena_release(arena, mark);
}

/* With the inner points at 0 the pull of the outer rings is the right side; the solution of the
 * free points is lifted to all inner ones. */
void lam_thin_plate_fill(lam_arena *arena, const lam_thin_plate *plate, double *net) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int rows = plate->count[0], columns = plate->count[1], m = plate->inner[0], n = plate->inner[1];
  double *product = LAM_NEW(arena, double, rows *columns), *half = LAM_NEW(arena, double, rows *n),
         *free = LAM_NEW(arena, double, m *n);

  for (int i = 2; i < rows - 2; i++)
    for (int j = 2; j < columns - 2; j++) net[i * columns + j] = 0;
  lam_thin_plate_apply(arena, plate, net, product);

  /* lift^T (-product) lift, into the free points. */
  multiply(rows, columns, n, -1, product, plate->lift[1], half);
  for (int k = 0; k < rows; k++)
    for (int i = 0; i < m; i++)
      for (int j = 0; j < n; j++) free[i * n + j] += plate->lift[0][k * m + i] * half[k * n + j];

  lam_cholesky_solve(m * n, plate->factor, free);
  memset(half, 0, (size_t)(rows * n) * sizeof *half);
  multiply(rows, m, n, 1, plate->lift[0], free, half);

  for (int i = 2; i < rows - 2; i++)
    for (int j = 2; j < columns - 2; j++)
      for (int k = 0; k < n; k++)
        net[i * columns + j] += half[i * n + k] * plate->lift[1][j * n + k];
  lam_arena_release(arena, mark);
}
