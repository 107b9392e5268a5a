/* ||K||_p by Gauss's rule, per knot span. Basis values are tabulated once; K depends on the control points through the
 * five tangents, which are linear in them: x_t = sum_a b_at P_a, so that dK/dP_a = sum_t b_at dK/dx_t. */
#include "core/quadrature.h"
#include "curve/basis.h"
#include "surf/developable_parts.h"
#include <string.h>

typedef struct direction {
  int places, width;
  double *weights, *values; /* values: places x 3 x width */
  int *first;
} direction;

static direction make_direction(lam_arena *arena, const lam_spline_surface *s, int d, int count) {
  int degree = s->degree[d], spans = s->count[d] - degree;
  const double *knots = s->knots[d];
  double length = knots[s->count[d]] - knots[degree];
  double *t = LAM_NEW(arena, double, count), *w = LAM_NEW(arena, double, count);
  direction r = {0, degree + 1, LAM_NEW(arena, double, spans *count),
                 LAM_NEW(arena, double, spans *count * 3 * (degree + 1)), LAM_NEW(arena, int, spans *count)};
  lam_gauss_rule(count, t, w);
  for (int span = degree; span < s->count[d]; span++) {
    double width = knots[span + 1] - knots[span];
    for (int k = 0; width > 0 && k < count; k++, r.places++) {
      double *values = r.values + r.places * 3 * r.width;
      lam_basis_eval(degree, knots, span, knots[span] + width * t[k], 2, values);
      r.weights[r.places] = w[k] * width / length;
      r.first[r.places] = span - degree;
    }
  }
  return r;
}

lam_gauss_norm lam_gauss_norm_make(lam_arena *arena, const lam_spline_surface *s, int count) {
  direction u = make_direction(arena, s, 0, count), v = make_direction(arena, s, 1, count);
  lam_gauss_norm norm = {.places = u.places * v.places, .arity = u.width * v.width};
  double *weights = LAM_NEW(arena, double, norm.places);
  double *basis = LAM_NEW(arena, double, norm.places *norm.arity *LAM_TANGENTS);
  int *points = LAM_NEW(arena, int, norm.places *norm.arity), *unknown = LAM_NEW(arena, int, s->count[0] * s->count[1]);
  static const int order[LAM_TANGENTS][2] = {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
  for (int i = 0; i < s->count[0]; i++)
    for (int j = 0; j < s->count[1]; j++) {
      bool inner = i > 0 && j > 0 && i < s->count[0] - 1 && j < s->count[1] - 1;
      unknown[i * s->count[1] + j] = inner ? norm.unknowns : -1;
      norm.unknowns += inner ? 3 : 0;
    }
  for (int g = 0; g < norm.places; g++) {
    int a = g / v.places, b = g % v.places;
    weights[g] = u.weights[a] * v.weights[b];
    for (int k = 0; k < norm.arity; k++) {
      int i = k / v.width, j = k % v.width;
      points[g * norm.arity + k] = (u.first[a] + i) * s->count[1] + v.first[b] + j;
      for (int t = 0; t < LAM_TANGENTS; t++)
        basis[(g * norm.arity + k) * LAM_TANGENTS + t] =
            u.values[(a * 3 + order[t][0]) * u.width + i] * v.values[(b * 3 + order[t][1]) * v.width + j];
    }
  }
  norm.weights = weights;
  norm.basis = basis;
  norm.points = points;
  norm.unknown = unknown;
  norm.local = LAM_NEW(arena, double, norm.arity *(3 + 3 * LAM_GAUSS_VARIABLES));
  return norm;
}

/* Adds scale * (slope h h^T + bend b^T second b) of one place; h: gradient of K by the points that act here. */
static void add_hessian(const lam_gauss_norm *norm, const int *point, const double *basis, const double *h,
                        double slope, double bend, const double *second, double *hessian) {
  double *half = norm->local + 3 * norm->arity; /* per point 3 x 15: b^T second */
  for (int a = 0; bend != 0 && a < norm->arity; a++) {
    double *out = half + 3 * LAM_GAUSS_VARIABLES * a;
    if (norm->unknown[point[a]] < 0) continue;
    memset(out, 0, 3 * LAM_GAUSS_VARIABLES * sizeof *out);
    for (int t = 0; t < LAM_TANGENTS; t++)
      for (int i = 0; i < 3; i++) {
        double factor = bend * basis[a * LAM_TANGENTS + t];
        const double *row = second + (3 * t + i) * LAM_GAUSS_VARIABLES;
        for (int k = 0; k < LAM_GAUSS_VARIABLES; k++) out[i * LAM_GAUSS_VARIABLES + k] += factor * row[k];
      }
  }
  for (int a = 0; a < norm->arity; a++) {
    int row = norm->unknown[point[a]];
    if (row < 0) continue;
    for (int b = 0; b <= a; b++) {
      int column = norm->unknown[point[b]];
      if (column < 0) continue;
      const double *cb = basis + b * LAM_TANGENTS;
      for (int i = 0; i < 3; i++) {
        double *out = hessian + (size_t)(row + i) * norm->unknowns + column;
        const double *from = half + (3 * a + i) * LAM_GAUSS_VARIABLES;
        for (int k = 0; k < 3; k++) {
          out[k] += slope * h[3 * a + i] * h[3 * b + k];
          if (bend != 0)
            out[k] += cb[0] * from[k] + cb[1] * from[3 + k] + cb[2] * from[6 + k] + cb[3] * from[9 + k] +
                      cb[4] * from[12 + k];
        }
      }
    }
  }
}

lam_gauss_value lam_gauss_norm_eval(const lam_gauss_norm *norm, const lam_vec3 *x, double p, double scale,
                                    lam_order order, double *gradient, double *hessian) {
  lam_gauss_value value = {.ratio = 0};
  double least = INFINITY, most = 0, second[LAM_GAUSS_VARIABLES * LAM_GAUSS_VARIABLES];
  int n = norm->unknowns;
  if (order >= LAM_ORDER_GRADIENT) memset(gradient, 0, (size_t)n * sizeof *gradient);
  if (order >= LAM_ORDER_GAUSS_NEWTON) memset(hessian, 0, (size_t)n * (size_t)n * sizeof *hessian);
  for (int g = 0; g < norm->places; g++) {
    const int *point = norm->points + g * norm->arity;
    const double *basis = norm->basis + (size_t)g * norm->arity * LAM_TANGENTS;
    lam_vec3 d[LAM_TANGENTS] = {{0}}, first[LAM_TANGENTS];
    for (int a = 0; a < norm->arity; a++)
      for (int t = 0; t < LAM_TANGENTS; t++) d[t] = lam_along(d[t], basis[a * LAM_TANGENTS + t], x[point[a]]);
    double stretch,
        K = lam_gauss_derivatives(d, &stretch, order ? first : NULL, order == LAM_ORDER_NEWTON ? second : NULL) / scale;
    double w = norm->weights[g], k = fabs(K), outer = p == 2 ? 1 : pow(k, p - 2);
    value.power += w * outer * k * k;
    value.max = fmax(value.max, k * scale);
    value.area += w * stretch;
    least = fmin(least, stretch);
    most = fmax(most, stretch);
    if (order == LAM_ORDER_VALUE) continue;
    double slope = w * p * outer * K / scale, *h = norm->local;
    for (int a = 0; a < norm->arity; a++) {
      int unknown = norm->unknown[point[a]];
      if (unknown < 0) continue;
      lam_vec3 dK = {0};
      for (int t = 0; t < LAM_TANGENTS; t++) dK = lam_along(dK, basis[a * LAM_TANGENTS + t], first[t]);
      h[3 * a] = dK.x;
      h[3 * a + 1] = dK.y;
      h[3 * a + 2] = dK.z;
      for (int i = 0; i < 3; i++) gradient[unknown + i] += slope * h[3 * a + i];
    }
    if (order >= LAM_ORDER_GAUSS_NEWTON)
      add_hessian(norm, point, basis, h, w * p * (p - 1) * outer / (scale * scale),
                  order == LAM_ORDER_NEWTON ? slope : 0, second, hessian);
  }
  value.ratio = most > 0 ? least / most : 0;
  return value;
}
