/* Frames, lengths, parameters, forms of cubics and joins of curves, against known values. */
#include "core/numbers.h"
#include "curve/bspline/parameters.h"
#include "curve/closest_on_curve.h"
#include "curve/curve_join.h"
#include "curve/frenet.h"
#include "curve/hermite.h"
#include "curve/length.h"
#include "tests/unit/curve_fixture.h"

/* (3 cos t, 3 sin t, c t) with c = *data. */
static void helix(const void *data, double t, int order, lam_vec3 *x) {
  double pitch = *(const double *)data;
  for (int k = 0; k <= order; k++) {
    double turn = t + k * M_PI_2;
    x[k] = lam_v3(3 * cos(turn), 3 * sin(turn), k == 0 ? pitch * t : k == 1 ? pitch : 0);
  }
}

/* The helix (3 cos t, 3 sin t, 4 t) has curvature 3/25 = .12 and torsion 4/25 = .16; T = (0,3,4)/5
 * at t = 0. */
static void test_helix(void **state) {
  (void)state;
  lam_vec3 x[4];
  double pitch = 4;
  helix(&pitch, 0, 3, x);
  lam_frenet f = lam_frenet_frame(x + 1);
  near(f.curvature, 0.12, 1e-15);
  near(f.torsion, 0.16, 1e-15);
  near3(f.tangent, lam_v3(0, 0.6, 0.8), 1e-15);
  near3(f.normal, lam_v3(-1, 0, 0), 1e-15);
  near3(f.binormal, lam_v3(0, -0.8, 0.6), 1e-15);
  pitch = -4;
  helix(&pitch, 0.7, 3, x);
  near(lam_frenet_frame(x + 1).torsion, -0.16, 1e-15);
}

/* One turn of the helix with pitch 4 is 2 pi sqrt(9 + 16) = 10 pi long, and its speed is 5. */
static void test_helix_length(void **state) {
  (void)state;
  double pitch = 4;
  lam_curve curve = {helix, &pitch, 0, 2 * LAM_PI, 0, NULL};
  near(lam_curve_length(&curve, 0, 2 * LAM_PI, 1e-13), 10 * LAM_PI, 1e-12);
  near(lam_curve_length(&curve, 2, 1, 1e-13), -5, 1e-13);
  near(lam_curve_at_length(&curve, 1, 7.5, 1e-13), 2.5, 1e-12);
  near(lam_curve_at_length(&curve, 5, -7.5, 1e-13), 3.5, 1e-12);
  near(lam_curve_at_length(&curve, 1, 1000, 1e-13), 2 * LAM_PI, 0);
}

/* The twisted cubic (t, t^2, t^3): curvature 2 and torsion 3 at t = 0; sqrt 19 / (7 sqrt 14) and
 * 3/19 at t = 1. */
static void test_twisted_cubic(void **state) {
  (void)state;
  lam_vec3 powers[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, x[4];
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  lam_bernstein_from_powers(3, powers);
  lam_spline_curve cubic = {3, 4, knots, powers, NULL};
  lam_spline_curve_eval(&cubic, 0, 3, x);
  lam_frenet f = lam_frenet_frame(x + 1);
  near(f.curvature, 2, 1e-14);
  near(f.torsion, 3, 1e-14);
  lam_spline_curve_eval(&cubic, 1, 3, x);
  f = lam_frenet_frame(x + 1);
  near(f.curvature, sqrt(19) / (7 * sqrt(14)), 1e-14);
  near(f.curvature, 0.166423535003, 1e-12);
  near(f.torsion, 3.0 / 19, 1e-14);
}

/* The quarter circle ((1 - t^2), 2 t) / (1 + t^2) as a rational Bezier curve, weights 1, 1, 2: at t
 * = 1/2 the point
 * (.6, .8), curvature 1, speed 2 / (1 + t^2) = 1.6. The fourth derivative of x + i y = (1 + i t) /
 * (1 - i t) = -1 + 2 / (1 - i t) is 48 / (1 - i t)^5. */
static void test_rational_circle(void **state) {
  (void)state;
  const lam_vec3 points[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const double knots[] = {0, 0, 0, 1, 1, 1}, circle_weights[] = {1, 1, 2};
  lam_spline_curve circle = {2, 3, knots, points, circle_weights};
  lam_vec3 x[5];
  lam_spline_curve_eval(&circle, 0.5, 4, x);
  near3(x[0], lam_v3(0.6, 0.8, 0), 1e-15);
  lam_frenet f = lam_frenet_frame(x + 1);
  near(f.curvature, 1, 1e-14);
  near(f.speed, 1.6, 1e-14);
  near(f.torsion, 0, 1e-14);
  double size = 48 / pow(1.25, 2.5), turn = 5 * atan(0.5);
  near3(x[4], lam_v3(size * cos(turn), size * sin(turn), 0), 1e-12);
  lam_curve curve = lam_curve_of_spline(arena, &circle);
  near(lam_curve_length(&curve, 0, 1, 1e-13), M_PI_2, 1e-12);
}

/* A straight curve has no normal, and a standing point no curvature. */
static void test_degenerate_frames(void **state) {
  (void)state;
  const lam_vec3 line[] = {{1, 2, 3}, {2, 4, 6}, {0, 0, 0}}, still[3] = {{0, 0, 0}};
  lam_frenet f = lam_frenet_frame(line);
  near(f.curvature, 0, 1e-15);
  near(lam_length(f.normal), 0, 0);
  assert_true(isnan(f.torsion) && isnan(lam_frenet_frame(still).curvature));
}

/* The parabola through (0,1), (1,3), (3,2) is -5/6 x^2 + 17/6 x + 1; through two points the line; a
 * quintic comes back.
 */
static void test_polynomials(void **state) {
  (void)state;
  const double x[] = {0, 1, 3}, y[] = {1, 3, 2};
  double a[6];
  lam_polynomial_through(3, x, y, a);
  near(a[2], -5.0 / 6, 1e-15);
  near(a[1], 17.0 / 6, 1e-15);
  near(a[0], 1, 1e-15);
  lam_polynomial_through(2, x + 1, y + 1, a);
  near(a[0], 3.5, 1e-15);
  near(a[1], -0.5, 1e-15);
  const double wanted[] = {1, -2, 0.5, 3, -1, 0.25}, places[] = {-1, -0.4, 0.1, 0.7, 1.5, 2};
  double values[6];
  for (int i = 0; i < 6; i++) {
    values[i] = 0;
    for (int k = 5; k >= 0; k--) values[i] = values[i] * places[i] + wanted[k];
  }
  lam_polynomial_through(6, places, values, a);
  for (int k = 0; k < 6; k++) near(a[k], wanted[k], 1e-12);
}

/* (0,0), (3,4), (3,10), (15,15): distances 5, 6, 13. Modified chord: from the formula with
 * Euclidean distances, turns .6435 and 1.1760. */
static void test_parameters(void **state) {
  (void)state;
  const lam_vec3 points[] = {{0, 0, 0}, {3, 4, 0}, {3, 10, 0}, {15, 15, 0}};
  const double expected[][4] = {{0, 1.0 / 3, 2.0 / 3, 1},
                                {0, 5.0 / 24, 11.0 / 24, 1},
                                {0, 0.26969468, 0.56513040, 1},
                                {0, 0.17446346, 0.53731572, 1}};
  for (int kind = 0; kind < LAM_PARAMETERS_COUNT; kind++) {
    double t[4];
    lam_parameters_choose((lam_parameters)kind, 4, points, t);
    for (int i = 0; i < 4; i++) near(t[i], expected[kind][i], kind < 2 ? 1e-15 : 6e-9);
  }
}

/* Hermite's functions at 1/3 are 20/27, 7/27, 4/27, -2/27; the piece from (0,0) to (1,0) with
 * slopes (1,2), (1,-2) passes
 * (.5,.5) and (.25,.375). All three forms give the same points and convert back. */
static void test_cubic_forms(void **state) {
  (void)state;
  double f[4];
  lam_hermite_basis(1.0 / 3, f);
  const double expected[] = {20, 7, 4, -2};
  for (int i = 0; i < 4; i++) near(f[i], expected[i] / 27, 1e-15);
  lam_hermite piece = {{{0, 0, 0}, {1, 0, 0}}, {{1, 2, 0}, {1, -2, 0}}};
  near3(lam_hermite_eval(&piece, 0.5), lam_v3(0.5, 0.5, 0), 1e-15);
  near3(lam_hermite_eval(&piece, 0.25), lam_v3(0.25, 0.375, 0), 1e-15);
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  for (int k = 0; k < 20; k++) {
    lam_hermite h = {{next_point(), next_point()}, {next_point(), next_point()}};
    lam_vec3 a[4], b[4], c[4];
    lam_hermite_to_algebraic(&h, a);
    lam_hermite_to_bezier(&h, b);
    for (int i = 0; i < 4; i++) c[i] = a[i];
    lam_bernstein_from_powers(3, c);
    for (int i = 0; i < 4; i++) near3(c[i], b[i], 1e-14);
    lam_bernstein_to_powers(3, c);
    for (int i = 0; i < 4; i++) near3(c[i], a[i], 1e-13);
    double t = next_in(0, 1);
    lam_vec3 x = lam_hermite_eval(&h, t);
    lam_spline_curve bezier = {3, 4, knots, b, NULL};
    near3(point_at(&bezier, t), x, 1e-14);
    near3(lam_add(lam_add(a[0], lam_scale(a[1], t)),
                  lam_add(lam_scale(a[2], t * t), lam_scale(a[3], t * t * t))),
          x, 1e-14);
    lam_hermite from_a = lam_hermite_from_algebraic(a), from_b = lam_hermite_from_bezier(b);
    for (int i = 0; i < 2; i++) {
      near3(from_a.p[i], h.p[i], 1e-13);
      near3(from_a.d[i], h.d[i], 1e-13);
      near3(from_b.p[i], h.p[i], 1e-13);
      near3(from_b.d[i], h.d[i], 1e-13);
    }
  }
}

/* A line traveled with speed 1/3, then 2/3: G1 (being straight even G2) with alpha 2, but only C0.
 */
static void test_join_of_a_broken_line(void **state) {
  (void)state;
  const lam_vec3 end[] = {{1, 1, 0}, {1, 1, 0}, {0, 0, 0}},
                 start[] = {{1, 1, 0}, {2, 2, 0}, {0, 0, 0}};
  lam_join join = lam_join_test(end, start, 1, 1e-9);
  assert_true(join.geometric >= 1);
  assert_int_equal(join.parametric, 0);
  near(join.alpha, 2, 1e-15);
  near(join.beta, 0, 1e-15);
  near(join.derivative_gap[0], sqrt(2), 1e-15);
  assert_string_equal(join.name[0], "C0");
  assert_string_equal(join.fails[0], "the first derivatives differ");
}

/* Q' = 2 P', Q'' = 4 P'' + .7 P' is G2, not C1; Q' = P', Q'' = 2 P'' points the same way, is C1 and
 * G1, not G2. */
static void test_join_of_curves(void **state) {
  (void)state;
  const lam_vec3 p[] = {{1, 2, 3}, {1, 0.5, -0.2}, {0.3, -1, 0.8}};
  lam_vec3 q[] = {p[0], lam_scale(p[1], 2), lam_along(lam_scale(p[2], 4), 0.7, p[1])};
  lam_join join = lam_join_test(p, q, 1, 1e-9);
  assert_int_equal(join.geometric, 2);
  assert_int_equal(join.parametric, 0);
  near(join.alpha, 2, 1e-14);
  near(join.beta, 0.7, 1e-14);
  assert_string_equal(join.name[1], "G2");
  assert_null(join.fails[1]);
  const lam_vec3 scaled[] = {p[0], p[1], lam_scale(p[2], 2)};
  join = lam_join_test(p, scaled, 1, 1e-9);
  assert_int_equal(join.geometric, 1);
  assert_int_equal(join.parametric, 1);
  lam_vec3 x[4] = {p[0], p[1], p[2], {0, 0, 0}};
  near(join.curvature_gap, lam_frenet_frame(x + 1).curvature, 1e-14);
  assert_string_equal(join.fails[1], "the curvature vectors differ");
  join = lam_join_test(p, p, 1, 1e-9);
  assert_string_equal(join.name[0], "C2");
  const lam_vec3 back[] = {p[0], lam_scale(p[1], -1), p[2]};
  assert_int_equal(lam_join_test(p, back, 1, 1e-9).geometric, 0);
  const lam_vec3 apart[] = {{1, 2, 4}, p[1], p[2]};
  join = lam_join_test(p, apart, 1, 1e-9);
  assert_int_equal(join.geometric, -1);
  near(join.gap, 1, 1e-15);
  assert_string_equal(join.name[0], "none");
}

/* No point of a fine sampling is nearer, and inside the curve the way there is at right angles to
 * it. */
static void test_closest_points(void **state) {
  (void)state;
  for (int k = 0; k < 40; k++) {
    lam_spline_curve c = next_curve(1 + k % 5, 2 + k % 5 + k % 4, k % 2, k % 3 != 0);
    lam_vec3 target = lam_scale(next_point(), 1.5);
    lam_closest found = lam_spline_curve_closest(arena, &c, target);
    double nearest = INFINITY;
    for (int i = 0; i <= 3000; i++)
      nearest = fmin(nearest, lam_distance(point_at(&c, 1 + i / 1000.0), target));
    assert_true(found.distance <= nearest * (1 + 1e-12) && found.distance >= nearest - 1e-2);
    near3(point_at(&c, found.t), found.point, 1e-15);
    near(lam_distance(found.point, target), found.distance, 1e-15);
    lam_vec3 x[2], left[2];
    lam_spline_curve_eval(&c, found.t, 1, x);
    lam_spline_curve_eval(&c, nextafter(found.t, 0), 1, left);
    bool corner = lam_distance(x[1], left[1]) > 1e-9;
    if (found.t > 1 && found.t < 4 && !corner)
      near(lam_dot(lam_unit(lam_sub(target, x[0])), lam_unit(x[1])), 0, 1e-8);
  }
}

/* Known nearest points: of the quarter circle (1, 0) to (0, 1), in the direction of the point, at
 * an end beyond it, and anywhere for the center; on the curve itself. */
static void test_closest_on_a_circle(void **state) {
  (void)state;
  const lam_vec3 points[] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const double knots[] = {0, 0, 0, 1, 1, 1}, circle_weights[] = {1, 1, 2};
  lam_spline_curve circle = {2, 3, knots, points, circle_weights};
  lam_closest found = lam_spline_curve_closest(arena, &circle, lam_v3(3, 4, 0));
  near3(found.point, lam_v3(0.6, 0.8, 0), 1e-12);
  near(found.distance, 4, 1e-14);
  near(found.t, 0.5, 1e-12);
  found = lam_spline_curve_closest(arena, &circle, lam_v3(2, -1, 2));
  near(found.t, 0, 0);
  near(found.distance, sqrt(6), 1e-15);
  near(lam_spline_curve_closest(arena, &circle, lam_v3(0, 0, 0)).distance, 1, 1e-15);
  near(lam_spline_curve_closest(arena, &circle, point_at(&circle, 0.3)).t, 0.3, 1e-14);
}

/* A C2 curve cut in two joins with C2; elevating and speeding up the second part leaves G2 with
 * alpha = 2. */
static void test_join_of_parts(void **state) {
  (void)state;
  const int degrees[] = {3, 5};
  for (int k = 0; k < 2; k++) {
    lam_spline_curve c = next_curve(degrees[k], degrees[k] + 3, k, true),
                     a = lam_spline_curve_part(arena, c, 1, 2.4),
                     b = lam_spline_curve_part(arena, c, 2.4, 4);
    lam_join join = lam_join_curves(&a, &b, 1e-9);
    assert_int_equal(join.parametric, 2);
    near(join.alpha, 1, 1e-11);
    b = lam_spline_curve_from_net(
        arena,
        lam_bspline_move_domain(
            arena, lam_bspline_elevate(arena, lam_spline_curve_net(arena, &b, false), 6), 0, 0.8));
    join = lam_join_curves(&a, &b, 1e-9);
    assert_int_equal(join.parametric, 0);
    assert_int_equal(join.geometric, 2);
    near(join.alpha, 2, 1e-10);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_helix),
      TEST(test_helix_length),
      TEST(test_twisted_cubic),
      TEST(test_rational_circle),
      TEST(test_degenerate_frames),
      TEST(test_polynomials),
      TEST(test_parameters),
      TEST(test_cubic_forms),
      TEST(test_join_of_a_broken_line),
      TEST(test_join_of_curves),
      TEST(test_join_of_parts),
      TEST(test_closest_points),
      TEST(test_closest_on_a_circle),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
