/* Fairness and fairing of surfaces, curves on them, Ferguson patches and local interpolation. */
#include "core/numbers.h"
#include "curve/frenet.h"
#include "curve/hermite.h"
#include "curve/length.h"
#include "surf/spline/curve_on.h"
#include "surf/spline/ferguson.h"
#include "surf/spline/spline_through.h"
#include "surf/spline/surface_fairness.h"
#include "tests/unit/spline_surface_fixture.h"

/* A quarter of a cone or cylinder about the z axis: radius a at z = 0, b at z = h; u around, v up.
 */
static lam_spline_surface quarter(double a, double b, double h) {
  static const double arc[] = {0, 0, 0, 1, 1, 1}, line[] = {0, 0, 1, 1};
  static const double weights[] = {1, 1, 0.70710678118654752, 0.70710678118654752, 1, 1};
  lam_vec3 *p = LAM_NEW(arena, lam_vec3, 6);
  for (int i = 0; i < 6; i++) {
    double r = i % 2 ? b : a;
    p[i] = lam_v3(i / 2 < 2 ? r : 0, i / 2 > 0 ? r : 0, i % 2 ? h : 0);
  }
  return (lam_spline_surface){NULL, {2, 1}, {3, 2}, {arc, line}, p, weights};
}

/* Cylinder of radius 2 and height 3: k = 1/2 on an area 3 pi. Cone of slant lengths v0 = 2, v1 = 4
 * and half angle 30 degrees: k = cot a / v, H = k / 2, so that integral k^2 = (pi/2) sin a cot^2 a
 * log(v1/v0) and integral |H_v|^2 = (pi/2) sin a cot^2 a / 8 (1/v0^2 - 1/v1^2). */
static void test_known_figures(void **state) {
  (void)state;
  lam_spline_surface s = quarter(2, 2, 3);
  lam_surface_fairness f = lam_spline_surface_fairness(arena, &s, 8);
  near(f.bending, 3 * LAM_PI / 4, 1e-7);
  near(f.curvature_change, 0, 1e-12);
  assert_int_equal(f.inflections, 0);
  s = quarter(1, 2, sqrt(3)); /* radius = v / 2, height = v cos 30 */
  f = lam_spline_surface_fairness(arena, &s, 8);
  near(f.bending, LAM_PI / 2 * 0.5 * 3 * log(2), 1e-6);
  near(f.curvature_change, LAM_PI / 2 * 0.5 * 3 / 8 * (1 / 4.0 - 1 / 16.0), 1e-5);
  near(f.curvature_jump, 0, 0);
}

/* A cubic graph z = c x^3 turns once on every line along x. At a knot of a
 * biquadratic surface H jumps: z = 0 for x < 1, z = (x - 1)^2 / 2 beyond, so H jumps by 1/2. */
static void test_inflections_and_jumps(void **state) {
  (void)state;
  static const double cubic[] = {-1, -1, -1, -1, 1, 1, 1, 1}, line[] = {0, 0, 1, 2, 2};
  lam_vec3 net[12];
  const double z[] = {-1, 1, -1, 1}; /* Bezier points of x^3 over [-1, 1] */
  for (int i = 0; i < 12; i++) net[i] = lam_v3(-1 + i / 3 * 2 / 3.0, i % 3, 0.2 * z[i / 3]);
  lam_spline_surface s = {NULL, {3, 1}, {4, 3}, {cubic, line}, net, NULL};
  lam_surface_fairness f = lam_spline_surface_fairness(arena, &s, 10);
  assert_int_equal(f.inflections, 2); /* one on each of two lines */
  static const double quadratic[] = {0, 0, 0, 1, 2, 2, 2};
  const double x[] = {0, 0.5, 1.5, 2}, height[] = {0, 0, 0, 0.5};
  for (int i = 0; i < 12; i++) net[i] = lam_v3(x[i / 3], i % 3, height[i / 3]);
  s = (lam_spline_surface){NULL, {2, 1}, {4, 3}, {quadratic, line}, net, NULL};
  f = lam_spline_surface_fairness(arena, &s, 10);
  near(f.curvature_jump, 0.5, 1e-9);
}

/* A shallow cap of 10 x 9 cubic points with one point pushed in by .2. */
static lam_spline_surface bumpy(void) {
  enum { M = 10, N = 9 };
  lam_vec3 *net = LAM_NEW(arena, lam_vec3, M * N);
  lam_spline_surface s = {NULL, {3, 3}, {M, N}, {NULL, NULL}, net, NULL};
  for (int d = 0; d < 2; d++) {
    double *knots = LAM_NEW(arena, double, s.count[d] + 4);
    lam_knots_clamped(3, s.count[d], knots);
    s.knots[d] = knots;
  }
  for (int i = 0; i < M * N; i++) {
    double x = 0, y = 0; /* at the knot averages, so that parameters are even */
    for (int k = 1; k <= 3; k++) {
      x += (s.knots[0][i / N + k] * 4 - 2) / 3;
      y += (s.knots[1][i % N + k] * 4 - 2) / 3;
    }
    net[i] = lam_v3(x, y, -0.08 * (x * x + y * y));
  }
  net[4 * N + 4].z -= 0.2;
  return s;
}

static void check_rings(const lam_spline_surface *a, const lam_spline_surface *b, int rings) {
  int m = a->count[0], n = a->count[1];
  for (int i = 0; i < m * n; i++) {
    int r = i / n, c = i % n;
    if (r < rings || r >= m - rings || c < rings || c >= n - rings)
      near3(b->points[i], a->points[i], 0);
  }
}

static void test_fairing_by_energy(void **state) {
  (void)state;
  lam_spline_surface s = bumpy();
  lam_surface_fairing report;
  lam_spline_surface t = lam_surface_fair_by_energy(arena, &s, 2, 0.15, &report);
  assert_int_equal(report.before.inflections,
                   8); /* two on each of the four lines through the dent */
  assert_int_equal(report.after.inflections, 0);
  assert_true(report.after.bending < 0.7 * report.before.bending);
  assert_true(report.after.curvature_change < 0.03 * report.before.curvature_change);
  assert_true(report.moved <= 0.15 && report.moved > 0.1499);
  check_rings(&s, &t, 2);
  lam_surface_fair_by_energy(arena, &s, 1, 0.001, &report); /* little room: little change */
  assert_true(report.moved <= 0.001 && report.moved > 0.00099);
}

static void test_fairing_by_knots(void **state) {
  (void)state;
  lam_spline_surface s = bumpy();
  lam_surface_fairing report;
  lam_spline_surface t = lam_surface_fair_by_knots(arena, &s, 40, 0.15, &report);
  assert_true(report.after.inflections < report.before.inflections);
  assert_true(report.after.curvature_change < 0.3 * report.before.curvature_change);
  assert_true(report.moved <= 0.15 * (1 + 1e-12));
  check_rings(&s, &t, 1);
  t = lam_surface_fair_by_knots(arena, &s, 1, 1, &report); /* one knot moves one or two rows */
  int rows = 0, columns = 0;
  for (int d = 0; d < 2; d++)
    for (int i = 0; i < s.count[d]; i++) {
      bool moved = false;
      for (int j = 0; j < s.count[1 - d]; j++) {
        int at = d ? j * s.count[1] + i : i * s.count[1] + j;
        moved = moved || lam_distance(s.points[at], t.points[at]) > 1e-12;
      }
      *(d ? &columns : &rows) += moved;
    }
  assert_true((rows >= 1 && rows <= 2) || (columns >= 1 && columns <= 2));
}

/* ---- curves on surfaces ---- */

static void test_curves_on_surfaces(void **state) {
  (void)state;
  static const double knots[] = {0, 0, 1, 1};
  const lam_vec3 around[] = {{0, 0.3, 0}, {1, 0.3, 0}};
  lam_spline_surface s = quarter(2, 2, 3);
  lam_spline_curve plane = {1, 2, knots, around, NULL};
  lam_curve c = lam_curve_on_surface(arena, &s, &plane);
  near(lam_curve_length(&c, 0, 1, 1e-12), LAM_PI, 1e-10);
  for (int i = 0; i <= 10; i++) {
    lam_vec3 x[4];
    c.eval(c.data, i / 10.0, 3, x);
    lam_frenet f = lam_frenet_frame(x + 1);
    near(f.curvature, 0.5, 1e-12);
    near(f.torsion, 0, 1e-12);
  }
  for (int k = 0; k < 6;
       k++) { /* derivatives against differences, extrapolated to an error of order h^6 */
    lam_vec3 net[24];
    double weights[24];
    for (int i = 0; i < 24; i++) {
      net[i] = next_point();
      weights[i] = next_in(0.5, 2);
    }
    const double u[] = {0, 0, 0, 0, 1, 1, 1, 1}, v[] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    s = (lam_spline_surface){NULL, {3, 5}, {4, 6}, {u, v}, net, k % 2 ? weights : NULL};
    const lam_vec3 path[] = {{0.1, 0.2, 0}, {0.9, 0.3, 0}, {0.2, 0.9, 0}, {0.8, 0.7, 0}};
    plane = (lam_spline_curve){3, 4, u, path, NULL};
    c = lam_curve_on_surface(arena, &s, &plane);
    const double factors[] = {1.5, -0.6, 0.1};
    double t = next_in(0.2, 0.8), h = 1e-3;
    lam_vec3 at[4], low[4], high[4], sum[3] = {{0, 0, 0}};
    c.eval(c.data, t, 3, at);
    for (int m = 1; m <= 3; m++) {
      c.eval(c.data, t - m * h, 3, low);
      c.eval(c.data, t + m * h, 3, high);
      for (int d = 0; d < 3; d++)
        sum[d] = lam_along(sum[d], factors[m - 1] / (2 * m * h), lam_sub(high[d], low[d]));
    }
    for (int d = 0; d < 3; d++) near3(sum[d], at[d + 1], 1e-7 * (1 + lam_length(at[d + 1])));
  }
}

/* ---- bicubic patches ---- */

static lam_vec3 bicubic(const lam_vec3 b[16], double u, double v) {
  lam_vec3 rows[4], x;
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  for (int i = 0; i < 4; i++)
    rows[i] = point_at(&(lam_spline_curve){3, 4, knots, b + 4 * i, NULL}, v);
  x = point_at(&(lam_spline_curve){3, 4, knots, rows, NULL}, u);
  return x;
}

/* The Bezier form has the values of x(u,v) = sum_kl h_k(u) h_l(v) data_kl with Hermite's cubics;
 * and turns back. */
static void test_ferguson(void **state) {
  (void)state;
  for (int k = 0; k < 5; k++) {
    lam_ferguson p;
    lam_vec3 b[16];
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++) {
        p.x[i][j] = next_point();
        p.u[i][j] = next_point();
        p.v[i][j] = next_point();
        p.uv[i][j] = next_point();
      }
    lam_ferguson_to_bezier(&p, b);
    for (int n = 0; n < 20; n++) {
      double u = next_in(0, 1), v = next_in(0, 1), f[4], g[4];
      lam_hermite_basis(u, f);
      lam_hermite_basis(v, g);
      lam_vec3 x = {0, 0, 0};
      for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
          x = lam_along(lam_along(x, f[i] * g[j], p.x[i][j]), f[2 + i] * g[j], p.u[i][j]);
          x = lam_along(lam_along(x, f[i] * g[2 + j], p.v[i][j]), f[2 + i] * g[2 + j], p.uv[i][j]);
        }
      near3(bicubic(b, u, v), x, 1e-14);
    }
    lam_ferguson back = lam_ferguson_from_bezier(b);
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++) {
        near3(back.x[i][j], p.x[i][j], 1e-13);
        near3(back.u[i][j], p.u[i][j], 1e-13);
        near3(back.v[i][j], p.v[i][j], 1e-13);
        near3(back.uv[i][j], p.uv[i][j], 1e-13);
      }
  }
}

static lam_vec3 biquadratic(double u, double v) {
  return lam_v3(u + 0.2 * v * v * u * u, v - 0.1 * u * u, u * u * v * v - u * v + 0.5 * u * u);
}

/* Points are met; polynomials of degree 2 in each parameter come back, which Bessel's tangents know
 * exactly; tangent planes are continuous; a moved point moves nothing beyond two rows. */
static void test_local_interpolation(void **state) {
  (void)state;
  enum { M = 7, N = 6 };
  const int count[] = {M, N};
  const double t0[M] = {0, 0.1, 0.3, 0.4, 0.7, 0.8, 1},
               t1[N] = {0, 0.3, 0.4, 0.5, 0.9, 1}, *const t[] = {t0, t1};
  lam_vec3 points[M * N];
  for (int i = 0; i < M * N; i++) points[i] = biquadratic(t0[i / N], t1[i % N]);
  lam_spline_surface s = lam_surface_through_local(arena, count, t, points);
  for (int i = 0; i < 60; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    near3(at(&s, u, v), biquadratic(u, v), 1e-13);
  }
  for (int i = 0; i < M * N; i++) points[i] = lam_along(points[i], 0.3, next_point());
  s = lam_surface_through_local(arena, count, t, points);
  for (int i = 0; i < M * N; i++) near3(at(&s, t0[i / N], t1[i % N]), points[i], 1e-14);
  for (int d = 0; d < 2; d++)
    for (int i = 0; i < s.count[d]; i++)
      assert_true(lam_bspline_multiplicity(&(lam_bspline){3, s.count[d], 3, s.knots[d], NULL},
                                           s.knots[d][i]) <= 4);
  for (int i = 0; i < 20; i++) {
    double v = next_in(0, 1);
    lam_vec3 before[4], after[4];
    lam_spline_surface_derivatives(&s, nextafter(0.4, 0), v, 1, before);
    lam_spline_surface_derivatives(&s, 0.4, v, 1, after);
    for (int k = 0; k < 3; k++) near3(before[k], after[k], 1e-12);
  }
  points[3 * N + 2].z += 1; /* at (.4, .4): rows 1 to 5, columns 0 to 4 */
  lam_spline_surface moved = lam_surface_through_local(arena, count, t, points);
  for (int i = 0; i < 60; i++) {
    double u = next_in(0, 1), v = next_in(0, 1), far = lam_distance(at(&s, u, v), at(&moved, u, v));
    if (u < 0.1 || u > 0.8 || v > 0.9) near(far, 0, 1e-14);
  }
  near(lam_distance(at(&s, 0.4, 0.4), at(&moved, 0.4, 0.4)), 1, 1e-13);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_known_figures),       TEST(test_inflections_and_jumps),
      TEST(test_fairing_by_energy),   TEST(test_fairing_by_knots),
      TEST(test_curves_on_surfaces),  TEST(test_ferguson),
      TEST(test_local_interpolation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
