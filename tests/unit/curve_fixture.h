/* What the tests of spline curves share: random curves and comparison at random parameters. */
#ifndef LAM_TESTS_CURVE_FIXTURE_H
#define LAM_TESTS_CURVE_FIXTURE_H

#include "core/arena.h"
#include "curve/bspline/basis.h"
#include "curve/curve.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static lam_arena *arena;
static uint64_t sequence;

static inline int set_up(void **state) {
  (void)state;
  arena = lam_arena_new();
  sequence = 7;
  return 0;
}

static inline int tear_down(void **state) {
  (void)state;
  lam_arena_free(arena);
  return 0;
}

/* A fixed sequence of numbers in [low, high). */
static inline double next_in(double low, double high) {
  sequence = sequence * 6364136223846793005u + 1442695040888963407u;
  return low + (high - low) * ((double)(sequence >> 11) / 9007199254740992.0);
}

static inline lam_vec3 next_point(void) {
  double x = next_in(-1, 1), y = next_in(-1, 1);
  return lam_v3(x, y, next_in(-1, 1));
}

/* count functions over uneven knots of [1, 4]; the second inner knot is double where degree and
 * count allow it. */
static inline double *next_knots(int degree, int count, bool clamp) {
  int total = count + degree + 1;
  double *knots = LAM_NEW(arena, double, total);
  for (int i = 1; i < total; i++) knots[i] = knots[i - 1] + next_in(0.3, 1.2);
  double low = knots[degree], high = knots[count];
  for (int i = 0; i < total; i++)
    knots[i] = i == degree ? 1 : i == count ? 4 : 1 + 3 * (knots[i] - low) / (high - low);
  for (int i = 0; clamp && i < total; i++) knots[i] = fmin(4, fmax(1, knots[i]));
  if (degree > 1 && count > degree + 3) knots[degree + 2] = knots[degree + 3];
  return knots;
}

static inline lam_spline_curve next_curve(int degree, int count, bool rational, bool clamp) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count);
  double *weights = rational ? LAM_NEW(arena, double, count) : NULL;
  for (int i = 0; i < count; i++) {
    points[i] = next_point();
    if (rational) weights[i] = next_in(0.5, 3);
  }
  lam_spline_curve curve = {degree, count, next_knots(degree, count, clamp), points, weights};
  assert_null(lam_spline_curve_problem(&curve));
  return curve;
}

static inline lam_vec3 point_at(const lam_spline_curve *curve, double t) {
  lam_vec3 x;
  lam_spline_curve_eval(curve, t, 0, &x);
  return x;
}

static inline void near(double value, double expected, double tolerance) {
  if (!(fabs(value - expected) <= tolerance))
    fail_msg("%.15g, expected %.15g +- %.1e", value, expected, tolerance);
}

static inline void near3(lam_vec3 value, lam_vec3 expected, double tolerance) {
  if (!(lam_distance(value, expected) <= tolerance))
    fail_msg("(%.15g, %.15g, %.15g), expected (%.15g, %.15g, %.15g) +- %.1e", value.x, value.y,
             value.z, expected.x, expected.y, expected.z, tolerance);
}

/* Both curves are the same at 40 random parameters of [low, high] and at its ends. */
static inline void same_curve(const lam_spline_curve *a, const lam_spline_curve *b, double low,
                              double high, double tolerance) {
  assert_null(lam_spline_curve_problem(b));
  for (int i = 0; i < 42; i++) {
    double t = i == 0 ? low : i == 1 ? high : next_in(low, high);
    near3(point_at(b, t), point_at(a, t), tolerance);
  }
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

#endif
