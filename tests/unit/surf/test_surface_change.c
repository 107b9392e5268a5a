/* Spline surfaces: changes with bounds, products, images, parameter lines; nearest points; joins.
 */
#include "surf/spline/closest_on_surface.h"
#include "surf/spline/surface_join.h"
#include "tests/unit/spline_surface_fixture.h"

enum { SURFACES = 12 };
static const double domain[] = {1, 4}; /* of next_knots */

static lam_spline_surface next_surface(int degree_u, int degree_v, int more, bool rational) {
  lam_spline_surface s = {.degree = {degree_u, degree_v},
                          .count = {degree_u + 1 + more, degree_v + 2 + more}};
  int total = s.count[0] * s.count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, total);
  double *weights = LAM_NEW(arena, double, total);
  for (int i = 0; i < total; i++) {
    points[i] = next_point();
    weights[i] = next_in(0.5, 3);
  }
  for (int d = 0; d < 2; d++) s.knots[d] = next_knots(s.degree[d], s.count[d], true);
  s.points = points;
  s.weights = rational ? weights : NULL;
  return s;
}

static lam_spline_surface example(int k) {
  return next_surface(1 + k % 4, 1 + k / 4, k % 3, k % 2);
}

/* The largest distance at 40 random places. */
static double distance(const lam_spline_surface *a, const lam_spline_surface *b) {
  double most = 0;
  for (int i = 0; i < 40; i++) {
    double u = next_in(1, 4), v = next_in(1, 4);
    most = fmax(most, lam_distance(at(a, u, v), at(b, u, v)));
  }
  return most;
}

/* What insertion put in goes again, a knot that matters stays, and no point moves farther than
 * allowed. */
static void test_removal(void **state) {
  (void)state;
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k), t = s;
    int d = k % 2;
    for (int i = 0; i < s.degree[d]; i++) t = lam_spline_surface_insert(arena, &t, d, 2.2);
    assert_int_equal(lam_spline_surface_remove(arena, &t, d, 2.2, 9, 1e-10), s.degree[d]);
    assert_int_equal(t.count[d], s.count[d]);
    same(&s, &t, domain, domain);
    assert_int_equal(lam_spline_surface_remove(arena, &t, d, 1, 1, 100), 0);
    if (s.count[1] <= s.degree[1] + 1) continue;
    double knot = s.knots[1][s.degree[1] + 1];
    assert_int_equal(lam_spline_surface_remove(arena, &t, 1, knot, 1, 1e-6), 0);
    for (double allowed = 0.01; allowed < 1e3; allowed *= 3) {
      t = s;
      if (lam_spline_surface_remove(arena, &t, 1, knot, 1, allowed) == 0) continue;
      double moved = distance(&s, &t);
      if (!(moved <= allowed && moved > 1e-6)) fail_msg("moved %g, allowed %g", moved, allowed);
      break;
    }
  }
}

/* Elevated surfaces come back; of others, no point moves farther than the bound, and the ends stay.
 */
static void test_reduction(void **state) {
  (void)state;
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k);
    int d = k % 2, degree[2] = {s.degree[0], s.degree[1]};
    degree[d]++;
    lam_spline_surface up = lam_spline_surface_elevate(arena, &s, degree);
    double bound;
    lam_spline_surface t = lam_spline_surface_reduce(arena, &up, d, 1, &bound);
    assert_int_equal(t.degree[d], s.degree[d]);
    assert_true(bound < 1e-9);
    near(distance(&s, &t), 0, 1e-10);
    if (s.degree[d] < 2) continue;
    t = lam_spline_surface_reduce(arena, &s, d, 1, &bound);
    double moved = distance(&s, &t);
    if (!(moved <= bound && bound < 100)) fail_msg("moved %g, bound %g", moved, bound);
    for (int end = 0; end < 2; end++)
      for (int i = 0; i < 5; i++) {
        double a = end ? 4 : 1, b = next_in(1, 4);
        near3(at(&t, d ? b : a, d ? a : b), at(&s, d ? b : a, d ? a : b), 1e-9);
      }
  }
}

static void test_product(void **state) {
  (void)state;
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k);
    lam_bspline f[2];
    for (int d = 0; d < 2; d++) {
      int degree = 1 + (k + d) % 3, count = degree + 1 + k % 2;
      double *values = LAM_NEW(arena, double, count);
      for (int i = 0; i < count; i++) values[i] = next_in(-1, 1);
      f[d] = (lam_bspline){degree, count, 1, next_knots(degree, count, true), values};
    }
    lam_spline_surface t = lam_spline_surface_scale(arena, f[0], f[1], &s);
    for (int d = 0; d < 2; d++) assert_int_equal(t.degree[d], s.degree[d] + f[d].degree);
    for (int i = 0; i < 30; i++) {
      double u = next_in(1, 4), v = next_in(1, 4), a, b;
      lam_bspline_eval(&f[0], u, 0, &a);
      lam_bspline_eval(&f[1], v, 0, &b);
      near3(at(&t, u, v), lam_scale(at(&s, u, v), a * b), exact);
    }
  }
}

static void test_images_domains_and_lines(void **state) {
  (void)state;
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k);
    lam_pose frame = {next_point(), {next_point(), next_point(), next_point()}};
    lam_spline_surface image = lam_spline_surface_map(arena, &s, frame);
    lam_spline_surface moved = lam_spline_surface_move_domain(arena, &s, k % 2, -1, 5);
    double t = next_in(1, 4);
    lam_spline_curve u = lam_spline_surface_line(arena, &s, 0, t),
                     v = lam_spline_surface_line(arena, &s, 1, t);
    lam_spline_curve shifted = lam_spline_curve_move_domain(arena, u, 0, 2);
    for (int i = 0; i < 30; i++) {
      double p = next_in(1, 4), q = next_in(1, 4), to = -1 + 2 * ((k % 2 ? q : p) - 1);
      lam_vec3 x = at(&s, p, q), y = lam_along(frame.origin, x.x, frame.axis[0]);
      near3(at(&image, p, q), lam_along(lam_along(y, x.y, frame.axis[1]), x.z, frame.axis[2]),
            exact);
      near3(at(&moved, k % 2 ? p : to, k % 2 ? to : q), x, exact);
      near3(point_at(&u, q), at(&s, t, q), exact);
      near3(point_at(&v, p), at(&s, p, t), exact);
      near3(point_at(&shifted, (q - 1) * 2 / 3), at(&s, t, q), exact);
    }
  }
}

/* ---- nearest points ---- */

/* Nearer than every point of a fine grid, and d . x_u = d . x_v = 0 inside. */
static void test_closest(void **state) {
  (void)state;
  int inside = 0;
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k);
    for (int j = 0; j < 4; j++) {
      lam_vec3 base =
          at(&s, next_in(1.2, 3.8), next_in(1.2, 3.8)); /* near the surface, then anywhere */
      lam_vec3 target = j < 3 ? lam_along(base, 0.1, next_point()) : lam_scale(next_point(), 1.5);
      lam_closest_on_surface c = lam_spline_surface_closest(arena, &s, target);
      near3(at(&s, c.u, c.v), c.point, 1e-13);
      near(lam_distance(c.point, target), c.distance, 0);
      double least = INFINITY;
      for (int i = 0; i <= 60 * 61; i++)
        least = fmin(least, lam_distance(at(&s, 1 + i / 61 * 0.05, 1 + i % 61 * 0.05), target));
      if (!(c.distance <= least + 1e-12))
        fail_msg("%g, but a grid point lies at %g", c.distance, least);
      bool edge = c.u == 1 || c.u == 4 || c.v == 1 || c.v == 4;
      for (int d = 0; d < 2; d++) /* at a knot of a surface of degree 1 there may be an edge */
        for (int i = 0; i < s.count[d]; i++)
          edge = edge || (s.degree[d] < 3 && fabs(s.knots[d][i] - (d ? c.v : c.u)) < 1e-6);
      if (edge) continue;
      inside++;
      lam_vec3 x[4];
      lam_spline_surface_derivatives(&s, c.u, c.v, 1, x);
      lam_vec3 away = lam_sub(x[0], target);
      near(lam_dot(away, x[1]), 0, 1e-7);
      near(lam_dot(away, x[2]), 0, 1e-7);
    }
  }
  assert_true(inside > 10);
}

/* A quarter of a cylinder of radius 2 about the y axis, from x = 2 up to z = 2, y from 0 to 3. */
static lam_spline_surface quarter_cylinder(void) {
  static const double arc[] = {0, 0, 0, 1, 1, 1}, line[] = {0, 0, 1, 1};
  static const double weights[] = {1, 1, 0.70710678118654752, 0.70710678118654752, 1, 1};
  static const lam_vec3 points[] = {{2, 0, 0}, {2, 3, 0}, {2, 0, 2},
                                    {2, 3, 2}, {0, 0, 2}, {0, 3, 2}};
  return (lam_spline_surface){NULL, {2, 1}, {3, 2}, {arc, line}, points, weights};
}

/* From outside, inside and beyond a corner; by hand. */
static void test_closest_on_a_cylinder(void **state) {
  (void)state;
  lam_spline_surface s = quarter_cylinder();
  lam_closest_on_surface c = lam_spline_surface_closest(arena, &s, lam_v3(3, 1, 4));
  near(c.distance, 3, 1e-14);
  near3(c.point, lam_v3(1.2, 1, 1.6), 1e-9);
  c = lam_spline_surface_closest(arena, &s, lam_v3(0.3, 2, 0.4));
  near(c.distance, 1.5, 1e-14);
  c = lam_spline_surface_closest(arena, &s, lam_v3(2, 5, -1));
  near(c.distance, sqrt(5), 1e-14);
  near3(c.point, lam_v3(2, 3, 0), 1e-14);
  c = lam_spline_surface_closest(arena, &s, lam_v3(0, 1.5, 0)); /* on the axis all are as near */
  near(c.distance, 2, 1e-14);
  c = lam_spline_surface_closest_from(&s, lam_v3(3, 1, 4), (lam_vec2){0.1, 0.9});
  near(c.distance, 3, 1e-14);
}

/* ---- joins ---- */

static lam_spline_surface plane(lam_vec3 corner, lam_vec3 u, lam_vec3 v) {
  static const double knots[] = {0, 0, 1, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 4);
  for (int i = 0; i < 4; i++) points[i] = lam_along(lam_along(corner, i / 2, u), i % 2, v);
  return (lam_spline_surface){NULL, {1, 1}, {2, 2}, {knots, knots}, points, NULL};
}

/* Planes at 30 degrees; a plane that goes on from a cylinder of radius 2, and one that folds back
 * into it; a gap. */
static void test_joins_by_hand(void **state) {
  (void)state;
  const double pi = acos(-1);
  lam_spline_surface flat = plane(lam_v3(0, 0, 0), lam_v3(1, 0, 0), lam_v3(0, 1, 0));
  lam_spline_surface tilted =
      plane(lam_v3(2, 0, 0), lam_v3(-3, 0, 0), lam_v3(0, -cos(pi / 6), sin(pi / 6)));
  lam_surface_join join = lam_surface_join_test(arena, &flat, &tilted, (int[]){0, 0}, 10, 1e-9);
  assert_string_equal(join.name, "G0");
  near(join.kink, pi / 6, 1e-12);
  near(join.curvature_gap, 0, 1e-12);
  near(join.gap, 0, 1e-12);
  lam_spline_surface round = quarter_cylinder(),
                     on = plane(lam_v3(0, 5, 2), lam_v3(-4, 0, 0), lam_v3(0, -9, 0));
  join = lam_surface_join_test(arena, &round, &on, (int[]){3, 1}, 10, 1e-9);
  assert_string_equal(join.name, "G1");
  assert_string_equal(join.fails, "the normal curvatures differ");
  near(join.curvature_gap, 0.5, 1e-12);
  near(join.kink, 0, 1e-7);
  lam_spline_surface back = plane(lam_v3(0, 0, 2), lam_v3(4, 0, 0), lam_v3(0, 3, 0));
  join = lam_surface_join_test(arena, &round, &back, (int[]){3, 1}, 10, 1e-9);
  assert_string_equal(join.name, "G0");
  near(join.kink, pi, 1e-7);
  lam_spline_surface off = plane(lam_v3(0, 0, 2), lam_v3(-4, 0, 0), lam_v3(0, 3, 0.3));
  join = lam_surface_join_test(arena, &round, &off, (int[]){3, 1}, 10, 1e-9);
  assert_string_equal(join.name, "none");
  near(join.parameter[0], 1, 1e-12); /* the gap opens towards y = 3 */
  near(join.gap, 0.3, 0.02);
}

/* The parts of a bicubic surface join G2, whatever the direction and parameters of one; a moved
 * second ring of points leaves G1, a moved first ring G0. */
static void test_joins_of_parts(void **state) {
  (void)state;
  static const char *const names[] = {"none", "G0", "G1", "G2"};
  for (int k = 0; k < 6; k++) {
    lam_spline_surface s = next_surface(3, 3, 0, k % 2);
    lam_spline_surface a = lam_spline_surface_part(arena, &s, 0, 1, 2.3),
                       b = lam_spline_surface_part(arena, &s, 0, 2.3, 4);
    b = lam_spline_surface_move_domain(arena, &b, 1, 0, 7);
    if (k % 3 == 1) b = lam_spline_surface_reverse(arena, &b, 1);
    for (int ring = 0; ring < 4; ring++) { /* 3 is too far from the side to matter */
      lam_vec3 *points = LAM_NEW(arena, lam_vec3, b.count[0] * b.count[1]);
      for (int i = 0; i < b.count[0] * b.count[1]; i++)
        points[i] =
            i / b.count[1] == ring ? lam_along(b.points[i], 0.1, next_point()) : b.points[i];
      lam_spline_surface t = b;
      t.points = points;
      lam_surface_join join = lam_surface_join_test(arena, &a, &t, (int[]){3, 1}, 20, 1e-6);
      if (join.geometric != ring - 1) fail_msg("%s, expected %s", join.name, names[ring]);
    }
    lam_spline_surface turned = lam_spline_surface_transpose(arena, &b);
    lam_surface_join join = lam_surface_join_test(arena, &a, &turned, (int[]){3, 0}, 20, 1e-6);
    assert_string_equal(join.name, "G2");
    assert_null(join.fails);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_removal),       TEST(test_reduction),
      TEST(test_product),       TEST(test_images_domains_and_lines),
      TEST(test_closest),       TEST(test_closest_on_a_cylinder),
      TEST(test_joins_by_hand), TEST(test_joins_of_parts),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
