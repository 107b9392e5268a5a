/* B-spline basis functions and interpolating splines. */
#include "core/arena.h"
#include "curve/bspline/basis.h"
#include "curve/cubic_spline.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

enum { DEGREES = 9, MOST_KNOTS = 64 };

/* A fixed sequence of numbers in [0, 1). */
static double next_random(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 9007199254740992.0;
}

/* Uneven knots over [2, 7]: unclamped for odd seeds, with a double knot where the degree allows it.
 */
static int make_knots(int degree, uint64_t seed, double *knots) {
  uint64_t state = seed;
  int count = degree + 5, total = count + degree + 1;
  for (int i = 0; i < total; i++) knots[i] = i == 0 ? 0 : knots[i - 1] + 0.2 + next_random(&state);
  double low = knots[degree], high = knots[count];
  for (int i = 0; i < total; i++) knots[i] = 2 + 5 * (knots[i] - low) / (high - low);
  for (int i = 0; i < total && seed % 2 == 0; i++) knots[i] = fmin(7, fmax(2, knots[i]));
  if (degree > 1) knots[degree + 2] = knots[degree + 3];
  assert_null(lam_knots_problem(degree, count, total, knots));
  return count;
}

/* The functions sum to 1 and their derivatives to 0, for every degree, over uneven knots. */
static void test_partition_of_unity(void **state) {
  (void)state;
  double knots[MOST_KNOTS], values[4 * LAM_BASIS_MAX_VALUES];
  for (int degree = 0; degree <= DEGREES; degree++)
    for (uint64_t seed = 1; seed <= 20; seed++) {
      uint64_t random = seed;
      int count = make_knots(degree, seed, knots);
      double t = 2 + 5 * next_random(&random);
      int span = lam_basis_span(degree, count, knots, t);
      assert_true(span >= degree && span < count && knots[span] <= t && t < knots[span + 1]);
      lam_basis_eval(degree, knots, span, t, 3, values);
      for (int k = 0; k <= 3; k++) {
        double sum = 0, size = 1;
        for (int j = 0; j <= degree; j++) {
          sum += values[k * (degree + 1) + j];
          size = fmax(size, fabs(values[k * (degree + 1) + j]));
          if (k == 0) assert_true(values[j] >= 0);
        }
        assert_true(fabs(sum - (k == 0)) <= 1e-13 * size);
      }
    }
}

/* Every derivative is the central difference of the one below it (extrapolated, error of order
 * h^6). */
static void test_derivatives_against_differences(void **state) {
  (void)state;
  const double h = 1e-2, factors[] = {1.5, -0.6, 0.1};
  double knots[MOST_KNOTS], at[4 * LAM_BASIS_MAX_VALUES], low[4 * LAM_BASIS_MAX_VALUES],
      high[4 * LAM_BASIS_MAX_VALUES];
  for (int degree = 1; degree <= DEGREES; degree++)
    for (uint64_t seed = 1; seed <= 20; seed++) {
      uint64_t random = seed + 100;
      int count = make_knots(degree, seed, knots), width = degree + 1;
      double t = 2 + 5 * next_random(&random);
      int span = lam_basis_span(degree, count, knots, t);
      lam_basis_eval(degree, knots, span, t, 3, at);
      double difference[3 * LAM_BASIS_MAX_VALUES] = {0}, size[3] = {1, 1, 1},
                            step = h * (knots[span + 1] - knots[span]);
      for (int k = 1; k <= 3; k++) { /* the piece's polynomial: the span stays the same */
        lam_basis_eval(degree, knots, span, t - k * step, 3, low);
        lam_basis_eval(degree, knots, span, t + k * step, 3, high);
        for (int i = 0; i < 3 * width; i++)
          difference[i] += factors[k - 1] * (high[i] - low[i]) / (2 * k * step);
      }
      for (int i = 0; i < 3 * width; i++)
        size[i / width] = fmax(size[i / width], fabs(at[width + i]));
      for (int i = 0; i < 3 * width; i++)
        assert_true(fabs(difference[i] - at[width + i]) <= 1e-8 * size[i / width]);
    }
}

/* Derivatives above the degree are zero, and the highest degree works. */
static void test_limits(void **state) {
  (void)state;
  double knots[2 * LAM_BASIS_MAX_VALUES], values[4 * LAM_BASIS_MAX_VALUES];
  lam_knots_clamped(1, 2, knots);
  lam_basis_eval(1, knots, 1, 0.25, 3, values);
  const double expected[] = {0.75, 0.25, -1, 1, 0, 0, 0, 0};
  for (int i = 0; i < 8; i++) assert_true(values[i] == expected[i]);
  lam_knots_clamped(LAM_BASIS_MAX_DEGREE, LAM_BASIS_MAX_VALUES, knots);
  lam_basis_eval(LAM_BASIS_MAX_DEGREE, knots, LAM_BASIS_MAX_DEGREE, 0.5, 0, values);
  double middle =
      tgamma(25) / (tgamma(13) * tgamma(13)) * pow(0.5, 24); /* Bernstein: binomial(24,12) / 2^24 */
  assert_true(fabs(values[12] - middle) <= 1e-14);
}

/* Clamped knots without inner ones give the Bernstein polynomials binomial(n,j) t^j (1-t)^(n-j). */
static void test_bezier_is_bernstein(void **state) {
  (void)state;
  double knots[2 * LAM_BASIS_MAX_VALUES], values[LAM_BASIS_MAX_VALUES];
  for (int degree = 0; degree <= 12; degree++) {
    lam_knots_clamped(degree, degree + 1, knots);
    for (int i = 0; i <= 10; i++) {
      double t = i / 10.0;
      lam_basis_eval(degree, knots, lam_basis_span(degree, degree + 1, knots, t), t, 0, values);
      for (int j = 0; j <= degree; j++) {
        double binomial = tgamma(degree + 1) / (tgamma(j + 1) * tgamma(degree - j + 1));
        assert_true(fabs(values[j] - binomial * pow(t, j) * pow(1 - t, degree - j)) <= 1e-13);
      }
    }
  }
}

/* The standard nine-point quadratic NURBS circle (weights 1 and 1/sqrt 2, double knots) has radius
 * 1 everywhere. */
static void test_circle(void **state) {
  (void)state;
  const double knots[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  assert_null(lam_knots_problem(2, 9, 12, knots));
  for (int i = 0; i <= 200; i++) {
    double t = i / 50.0, values[3], sum[3] = {0};
    int span = lam_basis_span(2, 9, knots, t);
    lam_basis_eval(2, knots, span, t, 0, values);
    for (int j = 0; j < 3; j++) {
      int point = span - 2 + j;
      double w = values[j] * (point % 2 ? M_SQRT1_2 : 1);
      sum[0] += w * x[point];
      sum[1] += w * y[point];
      sum[2] += w;
    }
    assert_true(fabs(hypot(sum[0], sum[1]) / sum[2] - 1) <= 1e-15);
  }
}

/* The end of the domain belongs to the last piece that is not empty, the outside to the nearest
 * piece. */
static void test_spans(void **state) {
  (void)state;
  const double knots[] = {0, 0, 0, 1, 1, 3, 3, 3};
  const double t[] = {-1, 0, 0.5, 1, 2, 3, 9};
  const int expected[] = {2, 2, 2, 4, 4, 4, 4};
  for (int i = 0; i < 7; i++) assert_int_equal(lam_basis_span(2, 5, knots, t[i]), expected[i]);
}

/* Bad knots are refused with a reason. */
static void test_bad_knots(void **state) {
  (void)state;
  const double falling[] = {0, 0, 1, 0.5, 2, 2}, empty[] = {1, 1, 1, 1, 1, 1},
               torn[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  const double infinite[] = {0, 0, 1, INFINITY}, many[] = {0, 0, 0, 1, 2, 2};
  assert_non_null(strstr(lam_knots_problem(2, 3, 5, falling), "as many"));
  assert_non_null(strstr(lam_knots_problem(2, 3, 6, falling), "not decrease"));
  assert_non_null(strstr(lam_knots_problem(2, 3, 6, empty), "empty"));
  assert_non_null(strstr(lam_knots_problem(2, 6, 9, torn), "inner knot"));
  assert_non_null(strstr(lam_knots_problem(1, 2, 4, infinite), "finite"));
  assert_non_null(strstr(lam_knots_problem(1, 4, 6, many), "degree + 1"));
}

/* A cubic is its own not-a-knot spline, and the derivatives are those of the cubic; likewise a
 * parabola through 3 points. */
static void test_spline_reproduces_cubics(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const double t[] = {0, 0.4, 1.1, 1.5, 3, 3.2};
  for (int count = 2; count <= 6; count++) {
    int degree = count - 1 < 3 ? count - 1 : 3;
    double values[12], x[2], dx[2], ddx[2];
    for (int i = 0; i < count; i++) {
      values[2 * i] = pow(t[i] - 1, degree);
      values[2 * i + 1] = 2 - 3 * t[i];
    }
    lam_spline spline = lam_spline_make(arena, count, 2, t, values);
    for (double s = 0; s <= t[count - 1]; s += 0.05) {
      lam_spline_eval(&spline, s, x, dx, ddx);
      double d = degree;
      assert_true(fabs(x[0] - pow(s - 1, d)) <= 1e-13);
      assert_true(fabs(dx[0] - d * pow(s - 1, d - 1)) <= 1e-12);
      assert_true(fabs(ddx[0] - (degree < 2 ? 0 : d * (d - 1) * pow(s - 1, d - 2))) <= 1e-12);
      assert_true(fabs(x[1] - (2 - 3 * s)) <= 1e-13 && fabs(dx[1] + 3) <= 1e-12 &&
                  fabs(ddx[1]) <= 1e-12);
    }
  }
  lam_arena_free(arena);
}

/* Interpolation of sin converges with the fourth power of the step (16 per halving; de Boor,
 * theorem of ch. V). */
static void test_spline_converges(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  double error[2] = {0};
  for (int level = 0; level < 2; level++) {
    int count = 20 * (level + 1) + 1;
    double *t = LAM_NEW(arena, double, count), *values = LAM_NEW(arena, double, count), x, dx, ddx;
    for (int i = 0; i < count; i++) {
      t[i] = 3.0 * i / (count - 1);
      values[i] = sin(t[i]);
    }
    lam_spline spline = lam_spline_make(arena, count, 1, t, values);
    for (double s = 0; s <= 3; s += 0.003) {
      lam_spline_eval(&spline, s, &x, &dx, &ddx);
      error[level] = fmax(error[level], fabs(x - sin(s)));
    }
  }
  assert_true(error[1] > 0 && error[0] / error[1] > 12 && error[0] / error[1] < 36);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_partition_of_unity),
      cmocka_unit_test(test_derivatives_against_differences),
      cmocka_unit_test(test_limits),
      cmocka_unit_test(test_bezier_is_bernstein),
      cmocka_unit_test(test_circle),
      cmocka_unit_test(test_spans),
      cmocka_unit_test(test_bad_knots),
      cmocka_unit_test(test_spline_reproduces_cubics),
      cmocka_unit_test(test_spline_converges),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
