/* Least squares of geometry: the plane through points, and the eigenvalues it needs. Called by the
 * measures of nets, by curve/curve_fairness.c, mesh/offset.c, fab/parts/panel.c and
 * surf/spline/spline_near.c. */
#include "core/numeric/fit.h"

#include <math.h>

/* One Jacobi rotation in the plane of axes p and q: a becomes R^T a R with a[p][q] = 0, and the
 * columns of vector turn with it (Golub & Van Loan, Matrix Computations, ch. 8). */
static void rotate(double a[3][3], double vector[3][3], int p, int q) {
  double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
  double c = 1 / sqrt(t * t + 1), s = t * c;

  for (int k = 0; k < 3; k++) {
    double x = a[k][p], y = a[k][q];
    a[k][p] = c * x - s * y, a[k][q] = s * x + c * y;
  }
  for (int k = 0; k < 3; k++) {
    double x = a[p][k], y = a[q][k];
    a[p][k] = c * x - s * y, a[q][k] = s * x + c * y;
    x = vector[k][p], y = vector[k][q];
    vector[k][p] = c * x - s * y, vector[k][q] = s * x + c * y;
  }
}

/* Cyclic Jacobi: sweeps over the three pairs until the rest outside the diagonal is gone. */
void lam_eigen3(double a[3][3], double value[3], double vector[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) vector[i][j] = i == j;

  for (int sweep = 0; sweep < 60; sweep++) {
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++)
        if (a[p][q] != 0) rotate(a, vector, p, q);
    if (fabs(a[0][1]) + fabs(a[0][2]) + fabs(a[1][2]) < 1e-300) break;
  }

  for (int i = 0; i < 3; i++) value[i] = a[i][i];
}

/* The normal is the eigenvector of the least eigenvalue of the covariance of the points. */
lam_vec3 lam_fit_plane(const lam_vec3 *points, int count, lam_vec3 *center, double spread[3]) {
  lam_vec3 c = {0, 0, 0};
  for (int i = 0; i < count; i++) c = lam_add(c, points[i]);
  c = lam_scale(c, 1.0 / count);

  double a[3][3] = {{0}}, value[3], vector[3][3];
  for (int i = 0; i < count; i++) {
    lam_vec3 d = lam_sub(points[i], c);
    double x[3] = {d.x, d.y, d.z};
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < 3; l++) a[k][l] += x[k] * x[l] / count;
  }

  /* Ascending eigenvalues. */
  lam_eigen3(a, value, vector);
  int order[3] = {0, 1, 2};
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2 - i; j++)
      if (value[order[j]] > value[order[j + 1]]) {
        int swap = order[j];
        order[j] = order[j + 1];
        order[j + 1] = swap;
      }

  for (int i = 0; i < 3; i++) spread[i] = sqrt(fmax(value[order[i]], 0));
  *center = c;
  return lam_v3(vector[0][order[0]], vector[1][order[0]], vector[2][order[0]]);
}
