/* Changes of spline curves: what must leave a curve as it is does, at random parameters. */
#include "tests/unit/curve_fixture.h"

enum { CURVES = 24 };
static const double exact = 1e-12; /* points are of size 1 */

/* Curves of degrees 1 to 6, every second one rational, every third one not clamped. */
static lam_spline_curve example(int k) {
  int degree = 1 + k % 6;
  return next_curve(degree, degree + 1 + k % 5 + k / 12, k % 2, k % 3 != 2);
}

/* Derivatives to order 3, polynomial and rational, against differences (extrapolated, error of
 * order h^6). */
static void test_derivatives(void **state) {
  (void)state;
  const double factors[] = {1.5, -0.6, 0.1};
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k);
    double t = 1.37, h = 2e-3;
    for (int i = 0; i < c.count + c.degree + 1; i++)
      if (fabs(c.knots[i] - t) < 4 * h) t += 8 * h;
    lam_vec3 at[4], low[4], high[4], sum[3] = {{0, 0, 0}};
    lam_spline_curve_eval(&c, t, 3, at);
    for (int m = 1; m <= 3; m++) {
      lam_spline_curve_eval(&c, t - m * h, 3, low);
      lam_spline_curve_eval(&c, t + m * h, 3, high);
      for (int d = 0; d < 3; d++)
        sum[d] = lam_along(sum[d], factors[m - 1] / (2 * m * h), lam_sub(high[d], low[d]));
    }
    for (int d = 0; d < 3; d++) near3(sum[d], at[d + 1], 1e-7 * (1 + lam_length(at[d + 1])));
  }
}

static void test_insertion(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), d = c;
    for (int times = 1; times <= c.degree; times++) {
      d = lam_spline_curve_insert(arena, d, next_in(1, 4), 1);
      d = lam_spline_curve_insert(arena, d, 2.5, times);
      same_curve(&c, &d, 1, 4, exact);
    }
    assert_int_equal(d.count, c.count + 2 * c.degree);
  }
}

/* Removal takes away exactly what insertion put in, and refuses a knot that matters. */
static void test_removal(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), d = lam_spline_curve_insert(arena, c, 2.2, c.degree);
    assert_int_equal(lam_spline_curve_remove(arena, &d, 2.2, c.degree, 1e-10), c.degree);
    assert_int_equal(d.count, c.count);
    for (int i = 0; i < c.count; i++) near3(d.points[i], c.points[i], 1e-11);
    double knot = c.knots[c.degree + 1];
    if (knot < 4) assert_int_equal(lam_spline_curve_remove(arena, &c, knot, 1, 1e-6), 0);
    assert_int_equal(lam_spline_curve_remove(arena, &c, 1, 1, 100), 0); /* no inner knot */
    assert_int_equal(lam_spline_curve_remove(arena, &c, 3.14159, 1, 100), 0);
  }
}

/* The reported deviation bounds the real one. */
static void test_removal_bound(void **state) {
  (void)state;
  for (int degree = 1; degree <= 5; degree++) {
    lam_spline_curve c = next_curve(degree, degree + 5, false, true);
    double deviation, largest = 0;
    lam_bspline less;
    assert_true(lam_bspline_remove(arena, lam_spline_curve_net(arena, &c, false),
                                   c.knots[degree + 1], 10, &less, &deviation));
    lam_spline_curve d = lam_spline_curve_from_net(arena, less);
    for (double t = 1; t <= 4; t += 0.001)
      largest = fmax(largest, lam_distance(point_at(&c, t), point_at(&d, t)));
    assert_true(largest <= deviation * (1 + 1e-12) && largest > 0.1 * deviation);
  }
}

static void test_elevation(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k);
    for (int more = 0; more <= 3; more++) {
      lam_spline_curve d = lam_spline_curve_elevate(arena, c, c.degree + more);
      same_curve(&c, &d, 1, 4, exact);
      assert_int_equal(d.degree, c.degree + more);
    }
  }
}

/* One degree more and back is the same; otherwise the ends stay and the bound holds. */
static void test_reduction(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), d = lam_spline_curve_elevate(arena, c, c.degree + 1), e;
    double deviation;
    for (int ends = 0; ends <= d.degree / 2; ends++) {
      e = lam_spline_curve_reduce(arena, d, ends, &deviation);
      assert_int_equal(e.degree, c.degree);
      assert_true(deviation <= 1e-11);
      same_curve(&c, &e, 1, 4, 1e-11);
    }
    if (c.degree < 3 || c.weights) continue;
    e = lam_spline_curve_reduce(arena, c, 2, &deviation);
    lam_vec3 x[2], y[2];
    double largest = 0;
    for (int end = 0; end < 2; end++) {
      lam_spline_curve_eval(&c, end ? 4 : 1, 1, x);
      lam_spline_curve_eval(&e, end ? 4 : 1, 1, y);
      near3(y[0], x[0], 1e-12);
      near3(y[1], x[1], 1e-10);
    }
    for (double t = 1; t <= 4; t += 0.003)
      largest = fmax(largest, lam_distance(point_at(&c, t), point_at(&e, t)));
    assert_true(largest <= deviation && largest > 0);
  }
}

/* Least squares: t^3 on [0,1] by a parabola without end conditions is 3/2 t^2 - 3/5 t + 1/20
 * (shifted Legendre). */
static void test_reduction_is_least_squares(void **state) {
  (void)state;
  const lam_vec3 points[] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  lam_spline_curve cubic = {3, 4, knots, points, NULL},
                   d = lam_spline_curve_reduce(arena, cubic, 0, NULL);
  for (double t = 0; t <= 1; t += 0.125)
    near(point_at(&d, t).x, 1.5 * t * t - 0.6 * t + 0.05, 1e-13);
}

/* Two parts, the pieces, and the way back. */
static void test_parts(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), low = lam_spline_curve_part(arena, c, 1, 2.3),
                     high = lam_spline_curve_part(arena, c, 2.3, 4),
                     whole = lam_spline_curve_part(arena, c, 1, 4);
    same_curve(&c, &low, 1, 2.3, exact);
    same_curve(&c, &high, 2.3, 4, exact);
    same_curve(&c, &whole, 1, 4, exact);
    near3(low.points[low.count - 1], high.points[0], exact);
    int count;
    const lam_spline_curve *pieces = lam_spline_curve_pieces(arena, c, &count);
    near(pieces[0].knots[0], 1, 0);
    near(pieces[count - 1].knots[2 * c.degree + 1], 4, 0);
    for (int i = 0; i < count; i++) {
      assert_int_equal(pieces[i].count, c.degree + 1);
      same_curve(&c, &pieces[i], pieces[i].knots[0], pieces[i].knots[2 * c.degree + 1], exact);
    }
  }
}

static void test_reversal_and_maps(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), back = lam_spline_curve_reverse(arena, c);
    lam_pose frame = {next_point(), {next_point(), next_point(), next_point()}};
    lam_spline_curve image = lam_spline_curve_map(arena, c, frame);
    assert_null(lam_spline_curve_problem(&back));
    for (int i = 0; i < 30; i++) {
      double t = next_in(1, 4);
      lam_vec3 x = point_at(&c, t), y = lam_along(frame.origin, x.x, frame.axis[0]);
      near3(point_at(&back, 5 - t), x, exact);
      near3(point_at(&image, t), lam_along(lam_along(y, x.y, frame.axis[1]), x.z, frame.axis[2]),
            exact);
    }
  }
}

/* The product with a scalar spline over other knots, and its smoothness at a knot that only one
 * factor has. */
static void test_product(void **state) {
  (void)state;
  for (int k = 0; k < CURVES; k++) {
    lam_spline_curve c = example(k), s = next_curve(1 + k % 4, 6, false, k % 2);
    double *scalar = LAM_NEW(arena, double, s.count);
    for (int i = 0; i < s.count; i++) scalar[i] = s.points[i].x;
    lam_bspline f = {s.degree, s.count, 1, s.knots, scalar};
    lam_spline_curve product = lam_spline_curve_scale(arena, f, c);
    assert_int_equal(product.degree, c.degree + s.degree);
    assert_null(lam_spline_curve_problem(&product));
    for (int i = 0; i < 40; i++) {
      double t = next_in(1, 4), value;
      lam_bspline_eval(&f, t, 0, &value);
      near3(point_at(&product, t), lam_scale(point_at(&c, t), value), exact);
    }
    lam_bspline net = lam_spline_curve_net(arena, &product, false);
    for (int i = s.degree + 1; i < s.count; i++) {
      int others = 0, own = lam_bspline_multiplicity(&f, s.knots[i]);
      for (int j = 0; j < c.count; j++) others += c.knots[j] == s.knots[i];
      if (!others) assert_int_equal(lam_bspline_multiplicity(&net, s.knots[i]), own + c.degree);
    }
  }
}

/* Splines of different degrees and knots after matching share both, and are what they were. */
static void test_matching(void **state) {
  (void)state;
  lam_spline_curve c[3] = {next_curve(2, 5, false, true), next_curve(4, 8, false, false),
                           next_curve(1, 3, false, true)};
  lam_bspline list[3];
  for (int k = 0; k < 3; k++) list[k] = lam_spline_curve_net(arena, &c[k], false);
  lam_bspline_match(arena, 3, list);
  for (int k = 0; k < 3; k++) {
    assert_int_equal(list[k].degree, 4);
    assert_int_equal(list[k].count, list[0].count);
    assert_ptr_equal(list[k].knots, list[0].knots);
    lam_spline_curve d = lam_spline_curve_from_net(arena, list[k]);
    same_curve(&c[k], &d, 1, 4, exact);
  }
}

/* .1, .2 ... .9 and i / 10 of another domain differ by rounding: matching makes one knot of two. */
static void test_matching_of_equal_knots(void **state) {
  (void)state;
  double knots[2][13], values[2][11];
  lam_bspline list[2];
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 13; i++) knots[k][i] = fmin(fmax(i - 1, 0), 10) * (k ? 0.7 : 0.1);
    for (int i = 0; i < 11; i++) values[k][i] = next_in(-1, 1);
    list[k] = lam_bspline_move_domain(arena, (lam_bspline){1, 11, 1, knots[k], values[k]}, 0, 1);
  }
  int different = 0;
  for (int i = 0; i < 13; i++) different += list[0].knots[i] != list[1].knots[i];
  assert_true(different > 0);
  lam_bspline_match(arena, 2, list);
  assert_int_equal(list[0].count, 11);
  assert_int_equal(list[1].count, 11);
  for (int i = 0; i < 11; i++) near(list[1].values[i], values[1][i], 1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_derivatives), TEST(test_insertion),
      TEST(test_removal),     TEST(test_removal_bound),
      TEST(test_elevation),   TEST(test_reduction),
      TEST(test_parts),       TEST(test_reduction_is_least_squares),
      TEST(test_product),     TEST(test_reversal_and_maps),
      TEST(test_matching),    TEST(test_matching_of_equal_knots),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
