/* The surface kind "approximation": spline surfaces near measured points. Registered in
 * surfaces.c; the mathematics is in surf/spline/spline_near.c. */
#include "core/stage.h"
#include "curve/bspline/basis.h"
#include "surf/spline/point_keys.h"
#include "surf/spline/spline_near.h"
#include "surf/spline/spline_surface.h"
#include "surf/spline/spline_through.h"

enum { MAX_COUNT = 100, MAX_CORRECTIONS = 50 };

/* Ways to spread the knots, in the order of their names. */
enum { EVEN, DENSE };
static const char *const knot_names[] = {[EVEN] = "even", [DENSE] = "dense", NULL};

/* The parameters of a row. */
typedef struct approximation_keys {
  lam_point_keys points;
  int grid[2], count[2], degree[2], corrections, knots;
  double fairness, within;
} approximation_keys;

/* The surface, and what the report says of the fit. */
typedef struct approximation_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  int total, fits;
  double within;             /* as in the keys, m */
  double most, mean, before; /* distances of the points, m; before: mean of the first fit */
} approximation_data;

/* Whether grid and degrees fit to the number of points and of control points. */
static bool check(const approximation_keys *keys, int count, lam_location location,
                  lam_errors *errors) {
  static const char *const directions[] = {"u", "v"};
  int before = errors->count, total = keys->grid[0] * keys->grid[1];
  if ((keys->grid[0] || keys->grid[1]) &&
      (keys->grid[0] < 2 || keys->grid[1] < 2 || count != total))
    lam_error_add(errors, location, "grid",
                  "%d x %d with %d points; expected two numbers whose product is that, or [0, 0]",
                  keys->grid[0], keys->grid[1], count);

  for (int d = 0; d < 2; d++)
    if (keys->degree[d] >= keys->count[d])
      lam_error_add(errors, location, "degree",
                    "degree %d in direction %s; expected at most %d with %d control points",
                    keys->degree[d], directions[d], keys->count[d] - 1, keys->count[d]);
  return errors->count == before;
}

/* Parameters of the points of a grid, and the mean lengths of its rows, m; false: two rows are
 * the same. */
static bool grid_parameters(lam_arena *arena, const int grid[2], const lam_vec3 *points,
                            lam_vec2 *t, double length[2]) {
  const double *rows[2];
  lam_grid_parameters(arena, LAM_PARAMETERS_CHORD, grid, points, rows);
  if (!rows[0] || !rows[1]) return false;

  length[0] = length[1] = 0;
  for (int k = 0; k < grid[0] * grid[1]; k++) {
    int i = k / grid[1], j = k % grid[1];
    t[k] = (lam_vec2){rows[0][i], rows[1][j]};
    if (i > 0) length[0] += lam_distance(points[k], points[k - grid[1]]) / grid[1];
    if (j > 0) length[1] += lam_distance(points[k], points[k - 1]) / grid[0];
  }
  return true;
}

/* What is fitted: the points, and where their feet are by now. */
typedef struct lam_cloud {
  const approximation_keys *keys;
  lam_surface_space space;
  int total;
  const lam_vec3 *points;
  lam_vec2 *t;
} lam_cloud;

/* The surface in cloud->space, with parameters corrected; false: it is not determined. */
static bool fit(lam_arena *arena, lam_cloud *cloud, lam_spline_surface *surface,
                approximation_data *data) {
  lam_surface_space *space = &cloud->space;
  for (int d = 0; d < 2 && cloud->keys->knots == DENSE; d++)
    space->knots[d] =
        lam_surface_knots(arena, space->degree[d], space->count[d], cloud->total, cloud->t, d);

  for (int step = 0; step <= cloud->keys->corrections; step++) {
    if (!lam_surface_near(arena, space, cloud->total, cloud->t, cloud->points, surface))
      return false;
    data->most = lam_surface_feet(surface, cloud->total, cloud->points, cloud->t, &data->mean);
    if (data->fits == 0 && step == 0) data->before = data->mean;
  }
  data->fits++;
  return true;
}

/* A quarter more control points in both directions and a sixteenth of the fairness; false: they
 * would be more than points, or more than there may be. */
static bool grow(lam_cloud *cloud) {
  int more[2], *count = cloud->space.count;
  for (int d = 0; d < 2; d++) {
    more[d] = count[d] + (count[d] + 3) / 4;
    if (more[d] > MAX_COUNT) more[d] = MAX_COUNT;
  }
  if (more[0] * more[1] > cloud->total || (more[0] == count[0] && more[1] == count[1]))
    return false;
  count[0] = more[0];
  count[1] = more[1];
  cloud->space.fairness /= 16;
  return true;
}

/* The points that the keys give, and their first parameters; false with messages. */
static bool collect(lam_arena *arena, const approximation_keys *keys, lam_location location,
                    lam_errors *errors, lam_cloud *cloud) {
  *cloud = (lam_cloud){.keys = keys, .space = {.fairness = keys->fairness}};
  cloud->points = lam_points_given(arena, &keys->points, 4, location, errors, &cloud->total);
  if (!cloud->points || !check(keys, cloud->total, location, errors)) return false;

  cloud->t = LAM_NEW(arena, lam_vec2, cloud->total);
  for (int d = 0; d < 2; d++) {
    cloud->space.degree[d] = keys->degree[d];
    cloud->space.count[d] = keys->count[d];
  }

  double *length = cloud->space.length;
  bool spread = keys->grid[0] ? grid_parameters(arena, keys->grid, cloud->points, cloud->t, length)
                              : lam_cloud_parameters(cloud->total, cloud->points, cloud->t, length);
  if (!spread)
    lam_error_add(errors, location, "points",
                  "they lie on a line, or two rows of the grid are the same; expected points "
                  "that spread over a surface");
  return spread;
}

/* Fits, and with `within` fits again with more control points until every point is near
 * enough. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const approximation_keys *keys = params;
  lam_cloud cloud;
  if (!collect(arena, keys, location, errors, &cloud)) return NULL;

  approximation_data *data = LAM_NEW(arena, approximation_data, 1);
  data->total = cloud.total;
  data->within = keys->within;
  lam_spline_surface surface;
  bool found = fit(arena, &cloud, &surface, data);
  while (found && keys->within > 0 && data->most > keys->within && grow(&cloud))
    found = fit(arena, &cloud, &surface, data);

  if (!found) {
    lam_error_add(errors, location, "fairness",
                  "without fairness %d points do not determine %d x %d control points; expected "
                  "fewer control points or a fairness above 0",
                  cloud.total, cloud.space.count[0], cloud.space.count[1]);
    return NULL;
  }
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

/* With `within` the growing is reported as an iteration. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const approximation_data *d = data;
  const lam_spline_surface *s = lam_nurbs_spline(d->nurbs);
  stage->iterations = -1;
  if (d->within > 0) {
    stage->iterations = d->fits;
    stage->converged = d->most <= d->within;
    stage->residual = d->most;
    stage->reason =
        stage->converged
            ? "no point is farther than `within`"
            : "a point is farther than `within`, with as many control points as there may be";
  }

  lam_stage_measure(arena, stage, "point_distance", "m", d->most, d->mean, d->total);
  lam_stage_note(arena, stage, "%d points, %d x %d control points", d->total, s->count[0],
                 s->count[1]);
  lam_stage_note(arena, stage, "mean distance before the parameters were corrected: %.4g m",
                 d->before);
}

/* The file of points among the parameters. */
static lam_point_file *cloud_of(void *params) {
  return &((approximation_keys *)params)->points.cloud;
}

static const lam_key keys[] = {
    LAM_POINT_KEYS(approximation_keys, points,
                   "[-0.3, 0.0, 0.02,  0.1, 2.1, 0.15,  -0.5, 4.3, 0.21,  -0.3, 6.5, 0.32,  0.3, "
                   "8.0, 0.41,  -0.3, 10.1, 0.14,"
                   " 2.0, 0.2, 0.27,  1.6, 2.3, 0.47,  1.8, 3.5, 0.77,  2.0, 6.2, 1.09,  2.2, 8.4, "
                   "0.85,  2.3, 9.9, 0.60,"
                   " 4.4, -0.4, 0.35,  3.7, 2.5, 0.91,  4.1, 3.8, 1.38,  3.9, 5.9, 1.69,  4.1, "
                   "8.4, 1.33,  4.4, 10.4, 0.81,"
                   " 6.2, -0.3, 0.50,  6.5, 2.4, 1.02,  6.2, 3.7, 1.44,  6.1, 5.8, 1.77,  6.4, "
                   "8.5, 1.31,  6.3, 9.9, 0.91,"
                   " 7.8, 0.3, 0.59,  7.5, 2.1, 0.82,  8.2, 3.8, 1.13,  8.5, 6.0, 1.28,  7.8, 7.6, "
                   "1.30,  7.5, 9.7, 0.89,"
                   " 10.1, -0.3, 0.51,  10.4, 1.8, 0.68,  10.4, 3.9, 0.76,  10.0, 6.1, 0.90,  "
                   "10.1, 8.1, 0.84,  10.0, 9.9, 0.69,"
                   " 11.7, -0.2, 0.64,  12.0, 2.0, 0.61,  11.9, 4.1, 0.65,  12.1, 6.1, 0.67,  "
                   "12.1, 8.0, 0.70,  11.9, 10.2, "
                   "0.66]",
                   "x, y, z of every point, in any order; with grid, v running fastest."),
    LAM_INTEGER_KEY(approximation_keys, "grid", grid, "[0, 0]", 0, 10000,
                    "Number of points in u and in v when they are a grid; [0, 0]: a cloud that "
                    "lies over a plane without folds, u along x as far as the plane allows."),
    LAM_INTEGER_KEY(
        approximation_keys, "count", count, "[4, 4]", 2, MAX_COUNT,
        "Number of control points in u and in v: few make a calm surface, many follow the points."),
    LAM_INTEGER_KEY(approximation_keys, "degree", degree, "[3, 3]", 1, LAM_BASIS_MAX_DEGREE,
                    "Degree in u and in v."),
    LAM_CHOICE_KEY(approximation_keys, "knots", knots, "even", knot_names,
                   "even: control points are spread evenly; dense: as the points are, more of them "
                   "where the scan is denser."),
    LAM_NUMBER_KEY(approximation_keys, "fairness", fairness, "1e-6", 0, 1e6,
                   "Weight of the bending energy against the mean square distance: 1e-6 bridges "
                   "gaps between points, 1e-4 takes out noise, 1e-2 flattens."),
    LAM_LENGTH_KEY(approximation_keys, "within", within, "0", 0, 1e6,
                   "No point shall be farther from the surface, before `size` scales it: control "
                   "points are added and fairness is taken away, a sixteenth of it left each time, "
                   "until that is so, at most as many as there are points; 0: `count` as it is."),
    LAM_INTEGER_KEY(approximation_keys, "corrections", corrections, "5", 0, MAX_CORRECTIONS,
                    "How often the points' parameters are moved to their feet on the surface and "
                    "the surface is found anew."),
    {0}};

const lam_surface_kind lam_surface_approximation = {
    .head = {.name = "approximation",
             .title = "Surface near points",
             .doc = "A smooth spline surface near scanned or surveyed points, by least squares "
                    "with fairness: noise stays out, unlike in a surface through the points. A "
                    "cloud may have any order, density and gaps, as long as it has no folds seen "
                    "from above (or from the side, when it is steep); the surface fills the "
                    "rectangle around it, and where this has no points it runs on straight. A grid "
                    "of rows may fold over: a vault, a shell. Read point_distance in the report: "
                    "when its maximum is far above the noise of the scan, take more control points "
                    "or less fairness.",
             .equation =
                 "mean |x(u_k, v_k) - P_k|^2 + fairness integral x_uu^2 + 2 x_uv^2 + x_vv^2 -> min",
             .source =
                 "Hoschek & Lasser, Fundamentals of CAGD, 4.4; Piegl & Tiller, The NURBS Book, 9.4",
             .keys = keys,
             .params_size = sizeof(approximation_keys)},
    .points = cloud_of,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
