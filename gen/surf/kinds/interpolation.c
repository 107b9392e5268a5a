/* The surface kind "interpolation": spline surfaces through listed points. Registered in
 * surfaces.c; the mathematics is in surf/spline/spline_through.c. */
#include "core/stage.h"
#include "curve/bspline/basis.h"
#include "surf/spline/point_keys.h"
#include "surf/spline/spline_surface.h"
#include "surf/spline/spline_through.h"

enum { MAX_POINTS = 1000 }; /* in one direction */

/* The parameters of a row. */
typedef struct interpolation_keys {
  int count[2], degree[2], ends, parameters;
  lam_point_keys points;
} interpolation_keys;

/* The surface, and the points with their parameters for the report. */
typedef struct interpolation_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  const double *t[2];
  const lam_vec3 *points;
  int count[2];
} interpolation_data;

/* The names of lam_ends, with local (Bessel's tangents) where LAM_ENDS_TANGENTS stands there. */
enum { LOCAL = 3 };
static const char *const end_names[] = {"average", "not-a-knot", "natural", "local", NULL};

/* For messages. */
static const char *const directions[] = {"u", "v"};

/* Whether count and degree fit to the number of points and to each other. */
static bool check(const interpolation_keys *keys, int given, lam_location location,
                  lam_errors *errors) {
  int before = errors->count;
  if (given != keys->count[0] * keys->count[1]) {
    lam_error_add(errors, location, "count",
                  "%d x %d with %d points; expected two numbers whose product is that",
                  keys->count[0], keys->count[1], given);
    return false;
  }

  for (int d = 0; d < 2 && keys->ends == LAM_ENDS_AVERAGE; d++)
    if (keys->degree[d] >= keys->count[d])
      lam_error_add(errors, location, "degree",
                    "degree %d in direction %s; expected at most %d with %d points",
                    keys->degree[d], directions[d], keys->count[d] - 1, keys->count[d]);

  for (int d = 0; d < 2 && keys->ends != LAM_ENDS_AVERAGE; d++)
    if (keys->degree[d] != 3)
      lam_error_add(errors, location, "degree",
                    "degree %d with ends %s; expected 3, or ends: average", keys->degree[d],
                    end_names[keys->ends]);
  return errors->count == before;
}

/* Parameters of the rows first; then the surface through the points. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const interpolation_keys *keys = params;
  int before = errors->count, given;
  const lam_vec3 *points = lam_points_given(arena, &keys->points, 4, location, errors, &given);
  if (!points || !check(keys, given, location, errors)) return NULL;

  interpolation_data *data = LAM_NEW(arena, interpolation_data, 1);
  *data = (interpolation_data){.points = points, .count = {keys->count[0], keys->count[1]}};

  lam_grid_parameters(arena, (lam_parameters)keys->parameters, keys->count, points, data->t);
  for (int d = 0; d < 2; d++)
    if (!data->t[d])
      lam_error_add(errors, location, "points",
                    "two neighboring rows in direction %s are the same; expected rows that "
                    "differ",
                    directions[d]);
  if (errors->count > before) return NULL;

  lam_spline_surface surface = keys->ends == LOCAL
                                   ? lam_surface_through_local(arena, keys->count, data->t, points)
                                   : lam_surface_through(arena, (lam_ends)keys->ends, keys->degree,
                                                         keys->count, data->t, points);
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

/* The largest and the mean distance of the points from the surface at their parameters. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const interpolation_data *d = data;
  double most = 0, mean = 0;
  int total = d->count[0] * d->count[1];
  for (int i = 0; i < total; i++) {
    lam_jet jet;
    lam_held_nurbs_eval(data, d->t[0][i / d->count[1]], d->t[1][i % d->count[1]], &jet);
    most = fmax(most, lam_distance(jet.x, d->points[i]));
    mean += lam_distance(jet.x, d->points[i]) / total;
  }

  stage->iterations = -1;
  lam_stage_measure(arena, stage, "point_distance", "m", most, mean, total);
}

/* The file of points among the parameters. */
static lam_point_file *cloud_of(void *params) {
  return &((interpolation_keys *)params)->points.cloud;
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(interpolation_keys, "count", count, "[4, 4]", 2, MAX_POINTS,
                    "Number of points in u and in v."),
    LAM_POINT_KEYS(interpolation_keys, points,
                   "[0, 0, 0,  0, 3, 1,  0, 6, 1,  0, 9, 0,"
                   " 3, 0, 1,  3, 3, 3,  3, 6, 2.5,  3, 9, 1,"
                   " 6, 0, 1,  6, 3, 2.5,  6, 6, 3,  6, 9, 1,"
                   " 9, 0, 0,  9, 3, 1,  9, 6, 1,  9, 9, 0.5]",
                   "x, y, z of every point, v running fastest: first "
                   "all points of the first u, then of the second."),
    LAM_CHOICE_KEY(interpolation_keys, "parameters", parameters, "chord", lam_parameters_names,
                   "How the points are spread over the parameters; centripetal and modified-chord "
                   "overshoot less at turns."),
    LAM_CHOICE_KEY(
        interpolation_keys, "ends", ends, "not-a-knot", end_names,
        "not-a-knot: cubic, the outer two pieces are one; natural: cubic, not bent at the sides; "
        "average: any degree, knots are averages of parameters; local: cubic with continuous "
        "tangent planes only, but a point moves no more than the four rows around it."),
    LAM_INTEGER_KEY(interpolation_keys, "degree", degree, "[3, 3]", 1, LAM_BASIS_MAX_DEGREE,
                    "Degree in u and in v; 3 unless ends is average."),
    {0}};

const lam_surface_kind lam_surface_interpolation = {
    .head = {.name = "interpolation",
             .title = "Surface through points",
             .doc = "A smooth spline surface through a grid of measured or chosen points, twice "
                    "continuously differentiable when cubic. Unlike control points, every point "
                    "lies on the surface. Noise in the points becomes waves in the surface, and "
                    "rows whose spacing differs much from row to row pull the parameter lines "
                    "askew: look at curvature before building from it.",
             .equation = "x(u_i, v_j) = P_ij",
             .source = "Piegl & Tiller, The NURBS Book, 9.2.5; de Boor, A Practical Guide to "
                       "Splines, ch. XVII",
             .keys = keys,
             .params_size = sizeof(interpolation_keys)},
    .points = cloud_of,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
