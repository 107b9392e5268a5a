/* Coons patches and surfaces through grids of points. */
#include "surf/coons_patch.h"
#include "surf/spline_through.h"
#include "tests/unit/spline_surface_fixture.h"

/* Four sides of different degrees, knots and domains that meet. */
static lam_coons example_coons(void) {
  lam_coons coons = {0};
  const int degree[] = {3, 2, 1, 4}, count[] = {6, 4, 5, 5};
  for (int i = 0; i < 4; i++) coons.side[i] = next_curve(degree[i], count[i], false, true);
  for (int i = 1; i < 4; i += 2) /* sides 1 and 3 start and end on sides 0 and 2 */
    for (int end = 0; end < 2; end++) {
      const lam_spline_curve *other = &coons.side[2 * end];
      lam_vec3 *points = (lam_vec3 *)coons.side[i].points; /* this test made them */
      points[end ? count[i] - 1 : 0] = other->points[i == 3 ? other->count - 1 : 0];
    }
  return coons;
}

static lam_vec3 side_at(const lam_coons *coons, int i, double t) { return point_at(&coons->side[i], 1 + 3 * t); }

/* The patch is the formula at every point, not only on its sides. */
static void test_bilinear_coons(void **state) {
  (void)state;
  for (int k = 0; k < 10; k++) {
    lam_coons c = example_coons();
    lam_spline_surface s = lam_coons_bilinear(arena, &c);
    assert_int_equal(s.degree[0], 3);
    assert_int_equal(s.degree[1], 4);
    for (int i = 0; i < 40; i++) {
      double u = i == 0 ? 0 : i == 1 ? 1 : next_in(0, 1), v = i == 2 ? 0 : i == 3 ? 1 : next_in(0, 1);
      lam_vec3 ruled = lam_mix(side_at(&c, 0, u), side_at(&c, 2, u), v);
      lam_vec3 other = lam_mix(side_at(&c, 1, v), side_at(&c, 3, v), u);
      lam_vec3 corners = lam_mix(lam_mix(side_at(&c, 0, 0), side_at(&c, 0, 1), u),
                                 lam_mix(side_at(&c, 2, 0), side_at(&c, 2, 1), u), v);
      near3(at(&s, u, v), lam_sub(lam_add(ruled, other), corners), exact);
    }
    near(lam_coons_check(arena, &c).corner, 0, 1e-15);
  }
}

/* The sides and derivatives of a bicubic patch give it back; with simple blends of a spline surface too, the sides and
 * what crosses them are met. */
static void test_hermite_coons(void **state) {
  (void)state;
  for (int k = 0; k < 5; k++) {
    lam_vec3 net[16];
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i < 16; i++) net[i] = next_point();
    lam_spline_surface bicubic = {NULL, {3, 3}, {4, 4}, {knots, knots}, net, NULL};
    lam_coons c = {0};
    for (int i = 0; i < 4; i++) {
      lam_vec3 *side = LAM_NEW(arena, lam_vec3, 4), *across = LAM_NEW(arena, lam_vec3, 4);
      int step = i % 2 ? 1 : 4, jump = i % 2 ? 4 : 1; /* along the side; to the next row */
      for (int j = 0; j < 4; j++) {
        const lam_vec3 *p = net + j * step;
        side[j] = p[i / 2 ? 3 * jump : 0];
        across[j] = i / 2 ? lam_scale(lam_sub(p[3 * jump], p[2 * jump]), 3) : lam_scale(lam_sub(p[jump], p[0]), 3);
      }
      c.side[i] = (lam_spline_curve){3, 4, knots, side, NULL};
      lam_spline_curve crossing = {3, 4, knots, across, NULL};
      c.across[i] = lam_spline_curve_net(arena, &crossing, false);
    }
    lam_coons_gaps gaps = lam_coons_check(arena, &c);
    near(gaps.corner + gaps.slope + gaps.twist, 0, 1e-13);
    lam_spline_surface s = lam_coons_hermite(arena, &c);
    const double unit[] = {0, 1};
    same(&bicubic, &s, unit, unit);
  }
}

/* Without given derivatives those across a side are mixed linearly from the slopes at its ends; the twists then agree
 * only in the mean. Both sides and, at twist-free corners, derivatives are met. */
static void test_hermite_coons_from_sides(void **state) {
  (void)state;
  lam_coons c = example_coons();
  lam_spline_surface s = lam_coons_hermite(arena, &c);
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
  lam_coons t = {.side = {{3, 4, knots, bottom, NULL},
                          {3, 4, knots, left, NULL},
                          {3, 4, knots, top, NULL},
                          {3, 4, knots, right, NULL}}};
  near(lam_coons_check(arena, &t).twist, 0, 1e-13);
  s = lam_coons_hermite(arena, &t); /* the translational surface bottom(u) + left(v) - corner */
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    lam_vec3 x = lam_sub(lam_add(point_at(&t.side[0], u), point_at(&t.side[1], v)), bottom[0]);
    near3(at(&s, u, v), x, exact);
  }
}

/* ---- through points ---- */

static lam_vec3 bicubic_at(double u, double v) {
  return lam_v3(u + 0.2 * v * v * u, v - 0.1 * u * u * u, u * u * v * v * v - u * v + 0.5 * u * u * u);
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
  lam_spline_surface s = lam_surface_through(arena, LAM_ENDS_NOT_A_KNOT, cubic, count, given, points);
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
      TEST(test_bilinear_coons),
      TEST(test_hermite_coons),
      TEST(test_hermite_coons_from_sides),
      TEST(test_through_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
