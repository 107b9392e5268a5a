/* The surface kind "coons": a patch between four curves. Registered in surfaces.c; the
 * mathematics is in surf/spline/coons_patch.c. */
#include "core/stage.h"
#include "curve/bspline/basis.h"
#include "curve/curve.h"
#include "surf/spline/coons_patch.h"
#include "surf/spline/sides_keys.h"
#include "surf/spline/spline_surface.h"

/* Samples of every side for the report. */
enum { SAMPLES = 200 };

/* The parameters of a row. */
typedef struct coons_keys {
  lam_sides_keys sides;
  int blend;
} coons_keys;

/* The patch, and the sides to measure it against. */
typedef struct coons_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_sides sides;
  lam_coons_blend blend;
} coons_data;

/* In the order of lam_coons_blend. */
static const char *const blends[] = {"bilinear", "hermite", NULL};

/* Derivatives across the sides are for a Hermite blend only. */
static bool check_across(lam_arena *arena, const coons_keys *keys, lam_location location,
                         lam_errors *errors) {
  const lam_side_keys *curves = keys->sides.curves.items;
  for (int i = 0; !keys->sides.file && i < keys->sides.curves.count; i++)
    if (curves[i].across.count && keys->blend != LAM_COONS_HERMITE) {
      lam_error_add(errors, location, lam_arena_printf(arena, "curves[%d].across", i),
                    "given with a bilinear blend; expected blend: hermite");
      return false;
    }
  return true;
}

/* The boundary among the parameters. */
static lam_sides_keys *sides_of(void *params) { return &((coons_keys *)params)->sides; }

/* The degree is known before the patch is made: weights may raise it beyond what can be
 * evaluated. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const coons_keys *keys = params;
  coons_data *data = LAM_NEW(arena, coons_data, 1);
  data->blend = (lam_coons_blend)keys->blend;
  if (!check_across(arena, keys, location, errors) ||
      !lam_sides_read(arena, &keys->sides, (lam_sides_limits){.degree = LAM_BASIS_MAX_DEGREE},
                      location, errors, &data->sides))
    return NULL;

  for (int d = 0; d < 2; d++) {
    int degree = lam_coons_degree(arena, &data->sides, data->blend, d);
    if (degree <= LAM_BASIS_MAX_DEGREE) continue;
    lam_error_add(errors, location, "curves",
                  "their weights make a patch of degree %d in %c; expected at most %d: fewer "
                  "degrees, or equal weights on opposite curves",
                  degree, d ? 'v' : 'u', LAM_BASIS_MAX_DEGREE);
    return NULL;
  }

  lam_spline_surface surface = lam_coons_surface(arena, &data->sides, data->blend);
  data->nurbs = lam_nurbs_make(arena, &surface);
  return data;
}

/* How far the patch is from its sides, and how well derivatives fit together at the corners. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const coons_data *d = data;
  double most = 0, mean = 0;
  for (int i = 0; i < LAM_SIDES; i++)
    for (int k = 0; k <= SAMPLES; k++) {
      double t = (double)k / SAMPLES;
      lam_vec3 x;
      lam_jet jet;
      lam_spline_curve_eval(&d->sides.side[i], t, 0, &x);
      lam_held_nurbs_eval(data, i % 2 ? i / 2 : t, i % 2 ? t : i / 2, &jet);
      most = fmax(most, lam_distance(x, jet.x));
      mean += lam_distance(x, jet.x) / (LAM_SIDES * (SAMPLES + 1));
    }

  stage->iterations = -1;
  lam_stage_measure(arena, stage, "side_distance", "m", most, mean, LAM_SIDES * (SAMPLES + 1));

  if (d->blend != LAM_COONS_HERMITE) return;
  lam_coons_gaps gaps = lam_coons_check(arena, &d->sides);
  lam_stage_measure(arena, stage, "slope_gap", "m", gaps.slope, NAN, 8);
  lam_stage_measure(arena, stage, "twist_gap", "m", gaps.twist, NAN, 4);
}

static const lam_key keys[] = {
    LAM_SIDES_KEYS(coons_keys, sides, lam_side_across_table,
                   "[{points: [0, 0, 0,  2, 0, 1.5,  4, 0, 1.5,  6, 0, 0]},"
                   " {points: [0, 0, 0,  0, 3, 2,  0, 6, 1]},"
                   " {points: [0, 6, 1,  3, 7, 3,  6, 6, 1]},"
                   " {points: [6, 0, 0,  7, 2, 0,  7, 4, 1,  6, 6, 1]}]"),
    LAM_CHOICE_KEY(coons_keys, "blend", blend, "bilinear", blends,
                   "bilinear: linear from side to side; hermite: cubic, with given derivatives "
                   "across the sides."),
    {0}};

const lam_surface_kind lam_surface_coons = {
    .head = {.name = "coons",
             .title = "Coons patch",
             .doc = "The surface between four curves that meet in corners, as one spline surface: "
                    "degrees and knots of opposite sides are made equal first, so it meets the "
                    "curves exactly, arcs and other curves with weights too. Bilinear blending "
                    "needs only the curves; it repeats every dent of a side across the whole "
                    "surface, weaker and weaker. Hermite blending meets prescribed derivatives "
                    "across the sides too, for patches that continue each other smoothly. The two "
                    "sides at a corner then each say how the surface twists there; where they "
                    "disagree (twist_gap in the report) the mean is taken and the derivatives are "
                    "only nearly met.",
             .equation = "x = (1-v) v0(u) + v v1(u) + (1-u) u0(v) + u u1(v) - the bilinear patch "
                         "of the corners",
             .source = "Coons, Surfaces for computer-aided design of space forms, 1967",
             .keys = keys,
             .params_size = sizeof(coons_keys)},
    .sides = sides_of,
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
