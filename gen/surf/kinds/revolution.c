/* A surface of revolution about the z axis, one line in surfaces.c: x = (r(v) cos u, r(v) sin
 * u, z(v)), where the profile (r, z) is a cubic spline through given points, parameterized by
 * chord length and run from v = 0 to v = 1. */
#include "core/numbers.h"
#include "curve/cubic_spline.h"
#include "surf/surface_kind.h"

/* Samples per piece, to find where a profile runs through the axis. */
enum { SAMPLES = 16 };

/* The parameters of a row: r and z of every point. */
typedef struct lam_revolution_keys {
  lam_list profile;
  int unit;
} lam_revolution_keys;

/* Adds a message when the curve reaches the axis between its ends. */
static void check_profile(const lam_spline *profile, lam_location location, lam_errors *errors) {
  for (int i = 0; i + 1 < profile->count; i++)
    for (int k = i == 0 ? 1 : 0; k < SAMPLES; k++) {
      double t = profile->t[i] + (profile->t[i + 1] - profile->t[i]) * k / SAMPLES, x[2], dx[2],
             ddx[2];

      lam_spline_eval(profile, t, x, dx, ddx);
      if (x[0] > 0) continue;
      lam_error_add(errors, location, "profile",
                    "the curve through the points reaches the axis between points %d and %d; "
                    "expected r > 0 (add points there, or move them)",
                    k ? i + 1 : i, i + 2);
      return;
    }
}

/* Parameters t of the profile's points, by chord length from 0 to 1; false with a message when
 * a point lies beyond the axis, or where the last one does. given: the numbers of the design. */
static bool chord_parameters(int count, const double *points, const double *given,
                             lam_location location, lam_errors *errors, double *t) {
  for (int i = 0; i < count; i++) {
    if (!(points[2 * i] >= 0)) {
      lam_error_add(errors, location, "profile",
                    "r of point %d is %g; expected a distance from the axis", i + 1, given[2 * i]);
      return false;
    }
    if (i == 0) continue;
    double chord = hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
    if (!(chord > 0)) {
      lam_error_add(errors, location, "profile", "points %d and %d are the same", i, i + 1);
      return false;
    }
    t[i] = t[i - 1] + chord;
  }

  for (int i = 0; i < count; i++) t[i] /= t[count - 1];
  return true;
}

/* The profile as a cubic spline, in meters. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_revolution_keys *keys = params;
  const double *given = keys->profile.items;
  int count = keys->profile.count / 2;
  if (keys->profile.count % 2 != 0 || count < 2) {
    lam_error_add(errors, location, "profile",
                  "%d numbers given; expected r and z of at least 2 points", keys->profile.count);
    return NULL;
  }

  double *t = LAM_NEW(arena, double, count), *points = LAM_NEW(arena, double, 2 * count);
  for (int i = 0; i < 2 * count; i++) points[i] = given[i] * lam_point_unit(keys->unit);
  if (!chord_parameters(count, points, given, location, errors, t)) return NULL;

  lam_spline *profile = LAM_NEW(arena, lam_spline, 1);
  *profile = lam_spline_make(arena, count, 2, t, points);
  check_profile(profile, location, errors);
  return profile;
}

/* The profile is a meridian. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  double x[2], dx[2], ddx[2];
  lam_spline_eval(data, v, x, dx, ddx);
  lam_jet_revolve((lam_meridian){x[0], x[1], dx[0], dx[1], ddx[0], ddx[1]}, u, jet);
}

/* The natural chart is the principal one. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  bool known = chart == LAM_CHART_NATURAL || chart == LAM_CHART_PRINCIPAL;
  return known &&
         lam_domain_give((lam_domain){{0, 2 * LAM_PI}, {0, 1}, {true, false}}, p, q, closed);
}

static const lam_key keys[] = {LAM_NUMBER_KEY(lam_revolution_keys, "profile", profile,
                                              "[1.2, 0,  0.8, 1,  0.7, 2,  0.9, 3]", 0, 0,
                                              "r and z of every point of the profile, from bottom "
                                              "to top when the normal shall point outward."),
                               LAM_CHOICE_KEY(lam_revolution_keys, "unit", unit, "m",
                                              lam_point_units, "Unit of the numbers in profile."),
                               {0}};

const lam_surface_kind lam_surface_revolution = {
    .head = {.name = "revolution",
             .title = "Surface of revolution",
             .doc = "Any profile turned about the z axis: towers, domes, vases. The profile is a "
                    "smooth curve through the listed points, with continuous curvature. Rings and "
                    "meridians are the curvature lines, so panels between them can be flat, and "
                    "every ring of panels is made of copies. Points at very uneven distances make "
                    "the curve swing out between them; where it touches the axis the surface has a "
                    "pole.",
             .equation = "x = (r(v) cos u, r(v) sin u, z(v)), 0 <= v <= 1",
             .source = "de Boor, A Practical Guide to Splines, ch. IV",
             .keys = keys,
             .params_size = sizeof(lam_revolution_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = lam_locate_natural};
