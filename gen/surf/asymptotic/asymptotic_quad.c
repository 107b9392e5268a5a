/* The kind of surface `asymptotic-quad`: its keys, the way from corner data to the finished
 * patch, and the report. Listed in surf/kinds/surfaces.c; the mathematics is in the other files
 * of this folder, with make_quad.c on top. */
#include "surf/asymptotic/asymptotic_quad.h"
#include "surf/spline/spline_surface.h"
#include "surf/surface_kind.h"

typedef struct lam_quad_keys {
  int form, unit;
  lam_list sides, curvatures;
  double corners[12], tangents[24], weights[4], knots[4];
  bool slopes;
} lam_quad_keys;

/* A finished surface. */
typedef struct lam_quad_data {
  const lam_nurbs *nurbs; /* first: see lam_held_nurbs_eval */
  lam_asymptotic_patch patch;
  bool straight[4];
} lam_quad_data;

/* Vector `number` of a list of coordinates, in meters. */
static lam_vec3 vector(const double *list, int number, double unit) {
  return lam_scale(lam_v3(list[3 * number], list[3 * number + 1], list[3 * number + 2]), unit);
}

/* Whether lists of numbers per curve have all of them or none; otherwise false with messages. */
static bool check_lists(const lam_quad_keys *keys, lam_location location, lam_errors *errors) {
  int before = errors->count;
  if (keys->sides.count != 0 && keys->sides.count != 4)
    lam_error_add(errors, location, "sides", "%d sides given; expected 4, or none",
                  keys->sides.count);

  if (keys->curvatures.count != 0 && keys->curvatures.count != 8)
    lam_error_add(errors, location, "curvatures",
                  "%d curvatures given; expected 8, two for each curve, or none",
                  keys->curvatures.count);
  return errors->count == before;
}

/* The corner data of the keys, in meters and 1/m; what is missing stays 0. */
static lam_quad_corners read_corners(const lam_quad_keys *keys, lam_quad_missing missing) {
  double unit = lam_point_unit(keys->unit);
  lam_quad_corners q = {
      .weight = {keys->weights[0], keys->weights[1], keys->weights[2], keys->weights[3]}};

  for (int i = 0; i < 4; i++) {
    q.corner[i] = vector(keys->corners, i, unit);
    q.knots[i / 2][i % 2] = keys->knots[i];
    for (int e = 0; e < 2; e++) {
      q.tangent[i][e] = vector(keys->tangents, 2 * i + e, unit);
      if (!missing.sides) q.side[i][e] = ((const int *)keys->sides.items)[i];
      if (!missing.curvatures)
        q.curvature[i][e] = ((const double *)keys->curvatures.items)[2 * i + e] / unit;
    }
  }
  return q;
}

/* The finished patch from its keys, or NULL with messages. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_quad_keys *keys = params;
  if (!check_lists(keys, location, errors)) return NULL;
  lam_quad_missing missing = {keys->sides.count == 0, keys->curvatures.count == 0, keys->slopes};
  lam_quad_corners q = read_corners(keys, missing);

  lam_quad_data *data = LAM_NEW(arena, lam_quad_data, 1);
  lam_quad_form form = (lam_quad_form)keys->form;
  if (!lam_quad_corners_complete(arena, &q, form, missing, location, errors)) return NULL;
  if (!lam_asymptotic_patch_make(arena, &q, form, location, errors, &data->patch)) return NULL;

  for (int i = 0; i < 4; i++) data->straight[i] = q.side[i][0] == 0;
  data->nurbs = lam_nurbs_make(arena, &data->patch.surface);
  return data;
}

/* Points along each boundary curve at which the report measures. */
enum { SAMPLES = 200 };

/* Adds the greatest deviations along the boundary and the energy, measured anew on the surface. */
static void report(lam_arena *arena, const void *data, lam_stage *stage) {
  const lam_quad_data *d = data;
  double ratio, sine;
  lam_asymptotic_residuals(arena, &d->patch.surface, d->straight, SAMPLES, &ratio, &sine);
  stage->iterations = -1;
  stage->measure_count = 3;
  stage->measures = LAM_NEW(arena, lam_measure, 3);
  double energy = lam_thin_plate_energy(arena, &d->patch.surface, 20);
  stage->measures[0] = (lam_measure){"normal_curvature_ratio", "", NAN, ratio, NAN, 4 * SAMPLES};
  stage->measures[1] = (lam_measure){"normal_binormal_sine", "", NAN, sine, NAN, 4 * SAMPLES};
  stage->measures[2] = (lam_measure){"thin_plate_energy", "m^2", energy, energy, energy, 1};
}

static const lam_key keys[] = {
    LAM_CHOICE_KEY(
        lam_quad_keys, "form", form, "bi-7", lam_quad_form_names,
        "bi-7: quintic boundary, calm surface; bi-11: the same boundary as in the thesis; bi-6, "
        "bi-8: quartic boundary, curvatures follow; bi-13: rational; c1: boundary of three pieces, "
        "smooth; b-spline: cubic boundary of three pieces, with slight creases."),
    LAM_NUMBER_KEY(lam_quad_keys, "corners", corners,
                   "[0, 0, 0,  4, 0.2, 1.2,  -0.3, 3.2, 1,  4.1, 3.6, -0.2]", 0, 0,
                   "x, y, z of the corners at (u,v) = (0,0), (1,0), (0,1), (1,1)."),
    LAM_NUMBER_KEY(
        lam_quad_keys, "tangents", tangents,
        "[4.025, -0.88, 1.135,  3.965, 1.45, 0.94,  -0.98, 3.125, 0.93,  0.535, 3.25, 0.87, 4.22, "
        "1.765, -0.995,  4.33, -0.525, -1.05,  1.015, 3.4, -1.24,  -0.63, 3.29, -1.315]",
        0, 0,
        "Derivatives of the boundary curves v=0, u=0, v=1, u=1 at their start and end: x, y, z of "
        "eight vectors. About as long as the side; longer ones make the curves start straighter."),
    LAM_INTEGER_KEY(lam_quad_keys, "sides", sides, "[]", -1, 1,
                    "For each of the four curves 1 when it bends into the patch, -1 away from it, "
                    "0 when it is straight; none: as the tangents turn."),
    LAM_NUMBER_KEY(lam_quad_keys, "curvatures", curvatures, "[]", 0, 1e9,
                   "Curvature of the four curves at start and end, one over the unit of the "
                   "corners; none: those of least bending energy."),
    LAM_FLAG_KEY(lam_quad_keys, "slopes", slopes, "no",
                 "Whether the vertical parts of the tangents are chosen for the calmest surface, "
                 "which takes some seconds; the given ones are ignored then."),
    LAM_NUMBER_KEY(lam_quad_keys, "weights", weights, "[1, 1, 1, 1]", 0, 0,
                   "Weights of the corners, for bi-13."),
    LAM_NUMBER_KEY(lam_quad_keys, "knots", knots, "[0.35, 0.65, 0.35, 0.65]", 0, 0,
                   "Inner knots of the curves along u and of those along v, for b-spline and c1."),
    LAM_CHOICE_KEY(lam_quad_keys, "unit", unit, "m", lam_point_units,
                   "Unit of corners and tangents."),
    {0}};

const lam_surface_kind lam_surface_asymptotic_quad = {
    .head = {.name = "asymptotic-quad",
             .title = "Patch with asymptotic boundary",
             .doc = "A smooth patch over four curves that are asymptotic curves of it: along its "
                    "edges it does not curve normal to itself, so that straight boards standing "
                    "upright on the surface can be bent along the edge, and neighboring patches "
                    "over the same curves meet smoothly. The curves are given by corners, tangents "
                    "and curvatures and completed by the one of least energy. At every corner the "
                    "torsions of its two curves must be opposite, and no curve may change the side "
                    "it bends to: corner data that cannot do so are refused. Inside, the surface "
                    "is as calm as thin sheet metal.",
             .equation =
                 "N = +- b along x(u,0), x(0,v), x(u,1), x(1,v);  tau_p + tau_q = 0 at the corners",
             .source = "thesis chapter 2; Wang, Zhu & Li, J. Comput. Math. 37(5), 2019",
             .keys = keys,
             .params_size = sizeof(lam_quad_keys)},
    .prepare = prepare,
    .eval = lam_held_nurbs_eval,
    .domain = lam_held_nurbs_domain,
    .spline = lam_held_nurbs_spline,
    .report = report};
