/* The kind of surface that designs use; the mathematics is in surf/developable_*.c. */
#include "surf/developable.h"
#include "curve/basis.h"
#include "curve/collocation.h"
#include "fab/workshop.h"
#include "surf/flatten.h"
#include "surf/kind.h"
#include "surf/spline_surface.h"

#include <string.h>

enum { MOST_INNER = 300, REPORT_GRID = 400 };

typedef struct developable_keys {
  lam_list curve[4], knots[2];
  int degree[2], unit, method, cells;
  double power;
} developable_keys;

typedef struct developable_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_developable_result result;
  lam_developable_measures coons;
  int cells;
} developable_data;

static const char *const curve_names[4] = {"v0", "u0", "v1", "u1"}; /* in the order of lam_four_sides.curve */
static const char *const methods[] = {"newton", "trust-region", "quasi-newton", "minimax", NULL};

/* ---- the boundary ---- */

/* The points of curve i, raised to `count` points when it is a Bezier curve of fewer. */
static const lam_vec3 *curve_points(lam_arena *arena, const developable_keys *keys, int i, int count) {
  int given = keys->curve[i].count / 3;
  double *values = LAM_NEW(arena, double, 3 * count), unit = lam_point_unit(keys->unit);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count);
  memcpy(values, keys->curve[i].items, (size_t)(3 * given) * sizeof *values);
  if (given < count) lam_bezier_elevate(given - 1, count - 1, 3, values);
  for (int k = 0; k < count; k++)
    points[k] = lam_scale(lam_v3(values[3 * k], values[3 * k + 1], values[3 * k + 2]), unit);
  return points;
}

static bool check_points(const developable_keys *keys, lam_place place, lam_errors *errors) {
  int before = errors->count;
  for (int i = 0; i < 4; i++) {
    int count = keys->curve[i].count, most = keys->degree[i % 2] ? 1000 : LAM_BASIS_MAX_VALUES;
    if (count % 3 || count < 6 || count > 3 * most)
      lam_error_add(errors, place, curve_names[i], "%d numbers given; expected x, y and z of 2 to %d points", count,
                    most);
  }
  return errors->count == before;
}

/* Degree, number of points and knots in direction d. */
static void set_direction(lam_arena *arena, const developable_keys *keys, int d, lam_place place, lam_errors *errors,
                          lam_four_sides *b) {
  int first = keys->curve[d].count / 3, second = keys->curve[d + 2].count / 3;
  const lam_list *knots = &keys->knots[d];
  const char *knot_name = d ? "knots_v" : "knots_u";
  b->count[d] = first > second ? first : second;
  b->degree[d] = keys->degree[d] ? keys->degree[d] : b->count[d] - 1;
  if (keys->degree[d] && first != second) {
    lam_error_add(errors, place, curve_names[d + 2], "%d points given; expected %d, as many as %s has", second, first,
                  curve_names[d]);
  } else if (b->degree[d] >= b->count[d]) {
    lam_error_add(errors, place, "degree", "degree %d given; expected at most %d with %d points", b->degree[d],
                  b->count[d] - 1, b->count[d]);
  } else if (knots->count) {
    const char *problem = lam_knots_problem(b->degree[d], b->count[d], knots->count, knots->items);
    const double *t = knots->items;
    if (!problem && (t[0] < t[b->degree[d]] || t[b->count[d]] < t[knots->count - 1]))
      problem = "must begin and end with degree + 1 equal ones, so that the curves meet at their end points";
    if (!keys->degree[d])
      lam_error_add(errors, place, knot_name, "given without a degree; expected a degree too, or no knots");
    else if (problem)
      lam_error_add(errors, place, knot_name, "%d knots given: they %s", knots->count, problem);
    b->knots[d] = t;
  } else {
    double *clamped = LAM_NEW(arena, double, b->count[d] + b->degree[d] + 1);
    lam_knots_clamped(b->degree[d], b->count[d], clamped);
    b->knots[d] = clamped;
  }
}

/* The curves must meet, to a millionth of the boundary's size. */
static void check_corners(const lam_four_sides *b, lam_place place, lam_errors *errors) {
  static const int ends[4][4] = {{0, 0, 1, 0}, {0, 1, 3, 0}, {2, 0, 1, 1}, {2, 1, 3, 1}}; /* curve, end, curve, end */
  double size = 0;
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < b->count[i % 2]; k++) size = fmax(size, lam_distance(b->curve[0][0], b->curve[i][k]));
  for (int c = 0; c < 4; c++) {
    int i = ends[c][0], j = ends[c][2];
    lam_vec3 p = b->curve[i][ends[c][1] ? b->count[i % 2] - 1 : 0],
             q = b->curve[j][ends[c][3] ? b->count[j % 2] - 1 : 0];
    if (lam_distance(p, q) > 1e-6 * size)
      lam_error_add(errors, place, curve_names[j], "its %s lies %.3g m from the %s of %s; expected curves that meet",
                    ends[c][3] ? "end" : "start", lam_distance(p, q), ends[c][1] ? "end" : "start", curve_names[i]);
  }
  if (!(size > 0)) lam_error_add(errors, place, curve_names[0], "all points are one; expected curves");
}

/* ---- the surface ---- */

static const void *prepare(lam_arena *arena, const void *params, lam_place place, lam_errors *errors) {
  const developable_keys *keys = params;
  int before = errors->count;
  lam_four_sides b = {0};
  if (!check_points(keys, place, errors)) return NULL;
  for (int d = 0; d < 2; d++) set_direction(arena, keys, d, place, errors, &b);
  if (errors->count > before) return NULL;
  for (int i = 0; i < 4; i++) b.curve[i] = curve_points(arena, keys, i, b.count[i % 2]);
  check_corners(&b, place, errors);
  if ((b.count[0] - 2) * (b.count[1] - 2) > MOST_INNER)
    lam_error_add(errors, place, "degree", "%d x %d points are %d inner ones; expected at most %d", b.count[0],
                  b.count[1], (b.count[0] - 2) * (b.count[1] - 2), MOST_INNER);
  if (errors->count > before) return NULL;
  developable_data *data = LAM_NEW(arena, developable_data, 1);
  lam_spline_surface surface = lam_coons_surface(arena, &b);
  data->cells = keys->cells;
  data->coons = lam_developable_measure(arena, &surface, 40, REPORT_GRID);
  if (!(data->coons.least_ratio > 1e-6)) {
    lam_error_add(errors, place, curve_names[0],
                  "the Coons surface over these curves has a place without a tangent plane; expected four sides that "
                  "do not touch each other along the way");
    return NULL;
  }
  lam_developable_options options = {.method = (lam_developable_method)keys->method, .power = keys->power};
  data->result = lam_developable_solve(arena, &surface, options);
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

/* Both singular values of the map from the flattened surface and their ratio, whose largest is returned. */
static double report_stretch(lam_arena *arena, const lam_flat_mesh *mesh, const lam_vec2 *flat, lam_stage *stage) {
  lam_measure m[3] = {
      {.name = "flattening_distortion"}, {.name = "flattening_stretch"}, {.name = "flattening_compression"}};
  lam_vec2 *stretch = LAM_NEW(arena, lam_vec2, mesh->triangle_count);
  lam_flat_stretches(mesh, flat, stretch);
  for (int k = 0; k < 3; k++) {
    m[k].unit = "";
    m[k].min = INFINITY;
    m[k].count = mesh->triangle_count;
    for (int t = 0; t < mesh->triangle_count; t++) {
      const double values[3] = {stretch[t].x / stretch[t].y, stretch[t].x, stretch[t].y};
      m[k].min = fmin(m[k].min, values[k]);
      m[k].max = fmax(m[k].max, values[k]);
      m[k].mean += values[k] / mesh->triangle_count;
    }
    lam_stage_measure_add(arena, stage, m[k]);
  }
  return m[0].max;
}

/* 40 Gauss points per span: not the rule that was minimized with. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const developable_data *d = data;
  const lam_spline_surface *surface = lam_nurbs_spline(d->nurbs);
  lam_developable_measures m = lam_developable_measure(arena, surface, 40, REPORT_GRID);
  lam_flat_mesh mesh = lam_flat_grid(arena, surface, d->cells, LAM_FLAT_GEODESICS);
  lam_flattening flat = lam_flatten(arena, &mesh);
  long places = (REPORT_GRID + 1L) * (REPORT_GRID + 1L);
  stage->converged = d->result.converged && flat.converged;
  stage->reason = d->result.converged && !flat.converged ? "the flattening did not converge" : d->result.reason;
  stage->iterations = d->result.iterations;
  stage->residual = d->result.norm;
  lam_stage_measure_add(arena, stage, (lam_measure){"gauss_curvature_l2", "1/m2", m.l2, m.l2, m.l2, 1});
  lam_stage_measure(arena, stage, "gauss_curvature_max", "1/m2", m.max, m.mean, places);
  lam_stage_measure(arena, stage, "corner_bound", "1/m2", m.corner_bound, m.corner_bound, 4);
  lam_stage_measure(arena, stage, "flattening_strain", "", flat.max_strain, flat.rms_strain, mesh.edge_count);
  double distortion = report_stretch(arena, &mesh, flat.points, stage);
  lam_stage_measure(arena, stage, "turned_triangles", "", flat.flips, flat.flips, mesh.triangle_count);
  lam_stage_note(arena, stage, "Coons surface before: |K| %.4g in the mean square, at most %.4g 1/m2", d->coons.l2,
                 d->coons.max);
  lam_stage_note(arena, stage,
                 "largest ratio of singular values, of the parameter lines: %.4g; of the flattened surface: %.6g",
                 lam_flat_anisotropy(&mesh, mesh.start, NULL), distortion);
  if (m.corner_bound > 0)
    lam_stage_note(arena, stage,
                   "no surface over this boundary has max |K| below %.5g 1/m2, the bound of its corners; this one %s",
                   m.corner_bound,
                   m.max <= m.corner_bound * (1 + 1e-4)
                       ? "attains it"
                       : lam_arena_printf(arena, "has %.4g times that", m.max / m.corner_bound));
  else
    lam_stage_note(arena, stage, "the corners set no bound on max |K|");
  if (d->result.escapes) lam_stage_note(arena, stage, "saddle points left: %d", d->result.escapes);
}

#define AT(member) offsetof(developable_keys, member)
#define CURVE(index, key, points, sentence)                                                                            \
  { .name = key, .type = LAM_KEY_NUMBER, .offset = AT(curve[index]), .initial = points, .doc = sentence }
#define KNOTS(index, key, direction)                                                                                   \
  {                                                                                                                    \
    .name = key, .type = LAM_KEY_NUMBER, .offset = AT(knots[index]), .initial = "[]",                                  \
    .doc = "Knots of the curves along " direction                                                                      \
           " when they are B-splines: count + degree + 1 numbers; none: clamped and evenly spaced."                    \
  }

static const lam_key keys[] = {
    CURVE(0, "v0", "[0, 0, 0,  1, -0.2, 0.55,  2, 0.1, 0.75,  3, 0, 0.3]",
          "x, y, z of the control points of the curve v=0, along u. A Bezier curve of any degree, or a B-spline."),
    CURVE(2, "v1", "[0, 3, 0.25,  1, 3.15, 0.95,  2, 2.9, 0.8,  3, 3, 0.05]", "The opposite curve, v=1, along u."),
    CURVE(1, "u0", "[0, 0, 0,  -0.15, 1, 0.2,  0.1, 2, 0.1,  0, 3, 0.25]",
          "The curve u=0, along v: from the start of v0 to the start of v1."),
    CURVE(3, "u1", "[3, 0, 0.3,  3.1, 1, -0.05,  3.2, 2, 0.05,  3, 3, 0.05]",
          "The curve u=1, along v: from the end of v0 to the end of v1."),
    {.name = "degree",
     .type = LAM_KEY_INTEGER,
     .offset = AT(degree),
     .count = 2,
     .initial = "[0, 0]",
     .min = 0,
     .max = 8,
     .doc = "Degree of the curves along u and of those along v when they are B-splines; 0: Bezier curves, and opposite "
            "ones may differ in degree."},
    KNOTS(0, "knots_u", "u"),
    KNOTS(1, "knots_v", "v"),
    {.name = "power",
     .type = LAM_KEY_NUMBER,
     .offset = AT(power),
     .count = 1,
     .initial = "2",
     .min = 2,
     .max = 96,
     .doc =
         "The p of the L^p norm of the Gaussian curvature: 2 makes it small in the mean square; the higher, the more "
         "the largest values count. Not used by the method minimax."},
    {.name = "method",
     .type = LAM_KEY_CHOICE,
     .offset = AT(method),
     .count = 1,
     .initial = "newton",
     .choices = methods,
     .doc = "newton: Levenberg-Marquardt, then Newton's method, past saddle points; minimax: the same on ever higher "
            "powers, until the largest value of the Gaussian curvature is least; the others are the two of the paper, "
            "for comparison."},
    {.name = "flatten",
     .type = LAM_KEY_INTEGER,
     .offset = AT(cells),
     .count = 1,
     .initial = "40",
     .min = 2,
     .max = 200,
     .doc = "Cells in each direction of the grid that is laid flat for the report."},
    {.name = "unit",
     .type = LAM_KEY_CHOICE,
     .offset = AT(unit),
     .count = 1,
     .initial = "m",
     .choices = lam_point_units,
     .doc = "Unit of the numbers in the curves."},
    {0}};

const lam_surface_kind lam_surface_developable = {
    .head = {.name = "developable",
             .title = "Nearly developable patch",
             .doc = "The surface over four boundary curves that is as developable as a smooth patch over them can be: "
                    "what sheet metal or plywood does when it is fixed along a frame. Where the curves lie on a cone, "
                    "a cylinder or a tangent surface, that surface is found; where no developable surface exists, the "
                    "Gaussian curvature is made as small as possible, and the report tells what remains, how little "
                    "of it the corners allow at best, and how much the sheet has to stretch. Making the mean small can "
                    "raise the maximum at an edge: take the method minimax then.",
             .equation = "int int |K|^p du dv -> min, K = (LN - M^2)/(EG - F^2)",
             .source = "Li & Deng, Construction and application of approximate developable surfaces, sec. 2-4",
             .keys = keys,
             .params_size = sizeof(developable_keys)},
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
