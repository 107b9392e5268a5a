/* How smoothly two spline surfaces join along a side, by comparing them at samples of the
 * first. Part of the surface kernel; called by the unit tests. */
#include "surf/spline/surface_join.h"
#include "curve/closest_on_curve.h"
#include "surf/spline/spline_edit.h"
#include "surf/surface.h"

/* The parameter that is fixed along a side: 0: u, 1: v. */
static int fixed_direction(int side) { return side % 2 ? 0 : 1; }

/* The value of that parameter. */
static double fixed_value(const lam_spline_surface *s, int side) {
  int d = fixed_direction(side);
  return s->knots[d][side < 2 ? s->degree[d] : s->count[d]];
}

/* Jet and curvatures at parameter t of a side. */
static lam_curvature curvature_at(const lam_spline_surface *s, int side, double t, lam_jet *jet) {
  double value = fixed_value(s, side);
  *jet = lam_spline_surface_jet(s, side % 2 ? value : t, side % 2 ? t : value);
  return lam_jet_curvature(jet);
}

/* Normal curvatures as a matrix over two unit vectors a, b of the tangent plane: k(a,a),
 * k(a,b), k(b,b). With a = p x_u + q x_v, k(a,a) = L p^2 + 2 M p q + N q^2. */
static void shape_matrix(const lam_curvature *c, const lam_jet *jet, lam_vec3 a, lam_vec3 b,
                         double sign, double k[3]) {
  double det = c->E * c->G - c->F * c->F, p[2][2];
  const lam_vec3 *axes[] = {&a, &b};
  for (int i = 0; i < 2; i++) {
    double au = lam_dot(*axes[i], jet->u), av = lam_dot(*axes[i], jet->v);
    p[i][0] = (c->G * au - c->F * av) / det;
    p[i][1] = (c->E * av - c->F * au) / det;
  }

  for (int m = 0; m < 3; m++) { /* aa, ab, bb */
    const double *x = p[m == 2], *y = p[m > 0];
    k[m] = sign * (c->L * x[0] * y[0] + c->M * (x[0] * y[1] + x[1] * y[0]) + c->N * x[1] * y[1]);
  }
}

/* The direction into the surface, at right angles to the side. */
static lam_vec3 inward(int side, const lam_jet *jet) {
  lam_vec3 along = lam_unit(side % 2 ? jet->v : jet->u), in = side % 2 ? jet->u : jet->v;
  in = lam_scale(in, side < 2 ? 1 : -1);
  return lam_along(in, -lam_dot(in, along), along);
}

/* The largest eigenvalue of a symmetric matrix aa, ab, bb, without sign. */
static double norm(const double k[3]) {
  return fabs(k[0] + k[2]) / 2 + hypot((k[0] - k[2]) / 2, k[1]);
}

/* The largest value, and the parameter t where it was found; NaN, once found, stays. */
static void keep_largest(double value, double t, double *most, double *parameter) {
  if (!isnan(*most) && !(value <= *most)) {
    *most = value;
    *parameter = t;
  }
}

/* The parameter line that a side is. */
static lam_spline_curve side_curve(lam_arena *arena, const lam_spline_surface *s, int side) {
  return lam_spline_surface_line(arena, s, fixed_direction(side), fixed_value(s, side));
}

/* Compares the surfaces at parameter t of the first side with the nearest point of the second,
 * whose curve is `other`. The worst values so far are kept in join; returns the larger of the
 * largest normal curvatures of the two, 1/m. */
static double compare_at(lam_arena *arena, const lam_spline_surface *first,
                         const lam_spline_surface *second, const int sides[2],
                         const lam_spline_curve *other, double t, lam_surface_join *join) {
  lam_jet a, b;
  lam_curvature p = curvature_at(first, sides[0], t, &a);
  lam_closest near = lam_spline_curve_closest(arena, other, a.x);
  lam_curvature q = curvature_at(second, sides[1], near.t, &b);

  /* One surface goes on where the other ends: the directions inward are opposite. */
  double turn = lam_dot(p.normal, q.normal) < 0 ? -1 : 1, k[2][3], difference[3];
  double kink = isnan(p.K) || isnan(q.K)
                    ? NAN
                    : lam_angle(inward(sides[0], &a), lam_scale(inward(sides[1], &b), -1));

  /* Normal curvatures of both in the same two directions, for normals on the same side. */
  lam_vec3 along = lam_unit(sides[0] % 2 ? a.v : a.u), across = lam_cross(p.normal, along);
  shape_matrix(&p, &a, along, across, 1, k[0]);
  shape_matrix(&q, &b, along, across, turn, k[1]);
  for (int m = 0; m < 3; m++) difference[m] = k[1][m] - k[0][m];

  keep_largest(near.distance, t, &join->gap, &join->parameter[0]);
  keep_largest(kink, t, &join->kink, &join->parameter[1]);
  keep_largest(norm(difference), t, &join->curvature_gap, &join->parameter[2]);
  return fmax(norm(k[0]), norm(k[1]));
}

/* Names the order that holds and the first condition that fails. size: of the first side, m; bend:
 * the largest normal curvature, 1/m. */
static void judge(lam_surface_join *join, double tolerance, double size, double bend) {
  static const char *const names[] = {"none", "G0", "G1", "G2"};
  static const char *const conditions[] = {"the sides differ", "the tangent planes differ",
                                           "the normal curvatures differ"};
  bool holds[] = {join->gap <= tolerance * size, join->kink <= tolerance,
                  join->curvature_gap <= tolerance * fmax(bend, 1 / size)};
  int n = 0;
  while (n < 3 && holds[n]) n++;

  join->geometric = n - 1;
  join->name = names[n];
  join->fails = n < 3 ? conditions[n] : NULL;
}

/* All samples are compared; the size of the first side is the farthest control point from its
 * start. */
lam_surface_join lam_surface_join_test(lam_arena *arena, const lam_spline_surface *first,
                                       const lam_spline_surface *second, const int sides[2],
                                       int samples, double tolerance) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_surface_join join = {.gap = -1, .kink = -1, .curvature_gap = -1};
  lam_spline_curve line = side_curve(arena, first, sides[0]);
  lam_spline_curve other = side_curve(arena, second, sides[1]);

  double size = 0, bend = 0;
  for (int i = 0; i < line.count; i++)
    size = fmax(size, lam_distance(line.points[i], line.points[0]));

  for (int i = 0; i <= samples; i++) {
    double low = line.knots[line.degree], high = line.knots[line.count],
           t = low + (high - low) * i / samples;
    bend = fmax(bend, compare_at(arena, first, second, sides, &other, t, &join));
  }
  lam_arena_release(arena, mark);

  judge(&join, tolerance, size, bend);
  return join;
}
