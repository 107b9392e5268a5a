/* Tensor-product surfaces: Bezier, B-spline and NURBS share one evaluation.
 *   x(u,v) = sum_ij N_i(u) N_j(v) w_ij P_ij / sum_ij N_i(u) N_j(v) w_ij
 * Derivatives follow from A = sum N N w P and W = sum N N w (Piegl & Tiller, The NURBS Book, 4.5):
 *   x_u  = (A_u - W_u x) / W,   x_uu = (A_uu - 2 W_u x_u - W_uu x) / W,
 *   x_uv = (A_uv - W_u x_v - W_v x_u - W_uv x) / W. */
#include "curve/basis.h"
#include "surf/kind.h"

enum { MAX_POINTS = 1000 }; /* in one direction */

typedef struct lam_nurbs_keys {
  int degree[2], count[2], unit;
  lam_list points, weights, knots[2];
} lam_nurbs_keys;

typedef struct lam_nurbs {
  int degree[2], count[2];
  const double *knots[2];
  const double *net; /* count[0] x count[1] rows of w x, w y, w z, w */
  bool closed[2];
} lam_nurbs;

typedef struct lam_point4 {
  double x[4];
} lam_point4;

/* A and W with derivatives: sum[a][b] is the derivative a times by u and b times by v; only a + b <= 2 is filled. */
static void sum_net(const lam_nurbs *s, double u, double v, lam_point4 sum[3][3]) {
  double at[2] = {u, v}, values[2][3 * LAM_BASIS_MAX_VALUES];
  int first[2], width[2];
  for (int d = 0; d < 2; d++) {
    int span = lam_basis_span(s->degree[d], s->count[d], s->knots[d], at[d]);
    lam_basis_eval(s->degree[d], s->knots[d], span, at[d], 2, values[d]);
    first[d] = span - s->degree[d];
    width[d] = s->degree[d] + 1;
  }
  for (int i = 0; i < width[0]; i++) {
    const double *row = s->net + 4 * ((size_t)(first[0] + i) * s->count[1] + first[1]);
    double across[3][4] = {{0}}; /* the row summed over v, with derivatives by v */
    for (int j = 0; j < width[1]; j++)
      for (int b = 0; b < 3; b++)
        for (int c = 0; c < 4; c++) across[b][c] += values[1][b * width[1] + j] * row[4 * j + c];
    for (int a = 0; a < 3; a++)
      for (int b = 0; a + b < 3; b++)
        for (int c = 0; c < 4; c++) sum[a][b].x[c] += values[0][a * width[0] + i] * across[b][c];
  }
}

static lam_vec3 position(const lam_point4 *p) { return lam_v3(p->x[0], p->x[1], p->x[2]); }

static void eval(const void *data, double u, double v, lam_jet *jet) {
  lam_point4 sum[3][3] = {0};
  sum_net(data, u, v, sum);
  double w = 1 / sum[0][0].x[3];
  double wu = sum[1][0].x[3], wv = sum[0][1].x[3], wuu = sum[2][0].x[3], wuv = sum[1][1].x[3], wvv = sum[0][2].x[3];
  lam_vec3 x = jet->x = lam_scale(position(&sum[0][0]), w);
  jet->u = lam_scale(lam_along(position(&sum[1][0]), -wu, x), w);
  jet->v = lam_scale(lam_along(position(&sum[0][1]), -wv, x), w);
  jet->uu = lam_scale(lam_along(lam_along(position(&sum[2][0]), -2 * wu, jet->u), -wuu, x), w);
  jet->vv = lam_scale(lam_along(lam_along(position(&sum[0][2]), -2 * wv, jet->v), -wvv, x), w);
  lam_vec3 mixed = lam_along(lam_along(position(&sum[1][1]), -wu, jet->v), -wv, jet->u);
  jet->uv = lam_scale(lam_along(mixed, -wuv, x), w);
}

/* Whether the surface closes up in direction d: its two end curves agree at 2 degree + 1 places of every knot span,
 * which is more than two different curves of these pieces can share. */
static bool closes_up(const lam_nurbs *s, int d) {
  const double *along = s->knots[1 - d], *across = s->knots[d];
  double low = across[s->degree[d]], high = across[s->count[d]], size = 0, gap = 0;
  int places = 2 * s->degree[1 - d] + 1;
  for (int k = s->degree[1 - d]; k < s->count[1 - d]; k++)
    for (int i = 0; i < places; i++) {
      double t = along[k] + (along[k + 1] - along[k]) * i / places;
      lam_jet a, b, middle;
      eval(s, d ? t : low, d ? low : t, &a);
      eval(s, d ? t : high, d ? high : t, &b);
      eval(s, d ? t : (low + high) / 2, d ? (low + high) / 2 : t, &middle);
      gap = fmax(gap, lam_distance(a.x, b.x));
      size = fmax(size, lam_distance(a.x, middle.x));
    }
  return gap <= 1e-12 * size;
}

static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  const lam_nurbs *s = data;
  lam_domain natural = {{s->knots[0][s->degree[0]], s->knots[0][s->count[0]]},
                        {s->knots[1][s->degree[1]], s->knots[1][s->count[1]]},
                        {s->closed[0], s->closed[1]}};
  return chart == LAM_CHART_NATURAL && lam_domain_give(natural, p, q, closed);
}

/* Checks that what is listed fits together. */
static bool check(const lam_nurbs_keys *keys, const int degree[2], lam_place place, lam_errors *errors) {
  static const char *const knot_names[] = {"knots_u", "knots_v"}, *const directions[] = {"u", "v"};
  int before = errors->count, total = keys->count[0] * keys->count[1];
  if (keys->points.count != 3 * total)
    lam_error_add(errors, place, "points", "%d numbers given; expected %d: x, y and z of %d x %d points",
                  keys->points.count, 3 * total, keys->count[0], keys->count[1]);
  if (keys->weights.count != 0 && keys->weights.count != total)
    lam_error_add(errors, place, "weights", "%d weights given; expected %d: one per point, or none",
                  keys->weights.count, total);
  for (int i = 0; i < keys->weights.count; i++)
    if (!(((const double *)keys->weights.items)[i] > 0)) {
      lam_error_add(errors, place, "weights", "weight %d is %g; expected a positive number", i + 1,
                    ((const double *)keys->weights.items)[i]);
      break;
    }
  for (int d = 0; d < 2; d++) {
    if (degree[d] >= keys->count[d]) {
      lam_error_add(errors, place, "degree", "degree %d in direction %s; expected at most %d with %d points", degree[d],
                    directions[d], keys->count[d] - 1, keys->count[d]);
      continue;
    }
    const lam_list *knots = &keys->knots[d];
    const char *problem =
        knots->count ? lam_knots_problem(degree[d], keys->count[d], knots->count, knots->items) : NULL;
    if (problem) lam_error_add(errors, place, knot_names[d], "%d knots given: they %s", knots->count, problem);
  }
  return errors->count == before;
}

static const lam_nurbs *make(lam_arena *arena, const lam_nurbs_keys *keys, const int degree[2], lam_place place,
                             lam_errors *errors) {
  if (!check(keys, degree, place, errors)) return NULL;
  lam_nurbs *s = LAM_NEW(arena, lam_nurbs, 1);
  int total = keys->count[0] * keys->count[1];
  double *net = LAM_NEW(arena, double, 4 * total), unit = lam_point_unit(keys->unit);
  const double *points = keys->points.items, *weights = keys->weights.items;
  for (int i = 0; i < total; i++) {
    double weight = keys->weights.count ? weights[i] : 1;
    for (int c = 0; c < 3; c++) net[4 * i + c] = weight * unit * points[3 * i + c];
    net[4 * i + 3] = weight;
  }
  s->net = net;
  for (int d = 0; d < 2; d++) {
    s->degree[d] = degree[d];
    s->count[d] = keys->count[d];
    s->knots[d] = keys->knots[d].items;
    if (keys->knots[d].count == 0) {
      double *knots = LAM_NEW(arena, double, keys->count[d] + degree[d] + 1);
      lam_knots_clamped(degree[d], keys->count[d], knots);
      s->knots[d] = knots;
    }
  }
  for (int d = 0; d < 2; d++) s->closed[d] = closes_up(s, d);
  return s;
}

static const void *prepare(lam_arena *arena, const void *params, lam_place place, lam_errors *errors) {
  const lam_nurbs_keys *keys = params;
  return make(arena, keys, keys->degree, place, errors);
}

static const void *prepare_bezier(lam_arena *arena, const void *params, lam_place place, lam_errors *errors) {
  const lam_nurbs_keys *keys = params;
  return make(arena, keys, (int[2]){keys->count[0] - 1, keys->count[1] - 1}, place, errors);
}

#define AT(member) offsetof(lam_nurbs_keys, member)
#define DEGREE                                                                                                         \
  {                                                                                                                    \
    .name = "degree", .type = LAM_KEY_INTEGER, .offset = AT(degree), .count = 2, .initial = "[3, 3]", .min = 1,        \
    .max = LAM_BASIS_MAX_DEGREE, .doc = "Polynomial degree in u and in v; less than the number of points."             \
  }
#define COUNT(most)                                                                                                    \
  {                                                                                                                    \
    .name = "count", .type = LAM_KEY_INTEGER, .offset = AT(count), .count = 2, .initial = "[4, 4]", .min = 2,          \
    .max = (most), .doc = "Number of control points in u and in v."                                                    \
  }
#define POINTS                                                                                                         \
  {                                                                                                                    \
    .name = "points", .type = LAM_KEY_NUMBER, .offset = AT(points),                                                    \
    .initial = "[0, 0, 2,  0, 3, 1,  0, 6, 1,  0, 9, 2,"                                                               \
               " 3, 0, 4,  3, 3, 3,  3, 6, 3,  3, 9, 4,"                                                               \
               " 6, 0, 4,  6, 3, 3,  6, 6, 3,  6, 9, 4,"                                                               \
               " 9, 0, 2,  9, 3, 1,  9, 6, 1,  9, 9, 2]",                                                              \
    .doc =                                                                                                             \
        "x, y, z of every control point, v running fastest: first all points of the first u, then of the second; the " \
        "default is a saddle of 4 x 4 points."                                                                         \
  }
#define UNIT                                                                                                           \
  {                                                                                                                    \
    .name = "unit", .type = LAM_KEY_CHOICE, .offset = AT(unit), .count = 1, .initial = "m",                            \
    .choices = lam_point_units, .doc = "Unit of the numbers in points."                                                \
  }
#define WEIGHTS                                                                                                        \
  {                                                                                                                    \
    .name = "weights", .type = LAM_KEY_NUMBER, .offset = AT(weights), .initial = "[]",                                 \
    .doc = "Positive weight of every control point, in the order of points; none: all 1."                              \
  }
#define KNOTS(direction, which)                                                                                        \
  {                                                                                                                    \
    .name = "knots_" direction, .type = LAM_KEY_NUMBER, .offset = AT(knots[which]), .initial = "[]",                   \
    .doc = "Knots in " direction                                                                                       \
           ", count + degree + 1 numbers that do not decrease; none: clamped and evenly spaced from 0 to 1."           \
  }

static const lam_key bezier_keys[] = {COUNT(LAM_BASIS_MAX_VALUES), POINTS, WEIGHTS, UNIT, {0}};
static const lam_key bspline_keys[] = {DEGREE, COUNT(MAX_POINTS), POINTS, KNOTS("u", 0), KNOTS("v", 1), UNIT, {0}};
static const lam_key nurbs_keys[] = {DEGREE,        COUNT(MAX_POINTS), POINTS, WEIGHTS,
                                     KNOTS("u", 0), KNOTS("v", 1),     UNIT,   {0}};

const lam_surface_kind lam_surface_bezier = {
    .head = {.name = "bezier",
             .title = "Bezier patch",
             .doc = "One polynomial patch over a net of control points, or one rational patch when weights are given. "
                    "It passes through the four corner points and touches the net there; every other point only pulls. "
                    "Good for a single calm shell with few points. The degree is one less than the number of points in "
                    "each direction, so many points make the patch stiff and slow to answer: take a B-spline then.",
             .equation = "x(u,v) = sum_ij B_i(u) B_j(v) w_ij P_ij / sum_ij B_i(u) B_j(v) w_ij, 0 <= u,v <= 1",
             .source = "Piegl & Tiller, The NURBS Book, 1.4",
             .keys = bezier_keys,
             .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare_bezier,
    .eval = eval,
    .domain = domain};

const lam_surface_kind lam_surface_bspline = {
    .head = {.name = "bspline",
             .title = "B-spline surface",
             .doc = "A surface of polynomial patches that join smoothly, over a net of control points. A point acts "
                    "only near itself, so free forms with many points stay easy to handle. Take degree 3 or more when "
                    "curvature matters: at degree 2 it jumps from patch to patch, and strips cut along such a surface "
                    "show the jump. A knot repeated as often as the degree makes a crease.",
             .equation = "x(u,v) = sum_ij N_i(u) N_j(v) P_ij",
             .source = "Piegl & Tiller, The NURBS Book, 3.4",
             .keys = bspline_keys,
             .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain};

const lam_surface_kind lam_surface_nurbs = {
    .head = {.name = "nurbs",
             .title = "NURBS surface",
             .doc = "The surface of most modelling programs: a B-spline surface with a weight on every control point. "
                    "With the right weights it contains the quadrics and surfaces of revolution exactly. Degree, "
                    "knots, points and weights are listed as such a program exports them; note that some programs "
                    "leave out the first and the last knot. Very uneven weights squeeze the parameter lines together, "
                    "and a net that follows them gets uneven too.",
             .equation = "x(u,v) = sum_ij N_i(u) N_j(v) w_ij P_ij / sum_ij N_i(u) N_j(v) w_ij",
             .source = "Piegl & Tiller, The NURBS Book, 4.4",
             .keys = nurbs_keys,
             .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain};
