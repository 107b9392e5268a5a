/* Initial nets from traced lines: which fields, through which point, in which sense. Called by
 * net/trace/start.c; the nets themselves are made by trace_net.c and trace_geodesic.c. */
#include "net/trace/trace_net.h"

#include <math.h>
#include <string.h>

/* Which of two directions is family 0, and the senses of both: family 1 is to the left of family
 * 0, and the line halfway between them is as near as can be to 60 degrees from x_u towards x_v.
 * Principal lines along u and v keep their names so, and the diagonals of (u, v) become u + v and
 * v - u. order[k]: the branch of family k. */
static void orient(const lam_jet *jet, const lam_vec2 given[2], int order[2], lam_vec2 d[2]) {
  lam_curvature c = lam_jet_curvature(jet);
  lam_vec3 e1 = lam_unit(jet->u), e2 = lam_cross(c.normal, e1), wanted = lam_along(e1, sqrt(3), e2);

  /* two orders and four pairs of senses; half of them are left-handed */
  double best = -INFINITY;
  for (int k = 0; k < 8; k++) {
    int swap = k & 1;
    double sign[2] = {k & 2 ? -1 : 1, k & 4 ? -1 : 1};
    lam_vec2 a[2];
    lam_vec3 x[2];
    for (int i = 0; i < 2; i++) {
      const lam_vec2 *from = &given[swap ? !i : i];
      a[i] = (lam_vec2){sign[i] * from->x, sign[i] * from->y};
      x[i] = lam_along(lam_scale(jet->u, a[i].x), a[i].y, jet->v);
    }

    double near = lam_dot(lam_unit(lam_add(x[0], x[1])), wanted);
    if (lam_dot(lam_cross(x[0], x[1]), c.normal) <= 0 || near <= best + 1e-9) continue;
    best = near;
    for (int i = 0; i < 2; i++) d[i] = a[i], order[i] = swap ? !i : i;
  }
}

enum { pattern = 12 }; /* points of a pattern over the rectangle, along u and along v */

/* The point (i, j) of the pattern. */
static void pattern_point(const lam_line_field *field, int i, int j, double at[2]) {
  at[0] = field->low[0] + (field->high[0] - field->low[0]) * (i + .5) / pattern;
  at[1] = field->low[1] + (field->high[1] - field->low[1]) * (j + .5) / pattern;
}

/* The side of the largest square of points with directions around (i, j), as the number of its
 * rings; 0: the point itself has none. */
static int rings_around(bool has[pattern][pattern], int i, int j) {
  for (int r = 0; r <= pattern / 2; r++) {
    int i0 = i - r, i1 = i + r, j0 = j - r, j1 = j + r;
    bool all = i0 >= 0 && j0 >= 0 && i1 < pattern && j1 < pattern;
    for (int a = i0; all && a <= i1; a++)
      for (int b = j0; all && b <= j1; b++) all = has[a][b];
    if (!all) return r;
  }
  return pattern / 2 + 1;
}

/* A point at which a field has directions, as far inside as can be: of a pattern of points, the
 * one with most such points around it. False: there is none. */
static bool suggest(const lam_line_field *field, double at[2]) {
  bool has[pattern][pattern];
  int most = 0;
  for (int i = 0; i < pattern; i++)
    for (int j = 0; j < pattern; j++) {
      lam_vec2 d[2];
      double point[2];
      pattern_point(field, i, j, point);
      has[i][j] = lam_line_directions(field, point[0], point[1], d);
    }

  for (int i = 0; i < pattern; i++)
    for (int j = 0; j < pattern; j++) {
      int rings = rings_around(has, i, j);
      if (rings <= most) continue;
      most = rings;
      pattern_point(field, i, j, at);
    }
  return most > 0;
}

/* Adds the error that the field has no directions at `at`: why, and where it has. */
static void no_directions(const lam_line_field *field, const double at[2], lam_location location,
                          lam_errors *errors) {
  lam_jet jet;
  lam_surface_eval(field->surface, at[0], at[1], &jet);
  lam_curvature c = lam_jet_curvature(&jet);
  double other[2];
  const char *expected =
      suggest(field, other)
          ? lam_arena_printf(errors->arena, "such as at: [%.4g, %.4g]", other[0], other[1])
          : "but the surface has none in this range";

  if (!isfinite(c.K))
    lam_error_add(errors, location, "net.from.at",
                  "[%.4g, %.4g] is a singular point; expected a regular one, %s", at[0], at[1],
                  expected);
  else if (field->chart == LAM_CHART_ASYMPTOTIC && c.K >= 0)
    lam_error_add(errors, location, "net.from.at",
                  "no asymptotic lines run through (u, v) = (%.4g, %.4g), where K = %.3g; expected "
                  "a point with K < 0, %s",
                  at[0], at[1], c.K, expected);
  else
    lam_error_add(errors, location, "net.from.at",
                  "(u, v) = (%.4g, %.4g) is an umbilic or a flat point, where every direction is a "
                  "principal one; expected another point, %s",
                  at[0], at[1], expected);
}

/* Whether `at` lies in the rectangle of the field and a hole is asked for only around a pole;
 * adds to errors otherwise. */
static bool check_options(const lam_line_field *field, const double at[2], int hole,
                          lam_location location, lam_errors *errors) {
  for (int c = 0; c < 2; c++)
    if (!(at[c] >= field->low[c] && at[c] <= field->high[c])) {
      lam_error_add(errors, location, "net.from.at",
                    "[%.6g, %.6g]; expected u from %.6g to %.6g and v from %.6g to %.6g", at[0],
                    at[1], field->low[0], field->high[0], field->low[1], field->high[1]);
      return false;
    }

  if (hole > 0 && field->chart != LAM_CHART_GEODESIC_POLAR) {
    lam_error_add(errors, location, "net.hole",
                  "%d, but traced lines have no flat point in their middle; expected 0", hole);
    return false;
  }
  return true;
}

/* The fields of both families through `at`, and their directions d there. given: those of the
 * branches. */
static void orient_families(const lam_line_field *field, const lam_vec2 given[2],
                            const double at[2], lam_line_field families[2], lam_vec2 d[2]) {
  int order[2] = {0, 1};
  lam_jet jet;
  lam_surface_eval(field->surface, at[0], at[1], &jet);
  orient(&jet, given, order, d);
  for (int k = 0; k < 2; k++) families[k] = *field, families[k].branch = order[k];
}

/* Adds the error that no cell fits around `at`. */
static void too_short(lam_chart chart, const double at[2], double spacing, lam_location location,
                      lam_errors *errors) {
  lam_error_add(errors, location, "net.grid",
                "the %s lines around (u, v) = (%.4g, %.4g) are too short for one cell%s; "
                "expected larger ranges of u and v, another point%s",
                lam_chart_names[chart], at[0], at[1],
                chart == LAM_CHART_GEODESIC_POLAR ? " outside the hole (grid: rings, spokes >= 3)"
                                                  : "",
                spacing > 0 ? ", or a smaller spacing" : "");
}

/* ---- the net ---- */

/* What is asked for; at: where the base lines cross. */
typedef struct request {
  const lam_surface *surface;
  lam_chart chart;
  int grid[2], hole;
  const lam_trace_options *options;
  const lam_placement_keys *placing;
  double at[2];
} request;

/* A net through the point of the request, and how much of the surface it covers. given: the
 * directions there. False: no cell fits. */
static bool trace_through(lam_arena *arena, const request *r, const lam_line_field *field,
                          const lam_vec2 given[2], lam_mesh *mesh, lam_traced *traced) {
  double spacing = r->options->spacing;
  lam_line_field families[2];
  lam_vec2 d[2];
  lam_cells cells;
  bool made;
  if (r->chart == LAM_CHART_GEODESIC_PARALLEL)
    made = lam_geodesic_parallel_net(arena, field, r->at, r->options->base, r->grid, spacing, mesh,
                                     &cells);
  else if (r->chart == LAM_CHART_GEODESIC_POLAR)
    made = lam_geodesic_polar_net(arena, field, r->at, r->grid, r->hole, spacing, mesh, &cells);
  else {
    orient_families(field, given, r->at, families, d);
    made = lam_weave_net(arena, families, d, r->at, r->grid, spacing, mesh, &cells);
  }
  if (!made) return false;

  *traced = (lam_traced){.coverage = lam_cells_coverage(arena, field, &cells),
                         .at = {r->at[0], r->at[1]},
                         .cells = {cells.rows - 1, cells.columns - 1}};
  return true;
}

/* The share that a rough net through a point covers; 0 where there is none. Scratch is released. */
static double coverage_through(lam_arena *arena, const lam_line_field *field, const double at[2]) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_line_field families[2];
  lam_vec2 given[2], d[2];
  lam_cells cells;
  double coverage = 0;
  if (lam_line_directions(field, at[0], at[1], given)) {
    orient_families(field, given, at, families, d);
    if (lam_weave_roughly(arena, families, d, at, &cells))
      coverage = lam_cells_coverage(arena, field, &cells);
  }
  lam_arena_release(arena, mark);
  return coverage;
}

/* Where lines that leave much of the surface bare in the middle may begin instead: of five by five
 * points, the one around which a rough net covers most. at: in, the middle; out, that point. False:
 * none is better than the middle. */
static bool better_start(lam_arena *arena, const lam_line_field *field, double at[2]) {
  enum { side = 5 };
  double best = coverage_through(arena, field, at) + .02; /* coverage is known to about a percent */
  bool found = false;
  for (int i = 0; i < side; i++)
    for (int j = 0; j < side; j++) {
      double point[2] = {field->low[0] + (field->high[0] - field->low[0]) * (i + .5) / side,
                         field->low[1] + (field->high[1] - field->low[1]) * (j + .5) / side};
      double coverage = coverage_through(arena, field, point);
      if (!(coverage > best)) continue;
      best = coverage;
      memcpy(at, point, sizeof point);
      found = true;
    }
  return found;
}

/* A net that is to cover the surface and does not, is traced anew from where more can be reached.
 */
static void try_elsewhere(lam_arena *arena, const request *asked, lam_mesh *mesh,
                          lam_traced *traced) {
  request r = *asked;
  lam_vec2 given[2];
  lam_line_field *field = LAM_NEW(arena, lam_line_field, 1);
  *field = lam_line_field_make(r.surface, r.chart, r.placing, NULL);
  lam_line_field rough = *field;
  rough.tolerance = 1e-6;
  if (!better_start(arena, &rough, r.at)) return;

  lam_mesh other;
  lam_traced there;
  if (!lam_line_directions(field, r.at[0], r.at[1], given) ||
      !trace_through(arena, &r, field, given, &other, &there) ||
      !(there.coverage > traced->coverage))
    return;
  *mesh = other;
  *traced = there;
}

/* Everything hangs on the directions at `at`, the middle of the ranges when it is not given. */
bool lam_trace_net(lam_arena *arena, const lam_surface *surface, lam_chart chart, const int grid[2],
                   int hole, const lam_trace_options *options, const lam_placement_keys *placing,
                   lam_location location, lam_errors *errors, lam_mesh *mesh, lam_traced *traced) {
  lam_line_field field = lam_line_field_make(surface, chart, placing, options->at);
  request r = {surface,
               chart,
               {grid[0], grid[1]},
               hole,
               options,
               placing,
               {(field.low[0] + field.high[0]) / 2, (field.low[1] + field.high[1]) / 2}};
  if (options->at) memcpy(r.at, options->at, sizeof r.at);
  if (!check_options(&field, r.at, hole, location, errors)) return false;

  lam_vec2 given[2];
  if (!lam_line_directions(&field, r.at[0], r.at[1], given)) {
    no_directions(&field, r.at, location, errors);
    return false;
  }
  if (!trace_through(arena, &r, &field, given, mesh, traced)) {
    too_short(chart, r.at, options->spacing, location, errors);
    return false;
  }

  /* Geodesics start from the line or pole in the middle: elsewhere they are another net. */
  bool free = !options->at && options->spacing == 0 && chart < LAM_CHART_COUNT;
  if (free && traced->coverage < lam_enough_coverage) try_elsewhere(arena, &r, mesh, traced);
  return true;
}
