/* The Gaussian curvature K of a surface as a function of its first and second derivatives, with
 * gradient and Hessian. Called by curvature_norm.c at every node of the quadrature.
 *
 * K = (l n - m^2) / D^2 with c = x_u x x_v, D = c.c, l = x_uu.c, m = x_uv.c, n = x_vv.c: no roots,
 * no unit normal. First derivatives, by the vector in front of which they stand:
 *
 *   dl:  c on x_uu,  x_v x x_uu on x_u,  x_uu x x_u on x_v  (a triple product); likewise m, n
 *   dD:  2 x_v x c on x_u,  2 c x x_u on x_v
 *
 * With y = (l, m, n, D) the Hessian is sum K_ij dy_i dy_j^T + sum K_i d2y_i. With [a] b = a x b,
 * the second derivatives are
 *
 *   l:  -[x_v] for (x_uu, x_u),  [x_u] for (x_uu, x_v),  -[x_uu] for (x_u, x_v)
 *   D:  2 [x_v]^T [x_v] for (x_u, x_u),  2 [x_u]^T [x_u] for (x_v, x_v),
 *       -2 [x_v]^T [x_u] - 2 [c] for (x_u, x_v) */
#include "surf/developable/developable_parts.h"
#include <string.h>

enum { U, V, UU, UV, VV };

/* Adds factor [a] to the block (row, column) of the 15 x 15 matrix h and its transpose,
 * -factor [a], to (column, row). */
static void add_cross(double *h, int row, int column, lam_vec3 a, double factor) {
  const double m[3][3] = {{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}};

  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) {
      h[(3 * row + i) * LAM_GAUSS_VARIABLES + 3 * column + k] += factor * m[i][k];
      h[(3 * column + k) * LAM_GAUSS_VARIABLES + 3 * row + i] += factor * m[i][k];
    }
}

/* Adds factor [a]^T [b] = factor ((a.b) I - b a^T) to the block (row, column) of h and, off the
 * diagonal, its transpose to (column, row). */
static void add_square(double *h, int row, int column, lam_vec3 a, lam_vec3 b, double factor) {
  const double p[3] = {a.x, a.y, a.z}, q[3] = {b.x, b.y, b.z};

  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) {
      double value = factor * ((i == k ? lam_dot(a, b) : 0) - q[i] * p[k]);
      h[(3 * row + i) * LAM_GAUSS_VARIABLES + 3 * column + k] += value;
      if (row != column) h[(3 * column + k) * LAM_GAUSS_VARIABLES + 3 * row + i] += value;
    }
}

/* The gradient y[5] of the triple product d[second].c, c = x_u x x_v. */
static void triple_gradient(const lam_vec3 d[], lam_vec3 c, int second, lam_vec3 *y) {
  y[second] = c;
  y[U] = lam_cross(d[V], d[second]);
  y[V] = lam_cross(d[second], d[U]);
}

/* Adds factor times the Hessian of the triple product d[second].(x_u x x_v) to h. */
static void triple_hessian(const lam_vec3 d[], int second, double factor, double *h) {
  add_cross(h, second, U, d[V], -factor);
  add_cross(h, second, V, d[U], factor);
  add_cross(h, U, V, d[second], -factor);
}

/* Sets second (15 x 15) to sum K_ij dy_i dy_j^T; y[i] are the gradients of l, m, n, D. */
static void gradient_products(lam_vec3 y[4][LAM_TANGENTS], const double K_ij[4][4],
                              double *second) {
  double flat[4][LAM_GAUSS_VARIABLES], mixed[4][LAM_GAUSS_VARIABLES] = {{0}};
  for (int k = 0; k < 4; k++)
    for (int a = 0; a < LAM_TANGENTS; a++) {
      flat[k][3 * a] = y[k][a].x;
      flat[k][3 * a + 1] = y[k][a].y;
      flat[k][3 * a + 2] = y[k][a].z;
    }

  for (int k = 0; k < 4; k++)
    for (int j = 0; j < 4; j++)
      for (int i = 0; K_ij[k][j] != 0 && i < LAM_GAUSS_VARIABLES; i++)
        mixed[k][i] += K_ij[k][j] * flat[j][i];

  for (int i = 0; i < LAM_GAUSS_VARIABLES; i++)
    for (int j = 0; j < LAM_GAUSS_VARIABLES; j++)
      second[i * LAM_GAUSS_VARIABLES + j] = flat[0][i] * mixed[0][j] + flat[1][i] * mixed[1][j] +
                                            flat[2][i] * mixed[2][j] + flat[3][i] * mixed[3][j];
}

/* Adds factor times the Hessian of D = |x_u x x_v|^2 to h. */
static void square_hessian(const lam_vec3 d[], lam_vec3 c, double factor, double *h) {
  add_square(h, U, U, d[V], d[V], 2 * factor);
  add_square(h, V, V, d[U], d[U], 2 * factor);
  add_square(h, U, V, d[V], d[U], -2 * factor);
  add_cross(h, U, V, c, -2 * factor);
}

/* The equations stand at the top of the file. */
double lam_gauss_derivatives(const lam_vec3 d[LAM_TANGENTS], double *stretch, lam_vec3 *first,
                             double *second) {
  lam_vec3 c = lam_cross(d[U], d[V]);
  double D = lam_dot(c, c), l = lam_dot(d[UU], c), m = lam_dot(d[UV], c), n = lam_dot(d[VV], c);
  double s = 1 / (D * D), K = (l * n - m * m) * s;
  *stretch = sqrt(D);
  if (!first && !second) return K;

  /* The gradients of l, m, n, D, and K_i, the derivatives of K by them. */
  lam_vec3 y[4][LAM_TANGENTS] = {{{0}}};
  for (int k = 0; k < 3; k++) triple_gradient(d, c, UU + k, y[k]);
  y[3][U] = lam_scale(lam_cross(d[V], c), 2);
  y[3][V] = lam_scale(lam_cross(c, d[U]), 2);
  const double K_i[4] = {n * s, -2 * m * s, l * s, -2 * K / D};

  if (first)
    for (int a = 0; a < LAM_TANGENTS; a++) {
      first[a] = lam_scale(y[0][a], K_i[0]);
      for (int k = 1; k < 4; k++) first[a] = lam_along(first[a], K_i[k], y[k][a]);
    }
  if (!second) return K;

  const double K_ij[4][4] = {{0, 0, s, -2 * K_i[0] / D},
                             {0, -2 * s, 0, -2 * K_i[1] / D},
                             {s, 0, 0, -2 * K_i[2] / D},
                             {-2 * K_i[0] / D, -2 * K_i[1] / D, -2 * K_i[2] / D, 6 * K / (D * D)}};
  gradient_products(y, K_ij, second);
  for (int k = 0; k < 3; k++) triple_hessian(d, UU + k, K_i[k], second);
  square_hessian(d, c, K_i[3], second);
  return K;
}
