/* A molding surface, one line in surfaces.c: a plane profile (a, b) carried along a plane
 * trajectory c in its normal planes,
 *   x = c(u) + a(v) n(u) + b(v) z,   n: horizontal, to the left of c.
 * With t = c'/|c'| = (cos f, sin f, 0):
 *   n' = -f' t,  x_u = (|c'| - a f') t,  x_v = a' n + b' z,  x_uv = -a' f' t.
 * F = M = 0, so the parameter lines are curvature lines; the profiles are geodesics.
 *   f' = (c' x c'') / |c'|^2,  f'' = (c' x c''') / |c'|^2 - 2 f' (c'.c'') / |c'|^2.
 * The surface is regular while a f' < |c'|: the profile must not reach the center of curvature
 * of the trajectory. Both curves are B-splines over [0, 1] with evenly spaced inner knots. */
#include "curve/bspline/basis.h"
#include "surf/surface_kind.h"

/* Samples of a curve per control point, to find where the surface is singular. */
enum { SAMPLES = 64, MAX_DEGREE = 9 };

/* The parameters of a row: lists of x, y and of distance, height. */
typedef struct lam_molding_keys {
  lam_list trajectory, profile;
  int degree[2], unit;
} lam_molding_keys;

/* A plane B-spline curve. */
typedef struct lam_plane_curve {
  int degree, count;
  const double *knots, *points;
} lam_plane_curve;

/* What evaluation needs. */
typedef struct lam_molding {
  lam_plane_curve trajectory, profile;
  bool closed[2];
} lam_molding;

/* Point and derivatives up to the third: d[k][0], d[k][1]. */
static void curve_eval(const lam_plane_curve *curve, double t, double d[4][2]) {
  double values[4 * (MAX_DEGREE + 1)];
  int span = lam_basis_span(curve->degree, curve->count, curve->knots, t),
      width = curve->degree + 1;
  lam_basis_eval(curve->degree, curve->knots, span, t, 3, values);

  for (int k = 0; k < 4; k++)
    for (int c = 0; c < 2; c++) {
      d[k][c] = 0;
      for (int j = 0; j < width; j++)
        d[k][c] += values[k * width + j] * curve->points[2 * (span - curve->degree + j) + c];
    }
}

/* The third component of the cross product. */
static double cross2(const double a[2], const double b[2]) { return a[0] * b[1] - a[1] * b[0]; }

/* The scalar product. */
static double dot2(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

/* turn is f', change is f''. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_molding *s = data;
  double c[4][2], p[4][2];
  curve_eval(&s->trajectory, u, c);
  curve_eval(&s->profile, v, p);

  double square = dot2(c[1], c[1]), speed = sqrt(square), turn = cross2(c[1], c[2]) / square;
  double change = (cross2(c[1], c[3]) - 2 * turn * dot2(c[1], c[2])) / square;
  lam_vec3 t = lam_v3(c[1][0] / speed, c[1][1] / speed, 0), n = lam_v3(-t.y, t.x, 0),
           z = lam_v3(0, 0, 1);

  double a = p[0][0];
  jet->x = lam_along(lam_along(lam_v3(c[0][0], c[0][1], 0), a, n), p[0][1], z);
  jet->u = lam_scale(t, speed - a * turn);
  jet->v = lam_along(lam_scale(n, p[1][0]), p[1][1], z);
  jet->uu = lam_along(lam_along(lam_v3(c[2][0], c[2][1], 0), -a * change, t), -a * turn * turn, n);
  jet->uv = lam_scale(t, -p[1][0] * turn);
  jet->vv = lam_along(lam_scale(n, p[2][0]), p[2][1], z);
}

/* The natural chart is the principal one. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  const lam_molding *s = data;
  bool known = chart == LAM_CHART_NATURAL || chart == LAM_CHART_PRINCIPAL;
  return known &&
         lam_domain_give((lam_domain){{0, 1}, {0, 1}, {s->closed[0], s->closed[1]}}, p, q, closed);
}

/* ---- making ---- */

/* A curve from a list of two numbers per point, in meters; false with a message at the key. */
static bool make_curve(lam_arena *arena, const lam_list *list, int degree, double unit,
                       const char *key, lam_location location, lam_errors *errors,
                       lam_plane_curve *curve) {
  const double *given = list->items;
  int count = list->count / 2;
  if (list->count % 2 != 0 || count < 2) {
    lam_error_add(errors, location, key,
                  "%d numbers given; expected two for each of at least 2 points", list->count);
    return false;
  }

  double *points = LAM_NEW(arena, double, 2 * count);
  for (int i = 0; i < 2 * count; i++) points[i] = given[i] * unit;
  for (int i = 1; i < count; i++)
    if (points[2 * i] == points[2 * i - 2] && points[2 * i + 1] == points[2 * i - 1]) {
      lam_error_add(errors, location, key, "points %d and %d are the same", i, i + 1);
      return false;
    }

  *curve = (lam_plane_curve){
      .degree = degree < count ? degree : count - 1, .count = count, .points = points};
  double *knots = LAM_NEW(arena, double, count + curve->degree + 1);
  lam_knots_clamped(curve->degree, count, knots);
  curve->knots = knots;
  return true;
}

/* Whether a curve ends where, and (with tangent) in the direction in which it begins. */
static bool closes_up(const lam_plane_curve *curve, bool tangent) {
  double d[2][4][2], gap[2], size = 0;
  for (int end = 0; end < 2; end++) curve_eval(curve, end, d[end]);
  for (int i = 1; i < curve->count; i++)
    size += hypot(curve->points[2 * i] - curve->points[2 * i - 2],
                  curve->points[2 * i + 1] - curve->points[2 * i - 1]);

  for (int c = 0; c < 2; c++) gap[c] = d[1][0][c] - d[0][0][c];
  double speeds = sqrt(dot2(d[0][1], d[0][1]) * dot2(d[1][1], d[1][1]));
  return hypot(gap[0], gap[1]) <= 1e-13 * size &&
         (!tangent ||
          (fabs(cross2(d[0][1], d[1][1])) <= 1e-13 * speeds && dot2(d[0][1], d[1][1]) > 0));
}

/* The range of the profile's distances a from the trajectory; false with a message when the
 * profile stands still. */
static bool profile_range(const lam_molding *s, double range[2], lam_location location,
                          lam_errors *errors) {
  double d[4][2];
  int steps = SAMPLES * s->profile.count;
  range[0] = INFINITY;
  range[1] = -INFINITY;

  for (int k = 0; k <= steps; k++) {
    curve_eval(&s->profile, (double)k / steps, d);
    range[0] = fmin(range[0], d[0][0]);
    range[1] = fmax(range[1], d[0][0]);
    if (dot2(d[1], d[1]) > 0) continue;
    lam_error_add(errors, location, "profile",
                  "the curve stands still at %g of its way; move the points there",
                  (double)k / steps);
    return false;
  }
  return true;
}

/* 1 - a f' / |c'| must stay positive, for the a in the range of the profile that makes it least. */
static void check_regular(const lam_molding *s, double unit, lam_location location,
                          lam_errors *errors) {
  double d[4][2], range[2];
  if (!profile_range(s, range, location, errors)) return;

  int steps = SAMPLES * s->trajectory.count;
  for (int k = 0; k <= steps; k++) {
    curve_eval(&s->trajectory, (double)k / steps, d);
    double square = dot2(d[1], d[1]), bend = cross2(d[1], d[2]) / (square * sqrt(square)),
           a = bend > 0 ? range[1] : range[0];
    if (square > 0 && 1 - a * bend > 1e-6) continue;

    lam_error_add(errors, location, "profile",
                  "reaches %g to the %s of the trajectory, whose radius at %g of its way is %g; "
                  "expected a smaller distance, or a trajectory that bends less",
                  fabs(a) / unit, bend > 0 ? "left" : "right", (double)k / steps,
                  square > 0 ? fabs(1 / bend) / unit : 0);
    return;
  }
}

/* Both curves, whether they close, and whether the surface is regular. A closed profile may
 * have a corner where it closes. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_molding_keys *keys = params;
  lam_molding *s = LAM_NEW(arena, lam_molding, 1);
  double unit = lam_point_unit(keys->unit);
  if (!make_curve(arena, &keys->trajectory, keys->degree[0], unit, "trajectory", location, errors,
                  &s->trajectory) ||
      !make_curve(arena, &keys->profile, keys->degree[1], unit, "profile", location, errors,
                  &s->profile))
    return NULL;

  s->closed[0] = closes_up(&s->trajectory, true);
  s->closed[1] = closes_up(&s->profile, false);
  check_regular(s, unit, location, errors);
  return s;
}

static const lam_key keys[] = {
    LAM_NUMBER_KEY(lam_molding_keys, "trajectory", trajectory, "[0, 0,  6, 0,  6, 6,  12, 6]", 0, 0,
                   "x and y of every control point of the curve on the ground along which the "
                   "profile travels."),
    LAM_NUMBER_KEY(
        lam_molding_keys, "profile", profile, "[-2, 0,  -2, 3,  2, 3,  2, 0]", 0, 0,
        "For every control point of the profile its distance from the trajectory, positive to the "
        "left, and its height; from right to left when the normal shall point up."),
    LAM_INTEGER_KEY(lam_molding_keys, "degree", degree, "[3, 3]", 2, MAX_DEGREE,
                    "Degrees of trajectory and profile; with one point more than the degree a "
                    "curve is a Bezier curve, with fewer its degree is lower."),
    LAM_CHOICE_KEY(lam_molding_keys, "unit", unit, "m", lam_point_units,
                   "Unit of the numbers in trajectory and profile."),
    {0}};

const lam_surface_kind lam_surface_molding = {
    .head = {.name = "molding",
             .title = "Molding surface",
             .doc = "A profile that travels along a curve on the ground, always square to it: "
                    "vaults over a curved street, stadium stands, cornices. Profiles and the paths "
                    "of their points are the curvature lines, the profiles are congruent and "
                    "geodesics: panels between them are nearly flat from the start, and one rib "
                    "serves all. A straight trajectory gives a cylinder, a circular one a surface "
                    "of revolution. Where the profile reaches the center of curvature of the "
                    "trajectory the surface would fold.",
             .equation = "x = c(u) + a(v) n(u) + b(v) z, n normal to c, (a, b) the profile",
             .source = "thesis 3.5.4, definition 27",
             .keys = keys,
             .params_size = sizeof(lam_molding_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = lam_locate_natural};
