/* The kind of surface `developable`: its keys, the way from four curves to the finished surface,
 * and the report. Listed in surf/kinds/surfaces.c; the mathematics is in developable_solve.c and
 * the files below it. */
#include "surf/developable/developable.h"
#include "core/stage.h"
#include "surf/flatten/flatten.h"
#include "surf/spline/coons_patch.h"
#include "surf/spline/sides_keys.h"
#include "surf/spline/spline_surface.h"

/* Limits of the boundary; cells of the grid on which the report measures |K|. */
enum { MOST_DEGREE = 8, MOST_INNER = 300, REPORT_GRID = 400 };

typedef struct developable_keys {
  lam_sides_keys sides;
  int method, cells;
  double power;
} developable_keys;

/* A finished surface. */
typedef struct developable_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_developable_result result;
  lam_developable_measures coons; /* of the start */
  int cells;                      /* of the grid that is laid flat */
} developable_data;

static const char *const methods[] = {"newton", "trust-region", "quasi-newton", "minimax", NULL};

static lam_sides_keys *sides_of(void *params) { return &((developable_keys *)params)->sides; }

/* Whether a surface has few enough inner points for dense matrices; otherwise false, with a
 * message. */
static bool check_size(const lam_spline_surface *surface, lam_location location,
                       lam_errors *errors) {
  int inner = (surface->count[0] - 2) * (surface->count[1] - 2);
  if (inner <= MOST_INNER) return true;
  lam_error_add(errors, location, "curves",
                "opposite curves have %d x %d points in common, %d inner ones; expected at most %d",
                surface->count[0], surface->count[1], inner, MOST_INNER);
  return false;
}

/* The finished surface from its keys, or NULL with messages. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const developable_keys *keys = params;
  lam_sides sides;
  if (!lam_sides_read(arena, &keys->sides, (lam_sides_limits){MOST_DEGREE, true}, location, errors,
                      &sides))
    return NULL;

  lam_spline_surface surface = lam_coons_surface(arena, &sides, LAM_COONS_BILINEAR);
  if (!check_size(&surface, location, errors)) return NULL;

  developable_data *data = LAM_NEW(arena, developable_data, 1);
  data->cells = keys->cells;
  data->coons = lam_developable_measure(arena, &surface, 40, REPORT_GRID);
  if (!(data->coons.least_ratio > 1e-6)) {
    lam_error_add(errors, location, "curves",
                  "the Coons surface over these curves has a place without a tangent plane; "
                  "expected four sides that do not touch each other along the way");
    return NULL;
  }

  lam_developable_options options = {.method = (lam_developable_method)keys->method,
                                     .power = keys->power};
  data->result = lam_developable_solve(arena, &surface, options);
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

/* Adds both singular values of the map from the flattened surface to the surface, and their
 * ratio, by triangles. Returns the largest ratio. */
static double report_stretch(lam_arena *arena, const lam_flat_mesh *mesh, const lam_vec2 *flat,
                             lam_stage *stage) {
  lam_measure m[3] = {{.name = "flattening_distortion"},
                      {.name = "flattening_stretch"},
                      {.name = "flattening_compression"}};
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

/* The sentence about the bound that the corners set on max |K|, and whether it is attained. */
static void note_bound(lam_arena *arena, const lam_developable_measures *m, lam_stage *stage) {
  if (!(m->corner_bound * m->area > 1e-9)) { /* less is rounding */
    lam_stage_note(arena, stage, "the corners set no bound on max |K|");
    return;
  }
  const char *verdict =
      m->max <= m->corner_bound * (1 + 1e-4)
          ? "attains it"
          : lam_arena_printf(arena, "has %.4g times that", m->max / m->corner_bound);
  lam_stage_note(arena, stage,
                 "no surface over this boundary has max |K| below %.5g 1/m2, the bound of its "
                 "corners; this one %s",
                 m->corner_bound, verdict);
}

/* Measures the surface, with 40 Gauss points per span and not the rule that was minimized with, and
 * its flattening. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const developable_data *d = data;
  const lam_spline_surface *surface = lam_nurbs_spline(d->nurbs);
  lam_developable_measures m = lam_developable_measure(arena, surface, 40, REPORT_GRID);
  lam_flat_mesh mesh = lam_flat_grid(arena, surface, d->cells, LAM_FLAT_GEODESICS);
  lam_flattening flat = lam_flatten(arena, &mesh);
  long samples = (REPORT_GRID + 1L) * (REPORT_GRID + 1L);

  stage->converged = d->result.converged && flat.converged;
  stage->reason =
      d->result.converged && !flat.converged ? "the flattening did not converge" : d->result.reason;
  stage->iterations = d->result.iterations;
  stage->residual = d->result.norm;

  lam_stage_measure_add(arena, stage,
                        (lam_measure){"gauss_curvature_l2", "1/m2", m.l2, m.l2, m.l2, 1});
  lam_stage_measure(arena, stage, "gauss_curvature_max", "1/m2", m.max, m.mean, samples);
  lam_stage_measure(arena, stage, "corner_bound", "1/m2", m.corner_bound, m.corner_bound, 4);
  lam_stage_measure(arena, stage, "flattening_strain", "", flat.max_strain, flat.rms_strain,
                    mesh.edge_count);
  double distortion = report_stretch(arena, &mesh, flat.points, stage);
  lam_stage_count(arena, stage, "turned_triangles", flat.flips);

  lam_stage_note(arena, stage,
                 "Coons surface before: |K| %.4g in the mean square, at most %.4g 1/m2",
                 d->coons.l2, d->coons.max);
  lam_stage_note(arena, stage,
                 "largest ratio of singular values, of the parameter lines: %.4g; of the flattened "
                 "surface: %.6g",
                 lam_flat_anisotropy(&mesh, mesh.start, NULL), distortion);
  note_bound(arena, &m, stage);
  if (d->result.escapes) lam_stage_note(arena, stage, "saddle points left: %d", d->result.escapes);
}

static const lam_key keys[] = {
    LAM_SIDES_KEYS(developable_keys, sides, lam_side_table,
                   "[{points: [0, 0, 0,  1, -0.2, 0.55,  2, 0.1, 0.75,  3, 0, 0.3]},"
                   " {points: [0, 0, 0,  -0.15, 1, 0.2,  0.1, 2, 0.1,  0, 3, 0.25]},"
                   " {points: [0, 3, 0.25,  1, 3.15, 0.95,  2, 2.9, 0.8,  3, 3, 0.05]},"
                   " {points: [3, 0, 0.3,  3.1, 1, -0.05,  3.2, 2, 0.05,  3, 3, 0.05]}]"),
    LAM_NUMBER_KEY(
        developable_keys, "power", power, "2", 2, 96,
        "The p of the L^p norm of the Gaussian curvature: 2 makes it small in the mean square; the "
        "higher, the more the largest values count. Not used by the method minimax."),
    LAM_CHOICE_KEY(
        developable_keys, "method", method, "newton", methods,
        "newton: Levenberg-Marquardt, then Newton's method, past saddle points; minimax: the same "
        "on ever higher powers, until the largest value of the Gaussian curvature is least; the "
        "others are the two of the paper, for comparison."),
    LAM_INTEGER_KEY(developable_keys, "flatten", cells, "40", 2, 200,
                    "Cells in each direction of the grid that is laid flat for the report."),
    {0}};

const lam_surface_kind lam_surface_developable = {
    .head = {.name = "developable",
             .title = "Nearly developable patch",
             .doc = "The surface over four polynomial curves that is as developable as a smooth "
                    "patch over them can be: what sheet metal or plywood does when it is fixed "
                    "along a frame. Where the curves lie on a cone, a cylinder or a tangent "
                    "surface, that surface is found; where no developable surface exists, the "
                    "Gaussian curvature is made as small as possible, and the report tells what "
                    "remains, how little of it the corners allow at best, and how much the sheet "
                    "has to stretch. Making the mean small can raise the maximum at an edge: take "
                    "the method minimax then.",
             .equation = "int int |K|^p du dv -> min, K = (LN - M^2)/(EG - F^2)",
             .source = "Li & Deng, Construction and application of approximate developable "
                       "surfaces, sec. 2-4",
             .keys = keys,
             .params_size = sizeof(developable_keys)},
    .sides = sides_of,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
