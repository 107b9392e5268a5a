/* The kind of surface that designs use; the mathematics is in surf/coons_patch.c. */
#include "curve/basis.h"
#include "curve/curve.h"
#include "fab/workshop.h"
#include "surf/coons_patch.h"
#include "surf/kind.h"
#include "surf/spline_surface.h"

enum { SAMPLES = 200, MAX_POINTS = 1000 };

typedef struct coons_keys {
  lam_list points[LAM_COONS_SIDES], knots[LAM_COONS_SIDES], across[LAM_COONS_SIDES];
  int degree[2], blend, unit;
} coons_keys;

typedef struct coons_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_coons coons;
  bool hermite;
} coons_data;

static const char *const side_names[] = {"v0", "u0", "v1", "u1"}; /* in the order of lam_coons.side */
static const char *const knot_names[] = {"knots_v0", "knots_u0", "knots_v1", "knots_u1"};
static const char *const across_names[] = {"across_v0", "across_u0", "across_v1", "across_u1"};
static const char *const blends[] = {"bilinear", "hermite", NULL};

/* ---- the sides ---- */

static lam_vec3 *read_points(lam_arena *arena, const lam_list *list, double unit) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, list->count / 3);
  const double *x = list->items;
  for (int i = 0; i < list->count / 3; i++) points[i] = lam_scale(lam_v3(x[3 * i], x[3 * i + 1], x[3 * i + 2]), unit);
  return points;
}

/* Side i, or false with a message. */
static bool read_side(lam_arena *arena, const coons_keys *keys, int i, lam_place place, lam_errors *errors,
                      lam_spline_curve *side) {
  int given = keys->points[i].count, count = given / 3, degree = keys->degree[i % 2];
  int most = degree ? MAX_POINTS : LAM_BASIS_MAX_VALUES;
  const lam_list *knots = &keys->knots[i];
  if (given % 3 || count < 2 || count > most) {
    lam_error_add(errors, place, side_names[i], "%d numbers given; expected x, y and z of 2 to %d points", given, most);
    return false;
  }
  if (!degree) degree = count - 1;
  if (degree >= count) {
    lam_error_add(errors, place, "degree", "degree %d given; expected at most %d with the %d points of %s", degree,
                  count - 1, count, side_names[i]);
    return false;
  }
  const char *problem = knots->count ? lam_knots_problem(degree, count, knots->count, knots->items) : NULL;
  if (problem) {
    lam_error_add(errors, place, knot_names[i], "%d knots given: they %s", knots->count, problem);
    return false;
  }
  double *even = LAM_NEW(arena, double, count + degree + 1);
  lam_knots_clamped(degree, count, even);
  *side = (lam_spline_curve){degree, count, knots->count ? knots->items : even,
                             read_points(arena, &keys->points[i], lam_point_unit(keys->unit)), NULL};
  return true;
}

static void read_across(lam_arena *arena, const coons_keys *keys, int i, lam_place place, lam_errors *errors,
                        lam_coons *coons) {
  const lam_list *list = &keys->across[i];
  const lam_spline_curve *side = &coons->side[i];
  if (!list->count) return;
  if (!keys->blend)
    lam_error_add(errors, place, across_names[i], "given with a bilinear blend; expected blend: hermite");
  else if (list->count != 3 * side->count)
    lam_error_add(errors, place, across_names[i],
                  "%d numbers given; expected %d: x, y and z of %d vectors, as many as "
                  "%s has points",
                  list->count, 3 * side->count, side->count, side_names[i]);
  if (list->count != 3 * side->count) return;
  lam_vec3 *points = read_points(arena, list, lam_point_unit(keys->unit));
  lam_spline_curve across = {side->degree, side->count, side->knots, points, NULL};
  coons->across[i] = lam_spline_curve_net(arena, &across, false);
}

/* The largest extent of the control points. */
static double size_of(const lam_coons *coons) {
  double size = 0;
  for (int i = 0; i < LAM_COONS_SIDES; i++)
    for (int k = 0; k < coons->side[i].count; k++)
      size = fmax(size, lam_distance(coons->side[0].points[0], coons->side[i].points[k]));
  return size;
}

static lam_vec3 end_of(const lam_spline_curve *side, int end) {
  lam_vec3 x;
  lam_spline_curve_eval(side, side->knots[end ? side->count : side->degree], 0, &x);
  return x;
}

/* The sides must meet, to a millionth of their size. */
static void check_corners(const lam_coons *coons, lam_place place, lam_errors *errors) {
  double size = size_of(coons);
  if (!(size > 0)) lam_error_add(errors, place, side_names[0], "all points are one; expected curves");
  for (int u = 0; u < 2; u++)
    for (int v = 0; v < 2; v++) {
      int i = 2 * v, j = 2 * u + 1; /* side i ends at u, side j ends at v */
      double apart = lam_distance(end_of(&coons->side[i], u), end_of(&coons->side[j], v));
      if (apart > 1e-6 * size)
        lam_error_add(errors, place, side_names[j], "its %s lies %.3g m from the %s of %s; expected curves that meet",
                      v ? "end" : "start", apart, u ? "end" : "start", side_names[i]);
    }
}

/* ---- the surface ---- */

static const void *prepare(lam_arena *arena, const void *params, lam_place place, lam_errors *errors) {
  const coons_keys *keys = params;
  int before = errors->count;
  coons_data *data = LAM_NEW(arena, coons_data, 1);
  bool sound = true;
  for (int i = 0; i < LAM_COONS_SIDES; i++)
    if (!read_side(arena, keys, i, place, errors, &data->coons.side[i])) sound = false;
  if (!sound) return NULL;
  for (int i = 0; i < LAM_COONS_SIDES; i++) read_across(arena, keys, i, place, errors, &data->coons);
  check_corners(&data->coons, place, errors);
  if (errors->count > before) return NULL;
  data->hermite = keys->blend == 1;
  lam_spline_surface surface =
      data->hermite ? lam_coons_hermite(arena, &data->coons) : lam_coons_bilinear(arena, &data->coons);
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const coons_data *d = data;
  double most = 0, mean = 0;
  for (int i = 0; i < LAM_COONS_SIDES; i++)
    for (int k = 0; k <= SAMPLES; k++) {
      const lam_spline_curve *side = &d->coons.side[i];
      double t = (double)k / SAMPLES, low = side->knots[side->degree], high = side->knots[side->count];
      lam_vec3 x;
      lam_jet jet;
      lam_spline_curve_eval(side, low + t * (high - low), 0, &x);
      lam_held_nurbs_eval(data, i % 2 ? i / 2 : t, i % 2 ? t : i / 2, &jet);
      most = fmax(most, lam_distance(x, jet.x));
      mean += lam_distance(x, jet.x) / (LAM_COONS_SIDES * (SAMPLES + 1));
    }
  stage->iterations = -1;
  lam_stage_measure(arena, stage, "side_distance", "m", most, mean, LAM_COONS_SIDES * (SAMPLES + 1));
  if (!d->hermite) return;
  lam_coons_gaps gaps = lam_coons_check(arena, &d->coons);
  lam_stage_measure(arena, stage, "slope_gap", "m", gaps.slope, NAN, 8);
  lam_stage_measure(arena, stage, "twist_gap", "m", gaps.twist, NAN, 4);
}

#define AT(member) offsetof(coons_keys, member)
#define SIDE(index, key, points_, sentence)                                                                            \
  { .name = key, .type = LAM_KEY_NUMBER, .offset = AT(points[index]), .initial = points_, .doc = sentence }
#define KNOTS(index, key, side)                                                                                        \
  {                                                                                                                    \
    .name = key, .type = LAM_KEY_NUMBER, .offset = AT(knots[index]), .initial = "[]",                                  \
    .doc = "Knots of " side ", points + degree + 1 numbers that do not decrease; none: clamped and evenly spaced."     \
  }
#define ACROSS(index, key, side, direction)                                                                            \
  {                                                                                                                    \
    .name = key, .type = LAM_KEY_NUMBER, .offset = AT(across[index]), .initial = "[]",                                 \
    .doc = "Derivatives by " direction " (from 0 to 1) along " side                                                    \
           ", as x, y, z of one control vector per point; none: mixed from the slopes of the sides that end there."    \
  }

static const lam_key keys[] = {
    SIDE(0, "v0", "[0, 0, 0,  2, 0, 1.5,  4, 0, 1.5,  6, 0, 0]",
         "x, y, z of the control points of the side v=0, along u: a Bezier curve, or a B-spline when degree is given."),
    SIDE(2, "v1", "[0, 6, 1,  3, 7, 3,  6, 6, 1]", "The opposite side, v=1, along u; its number of points may differ."),
    SIDE(1, "u0", "[0, 0, 0,  0, 3, 2,  0, 6, 1]", "The side u=0, along v: from the start of v0 to the start of v1."),
    SIDE(3, "u1", "[6, 0, 0,  7, 2, 0,  7, 4, 1,  6, 6, 1]",
         "The side u=1, along v: from the end of v0 to the end of v1."),
    {.name = "blend",
     .type = LAM_KEY_CHOICE,
     .offset = AT(blend),
     .count = 1,
     .initial = "bilinear",
     .choices = blends,
     .doc = "bilinear: linear from side to side; hermite: cubic, with given derivatives across the sides."},
    ACROSS(0, "across_v0", "v0", "v"),
    ACROSS(2, "across_v1", "v1", "v"),
    ACROSS(1, "across_u0", "u0", "u"),
    ACROSS(3, "across_u1", "u1", "u"),
    {.name = "degree",
     .type = LAM_KEY_INTEGER,
     .offset = AT(degree),
     .count = 2,
     .initial = "[0, 0]",
     .min = 0,
     .max = LAM_BASIS_MAX_DEGREE,
     .doc = "Degree of the sides along u and of those along v; 0: Bezier curves, of as many degrees as they need."},
    KNOTS(0, "knots_v0", "v0"),
    KNOTS(2, "knots_v1", "v1"),
    KNOTS(1, "knots_u0", "u0"),
    KNOTS(3, "knots_u1", "u1"),
    {.name = "unit",
     .type = LAM_KEY_CHOICE,
     .offset = AT(unit),
     .count = 1,
     .initial = "m",
     .choices = lam_point_units,
     .doc = "Unit of the numbers in points and vectors."},
    {0}};

const lam_surface_kind lam_surface_coons = {
    .head = {.name = "coons",
             .title = "Coons patch",
             .doc = "The surface between four curves that meet in corners, as one spline surface: degrees and knots of "
                    "opposite sides are made equal first, so it meets the curves exactly. Bilinear blending needs only "
                    "the curves; it repeats every dent of a side across the whole surface, weaker and weaker. Hermite "
                    "blending meets prescribed derivatives across the sides too, for patches that continue each other "
                    "smoothly. The two sides at a corner then each say how the surface twists there; where they "
                    "disagree (twist_gap in the report) the mean is taken and the derivatives are only nearly met.",
             .equation = "x = (1-v) v0(u) + v v1(u) + (1-u) u0(v) + u u1(v) - the bilinear patch of the corners",
             .source = "Coons, Surfaces for computer-aided design of space forms, 1967",
             .keys = keys,
             .params_size = sizeof(coons_keys)},
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
