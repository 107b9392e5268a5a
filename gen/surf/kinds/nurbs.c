/* Spline surfaces with listed control points, three kinds in surfaces.c: Bezier, B-spline,
 * NURBS. The evaluation is in surf/spline/spline_surface.c. */
#include "curve/bspline/basis.h"
#include "surf/spline/point_keys.h"
#include "surf/spline/spline_surface.h"

enum { MAX_POINTS = 1000 }; /* in one direction */

/* The parameters of a row of any of the three. */
typedef struct lam_nurbs_keys {
  int degree[2], count[2], unit;
  lam_list points, weights, knots[2];
} lam_nurbs_keys;

/* Whether degree and knots of direction d fit to the number of points. */
static void check_direction(const lam_nurbs_keys *keys, int degree, int d, lam_location location,
                            lam_errors *errors) {
  static const char *const knot_names[] = {"knots_u", "knots_v"}, *const directions[] = {"u", "v"};
  int count = keys->count[d];
  if (degree >= count) {
    lam_error_add(errors, location, "degree",
                  "degree %d in direction %s; expected at most %d with %d points", degree,
                  directions[d], count - 1, count);
    return;
  }

  const lam_list *knots = &keys->knots[d];
  const char *problem =
      knots->count ? lam_knots_problem(degree, count, knots->count, knots->items) : NULL;
  if (problem)
    lam_error_add(errors, location, knot_names[d], "%d knots given: they %s", knots->count,
                  problem);
}

/* Whether what is listed fits together; all of what is wrong is told at once. */
static bool check(const lam_nurbs_keys *keys, const int degree[2], lam_location location,
                  lam_errors *errors) {
  int before = errors->count, total = keys->count[0] * keys->count[1];
  if (keys->points.count != 3 * total)
    lam_error_add(errors, location, "points",
                  "%d numbers given; expected %d: x, y and z of %d x %d points", keys->points.count,
                  3 * total, keys->count[0], keys->count[1]);

  if (keys->weights.count != 0 && keys->weights.count != total)
    lam_error_add(errors, location, "weights",
                  "%d weights given; expected %d: one per point, or none", keys->weights.count,
                  total);
  lam_weights_check(&keys->weights, "weights", location, errors);

  for (int d = 0; d < 2; d++) check_direction(keys, degree[d], d, location, errors);
  return errors->count == before;
}

/* The surface of the keys with these degrees; NULL with messages. Knots that are not given are
 * evenly spaced. */
static const lam_nurbs *make(lam_arena *arena, const lam_nurbs_keys *keys, const int degree[2],
                             lam_location location, lam_errors *errors) {
  if (!check(keys, degree, location, errors)) return NULL;

  lam_spline_surface shape = {.points = lam_points_read(arena, &keys->points, keys->unit),
                              .weights = keys->weights.count ? keys->weights.items : NULL};
  for (int d = 0; d < 2; d++) {
    shape.degree[d] = degree[d];
    shape.count[d] = keys->count[d];
    shape.knots[d] = keys->knots[d].items;
    if (keys->knots[d].count == 0) {
      double *knots = LAM_NEW(arena, double, keys->count[d] + degree[d] + 1);
      lam_knots_clamped(degree[d], keys->count[d], knots);
      shape.knots[d] = knots;
    }
  }
  return lam_nurbs_make(arena, &shape);
}

/* With the degrees of the keys. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_nurbs_keys *keys = params;
  return make(arena, keys, keys->degree, location, errors);
}

/* A Bezier patch has the degrees that its points make. */
static const void *prepare_bezier(lam_arena *arena, const void *params, lam_location location,
                                  lam_errors *errors) {
  const lam_nurbs_keys *keys = params;
  return make(arena, keys, (int[2]){keys->count[0] - 1, keys->count[1] - 1}, location, errors);
}

/* The keys, of which each kind has its own choice. */
#define DEGREE                                                                                     \
  LAM_INTEGER_KEY(lam_nurbs_keys, "degree", degree, "[3, 3]", 1, LAM_BASIS_MAX_DEGREE,             \
                  "Polynomial degree in u and in v; less than the number of points.")
#define COUNT(most)                                                                                \
  LAM_INTEGER_KEY(lam_nurbs_keys, "count", count, "[4, 4]", 2, (most),                             \
                  "Number of control points in u and in v.")
#define POINTS                                                                                     \
  LAM_NUMBER_KEY(lam_nurbs_keys, "points", points,                                                 \
                 "[0, 0, 2,  0, 3, 1,  0, 6, 1,  0, 9, 2,"                                         \
                 " 3, 0, 4,  3, 3, 3,  3, 6, 3,  3, 9, 4,"                                         \
                 " 6, 0, 4,  6, 3, 3,  6, 6, 3,  6, 9, 4,"                                         \
                 " 9, 0, 2,  9, 3, 1,  9, 6, 1,  9, 9, 2]",                                        \
                 0, 0,                                                                             \
                 "x, y, z of every control point, v running fastest: first all points of the "     \
                 "first u, then of the second; the default is a saddle of 4 x 4 points.")
#define UNIT                                                                                       \
  LAM_CHOICE_KEY(lam_nurbs_keys, "unit", unit, "m", lam_point_units,                               \
                 "Unit of the numbers in points.")
#define WEIGHTS                                                                                    \
  LAM_NUMBER_KEY(lam_nurbs_keys, "weights", weights, "[]", 0, 0,                                   \
                 "Positive weight of every control point, in the order of points; none: all 1.")
#define KNOTS(direction, which)                                                                    \
  LAM_NUMBER_KEY(lam_nurbs_keys, "knots_" direction, knots[which], "[]", 0, 0,                     \
                 "Knots in " direction ", count + degree + 1 numbers that do not decrease; none: " \
                 "clamped and evenly spaced from 0 to 1.")

static const lam_key bezier_keys[] = {COUNT(LAM_BASIS_MAX_VALUES), POINTS, WEIGHTS, UNIT, {0}};
static const lam_key bspline_keys[] = {
    DEGREE, COUNT(MAX_POINTS), POINTS, KNOTS("u", 0), KNOTS("v", 1), UNIT, {0}};
static const lam_key nurbs_keys[] = {DEGREE,        COUNT(MAX_POINTS), POINTS, WEIGHTS,
                                     KNOTS("u", 0), KNOTS("v", 1),     UNIT,   {0}};

const lam_surface_kind lam_surface_bezier = {
    .head =
        {.name = "bezier",
         .title = "Bezier patch",
         .doc = "One polynomial patch over a net of control points, or one rational patch when "
                "weights are given. It passes through the four corner points and touches the net "
                "there; every other point only pulls. Good for a single calm shell with few "
                "points. The degree is one less than the number of points in each direction, so "
                "many points make the patch stiff and slow to answer: take a B-spline then.",
         .equation =
             "x(u,v) = sum_ij B_i(u) B_j(v) w_ij P_ij / sum_ij B_i(u) B_j(v) w_ij, 0 <= u,v <= 1",
         .source = "Piegl & Tiller, The NURBS Book, 1.4",
         .keys = bezier_keys,
         .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare_bezier,
    .eval = lam_nurbs_eval,
    .domain = lam_nurbs_domain,
    .spline = lam_nurbs_spline};

const lam_surface_kind lam_surface_bspline = {
    .head = {.name = "bspline",
             .title = "B-spline surface",
             .doc = "A surface of polynomial patches that join smoothly, over a net of control "
                    "points. A point acts only near itself, so free forms with many points stay "
                    "easy to handle. Take degree 3 or more when curvature matters: at degree 2 it "
                    "jumps from patch to patch, and strips cut along such a surface show the jump. "
                    "A knot repeated as often as the degree makes a crease.",
             .equation = "x(u,v) = sum_ij N_i(u) N_j(v) P_ij",
             .source = "Piegl & Tiller, The NURBS Book, 3.4",
             .keys = bspline_keys,
             .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare,
    .eval = lam_nurbs_eval,
    .domain = lam_nurbs_domain,
    .spline = lam_nurbs_spline};

const lam_surface_kind lam_surface_nurbs = {
    .head = {.name = "nurbs",
             .title = "NURBS surface",
             .doc = "The surface of most modelling programs: a B-spline surface with a weight on "
                    "every control point. With the right weights it contains the quadrics and "
                    "surfaces of revolution exactly. Degree, knots, points and weights are listed "
                    "as such a program exports them; note that some programs leave out the first "
                    "and the last knot. Very uneven weights squeeze the parameter lines together, "
                    "and a net that follows them gets uneven too.",
             .equation = "x(u,v) = sum_ij N_i(u) N_j(v) w_ij P_ij / sum_ij N_i(u) N_j(v) w_ij",
             .source = "Piegl & Tiller, The NURBS Book, 4.4",
             .keys = nurbs_keys,
             .params_size = sizeof(lam_nurbs_keys)},
    .prepare = prepare,
    .eval = lam_nurbs_eval,
    .domain = lam_nurbs_domain,
    .spline = lam_nurbs_spline};
