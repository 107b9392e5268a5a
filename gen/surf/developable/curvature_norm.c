/* ||K||_p by Gauss's rule, per knot span. Basis values are tabulated once; K depends on the control
 * points through the five tangents, which are linear in them: x_t = sum_a b_at P_a, so that dK/dP_a
 * = sum_t b_at dK/dx_t. */
#include "core/numbers.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/developable/developable_parts.h"
#include <math.h>
#include <string.h>

typedef struct direction {
  int places, width;
  double *weights, *values; /* values: places x 3 x width */
  int *first;
} direction;

/* The places on [0,1] and their weights. */
typedef void rule(int count, double *places, double *weights);

/* Close to each other at the ends, which belong to them; all weights alike. */
static void closed_rule(int count, double *places, double *weights) {
  for (int k = 0; k < count; k++) {
    places[k] = 0.5 - 0.5 * cos(LAM_PI * k / (count - 1));
    weights[k] = 1. / count;
  }
}

static direction make_direction(lam_arena *arena, const lam_spline_surface *s, int d, int count,
                                rule *places_of) {
  int degree = s->degree[d], spans = s->count[d] - degree;
  const double *knots = s->knots[d];
  double length = knots[s->count[d]] - knots[degree];
  double *t = LAM_NEW(arena, double, count), *w = LAM_NEW(arena, double, count);
  direction r = {0, degree + 1, LAM_NEW(arena, double, spans *count),
                 LAM_NEW(arena, double, spans *count * 3 * (degree + 1)),
                 LAM_NEW(arena, int, spans *count)};
  places_of(count, t, w);
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

static const int order[LAM_TANGENTS][2] = {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

/* Place (a, b) of the product of both directions: the control points that act there, and their
 * basis functions. */
static void fill_place(const direction *u, const direction *v, int a, int b, int row, int *points,
                       double *basis) {
  for (int k = 0; k < u->width * v->width; k++) {
    int i = k / v->width, j = k % v->width;
    points[k] = (u->first[a] + i) * row + v->first[b] + j;
    for (int t = 0; t < LAM_TANGENTS; t++)
      basis[k * LAM_TANGENTS + t] = u->values[(a * 3 + order[t][0]) * u->width + i] *
                                    v->values[(b * 3 + order[t][1]) * v->width + j];
  }
}

static void tangents(int arity, const int *points, const double *basis, const lam_vec3 *x,
                     lam_vec3 d[LAM_TANGENTS]) {
  memset(d, 0, LAM_TANGENTS * sizeof *d);
  for (int a = 0; a < arity; a++)
    for (int t = 0; t < LAM_TANGENTS; t++)
      d[t] = lam_along(d[t], basis[a * LAM_TANGENTS + t], x[points[a]]);
}

/* Marks the places where |K| at control points x is at least the share of its largest value;
 * returns their number. */
static int choose(lam_arena *arena, const direction *u, const direction *v, int row,
                  const lam_vec3 *x, double share, int *kept) {
  int all = u->places * v->places, arity = u->width * v->width, count = 0;
  double *basis = LAM_NEW(arena, double, arity *LAM_TANGENTS), *K = LAM_NEW(arena, double, all),
         most = 0, stretch;
  int *points = LAM_NEW(arena, int, arity);
  for (int g = 0; g < all; g++) {
    lam_vec3 d[LAM_TANGENTS];
    fill_place(u, v, g / v->places, g % v->places, row, points, basis);
    tangents(arity, points, basis, x, d);
    K[g] = fabs(lam_gauss_derivatives(d, &stretch, NULL, NULL));
    most = fmax(most, K[g]);
  }
  for (int g = 0; g < all; g++)
    if (K[g] >= share * most) kept[count++] = g;
  return count;
}

static lam_gauss_norm make_norm(lam_arena *arena, const lam_spline_surface *s, int count,
                                rule *places_of, const lam_vec3 *x, double share) {
  direction u = make_direction(arena, s, 0, count, places_of),
            v = make_direction(arena, s, 1, count, places_of);
  lam_gauss_norm norm = {.places = u.places * v.places, .arity = u.width * v.width};
  int arity = norm.arity, *kept = LAM_NEW(arena, int, norm.places), *unknown;
  for (int g = 0; g < norm.places; g++) kept[g] = g;
  if (x) norm.places = choose(arena, &u, &v, s->count[1], x, share, kept);
  double *weights = LAM_NEW(arena, double, norm.places);
  double *basis = LAM_NEW(arena, double, (size_t)norm.places *(size_t)(arity * LAM_TANGENTS));
  int *points = LAM_NEW(arena, int, (size_t)norm.places *(size_t)arity);
  for (int g = 0; g < norm.places; g++) {
    int a = kept[g] / v.places, b = kept[g] % v.places;
    weights[g] = u.weights[a] * v.weights[b];
    fill_place(&u, &v, a, b, s->count[1], points + (size_t)g * (size_t)arity,
               basis + (size_t)g * (size_t)(arity * LAM_TANGENTS));
  }
  unknown = LAM_NEW(arena, int, s->count[0] * s->count[1]);
  for (int i = 0; i < s->count[0]; i++)
    for (int j = 0; j < s->count[1]; j++) {
      bool inner = i > 0 && j > 0 && i < s->count[0] - 1 && j < s->count[1] - 1;
      unknown[i * s->count[1] + j] = inner ? norm.unknowns : -1;
      norm.unknowns += inner ? 3 : 0;
    }
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

static void *joined(lam_arena *arena, size_t size, const void *a, int a_count, const void *b,
                    int b_count) {
  char *both = lam_arena_alloc(arena, (size_t)(a_count + b_count), size);
  memcpy(both, a, (size_t)a_count * size);
  memcpy(both + (size_t)a_count * size, b, (size_t)b_count * size);
  return both;
}

lam_gauss_norm lam_gauss_norm_join(lam_arena *arena, const lam_gauss_norm *a,
                                   const lam_gauss_norm *b) {
  size_t arity = (size_t)a->arity;
  lam_gauss_norm norm = *a;
  norm.places = a->places + b->places;
  norm.weights = joined(arena, sizeof *a->weights, a->weights, a->places, b->weights, b->places);
  norm.points =
      joined(arena, arity * sizeof *a->points, a->points, a->places, b->points, b->places);
  norm.basis = joined(arena, arity * LAM_TANGENTS * sizeof *a->basis, a->basis, a->places, b->basis,
                      b->places);
  return norm;
}

/* Adds scale * (slope h h^T + bend b^T second b) of one place; h: gradient of K by the points that
 * act here. */
static void add_hessian(const lam_gauss_norm *norm, const int *point, const double *basis,
                        const double *h, double slope, double bend, const double *second,
                        double *hessian) {
  double *half = norm->local + 3 * norm->arity; /* per point 3 x 15: b^T second */
  for (int a = 0; bend != 0 && a < norm->arity; a++) {
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

static const double nothing = 1e-30; /* |K/scale|^(p-2) of places whose derivatives are left out */

lam_gauss_value lam_gauss_norm_eval(const lam_gauss_norm *norm, const lam_vec3 *x, double p,
                                    double scale, lam_order want, double *gradient,
                                    double *hessian) {
  lam_gauss_value value = {.scale = scale};
  double least = INFINITY, most = 0, second[LAM_GAUSS_VARIABLES * LAM_GAUSS_VARIABLES];
  int n = norm->unknowns;
  if (want >= LAM_ORDER_GRADIENT) memset(gradient, 0, (size_t)n * sizeof *gradient);
  if (want >= LAM_ORDER_GAUSS_NEWTON) memset(hessian, 0, (size_t)n * (size_t)n * sizeof *hessian);
  for (int g = 0; g < norm->places; g++) {
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
    if (want == LAM_ORDER_VALUE || (p > 2 && outer < nothing)) continue;
    lam_gauss_derivatives(d, &stretch, first, want == LAM_ORDER_NEWTON ? second : NULL);
    double slope = w * p * outer * K / scale, *h = norm->local;
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
    if (want >= LAM_ORDER_GAUSS_NEWTON)
      add_hessian(norm, point, basis, h, w * p * (p - 1) * outer / (scale * scale),
                  want == LAM_ORDER_NEWTON ? slope : 0, second, hessian);
  }
  value.ratio = most > 0 ? least / most : 0;
  return value;
}
