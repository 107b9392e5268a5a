/* The L^p norm of the Gaussian curvature over the parameters, by Gauss's rule per knot span, as
 * a function of the inner control points. Called by the files of this folder that minimize it.
 *
 * Basis values are tabulated once; K depends on the control points through the five tangents,
 * which are linear in them: x_t = sum_a b_at P_a, so that dK/dP_a = sum_t b_at dK/dx_t. */
#include "core/numbers.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/developable/developable_parts.h"
#include <math.h>
#include <string.h>

/* The nodes of all knot spans of one direction, with the basis functions there. */
typedef struct direction {
  int nodes, width; /* width: degree + 1, the functions that act at a node */
  double *weights;  /* nodes; their sum is 1 */
  double *values;   /* nodes x 3 x width: the functions, their first and second derivatives */
  int *first;       /* nodes: the first function that acts there */
} direction;

/* A quadrature rule: `count` nodes on [0,1] and their weights, whose sum is 1. */
typedef void rule(int count, double *nodes, double *weights);

/* The extrema of a Chebyshev polynomial: they crowd towards 0 and 1 and include both. All weights
 * are alike, because this rule serves to find the largest value, not an integral. */
static void closed_rule(int count, double *nodes, double *weights) {
  for (int k = 0; k < count; k++) {
    nodes[k] = 0.5 - 0.5 * cos(LAM_PI * k / (count - 1));
    weights[k] = 1. / count;
  }
}

/* Tabulates direction d of a surface: count nodes of the rule in every knot span that is not
 * empty. */
static direction make_direction(lam_arena *arena, const lam_spline_surface *s, int d, int count,
                                rule *nodes_of) {
  int degree = s->degree[d], spans = s->count[d] - degree;
  const double *knots = s->knots[d];
  double length = knots[s->count[d]] - knots[degree];
  double *t = LAM_NEW(arena, double, count), *w = LAM_NEW(arena, double, count);
  direction r = {0, degree + 1, LAM_NEW(arena, double, spans *count),
                 LAM_NEW(arena, double, spans *count * 3 * (degree + 1)),
                 LAM_NEW(arena, int, spans *count)};

  nodes_of(count, t, w);
  for (int span = degree; span < s->count[d]; span++) {
    double width = knots[span + 1] - knots[span];
    for (int k = 0; width > 0 && k < count; k++, r.nodes++) {
      double *values = r.values + r.nodes * 3 * r.width;
      lam_basis_eval(degree, knots, span, knots[span] + width * t[k], 2, values);
      r.weights[r.nodes] = w[k] * width / length;
      r.first[r.nodes] = span - degree;
    }
  }
  return r;
}

/* How often each tangent x_u, x_v, x_uu, x_uv, x_vv is differentiated by u and by v. */
static const int order[LAM_TANGENTS][2] = {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

/* Node (a, b) of the product of both directions: the numbers of the control points that act
 * there and the derivatives of their basis functions, in the order of the tangents. row: points
 * per row of the net. */
static void fill_node(const direction *u, const direction *v, int a, int b, int row, int *points,
                      double *basis) {
  for (int k = 0; k < u->width * v->width; k++) {
    int i = k / v->width, j = k % v->width;
    points[k] = (u->first[a] + i) * row + v->first[b] + j;
    for (int t = 0; t < LAM_TANGENTS; t++)
      basis[k * LAM_TANGENTS + t] = u->values[(a * 3 + order[t][0]) * u->width + i] *
                                    v->values[(b * 3 + order[t][1]) * v->width + j];
  }
}

/* The five tangents d at a node with `arity` points, for the control points x. */
static void tangents(int arity, const int *points, const double *basis, const lam_vec3 *x,
                     lam_vec3 d[LAM_TANGENTS]) {
  memset(d, 0, LAM_TANGENTS * sizeof *d);
  for (int a = 0; a < arity; a++)
    for (int t = 0; t < LAM_TANGENTS; t++)
      d[t] = lam_along(d[t], basis[a * LAM_TANGENTS + t], x[points[a]]);
}

/* Marks the nodes where |K| at control points x is at least `share` of its largest value: fills
 * kept with their numbers and returns how many there are. */
static int choose(lam_arena *arena, const direction *u, const direction *v, int row,
                  const lam_vec3 *x, double share, int *kept) {
  int all = u->nodes * v->nodes, arity = u->width * v->width, count = 0;
  double *basis = LAM_NEW(arena, double, arity *LAM_TANGENTS), *K = LAM_NEW(arena, double, all);
  double most = 0, stretch;
  int *points = LAM_NEW(arena, int, arity);

  for (int g = 0; g < all; g++) {
    lam_vec3 d[LAM_TANGENTS];
    fill_node(u, v, g / v->nodes, g % v->nodes, row, points, basis);
    tangents(arity, points, basis, x, d);
    K[g] = fabs(lam_gauss_derivatives(d, &stretch, NULL, NULL));
    most = fmax(most, K[g]);
  }

  for (int g = 0; g < all; g++)
    if (K[g] >= share * most) kept[count++] = g;
  return count;
}

/* Numbers the unknowns, three for every inner control point; -1 on the boundary. Returns their
 * number. */
static int number_unknowns(const lam_spline_surface *s, int *unknown) {
  int count = 0;
  for (int i = 0; i < s->count[0]; i++)
    for (int j = 0; j < s->count[1]; j++) {
      bool inner = i > 0 && j > 0 && i < s->count[0] - 1 && j < s->count[1] - 1;
      unknown[i * s->count[1] + j] = inner ? count : -1;
      count += inner ? 3 : 0;
    }
  return count;
}

/* The norm over count nodes of the rule per span and direction; with x only those nodes where |K|
 * at control points x is at least `share` of its largest value. */
static lam_gauss_norm make_norm(lam_arena *arena, const lam_spline_surface *s, int count,
                                rule *nodes_of, const lam_vec3 *x, double share) {
  direction u = make_direction(arena, s, 0, count, nodes_of),
            v = make_direction(arena, s, 1, count, nodes_of);
  lam_gauss_norm norm = {.nodes = u.nodes * v.nodes, .arity = u.width * v.width};
  int arity = norm.arity, *kept = LAM_NEW(arena, int, norm.nodes);
  for (int g = 0; g < norm.nodes; g++) kept[g] = g;
  if (x) norm.nodes = choose(arena, &u, &v, s->count[1], x, share, kept);

  double *weights = LAM_NEW(arena, double, norm.nodes);
  double *basis = LAM_NEW(arena, double, (size_t)norm.nodes *(size_t)(arity * LAM_TANGENTS));
  int *points = LAM_NEW(arena, int, (size_t)norm.nodes *(size_t)arity);
  for (int g = 0; g < norm.nodes; g++) {
    int a = kept[g] / v.nodes, b = kept[g] % v.nodes;
    weights[g] = u.weights[a] * v.weights[b];
    fill_node(&u, &v, a, b, s->count[1], points + (size_t)g * (size_t)arity,
              basis + (size_t)g * (size_t)(arity * LAM_TANGENTS));
  }

  int *unknown = LAM_NEW(arena, int, s->count[0] * s->count[1]);
  norm.unknowns = number_unknowns(s, unknown);
  norm.weights = weights;
  norm.basis = basis;
  norm.points = points;
  norm.unknown = unknown;
  norm.local = LAM_NEW(arena, double, arity *(3 + 3 * LAM_GAUSS_VARIABLES));
  return norm;
}

lam_gauss_norm lam_gauss_norm_make(lam_arena *arena, const lam_spline_surface *s, int count) {
  return make_norm(arena, s, count, lam_gauss_rule, NULL, 0);
}

lam_gauss_norm lam_gauss_norm_closed(lam_arena *arena, const lam_spline_surface *s, int count,
                                     const lam_vec3 *x, double share) {
  return make_norm(arena, s, count, closed_rule, x, share);
}

/* A copy of two arrays, one after the other, of elements of `size` bytes. */
static void *joined(lam_arena *arena, size_t size, const void *a, int a_count, const void *b,
                    int b_count) {
  char *both = lam_arena_alloc(arena, (size_t)(a_count + b_count), size);
  memcpy(both, a, (size_t)a_count * size);
  memcpy(both + (size_t)a_count * size, b, (size_t)b_count * size);
  return both;
}

/* Unknowns and room for the kernel are those of a: both norms are of one surface. */
lam_gauss_norm lam_gauss_norm_join(lam_arena *arena, const lam_gauss_norm *a,
                                   const lam_gauss_norm *b) {
  size_t arity = (size_t)a->arity;
  lam_gauss_norm norm = *a;
  norm.nodes = a->nodes + b->nodes;
  norm.weights = joined(arena, sizeof *a->weights, a->weights, a->nodes, b->weights, b->nodes);
  norm.points = joined(arena, arity * sizeof *a->points, a->points, a->nodes, b->points, b->nodes);
  norm.basis = joined(arena, arity * LAM_TANGENTS * sizeof *a->basis, a->basis, a->nodes, b->basis,
                      b->nodes);
  return norm;
}

/* Adds dK/dP_a = sum_t b_at dK/dx_t of the points that act at a node, times slope, to the
 * gradient, and keeps it unscaled in h, three numbers per point. first: dK/dx_t. */
static void add_gradient(const lam_gauss_norm *norm, const int *point, const double *basis,
                         const lam_vec3 first[LAM_TANGENTS], double slope, double *h,
                         double *gradient) {
  for (int a = 0; a < norm->arity; a++) {
    int unknown = norm->unknown[point[a]];
    if (unknown < 0) continue;

    lam_vec3 dK = {0};
    for (int t = 0; t < LAM_TANGENTS; t++)
      dK = lam_along(dK, basis[a * LAM_TANGENTS + t], first[t]);
    h[3 * a] = dK.x;
    h[3 * a + 1] = dK.y;
    h[3 * a + 2] = dK.z;
    for (int i = 0; i < 3; i++) gradient[unknown + i] += slope * h[3 * a + i];
  }
}

/* half = bend b^T second, 3 x 15 for every point that acts at a node: the left half of the product
 * b^T second b. */
static void multiply_left(const lam_gauss_norm *norm, const int *point, const double *basis,
                          double bend, const double *second, double *half) {
  for (int a = 0; a < norm->arity; a++) {
    double *out = half + 3 * LAM_GAUSS_VARIABLES * a;
    if (norm->unknown[point[a]] < 0) continue;

    memset(out, 0, 3 * LAM_GAUSS_VARIABLES * sizeof *out);
    for (int t = 0; t < LAM_TANGENTS; t++)
      for (int i = 0; i < 3; i++) {
        double factor = bend * basis[a * LAM_TANGENTS + t];
        const double *row = second + (3 * t + i) * LAM_GAUSS_VARIABLES;
        for (int k = 0; k < LAM_GAUSS_VARIABLES; k++)
          out[i * LAM_GAUSS_VARIABLES + k] += factor * row[k];
      }
  }
}

/* Adds slope h h^T + bend b^T second b of one node to the lower triangle; h: the gradient of K by
 * the points that act here, second: the 15 x 15 Hessian of K, not read when bend is 0. */
static void add_hessian(const lam_gauss_norm *norm, const int *point, const double *basis,
                        const double *h, double slope, double bend, const double *second,
                        double *hessian) {
  double *half = norm->local + 3 * norm->arity; /* arity x 3 x 15 */
  if (bend != 0) multiply_left(norm, point, basis, bend, second, half);

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
            out[k] += cb[0] * from[k] + cb[1] * from[3 + k] + cb[2] * from[6 + k] +
                      cb[3] * from[9 + k] + cb[4] * from[12 + k];
        }
      }
    }
  }
}

/* Where |K/scale|^(p-2) is less, the derivatives of a node are left out. */
static const double negligible = 1e-30;

/* With k = K/scale a node adds w |k|^p, its gradient slope dK, slope = w p |k|^(p-2) k / scale, and
 * the Hessian w p (p-1) |k|^(p-2) / scale^2 dK dK^T + slope d2K. */
lam_gauss_value lam_gauss_norm_eval(const lam_gauss_norm *norm, const lam_vec3 *x, double p,
                                    double scale, lam_order want, double *gradient,
                                    double *hessian) {
  lam_gauss_value value = {.scale = scale};
  double least = INFINITY, most = 0, second[LAM_GAUSS_VARIABLES * LAM_GAUSS_VARIABLES];
  int n = norm->unknowns;
  if (want >= LAM_ORDER_GRADIENT) memset(gradient, 0, (size_t)n * sizeof *gradient);
  if (want >= LAM_ORDER_GAUSS_NEWTON) memset(hessian, 0, (size_t)n * (size_t)n * sizeof *hessian);

  for (int g = 0; g < norm->nodes; g++) {
    const int *point = norm->points + g * norm->arity;
    const double *basis = norm->basis + (size_t)g * norm->arity * LAM_TANGENTS;
    lam_vec3 d[LAM_TANGENTS], first[LAM_TANGENTS];
    tangents(norm->arity, point, basis, x, d);

    double stretch, w = norm->weights[g];
    double K = lam_gauss_derivatives(d, &stretch, NULL, NULL) / scale, k = fabs(K),
           outer = p == 2 ? 1 : pow(k, p - 2);
    value.power += w * outer * k * k;
    value.max = fmax(value.max, k * scale);
    value.area += w * stretch;
    least = fmin(least, stretch);
    most = fmax(most, stretch);

    if (want == LAM_ORDER_VALUE || (p > 2 && outer < negligible)) continue;
    lam_gauss_derivatives(d, &stretch, first, want == LAM_ORDER_NEWTON ? second : NULL);
    double slope = w * p * outer * K / scale, *h = norm->local;
    add_gradient(norm, point, basis, first, slope, h, gradient);
    if (want >= LAM_ORDER_GAUSS_NEWTON)
      add_hessian(norm, point, basis, h, w * p * (p - 1) * outer / (scale * scale),
                  want == LAM_ORDER_NEWTON ? slope : 0, second, hessian);
  }

  value.ratio = most > 0 ? least / most : 0;
  return value;
}
