/* Coons patches as spline surfaces. Called by surf/kinds/coons.c and
 * surf/developable/developable.c.
 *
 * Both blends have one form. With functions f_k (the linear 1 - t, t, or Hermite's F0, F1, G0,
 * G1), curves A_k along u (sides, then derivatives across them), curves B_k along v, and T_kl
 * what A_l and B_k share at the corners,
 *   x(u,v) = sum_k f_k(v) A_k(u) + sum_k f_k(u) B_k(v) - sum_kl f_k(u) f_l(v) T_kl.
 * With weight functions U(u) and V(v) that make U A_k and V B_k polynomial splines,
 *   U V x = sum_k V f_k(v) U A_k(u) + sum_k U f_k(u) V B_k(v) - sum_kl U f_k(u) V f_l(v) T_kl.
 * When U, U f_k and U A_k are splines over common knots in u, and V, V f_k and V B_k in v,
 * every term is a product of two splines, and the control points of U V x follow from theirs by
 * the same formula. */
#include "surf/spline/coons_patch.h"
#include "curve/curve.h"
#include <float.h>
#include <string.h>

/* Most terms of a blend. */
enum { MOST = 4 };

/* One direction, over [0,1]: the curves A_k. */
typedef struct lam_blend {
  int terms; /* 2 or 4 */
  lam_spline_curve curve[MOST];
} lam_blend;

/* The splines U A_k, U f_k (dimension `terms`) and U, when the sides have weights. */
typedef struct lam_products {
  int count;
  lam_bspline list[MOST + 2];
  const double *weights; /* coefficients of U; NULL: 1 */
} lam_products;

/* The derivative of this order, 0 or 1, at t = end. */
static lam_vec3 at_end(const lam_spline_curve *c, int end, int order) {
  lam_vec3 x[2];
  lam_spline_curve_eval(c, end, order, x);
  return x[order];
}

/* The line from a to b. */
static lam_spline_curve line(lam_arena *arena, lam_vec3 a, lam_vec3 b) {
  static const double knots[] = {0, 0, 1, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 2);
  points[0] = a;
  points[1] = b;
  return (lam_spline_curve){1, 2, knots, points, NULL};
}

/* The functions f_k as one spline of dimension `terms`. */
static lam_bspline functions(int terms) {
  static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, linear[] = {1, 0, 0, 1};
  static const double cubic[] = {1, 0, 0, 0, 1, 0, 1.0 / 3, 0, 0, 1, 0, -1.0 / 3, 0, 1, 0, 0};
  return terms == 2 ? (lam_bspline){1, 2, 2, knots + 2, linear}
                    : (lam_bspline){3, 4, 4, knots, cubic};
}

/* The curves of both directions: blends[0] along u with sides 0 and 2, blends[1] along v with
 * sides 1 and 3. */
static void collect(lam_arena *arena, const lam_sides *sides, lam_coons_blend blend,
                    lam_blend blends[2]) {
  for (int d = 0; d < 2; d++) {
    blends[d].terms = blend == LAM_COONS_HERMITE ? 4 : 2;
    for (int k = 0; k < 2; k++) blends[d].curve[k] = sides->side[2 * k + d];
  }

  /* Derivatives that are not given are mixed linearly from the slopes of the sides that end
   * there. */
  for (int d = 0; d < 2 && blend == LAM_COONS_HERMITE; d++)
    for (int k = 0; k < 2; k++) {
      lam_bspline given = sides->across[2 * k + d];
      const lam_spline_curve *ends = blends[1 - d].curve;
      blends[d].curve[2 + k] = given.count
                                   ? lam_spline_curve_from_net(arena, given)
                                   : line(arena, at_end(&ends[0], k, 1), at_end(&ends[1], k, 1));
    }
}

/* ---- common weights ---- */

/* Whether the weights of two curves are the same up to a factor. */
static bool same_weights(const lam_spline_curve *a, const lam_spline_curve *b) {
  if (a->degree != b->degree || a->count != b->count) return false;
  if (memcmp(a->knots, b->knots, (size_t)(a->count + a->degree + 1) * sizeof *a->knots) != 0)
    return false;
  for (int i = 1; i < a->count; i++)
    if (fabs(a->weights[i] / a->weights[0] / (b->weights[i] / b->weights[0]) - 1) > 4 * DBL_EPSILON)
      return false;
  return true;
}

/* The weight function of a rational curve, as a spline of dimension 1. */
static lam_bspline weights_of(const lam_spline_curve *c) {
  return (lam_bspline){c->degree, c->count, 1, c->knots, c->weights};
}

/* The first three components of a homogeneous net, times a factor. */
static lam_bspline positions(lam_arena *arena, lam_bspline net, double factor) {
  double *values = LAM_NEW(arena, double, 3 * net.count);
  for (int i = 0; i < net.count; i++)
    for (int c = 0; c < 3; c++) values[3 * i + c] = factor * net.values[i * net.dimension + c];
  return (lam_bspline){net.degree, net.count, 3, net.knots, values};
}

/* U is the product of the weight functions of the two sides: both, one when they are equal or
 * the other is 1, or none (dimension 0). factor[k] is what U A_k lacks when the weights of
 * curve k have been multiplied in: another weight function, or none (dimension 0); scale[k] a
 * number. */
static lam_bspline common_weights(lam_arena *arena, const lam_spline_curve side[2],
                                  lam_bspline factor[2], double scale[2]) {
  bool rational[] = {side[0].weights, side[1].weights};
  factor[0] = factor[1] = (lam_bspline){0};
  scale[0] = scale[1] = 1;

  if (rational[0] && rational[1] && same_weights(&side[0], &side[1])) {
    scale[1] = side[0].weights[0] / side[1].weights[0];
    return weights_of(&side[0]);
  }

  for (int k = 0; k < 2; k++)
    if (rational[1 - k]) factor[k] = weights_of(&side[1 - k]);
  if (!factor[0].dimension) return factor[1];
  if (!factor[1].dimension) return factor[0];
  return lam_bspline_product(arena, factor[1], factor[0]);
}

/* The degree of U, without making it. */
static int degree_of_weights(const lam_spline_curve side[2]) {
  if (side[0].weights && side[1].weights && same_weights(&side[0], &side[1])) return side[0].degree;
  return (side[0].weights ? side[0].degree : 0) + (side[1].weights ? side[1].degree : 0);
}

/* The product with a weight function, which may be none. */
static lam_bspline times(lam_arena *arena, lam_bspline weights, lam_bspline f) {
  return weights.dimension ? lam_bspline_product(arena, weights, f) : f;
}

/* U A_k, U f_k and U over common knots. The curves beyond the two sides have no weights of
 * their own. */
static lam_products multiply(lam_arena *arena, const lam_blend *blend) {
  lam_bspline factor[2];
  double scale[2];
  lam_bspline weights = common_weights(arena, blend->curve, factor, scale);
  lam_products products = {.count = blend->terms + 1};

  for (int k = 0; k < blend->terms; k++) {
    lam_bspline net = lam_spline_curve_net(arena, &blend->curve[k], false);
    products.list[k] =
        times(arena, k < 2 ? factor[k] : weights, positions(arena, net, k < 2 ? scale[k] : 1));
  }

  products.list[blend->terms] = times(arena, weights, functions(blend->terms));
  if (weights.dimension) products.list[products.count++] = weights;
  lam_bspline_match(arena, products.count, products.list);

  if (weights.dimension) products.weights = products.list[products.count - 1].values;
  return products;
}

/* The largest degree of the terms U f_k and U A_k; U A_k has lost the weights of curve k. */
int lam_coons_degree(lam_arena *arena, const lam_sides *sides, lam_coons_blend blend, int d) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_blend blends[2];
  collect(arena, sides, blend, blends);

  const lam_blend *b = &blends[d];
  int weights = degree_of_weights(b->curve), degree = weights + functions(b->terms).degree;
  for (int k = 0; k < b->terms; k++) {
    int total = weights + b->curve[k].degree - (b->curve[k].weights ? b->curve[k].degree : 0);
    degree = total > degree ? total : degree;
  }

  lam_arena_release(arena, mark);
  return degree;
}

/* ---- the patch ---- */

/* What curve l along u and curve k along v say about their corner. Curve l belongs to v = l % 2 and
 * gives the position (l < 2) or the derivative by v; at u = k % 2 it is taken itself (k < 2) or its
 * derivative. */
static void corner(const lam_blend blends[2], int k, int l, lam_vec3 said[2]) {
  said[0] = at_end(&blends[0].curve[l], k % 2, k / 2);
  said[1] = at_end(&blends[1].curve[k], l % 2, l / 2);
}

/* Curves k or l below 2 are sides: corners with one of them compare slopes, the others
 * twists. */
lam_coons_gaps lam_coons_check(lam_arena *arena, const lam_sides *sides) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_blend blends[2];
  lam_coons_gaps gaps = {0, 0};
  collect(arena, sides, LAM_COONS_HERMITE, blends);

  for (int k = 0; k < MOST; k++)
    for (int l = 0; l < MOST; l++) {
      lam_vec3 said[2];
      corner(blends, k, l, said);
      if (k < 2 && l < 2) continue; /* the corner itself */
      double *gap = k < 2 || l < 2 ? &gaps.slope : &gaps.twist;
      *gap = fmax(*gap, lam_distance(said[0], said[1]));
    }
  lam_arena_release(arena, mark);
  return gaps;
}

/* Control point i of a spline of dimension 3. */
static lam_vec3 value(const lam_bspline *f, int i) {
  return lam_v3(f->values[3 * i], f->values[3 * i + 1], f->values[3 * i + 2]);
}

/* The boundary as the sides give it, to the last digit. */
static void keep_sides(const lam_products p[2], lam_vec3 *points) {
  int m = p[0].list[0].count, n = p[1].list[0].count;
  for (int side = LAM_SIDES - 1; side >= 0; side--) {
    const lam_bspline *f = &p[side % 2].list[side / 2];
    const double *weights = p[side % 2].weights;
    for (int i = 0; i < f->count; i++) {
      int at = side % 2 ? (side == 3 ? m - 1 : 0) * n + i : i * n + (side == 2 ? n - 1 : 0);
      points[at] = lam_scale(value(f, i), weights ? 1 / weights[i] : 1);
    }
  }
}

/* T_kl: the mean of what the two curves say about every corner. */
static void share_corners(const lam_blend blends[2], lam_vec3 shared[MOST][MOST]) {
  int terms = blends[0].terms;
  for (int k = 0; k < terms; k++)
    for (int l = 0; l < terms; l++) {
      lam_vec3 said[2];
      corner(blends, k, l, said);
      shared[k][l] = lam_mix(said[0], said[1], 0.5);
    }
}

/* Control point (i, j) of U V x, by the formula at the head of this file. */
static lam_vec3 blended(const lam_products p[2], int terms, lam_vec3 shared[MOST][MOST], int i,
                        int j) {
  const lam_bspline *a = p[0].list, *b = p[1].list, *f = &a[terms], *g = &b[terms];
  lam_vec3 x = {0, 0, 0};
  for (int k = 0; k < terms; k++) {
    double fu = f->values[i * terms + k], fv = g->values[j * terms + k];
    x = lam_along(lam_along(x, fv, value(&a[k], i)), fu, value(&b[k], j));
    for (int l = 0; l < terms; l++) x = lam_along(x, -fu * g->values[j * terms + l], shared[k][l]);
  }
  return x;
}

/* The control points of U V x are divided by those of U V. */
lam_spline_surface lam_coons_surface(lam_arena *arena, const lam_sides *sides,
                                     lam_coons_blend blend) {
  lam_blend blends[2];
  lam_vec3 shared[MOST][MOST];
  lam_products p[2];
  collect(arena, sides, blend, blends);
  share_corners(blends, shared);
  for (int d = 0; d < 2; d++) p[d] = multiply(arena, &blends[d]);

  const lam_bspline *a = p[0].list, *b = p[1].list;
  const double *wu = p[0].weights, *wv = p[1].weights;
  int m = a->count, n = b->count;
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, (size_t)m * n);
  double *weights = wu || wv ? LAM_NEW(arena, double, (size_t)m *n) : NULL;
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      double w = (wu ? wu[i] : 1) * (wv ? wv[j] : 1);
      points[i * n + j] = lam_scale(blended(p, blends[0].terms, shared, i, j), 1 / w);
      if (weights) weights[i * n + j] = w;
    }

  if (blend == LAM_COONS_BILINEAR) keep_sides(p, points);
  return (lam_spline_surface){NULL,   {a->degree, b->degree}, {m, n}, {a->knots, b->knots}, points,
                              weights};
}
