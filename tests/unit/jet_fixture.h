/* Curvatures of a grid net by a jet fit: in the frame of the vertex normal, the height of the 5 x 5
 * vertices around is fitted by a polynomial of degree 4 (least squares); K and H come from its
 * derivatives at the vertex. Nothing of the solver is used. */
#ifndef LAM_TESTS_JET_FIXTURE_H
#define LAM_TESTS_JET_FIXTURE_H

#include "net_fixture.h"

typedef struct jet_curvature {
  double K, H;
} jet_curvature;

enum { jet_degree = 4, jet_terms = 15 };

/* Gaussian elimination of the normal equations A c = b. */
static inline void jet_solve(double A[jet_terms][jet_terms], double b[jet_terms]) {
  for (int c = 0; c < jet_terms; c++) /* positive definite: no pivots */
    for (int r = c + 1; r < jet_terms; r++) {
      double factor = A[r][c] / A[c][c];
      for (int k = c; k < jet_terms; k++) A[r][k] -= factor * A[c][k];
      b[r] -= factor * b[c];
    }
  for (int c = jet_terms - 1; c >= 0; c--) {
    for (int k = c + 1; k < jet_terms; k++) b[c] -= A[c][k] * b[k];
    b[c] /= A[c][c];
  }
}

/* At vertex (i, j) of a grid with m vertices per row, at least two rows from the border. */
static inline jet_curvature jet_fit(const lam_vec3 *x, const lam_vec3 *normals, int m, int i,
                                    int j) {
  int c = i * m + j;
  double scale = lam_distance(x[c], x[c + 1]);
  lam_vec3 n = normals[c], a = lam_sub(x[c + m], x[c]);
  a = lam_unit(lam_along(a, -lam_dot(a, n), n));
  lam_vec3 b = lam_cross(n, a);
  double A[jet_terms][jet_terms] = {{0}}, rhs[jet_terms] = {0};
  for (int di = -2; di <= 2; di++)
    for (int dj = -2; dj <= 2; dj++) {
      lam_vec3 d = lam_scale(lam_sub(x[c + di * m + dj], x[c]), 1 / scale);
      double u = lam_dot(d, a), v = lam_dot(d, b), w = lam_dot(d, n), row[jet_terms];
      int k = 0;
      for (int degree = 0; degree <= jet_degree; degree++)
        for (int q = 0; q <= degree; q++) row[k++] = pow(u, degree - q) * pow(v, q);
      for (int r = 0; r < jet_terms; r++) {
        rhs[r] += row[r] * w;
        for (int s = 0; s < jet_terms; s++) A[r][s] += row[r] * row[s];
      }
    }
  jet_solve(A, rhs);
  double p = rhs[1], q = rhs[2], r = 2 * rhs[3], s = rhs[4], t = 2 * rhs[5], g = 1 + p * p + q * q;
  return (jet_curvature){(r * t - s * s) / (g * g) / (scale * scale),
                         ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * pow(g, 1.5)) /
                             scale};
}

#endif
