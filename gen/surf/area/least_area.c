/* The kind of surface `least-area`: its keys, the boundary from four curves or a net, the
 * solution by Newton's method or by that of the paper, and the report. Listed in
 * surf/kinds/surfaces.c; the mathematics is in the other files of this folder. */
#include "surf/area/least_area.h"
#include "core/stage.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_paper.h"
#include "surf/spline/sides_keys.h"
#include "surf/spline/spline_surface.h"
#include "surf/surface_kind.h"
#include <math.h>

enum { MAX_POINTS = 200, MAX_SPANS = 64 };

typedef struct least_area_keys {
  int degree[2], count[2], method, spans, inner_weights;
  lam_sides_keys sides;
  lam_list points, weights, knots[2];
  double mean_curvature, tolerance;
} least_area_keys;

/* A finished surface. */
typedef struct least_area {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_least_area_result result;
  double mean_curvature;
  const lam_paper_result *paper; /* NULL: by Newton's method */
} least_area;

static const char *const inner_weights[] = {"fixed", "free", "separable", NULL};
enum { WEIGHTS_FIXED, WEIGHTS_FREE, WEIGHTS_SEPARABLE };
static const char *const methods[] = {"newton", "paper", NULL};
enum { METHOD_NEWTON, METHOD_PAPER };
/* Bounds of free weights. */
static const double weight_low = 0.01, weight_high = 30;
enum { PAPER_HALF = 3, PAPER_STEPS = 100 }; /* Bezier patches of degree 3 + 3 */

/* Whether the ends of the knots are repeated degree + 1 times. */
static bool clamped(int degree, int count, const double *knots) {
  return knots[0] == knots[degree] && knots[count] == knots[count + degree];
}

/* Whether given knots are sound and clamped; otherwise a message at the key. None given is well. */
static bool check_knots(int degree, int count, const lam_list *knots, const char *key,
                        lam_location location, lam_errors *errors) {
  if (knots->count == 0) return true;
  const char *problem = lam_knots_problem(degree, count, knots->count, knots->items);
  if (!problem && !clamped(degree, count, knots->items))
    problem = "must repeat the first and the last degree + 1 times";
  if (problem)
    lam_error_add(errors, location, key, "%d knots given: they %s", knots->count, problem);
  return !problem;
}

/* ---- four curves ---- */

/* The boundary from four curves; false with a message. */
static bool read_curves(lam_arena *arena, const least_area_keys *keys, lam_location location,
                        lam_errors *errors, lam_spline_surface *surface) {
  lam_sides sides;
  if (!lam_sides_read(arena, &keys->sides, (lam_sides_limits){.degree = LAM_LEAST_AREA_MAX_DEGREE},
                      location, errors, &sides))
    return false;
  if (lam_spline_surface_between(arena, &sides, surface)) return true;
  lam_error_add(errors, location, "curves",
                "the weights at the corners do not fit; expected curves whose end weights agree up "
                "to one factor per curve");
  return false;
}

/* ---- a net of control points ---- */

/* Whether numbers of points and weights fit the counts (total: of the net, ring: of its
 * boundary), and degrees and knots as well; otherwise false with a message. */
static bool check_net(const least_area_keys *keys, int total, int ring, lam_location location,
                      lam_errors *errors) {
  static const char *const knots[] = {"knots_u", "knots_v"};
  int points = keys->points.count, weights = keys->weights.count;
  if (points != 3 * total && points != 3 * ring) {
    lam_error_add(errors, location, "points",
                  "%d numbers given; expected %d: x, y and z of %d x %d points, or %d: of the %d "
                  "on the boundary",
                  points, 3 * total, keys->count[0], keys->count[1], 3 * ring, ring);
    return false;
  }

  if (weights != 0 && weights != points / 3) {
    lam_error_add(errors, location, "weights",
                  "%d weights given; expected %d: one per point, or none", weights, points / 3);
    return false;
  }
  if (!lam_weights_check(&keys->weights, "weights", location, errors)) return false;

  for (int d = 0; d < 2; d++) {
    if (keys->degree[d] >= keys->count[d]) {
      lam_error_add(errors, location, "degree", "degree %d; expected at most %d with %d points",
                    keys->degree[d], keys->count[d] - 1, keys->count[d]);
      return false;
    }
    if (!check_knots(keys->degree[d], keys->count[d], &keys->knots[d], knots[d], location, errors))
      return false;
  }
  return true;
}

/* Sets points and weights (NULL: none) of the boundary to those given, which are of the boundary
 * alone or of the whole net, row by row. Inner points stay at the origin, with weight 1. */
static void fill_net(const least_area_keys *keys, const lam_vec3 *from, lam_vec3 *points,
                     double *weights) {
  const double *from_weights = keys->weights.items;
  int m = keys->count[0], n = keys->count[1], given = 0;
  for (int k = 0; k < m * n; k++) {
    bool inner = k / n > 0 && k / n < m - 1 && k % n > 0 && k % n < n - 1;
    if (weights) weights[k] = 1;
    if (!inner) {
      points[k] = from[given];
      if (weights) weights[k] = from_weights[given];
    }
    given += !inner || keys->points.count == 3 * m * n;
  }
}

/* The boundary from a net of control points, of degree 3 at least; false with a message. */
static bool read_net(lam_arena *arena, const least_area_keys *keys, lam_location location,
                     lam_errors *errors, lam_spline_surface *surface) {
  int m = keys->count[0], n = keys->count[1], total = m * n, ring = 2 * (m + n) - 4;
  if (!check_net(keys, total, ring, location, errors)) return false;

  const lam_vec3 *from = lam_points_read(arena, &keys->points, keys->sides.unit);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, total);
  double *weights = keys->weights.count ? LAM_NEW(arena, double, total) : NULL;
  fill_net(keys, from, points, weights);
  *surface = (lam_spline_surface){.points = points, .weights = weights};
  for (int d = 0; d < 2; d++) {
    double *knots = LAM_NEW(arena, double, keys->count[d] + keys->degree[d] + 1);
    lam_knots_clamped(keys->degree[d], keys->count[d], knots);
    surface->degree[d] = keys->degree[d];
    surface->count[d] = keys->count[d];
    surface->knots[d] = keys->knots[d].count ? keys->knots[d].items : knots;
  }

  int least[2] = {surface->degree[0] > 3 ? surface->degree[0] : 3,
                  surface->degree[1] > 3 ? surface->degree[1] : 3};
  *surface = lam_least_area_unit_weights(arena, surface);
  *surface = lam_spline_surface_elevate(arena, surface, least);
  return true;
}

/* ---- solutions ---- */

/* The least area that the spans allow. Free weights are found on the boundary's own knots,
 * before others are inserted. */
static lam_least_area_result by_newton(lam_arena *arena, const least_area_keys *keys,
                                       const lam_spline_surface *boundary) {
  lam_least_area_options options = lam_least_area_defaults();
  options.tolerance = keys->tolerance;
  options.mean_curvature = keys->mean_curvature;

  lam_spline_surface own = *boundary;
  if (keys->inner_weights == WEIGHTS_SEPARABLE)
    own = lam_least_area_separable_weights(arena, boundary);
  if (keys->inner_weights != WEIGHTS_FREE)
    return lam_least_area_solve(arena, &own, keys->spans, &options);

  lam_least_area_result result = lam_least_area_solve(arena, boundary, 1, &options);
  result = lam_least_area_weights(arena, &result.surface, weight_low, weight_high, &options);
  return keys->spans > 1 ? lam_least_area_solve(arena, &result.surface, keys->spans, &options)
                         : result;
}

/* Of the paper's results the one with the wanted weights; all of them are kept in `paper`. */
static lam_least_area_result by_paper(lam_arena *arena, const least_area_keys *keys,
                                      const lam_spline_surface *boundary, lam_paper_result *paper) {
  double size = 0;
  for (int k = 0; k < boundary->count[0] * boundary->count[1]; k++)
    size = fmax(size, lam_distance(boundary->points[k], boundary->points[0]));
  *paper = lam_least_area_paper(arena, boundary, PAPER_HALF, PAPER_HALF,
                                sqrt(keys->tolerance) * size, PAPER_STEPS);

  lam_least_area_result result = paper->patches;
  if (keys->inner_weights == WEIGHTS_FREE)
    result.surface = lam_least_area_paper_weights(arena, boundary, &paper->patches.surface,
                                                  weight_low, weight_high);
  else
    result.surface = keys->inner_weights == WEIGHTS_SEPARABLE ? paper->separable : paper->nurbs;
  return result;
}

/* ---- the kind ---- */

static lam_sides_keys *sides_of(void *params) { return &((least_area_keys *)params)->sides; }

/* A mean curvature is reached by Newton's method without free weights alone; otherwise false
 * with a message. */
static bool check_mean_curvature(const least_area_keys *keys, lam_location location,
                                 lam_errors *errors) {
  if (keys->mean_curvature == 0 ||
      (keys->inner_weights != WEIGHTS_FREE && keys->method != METHOD_PAPER))
    return true;
  lam_error_add(errors, location, "mean_curvature",
                "%g; expected 0 with free inner weights or method: paper", keys->mean_curvature);
  return false;
}

/* The finished surface from its keys, or NULL with messages. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const least_area_keys *keys = params;
  lam_spline_surface boundary;
  if (!(keys->sides.curves.count || keys->sides.file ? read_curves : read_net)(
          arena, keys, location, errors, &boundary))
    return NULL;
  if (!check_mean_curvature(keys, location, errors)) return NULL;

  least_area *data = LAM_NEW(arena, least_area, 1);
  data->mean_curvature = keys->mean_curvature;
  if (keys->method == METHOD_PAPER) {
    lam_paper_result *paper = LAM_NEW(arena, lam_paper_result, 1);
    data->result = by_paper(arena, keys, &boundary, paper);
    data->paper = paper;
  } else {
    data->result = by_newton(arena, keys, &boundary);
  }
  data->nurbs = lam_nurbs_make(arena, &data->result.surface);
  return data;
}

/* Adds the areas of the paper's results. That on approximated borders may be below the least
 * one. */
static void report_paper(lam_arena *arena, const lam_paper_result *paper, lam_stage *stage) {
  const struct {
    const char *name;
    const lam_spline_surface *surface;
  } results[] = {{"area_patches", &paper->patches.surface},
                 {"area_rational", &paper->rational},
                 {"area_separable", &paper->separable}};

  for (size_t k = 0; k < sizeof results / sizeof *results; k++) {
    double area = lam_surface_area(arena, results[k].surface, results[k].surface->degree[0] + 6);
    lam_stage_measure_add(arena, stage, (lam_measure){results[k].name, "m2", area, area, area, 1});
  }

  lam_stage_note(
      arena, stage,
      "area_patches: of Bezier patches on approximated borders; area_rational and area_separable: "
      "of rational Bezier patches and of the NURBS surface with separable weights, on the exact "
      "boundary");
}

/* The verdict. Points that slide within the surface may save next to nothing for long: where
 * eight steps save less than a twentieth of what finer knots would, the surface is as good as its
 * knots allow. */
static void report_verdict(const least_area *s, double excess, lam_stage *stage) {
  bool creeps = !s->result.converged && s->result.fall < excess / 20;
  stage->converged = s->result.converged || creeps;
  stage->reason = creeps ? "the area falls by next to nothing against what finer knots would save"
                         : s->result.reason;
  stage->iterations = s->result.iterations;
}

/* Adds area and mean curvature, measured anew, and how the surface was found. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const least_area *s = data;
  const lam_spline_surface *shape = &s->result.surface;
  double area = lam_surface_area(arena, shape, shape->degree[0] + 6), largest, rms;
  long samples;
  lam_surface_mean_curvature(arena, shape, s->mean_curvature, 6, &largest, &rms, &samples);
  lam_stage_measure_add(arena, stage, (lam_measure){"area", "m2", area, area, area, 1});
  double excess = s->mean_curvature == 0 ? lam_surface_area_excess(arena, shape) : NAN;
  report_verdict(s, excess, stage);
  if (isfinite(excess))
    lam_stage_measure_add(arena, stage,
                          (lam_measure){"area_excess", "m2", excess, excess, excess, 1});
  lam_stage_measure(arena, stage, "mean_curvature_max", "1/m", largest, rms, samples);
  lam_stage_note(arena, stage,
                 "%d x %d control points; area and curvature before the surface is placed",
                 shape->count[0], shape->count[1]);

  if (isfinite(excess))
    lam_stage_note(arena, stage, "the area is about %.1e of it above the least one", excess / area);
  if (s->paper)
    report_paper(arena, s->paper, stage);
  else
    lam_stage_note(arena, stage,
                   "area by the quadrature that was minimized with: off by %.1e of it",
                   fabs(s->result.area / area - 1));
  if (s->result.saddles)
    lam_stage_note(arena, stage, "%d stationary surfaces of larger area were left",
                   s->result.saddles);
}

static const lam_key keys_table[] = {
    LAM_SIDES_KEYS(least_area_keys, sides, lam_side_table, "[]"),
    LAM_INTEGER_KEY(least_area_keys, "degree", degree, "[3, 3]", 1, LAM_LEAST_AREA_MAX_DEGREE,
                    "Polynomial degree in u and in v; raised to 3 when it is less."),
    LAM_INTEGER_KEY(least_area_keys, "count", count, "[4, 4]", 2, MAX_POINTS,
                    "Number of control points in u and in v."),
    LAM_NUMBER_KEY(least_area_keys, "points", points,
                   "[0, 0, 2,  0, 3, 1,  0, 6, 1,  0, 9, 2, 3, 0, 4,  3, 9, 4,  6, 0, 4,  6, 9, 4, "
                   "9, 0, 2,  9, 3, 1,  9, 6, 1,  9, 9, 2]",
                   0, 0,
                   "In place of curves: x, y, z of the control points, v running fastest, of the "
                   "boundary alone or of all (inner ones are not used)."),
    LAM_NUMBER_KEY(least_area_keys, "weights", weights, "[]", 0, 0,
                   "Positive weights in the order of points; none: all 1."),
    LAM_NUMBER_KEY(least_area_keys, "knots_u", knots[0], "[]", 0, 0,
                   "Knots in u, count + degree + 1, the first and the last repeated degree + 1 "
                   "times; none: evenly spaced."),
    LAM_NUMBER_KEY(least_area_keys, "knots_v", knots[1], "[]", 0, 0, "Knots in v, likewise."),
    LAM_CHOICE_KEY(least_area_keys, "method", method, "newton", methods,
                   "newton: the least area that the spans allow; paper: Bezier patches of degree 6 "
                   "on approximated borders, then the nearest surface on the exact boundary (Wu & "
                   "Wang); spans is not used."),
    LAM_INTEGER_KEY(least_area_keys, "spans", spans, "8", 1, MAX_SPANS,
                    "Knot spans in each direction, at least; 1: no knots are added, and the "
                    "surface has the given number of points."),
    LAM_CHOICE_KEY(
        least_area_keys, "inner_weights", inner_weights, "fixed", inner_weights,
        "fixed: inner points have weight 1 before knots are added; separable: w_i0 w_0j / w_00, as "
        "of a product of two curves; free: their weights are sought too, between 0.01 and 30."),
    LAM_NUMBER_KEY(least_area_keys, "mean_curvature", mean_curvature, "0", 0, 0,
                   "Mean curvature to reach, in 1/m, positive towards x_u x x_v: as of a soap film "
                   "under pressure; 0: least area."),
    LAM_NUMBER_KEY(least_area_keys, "tolerance", tolerance, "1e-9", 1e-14, 0.1,
                   "Stops where a step saves less than this part of the area; by the paper's "
                   "method, where the surface moves by less than the root of it."),
    {0}};

const lam_surface_kind lam_surface_least_area = {
    .head = {.name = "least-area",
             .title = "Surface of least area",
             .doc =
                 "The soap film on a frame of four curves, as a NURBS surface whose boundary is "
                 "exactly the given one. With few spans it is the best surface with few control "
                 "points, good for exchange; the default of 8 spans is usually within a "
                 "millionth of the least area, 16 within some hundred-millionths, and ten times as "
                 "far off or more where sides bend strongly: area_excess of the report estimates "
                 "by how much, a quarter too low at worst from 4 spans on. Sides that are far "
                 "apart for their length "
                 "have no film that a rectangle can span: the surface then collapses towards "
                 "them, and mean_curvature_max of the report stays large. Near corners it is "
                 "never small unless the sides fit a minimal surface there.",
             .equation = "integral |x_u x x_v| du dv -> min over the inner control points",
             .source = "Wu & Wang, Designing approximate minimal NURBS surfaces with boundaries "
                       "interpolation, 2010",
             .keys = keys_table,
             .params_size = sizeof(least_area_keys)},
    .sides = sides_of,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
