/* Smooth curves along polylines of nets. */
#include "core/numbers.h"
#include "tests/unit/asserts.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "curve/curve.h"
#include "mesh/line_curve.h"
#include <stdio.h>

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

enum { most = 64 };
static int order[most];

static lam_polyline line_of(int count, bool closed) {
  for (int i = 0; i < most; i++)
    order[i] = most - 1 - i; /* of vertices in another order than the line's */
  return (lam_polyline){0, closed, count, order};
}

/* The curve's jet at t from the right, or from the left at the end of a piece. */
static void jet(const lam_spline_curve *c, double t, lam_vec3 x[4]) {
  lam_spline_curve_eval(c, t, 3, x);
}

/* At chord-length parameters, the curve is at the vertices; between knots, second derivatives go
 * on. */
static void vertices_are_interpolated(void **state) {
  lam_vec3 x[most];
  for (int i = 0; i < most; i++) x[most - 1 - i] = lam_v3(i, 0.1 * i * i, sin(0.7 * i));
  for (int count = 2; count < 20; count++) {
    lam_polyline line = line_of(count, false);
    lam_spline_curve c = lam_polyline_curve(*state, x, &line);
    assert_null(lam_spline_curve_problem(&c));
    assert_int_equal(c.degree, count < 4 ? count - 1 : 3);
    assert_int_equal(c.count, count);
    double total = 0, t = 0;
    for (int i = 1; i < count; i++) total += lam_distance(x[order[i]], x[order[i - 1]]);
    for (int i = 0; i < count; i++) {
      lam_vec3 at[4], before[4], after[4];
      if (i) t += lam_distance(x[order[i]], x[order[i - 1]]) / total;
      t = fmin(t, 1);
      jet(&c, t, at);
      assert_near_named(lam_distance(at[0], x[order[i]]), 0, 1e-12, "vertex");
      if (i == 0 || i == count - 1) continue;
      jet(&c, t - 1e-9, before);
      jet(&c, t + 1e-9, after);
      assert_near_named(lam_distance(before[2], after[2]), 0, 1e-4 * (1 + lam_length(at[2])),
                        "second derivative");
    }
  }
}

/* A closed line comes back to its start with the same first and second derivatives. Through n
 * points of a circle of radius 1, an angle a apart, the C2 cubic over equal steps has derivatives D
 * with D (4 + 2 cos a) = 6 sin a there (from D_(i-1) + 4 D_i + D_(i+1) = 3 (P_(i+1) - P_(i-1))),
 * and lies cos(a/2) + D sin(a/2) / 4 from the center halfway.
 */
static void closed_lines_close(void **state) {
  static const int counts[] = {4, 5, 12, 40};
  for (int k = 0; k < 4; k++) {
    int n = counts[k];
    double pi = LAM_PI;
    lam_vec3 x[most];
    for (int i = 0; i < most; i++)
      x[most - 1 - i] = lam_v3(cos(2 * pi * i / n), sin(2 * pi * i / n), 0);
    lam_polyline line = line_of(n, true);
    lam_spline_curve c = lam_polyline_curve(*state, x, &line);
    lam_vec3 start[4], end[4], middle[4];
    jet(&c, 0, start);
    jet(&c, 1, end);
    assert_near_named(c.knots[0], 0, 0, "domain");
    assert_near_named(c.knots[c.count], 1, 0, "domain");
    for (int d = 0; d < 3; d++)
      assert_near_named(lam_distance(start[d], end[d]), 0, 1e-11 * (1 + lam_length(start[d])),
                        "derivative at the seam");
    double a = 2 * pi / n, halfway = cos(a / 2) + 6 * sin(a) / (4 + 2 * cos(a)) * sin(a / 2) / 4;
    for (int i = 0; i < n; i++) {
      jet(&c, (i + 0.5) / n, middle);
      assert_near_named(lam_length(middle[0]), halfway, 1e-11, "radius halfway");
    }
  }
}

/* Vertices in one place count once; a line of nothing else is none. */
static void repeated_vertices_count_once(void **state) {
  lam_vec3 x[most];
  for (int i = 0; i < most; i++) x[most - 1 - i] = lam_v3(i / 2, i / 2 % 3, 0);
  lam_polyline line = line_of(12, false);
  assert_int_equal(lam_polyline_curve(*state, x, &line).count, 6);
  line = line_of(2, true);
  assert_int_equal(lam_polyline_curve(*state, x, &line).count, 0);
}

/* Around a circle of radius 2 m in 48 steps: 2 pi R in all, to 1e-6 of it (a cubic spline); open
 * and straight, the lengths of the edges. */
static void lengths_are_those_of_the_curve(void **state) {
  enum { around = 48 };
  lam_vec3 x[most];
  lam_polyline line = line_of(around, true);
  for (int i = 0; i < around; i++) {
    double t = 2 * LAM_PI * i / around;
    x[order[i]] = lam_v3(2 * cos(t), 2 * sin(t), 1);
  }
  const double *length = lam_polyline_lengths(*state, x, &line);
  for (int i = 0; i <= around; i++)
    assert_near(length[i], 4 * LAM_PI * i / around, 4 * LAM_PI * 1e-6);

  line = line_of(9, false);
  for (int i = 0; i < 9; i++) x[order[i]] = lam_v3(i * i, 0, 0);
  length = lam_polyline_lengths(*state, x, &line);
  for (int i = 0; i < 9; i++) assert_near(length[i], i * i, 1e-9);
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(vertices_are_interpolated),
      TEST(closed_lines_close),
      TEST(repeated_vertices_count_once),
      TEST(lengths_are_those_of_the_curve),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
