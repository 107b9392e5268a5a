/* Coons patches and surfaces through grids of points. */
#include "surf/spline/coons_patch.h"
#include "surf/spline/spline_through.h"
#include "tests/unit/spline_surface_fixture.h"

/* Four sides of different degrees and knots that meet; rational ones have weights that do not agree
 * at the corners. */
static lam_sides example(bool rational) {
  lam_sides given = {0}, sides;
  lam_sides_gap gap;
  const int degree[] = {3, 2, 1, 4}, count[] = {6, 4, 5, 5};
  for (int i = 0; i < 4; i++) given.side[i] = next_curve(degree[i], count[i], rational, true);
  for (int i = 1; i < 4; i += 2) /* sides 1 and 3 start and end on sides 0 and 2 */
    for (int end = 0; end < 2; end++) {
      const lam_spline_curve *other = &given.side[2 * end];
      lam_vec3 *points = (lam_vec3 *)given.side[i].points; /* this test made them */
      points[end ? count[i] - 1 : 0] = other->points[i == 3 ? other->count - 1 : 0];
    }
  assert_true(lam_sides_join(arena, &given, &sides, &gap));
  return sides;
}

static lam_vec3 side_at(const lam_sides *sides, int i, double t) {
  return point_at(&sides->side[i], t);
}

/* The formula, from the curves alone. */
static lam_vec3 bilinear_at(const lam_sides *c, double u, double v) {
  lam_vec3 ruled = lam_mix(side_at(c, 0, u), side_at(c, 2, u), v);
  lam_vec3 other = lam_mix(side_at(c, 1, v), side_at(c, 3, v), u);
  lam_vec3 corners = lam_mix(lam_mix(side_at(c, 0, 0), side_at(c, 0, 1), u),
                             lam_mix(side_at(c, 2, 0), side_at(c, 2, 1), u), v);
  return lam_sub(lam_add(ruled, other), corners);
}

static void meets_formula(const lam_sides *c, const lam_spline_surface *s) {
  for (int i = 0; i < 40; i++) {
    double u = i == 0 ? 0 : i == 1 ? 1 : next_in(0, 1), v = i == 2 ? 0 : i == 3 ? 1 : next_in(0, 1);
    near3(at(s, u, v), bilinear_at(c, u, v), exact);
  }
}

/* The largest distance of a boundary point from its side. */
static double side_gap(const lam_sides *c, const lam_spline_surface *s) {
  double most = 0;
  for (int i = 0; i < 4; i++)
    for (int k = 0; k <= 100; k++) {
      double t = k / 100.0;
      most =
          fmax(most, lam_distance(at(s, i % 2 ? i / 2 : t, i % 2 ? t : i / 2), side_at(c, i, t)));
    }
  return most;
}

/* The patch is the formula at every point, not only on its sides. */
static void test_bilinear_coons(void **state) {
  (void)state;
  for (int k = 0; k < 10; k++) {
    lam_sides c = example(false);
    lam_spline_surface s = lam_coons_surface(arena, &c, LAM_COONS_BILINEAR);
    assert_int_equal(s.degree[0], 3);
    assert_int_equal(s.degree[1], 4);
    assert_null(s.weights);
    meets_formula(&c, &s);
  }
}

/* The same with weights: degrees 3 and 1 along u give a denominator of degree 4 and a patch of
 * degree 5. */
static void test_rational_coons(void **state) {
  (void)state;
  for (int k = 0; k < 10; k++) {
    lam_sides c = example(true);
    lam_spline_surface s = lam_coons_surface(arena, &c, LAM_COONS_BILINEAR);
    assert_int_equal(s.degree[0], 5);
    assert_int_equal(s.degree[1], 7);
    for (int d = 0; d < 2; d++)
      assert_int_equal(lam_coons_degree(arena, &c, LAM_COONS_BILINEAR, d), s.degree[d]);
    for (int i = 0; i < s.count[0] * s.count[1]; i++) assert_true(s.weights[i] > 0);
    meets_formula(&c, &s);
    s = lam_coons_surface(arena, &c, LAM_COONS_HERMITE);
    assert_true(side_gap(&c, &s) < exact);
    for (int d = 0; d < 2; d++)
      assert_int_equal(lam_coons_degree(arena, &c, LAM_COONS_HERMITE, d), s.degree[d]);
  }
}

/* A quarter of a circle from angle `from`, around the z axis or, tilted, around the y axis. */
static lam_spline_curve quarter(double radius, double z, bool upright) {
  static const double knots[] = {0, 0, 0, 1, 1, 1}, weights[] = {1, 0.70710678118654752, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 3);
  for (int i = 0; i < 3; i++) {
    double a = i < 2 ? radius : 0, b = i > 0 ? radius : 0;
    points[i] = upright ? lam_v3(a, 0, b) : lam_v3(a, b, z);
  }
  return (lam_spline_curve){2, 3, knots, points, weights};
}

static lam_spline_curve segment(lam_vec3 a, lam_vec3 b) {
  static const double knots[] = {0, 0, 1, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 2);
  points[0] = a;
  points[1] = b;
  return (lam_spline_curve){1, 2, knots, points, NULL};
}

static lam_spline_surface patch_of(lam_spline_curve a, lam_spline_curve b, lam_spline_curve c,
                                   lam_spline_curve d, lam_sides *sides) {
  lam_sides_gap gap;
  lam_sides given = {.side = {a, b, c, d}};
  assert_true(lam_sides_join(arena, &given, sides, &gap));
  return lam_coons_surface(arena, sides, LAM_COONS_BILINEAR);
}

/* Between two arcs and two lines the patch is ruled: a quarter of a cylinder, of a cone. Their
 * equations are met. */
static void test_quadrics(void **state) {
  (void)state;
  lam_sides c;
  lam_spline_surface s =
      patch_of(quarter(2, 0, false), segment(lam_v3(2, 0, 0), lam_v3(2, 0, 3)),
               quarter(2, 3, false), segment(lam_v3(0, 2, 0), lam_v3(0, 2, 3)), &c);
  assert_int_equal(s.degree[0], 3); /* the denominator of the arcs, once, times a linear function */
  assert_int_equal(s.degree[1], 1);
  assert_true(side_gap(&c, &s) < 1e-14);
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    lam_vec3 x = at(&s, u, v);
    near(hypot(x.x, x.y), 2, 1e-14);
    near(x.z, 3 * v, 1e-14);
  }
  s = patch_of(quarter(2, 0, false), segment(lam_v3(2, 0, 0), lam_v3(0.5, 0, 3)),
               quarter(0.5, 3, false), segment(lam_v3(0, 2, 0), lam_v3(0, 0.5, 3)), &c);
  assert_true(side_gap(&c, &s) < 1e-14);
  for (int i = 0; i < 40; i++) {
    lam_vec3 x = at(&s, next_in(0, 1), next_in(0, 1));
    near(hypot(x.x, x.y), 2 - x.z / 2, 1e-14);
  }
}

/* Three quarter circles on a sphere and its pole, a side of length 0: the boundary is met; the
 * inside is no sphere. */
static void test_octant(void **state) {
  (void)state;
  lam_sides c;
  lam_spline_curve meridian = quarter(1, 0, true);
  lam_vec3 *turned = LAM_NEW(arena, lam_vec3, 3);
  for (int i = 0; i < 3; i++) turned[i] = lam_v3(0, meridian.points[i].x, meridian.points[i].z);
  lam_spline_curve other = meridian;
  other.points = turned;
  lam_spline_surface s = patch_of(quarter(1, 0, false), meridian,
                                  segment(lam_v3(0, 0, 1), lam_v3(0, 0, 1)), other, &c);
  assert_true(side_gap(&c, &s) < 1e-14);
  for (int i = 0; i <= 20; i++) {
    near(lam_length(at(&s, i / 20.0, 0)), 1, 1e-14);
    near(lam_length(at(&s, 0, i / 20.0)), 1, 1e-14);
    near(lam_length(at(&s, 1, i / 20.0)), 1, 1e-14);
  }
  meets_formula(&c, &s);
  lam_sides scaled = c; /* a factor on the weights of one curve changes nothing */
  double *weights = LAM_NEW(arena, double, 3);
  for (int i = 0; i < 3; i++) weights[i] = 5 * c.side[1].weights[i];
  scaled.side[1].weights = weights;
  lam_spline_surface t = lam_coons_surface(arena, &scaled, LAM_COONS_BILINEAR);
  const double unit[] = {0, 1};
  same(&s, &t, unit, unit);
}

/* The sides and derivatives of a bicubic patch give it back; with simple blends of a spline surface
 * too, the sides and what crosses them are met. */
static void test_hermite_coons(void **state) {
  (void)state;
  for (int k = 0; k < 5; k++) {
    lam_vec3 net[16];
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i < 16; i++) net[i] = next_point();
    lam_spline_surface bicubic = {NULL, {3, 3}, {4, 4}, {knots, knots}, net, NULL};
    lam_sides c = {0};
    for (int i = 0; i < 4; i++) {
      lam_vec3 *side = LAM_NEW(arena, lam_vec3, 4), *across = LAM_NEW(arena, lam_vec3, 4);
      int step = i % 2 ? 1 : 4, jump = i % 2 ? 4 : 1; /* along the side; to the next row */
      for (int j = 0; j < 4; j++) {
        const lam_vec3 *p = net + j * step;
        side[j] = p[i / 2 ? 3 * jump : 0];
        across[j] = i / 2 ? lam_scale(lam_sub(p[3 * jump], p[2 * jump]), 3)
                          : lam_scale(lam_sub(p[jump], p[0]), 3);
      }
      c.side[i] = (lam_spline_curve){3, 4, knots, side, NULL};
      lam_spline_curve crossing = {3, 4, knots, across, NULL};
      c.across[i] = lam_spline_curve_net(arena, &crossing, false);
    }
    lam_coons_gaps gaps = lam_coons_check(arena, &c);
    near(gaps.slope + gaps.twist, 0, 1e-13);
    lam_spline_surface s = lam_coons_surface(arena, &c, LAM_COONS_HERMITE);
    const double unit[] = {0, 1};
    same(&bicubic, &s, unit, unit);
  }
}

/* Without given derivatives those across a side are mixed linearly from the slopes at its ends; the
 * twists then agree only in the mean. Both sides and, at twist-free corners, derivatives are met.
 */
static void test_hermite_coons_from_sides(void **state) {
  (void)state;
  lam_sides c = example(false);
  lam_spline_surface s = lam_coons_surface(arena, &c, LAM_COONS_HERMITE);
  assert_true(lam_coons_check(arena, &c).twist > 0.1);
  for (int i = 0; i < 40; i++) {
    double t = next_in(0, 1);
    near3(at(&s, t, 0), side_at(&c, 0, t), exact);
    near3(at(&s, t, 1), side_at(&c, 2, t), exact);
    near3(at(&s, 0, t), side_at(&c, 1, t), exact);
    near3(at(&s, 1, t), side_at(&c, 3, t), exact);
  }
  /* all slopes across v = 0 equal, and those of the other sides: constant across, so no twists */
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  const lam_vec3 shift = {0.2, 3, 0.5};
  lam_vec3 bottom[4], top[4], left[4], right[4];
  for (int i = 0; i < 4; i++) {
    bottom[i] = lam_along(lam_v3(i, 0, 0), 0.3, next_point());
    top[i] = lam_add(bottom[i], shift);
  }
  for (int i = 0; i < 4; i++) {
    left[i] = lam_along(lam_along(bottom[0], i / 3.0, shift), i == 1 || i == 2, lam_v3(0, 0, 0.7));
    right[i] = lam_add(left[i], lam_sub(bottom[3], bottom[0]));
  }
  lam_sides t = {.side = {{3, 4, knots, bottom, NULL},
                          {3, 4, knots, left, NULL},
                          {3, 4, knots, top, NULL},
                          {3, 4, knots, right, NULL}}};
  near(lam_coons_check(arena, &t).twist, 0, 1e-13);
  s = lam_coons_surface(
      arena, &t, LAM_COONS_HERMITE); /* the translational surface bottom(u) + left(v) - corner */
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    lam_vec3 x = lam_sub(lam_add(point_at(&t.side[0], u), point_at(&t.side[1], v)), bottom[0]);
    near3(at(&s, u, v), x, exact);
  }
}

/* ---- through points ---- */

static lam_vec3 bicubic_at(double u, double v) {
  return lam_v3(u + 0.2 * v * v * u, v - 0.1 * u * u * u,
                u * u * v * v * v - u * v + 0.5 * u * u * u);
}

/* Cubics come back; other points are met, whatever the ends and the parameters. */
static void test_through_points(void **state) {
  (void)state;
  enum { M = 7, N = 6 };
  const int count[] = {M, N}, cubic[] = {3, 3}, other[] = {4, 2};
  const double t0[M] = {0, 0.1, 0.3, 0.4, 0.7, 0.8, 1}, t1[N] = {0, 0.3, 0.4, 0.5, 0.9, 1};
  const double *const given[] = {t0, t1};
  lam_vec3 points[M * N];
  for (int i = 0; i < M * N; i++) points[i] = bicubic_at(t0[i / N], t1[i % N]);
  lam_spline_surface s =
      lam_surface_through(arena, LAM_ENDS_NOT_A_KNOT, cubic, count, given, points);
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    near3(at(&s, u, v), bicubic_at(u, v), 1e-12);
  }
  for (int i = 0; i < M * N; i++) points[i] = lam_along(lam_v3(i / N, i % N, 0), 0.4, next_point());
  for (int kind = 0; kind < LAM_PARAMETERS_COUNT; kind++)
    for (int ends = 0; ends < LAM_ENDS_TANGENTS; ends++) {
      const double *t[2];
      lam_grid_parameters(arena, (lam_parameters)kind, count, points, t);
      s = lam_surface_through(arena, (lam_ends)ends, ends ? cubic : other, count, t, points);
      for (int i = 0; i < M * N; i++) near3(at(&s, t[0][i / N], t[1][i % N]), points[i], 1e-11);
    }
  for (int i = 0; i < N; i++) points[N + i] = points[i]; /* two rows alike */
  const double *t[2];
  lam_grid_parameters(arena, LAM_PARAMETERS_CHORD, count, points, t);
  assert_null(t[0]);
  assert_non_null(t[1]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_bilinear_coons), TEST(test_rational_coons), TEST(test_quadrics),
      TEST(test_octant),         TEST(test_hermite_coons),  TEST(test_hermite_coons_from_sides),
      TEST(test_through_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
