/* Derivatives of spline surfaces by Leibniz' rule (Piegl & Tiller, The NURBS Book, eq. 4.20),
 * for the files of surf/spline. With x = A / W and (a,b) the derivative a times by u and b
 * times by v,
 *   W x^(a,b) = A^(a,b) - sum_{(i,j) != (0,0)} C(a,i) C(b,j) W^(i,j) x^(a-i,b-j). */
#include "curve/bspline/basis.h"
#include "surf/spline/spline_edit.h"
#include <assert.h>

enum { ORDERS = LAM_SPLINE_MAX_ORDER + 1 };

/* A with its derivatives in sum[a][b][0..2] and W in sum[a][b][3], for a + b <= order. */
static void sum_net(const lam_spline_surface *s, double u, double v, int order,
                    double sum[ORDERS][ORDERS][4]) {
  double at[2] = {u, v}, basis[2][ORDERS * LAM_BASIS_MAX_VALUES];
  int first[2], width[2];

  /* The functions of either direction that do not vanish at (u,v). */
  for (int d = 0; d < 2; d++) {
    int span = lam_basis_span(s->degree[d], s->count[d], s->knots[d], at[d]);
    lam_basis_eval(s->degree[d], s->knots[d], span, at[d], order, basis[d]);
    first[d] = span - s->degree[d];
    width[d] = s->degree[d] + 1;
  }

  for (int i = 0; i < width[0]; i++)
    for (int j = 0; j < width[1]; j++) {
      size_t k = (size_t)(first[0] + i) * s->count[1] + first[1] + j;
      double w = s->weights ? s->weights[k] : 1;
      for (int a = 0; a <= order; a++)
        for (int b = 0; a + b <= order; b++) {
          double f = w * basis[0][a * width[0] + i] * basis[1][b * width[1] + j];
          sum[a][b][0] += f * s->points[k].x;
          sum[a][b][1] += f * s->points[k].y;
          sum[a][b][2] += f * s->points[k].z;
          sum[a][b][3] += f;
        }
    }
}

/* Orders rise, so that what the sum needs has been computed before. */
void lam_spline_surface_derivatives(const lam_spline_surface *s, double u, double v, int order,
                                    lam_vec3 *values) {
  static const double binomial[ORDERS][ORDERS] = {{1},
                                                  {1, 1},
                                                  {1, 2, 1},
                                                  {1, 3, 3, 1},
                                                  {1, 4, 6, 4, 1},
                                                  {1, 5, 10, 10, 5, 1},
                                                  {1, 6, 15, 20, 15, 6, 1}};

  double sum[ORDERS][ORDERS][4] = {{{0}}};
  assert(order <= LAM_SPLINE_MAX_ORDER);
  sum_net(s, u, v, order, sum);

  int n = order + 1;
  for (int a = 0; a <= order; a++)
    for (int b = 0; a + b <= order; b++) {
      lam_vec3 x = lam_v3(sum[a][b][0], sum[a][b][1], sum[a][b][2]);
      for (int i = 0; s->weights && i <= a; i++)
        for (int j = 0; j <= b; j++)
          if (i + j > 0)
            x = lam_along(x, -binomial[a][i] * binomial[b][j] * sum[i][j][3],
                          values[(a - i) * n + b - j]);
      values[a * n + b] = s->weights ? lam_scale(x, 1 / sum[0][0][3]) : x;
    }
}

/* Derivative (a, b) stands at 3 a + b. */
lam_jet lam_spline_surface_jet(const lam_spline_surface *surface, double u, double v) {
  lam_vec3 x[9];
  lam_spline_surface_derivatives(surface, u, v, 2, x);
  return (lam_jet){.x = x[0], .u = x[3], .v = x[1], .uu = x[6], .uv = x[4], .vv = x[2]};
}
