/* Curves through points and near them, and how fair they are. */
#include "core/numbers.h"
#include "curve/curve_fairness.h"
#include "curve/interpolate.h"
#include "curve/least_squares.h"
#include "tests/unit/curve_fixture.h"

static double cubic(double t, int which) {
  return which ? t * t * t - 2 * t + 1 : -0.5 * t * t * t + t * t;
}

static double *next_parameters(int count) {
  double *t = LAM_NEW(arena, double, count);
  for (int i = 1; i < count; i++) t[i] = t[i - 1] + next_in(0.2, 1.3);
  return t;
}

/* All kinds of ends and all degrees pass through the points. */
static void test_interpolation_meets_points(void **state) {
  (void)state;
  for (int count = 2; count <= 14; count++)
    for (int degree = 1; degree <= 6; degree++)
      for (int ends = 0; ends < LAM_ENDS_COUNT; ends++)
        for (int kind = 0; kind < LAM_PARAMETERS_COUNT; kind++) {
          lam_vec3 *points = LAM_NEW(arena, lam_vec3, count);
          double *t = LAM_NEW(arena, double, count);
          for (int i = 0; i < count; i++) points[i] = next_point();
          lam_parameters_choose((lam_parameters)kind, count, points, t);
          lam_spline_curve c = lam_interpolate_points(arena, (lam_ends)ends, degree,
                                                      (lam_parameters)kind, count, points);
          assert_null(lam_spline_curve_problem(&c));
          for (int i = 0; i < count; i++) near3(point_at(&c, t[i]), points[i], 1e-11);
        }
}

/* Jump of the derivative of this order at t. */
static double jump(const lam_spline_curve *c, double t, int order) {
  lam_vec3 a[4], b[4];
  lam_spline_curve_eval(c, t, order, a);
  lam_spline_curve_eval(c, nextafter(t, -1), order, b);
  return lam_distance(a[order], b[order]);
}

/* C2 at every point; not-a-knot ends give cubics back; natural ends have no second derivative;
 * given slopes are met. */
static void test_cubic_ends(void **state) {
  (void)state;
  int count = 9;
  double *t = next_parameters(count), values[18], slopes[] = {1, 2, -3, 0.5};
  for (int i = 0; i < 18; i++) values[i] = i % 2 ? cubic(t[i / 2], 1) : cubic(t[i / 2], 0);
  lam_bspline f = lam_interpolate(arena, LAM_ENDS_NOT_A_KNOT, 3, count, t, 2, values, NULL);
  for (int i = 0; i < 50; i++) {
    double x[2], s = next_in(0, t[count - 1]);
    lam_bspline_eval(&f, s, 0, x);
    near(x[0], cubic(s, 0), 1e-10);
    near(x[1], cubic(s, 1), 1e-10);
  }
  for (int i = 0; i < 18; i++) values[i] = next_in(-1, 1);
  lam_bspline natural = lam_interpolate(arena, LAM_ENDS_NATURAL, 3, count, t, 2, values, NULL);
  lam_bspline given = lam_interpolate(arena, LAM_ENDS_TANGENTS, 3, count, t, 2, values, slopes);
  for (int e = 0; e < 2; e++) {
    double x[6];
    lam_bspline_eval(&natural, e ? t[count - 1] : 0, 2, x);
    near(hypot(x[4], x[5]), 0, 1e-11);
    lam_bspline_eval(&given, e ? t[count - 1] : 0, 1, x);
    near(x[2], slopes[2 * e], 1e-11);
    near(x[3], slopes[2 * e + 1], 1e-11);
  }
  assert_int_equal(natural.count, count + 2);
  for (int i = 1; i + 1 < count; i++)
    assert_int_equal(lam_bspline_multiplicity(&natural, t[i]), 1); /* so C2 */
}

/* Bessel's tangents and the local interpolation give parabolas back; the curve is C1 and a point
 * acts only on the four pieces around it. */
static void test_local_interpolation(void **state) {
  (void)state;
  enum { COUNT = 9 };
  double *t = next_parameters(COUNT);
  lam_vec3 points[COUNT];
  for (int i = 0; i < COUNT; i++)
    points[i] = lam_v3(t[i] * t[i], 1 - t[i], 2 * t[i] - 0.3 * t[i] * t[i]);
  lam_spline_curve c = lam_interpolate_local(arena, COUNT, t, points, NULL);
  for (int i = 0; i < 40; i++) {
    double s = next_in(0, t[COUNT - 1]);
    near3(point_at(&c, s), lam_v3(s * s, 1 - s, 2 * s - 0.3 * s * s), 1e-12);
  }
  for (int i = 0; i < COUNT; i++) points[i] = next_point();
  c = lam_interpolate_local(arena, COUNT, t, points, NULL);
  for (int i = 1; i + 1 < COUNT; i++) near(jump(&c, t[i], 1), 0, 1e-11);
  lam_vec3 moved[COUNT];
  for (int i = 0; i < COUNT; i++)
    moved[i] = i == 4 ? lam_add(points[i], lam_v3(1, 1, 1)) : points[i];
  lam_spline_curve d = lam_interpolate_local(arena, COUNT, t, moved, NULL);
  same_curve(&c, &d, t[0], t[2], 1e-14);
  same_curve(&c, &d, t[6], t[8], 1e-14);
  assert_true(lam_distance(point_at(&c, (t[2] + t[3]) / 2), point_at(&d, (t[2] + t[3]) / 2)) >
              1e-3);
}

/* Points of a spline with the same knots come back exactly; with noise the residuals are at right
 * angles to all inner basis functions, which is what makes the sum of squares least. */
static void test_least_squares(void **state) {
  (void)state;
  for (int degree = 1; degree <= 5; degree++) {
    enum { N = 80 };
    lam_spline_curve c = next_curve(degree, degree + 5, false, true), d;
    lam_vec3 points[N], rest[N];
    double t[N];
    lam_fit_error error;
    for (int i = 0; i < N; i++) {
      t[i] = 1 + 3.0 * i / (N - 1);
      points[i] = point_at(&c, t[i]);
    }
    assert_true(lam_fit_curve(arena, degree, c.count, c.knots, N, t, points, &d, &error));
    assert_true(error.max < 1e-12);
    for (int i = 0; i < c.count; i++) near3(d.points[i], c.points[i], 1e-10);
    for (int i = 0; i < N; i++) points[i] = lam_along(points[i], 0.1, next_point());
    assert_true(lam_fit_curve(arena, degree, c.count, NULL, N, t, points, &d, &error));
    near3(point_at(&d, 1), points[0], 1e-14);
    near3(point_at(&d, 4), points[N - 1], 1e-14);
    double most = 0, rms = 0;
    for (int i = 0; i < N; i++) {
      rest[i] = lam_sub(points[i], point_at(&d, t[i]));
      most = fmax(most, lam_length(rest[i]));
      rms += lam_dot(rest[i], rest[i]) / N;
    }
    near(error.max, most, 1e-14);
    near(error.rms, sqrt(rms), 1e-14);
    assert_true(most > 0.01);
    for (int j = 1; j < d.count - 1; j++) {
      lam_vec3 sum = {0, 0, 0};
      for (int i = 0; i < N; i++) {
        double basis[LAM_BASIS_MAX_VALUES];
        int span = lam_basis_span(degree, d.count, d.knots, t[i]), k = j - (span - degree);
        lam_basis_eval(degree, d.knots, span, t[i], 0, basis);
        if (k >= 0 && k <= degree) sum = lam_along(sum, basis[k], rest[i]);
      }
      near3(sum, lam_v3(0, 0, 0), 1e-12);
    }
  }
}

/* Knots without points among them are refused; a tolerance is kept with fewer points than
 * interpolation needs. */
static void test_least_squares_limits(void **state) {
  (void)state;
  enum { N = 60 };
  const double bad[] = {0, 0, 0, 0, 0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 1, 1, 1, 1};
  lam_vec3 points[N];
  double t[N];
  lam_spline_curve c;
  lam_fit_error error;
  for (int i = 0; i < N; i++) {
    t[i] = i / (N - 1.0);
    points[i] = lam_v3(cos(3 * t[i]), sin(3 * t[i]), t[i]);
  }
  assert_false(lam_fit_curve(arena, 3, 10, bad, N, t, points, &c, NULL));
  c = lam_fit_curve_within(arena, 3, 1e-5, N, t, points, &error);
  assert_true(error.max <= 1e-5 && c.count > 6 && c.count < 20);
  lam_spline_curve fewer;
  assert_true(lam_fit_curve(arena, 3, c.count - 1, NULL, N, t, points, &fewer, &error));
  assert_true(error.max > 1e-5);
  for (int i = 1; i + 1 < N; i++) points[i] = lam_along(points[i], 0.1, next_point());
  c = lam_fit_curve_within(arena, 3, 1e-9, N, t, points,
                           &error); /* noise: only interpolation is that near */
  assert_int_equal(c.count, N);
  assert_true(error.max <= 1e-9);
}

/* A cosine over [0, 3 pi] turns from side to side three times, the parabola, the ellipse and the
 * helix never. The variation is the sum of the differences between extreme curvatures. */
static void wave(const void *data, double t, int order, lam_vec3 *x) {
  (void)data;
  for (int k = 0; k <= order; k++) x[k] = lam_v3(k == 0 ? t : k == 1, cos(t + k * M_PI_2), 0);
}

static void helix(const void *data, double t, int order, lam_vec3 *x) {
  (void)data;
  for (int k = 0; k <= order; k++) {
    double turn = t + k * M_PI_2;
    x[k] = lam_v3(3 * cos(turn), 3 * sin(turn), k == 0 ? 4 * t : k == 1 ? 4 : 0);
  }
}

static void ellipse(const void *data, double t, int order, lam_vec3 *x) {
  (void)data;
  for (int k = 0; k <= order; k++) x[k] = lam_v3(2 * cos(t + k * M_PI_2), sin(t + k * M_PI_2), 0);
}

static void test_fairness_figures(void **state) {
  (void)state;
  lam_curve curve = {wave, NULL, 0, 3 * LAM_PI, 0, NULL};
  lam_fairness f = lam_curve_fairness(arena, &curve, 64);
  assert_int_equal(f.inflections, 3);
  near(f.curvature_variation, 6, 1e-3); /* |k| goes 1, 0, 1, 0, 1, 0, 1: six times 1 */
  curve = (lam_curve){helix, NULL, 0, 2 * LAM_PI, 0, NULL};
  f = lam_curve_fairness(arena, &curve, 16);
  near(f.bending, 0.0144 * 10 * LAM_PI, 1e-12);
  near(f.curvature_change, 0, 1e-20);
  curve = (lam_curve){ellipse, NULL, 0, 2 * LAM_PI, 0, NULL};
  f = lam_curve_fairness(arena, &curve, 64);
  assert_int_equal(f.inflections, 0);
  near(f.curvature_variation, 4 * (2 - 0.25),
       1e-9); /* curvature between a/b^2 = 2 and b/a^2 = 1/4 */
  const lam_vec3 points[] = {{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}};
  const double knots[] = {0, 0, 0, 1, 1, 1};
  lam_spline_curve parabola = {2, 3, knots, points, NULL};
  curve = lam_curve_of_spline(arena, &parabola);
  f = lam_curve_fairness(arena, &curve, 32);
  assert_int_equal(f.inflections, 0);
  near(f.curvature_variation, 2 - 2 / pow(5, 1.5), 1e-12);
  near(f.curvature_jump, 0, 0);
  /* integral of 4 / (1 + 4 t^2)^(5/2) dt with s = 2 t: 2 (s/(1+s^2)^(1/2) - s^3/(3 (1+s^2)^(3/2)))
   * at s = 2 */
  near(f.bending, 2 * (2 / sqrt(5) - 8 / (3 * pow(5, 1.5))), 1e-12);
}

/* Half a circle with a dent of 6 % at one of 13 points: the curve turns the other way in the dent,
 * so it has two inflections that a fair one has not. */
static lam_spline_curve bumpy(void) {
  enum { COUNT = 13 };
  lam_vec3 points[COUNT];
  for (int i = 0; i < COUNT; i++) {
    double a = LAM_PI * i / (COUNT - 1), r = i == 6 ? 0.94 : 1;
    points[i] = lam_v3(r * cos(a), r * sin(a), 0);
  }
  return lam_interpolate_points(arena, LAM_ENDS_NATURAL, 3, LAM_PARAMETERS_UNIFORM, COUNT, points);
}

static void test_fairing_by_energy(void **state) {
  (void)state;
  lam_spline_curve c = bumpy();
  lam_fairing report;
  for (int order = 2; order <= 3; order++) {
    lam_spline_curve d = lam_fair_by_energy(arena, c, order, 2, 0.08, &report);
    assert_int_equal(report.before.inflections, 2);
    assert_int_equal(report.after.inflections, 0);
    assert_true(report.after.curvature_change < 0.2 * report.before.curvature_change);
    assert_true(report.moved <= 0.08 && report.moved > 0.02);
    for (int i = 0; i < 2; i++) {
      near3(d.points[i], c.points[i], 0);
      near3(d.points[c.count - 1 - i], c.points[c.count - 1 - i], 0);
    }
  }
  lam_fair_by_energy(arena, c, 3, 2, 0.001, &report); /* little room: little change */
  assert_true(report.moved <= 0.001 && report.moved > 0.00099);
}

static void test_fairing_by_knots(void **state) {
  (void)state;
  lam_spline_curve c = bumpy();
  lam_fairing report;
  lam_spline_curve d = lam_fair_by_knots(arena, c, 40, 0.08, &report);
  assert_int_equal(report.before.inflections, 2);
  assert_int_equal(report.after.inflections, 0);
  assert_true(report.after.curvature_change < 0.3 * report.before.curvature_change);
  assert_true(report.moved <= 0.08 * (1 + 1e-12));
  near3(d.points[0], c.points[0], 0);
  lam_spline_curve once = lam_fair_by_knots(arena, c, 1, 1, &report);
  int moved = 0;
  for (int i = 0; i < c.count; i++) moved += lam_distance(once.points[i], c.points[i]) > 1e-12;
  assert_true(moved >= 1 && moved <= 2);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_interpolation_meets_points), TEST(test_cubic_ends),
      TEST(test_local_interpolation),        TEST(test_least_squares),
      TEST(test_least_squares_limits),       TEST(test_fairness_figures),
      TEST(test_fairing_by_energy),          TEST(test_fairing_by_knots),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
