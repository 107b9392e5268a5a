/* Dense linear algebra, quadrature, collocation and minimization. */
#include "core/numeric/dense.h"
#include "core/numeric/minimize.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/collocation.h"
#include "tests/unit/net_fixture.h"

enum { N = 12 };

/* Random systems with known solutions. */
static void test_solvers(void **state) {
  net_fixture *f = *state;
  double a[N * N], spd[N * N] = {0}, x[N], b[N] = {0}, c[N] = {0};
  int pivot[N];
  for (int i = 0; i < N * N; i++) a[i] = net_random(f);
  for (int i = 0; i < N; i++) x[i] = net_random(f);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      for (int k = 0; k < N; k++) spd[i * N + j] += a[i * N + k] * a[j * N + k];
      b[i] += a[i * N + j] * x[j];
    }
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) c[i] += spd[i * N + j] * x[j];
  assert_true(lam_lu_factor(N, a, pivot));
  lam_lu_solve(N, a, pivot, b);
  assert_true(lam_cholesky_factor(N, spd));
  lam_cholesky_solve(N, spd, c);
  for (int i = 0; i < N; i++) {
    assert_near(b[i], x[i], 1e-11);
    assert_near(c[i], x[i], 1e-8);
  }
  double indefinite[] = {1, 2, 2, 1}, singular[] = {1, 2, 2, 4};
  assert_false(lam_cholesky_factor(2, indefinite));
  assert_false(lam_lu_factor(2, singular, pivot));
}

/* diag(1, 1e-12) turned by 30 degrees on both sides: the small singular value keeps its digits. */
static void test_singular_values(void **state) {
  (void)state;
  double c = sqrt(0.75), s = 0.5, t = 1e-12, sigma[2], v[4];
  double a[] = {c * c + t * s * s, c * s - t * c * s, c * s - t * c * s, s * s + t * c * c};
  lam_singular_values(2, a, sigma, v);
  assert_near(sigma[0], 1, 1e-14);
  assert_near(sigma[1], 1e-12, 1e-16);
  assert_near(fabs(v[3] * c - v[1] * s), 1, 1e-3);
}

/* min x^2 + y^2 + z^2 with x + y + z = 3 is (1,1,1), with the condition given twice too; two
 * different sums contradict; without z in the energy and free z there is no unique minimum. */
static void test_least_energy(void **state) {
  net_fixture *f = *state;
  double h[] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, g[3] = {0}, c[] = {1, 1, 1, -2, -2, -2}, d[] = {3, -6},
         x[3];
  assert_int_equal(lam_least_energy(f->arena, 3, h, g, 2, c, d, 1e-9, x), LAM_LEAST_FOUND);
  for (int i = 0; i < 3; i++) assert_near(x[i], 1, 1e-14);
  d[1] = 5;
  assert_int_equal(lam_least_energy(f->arena, 3, h, g, 2, c, d, 1e-9, x), LAM_LEAST_CONTRADICTORY);
  h[8] = 0;
  assert_int_equal(lam_least_energy(f->arena, 3, h, g, 0, c, d, 1e-9, x), LAM_LEAST_FLAT);
}

/* t^(2n-1) integrates to 1/(2n), as exact as the rule is said to be; t^(2n) does not. */
static void test_quadrature(void **state) {
  (void)state;
  double places[40], weights[40];
  for (int n = 1; n <= 40; n++) {
    double sum = 0, total = 0, above = 0;
    lam_gauss_rule(n, places, weights);
    for (int k = 0; k < n; k++) {
      sum += weights[k] * pow(places[k], 2 * n - 1);
      above += weights[k] * pow(places[k], 2 * n);
      total += weights[k];
    }
    assert_near(sum, 0.5 / n, 1e-14);
    assert_near(total, 1, 1e-14);
    if (n < 6) assert_true(fabs(above - 1.0 / (2 * n + 1)) > 1e-9);
  }
}

/* A cubic in the space of quintic splines with inner knots: the spline from its values is the
 * cubic; elevation agrees.
 */
static void test_collocation(void **state) {
  net_fixture *f = *state;
  int count;
  const double inner[] = {0.3, 0.6}, *knots = lam_knots_repeat(f->arena, 5, 2, inner, 4, &count);
  assert_int_equal(count, 14);
  lam_collocation space = lam_collocation_make(f->arena, 5, count, knots);
  double values[14], bezier[6] = {1, -2, 4, 3}; /* Bezier points of the cubic */
#define CUBIC(t)                                                                                   \
  (pow(1 - (t), 3) - 6 * (t)*pow(1 - (t), 2) + 12 * (t) * (t) * (1 - (t)) + 3 * (t) * (t) * (t))
  for (int i = 0; i < 14; i++) values[i] = CUBIC(space.nodes[i]);
  lam_collocation_solve(f->arena, &space, 1, values);
  lam_bezier_elevate(3, 5, 1, bezier);
  for (int g = 0; g <= 20; g++) {
    double t = g / 20.0, row[6], sum = 0, raised = 0;
    static const int choose[] = {1, 5, 10, 10, 5, 1};
    int span = lam_basis_span(5, count, knots, t);
    lam_basis_eval(5, knots, span, t, 0, row);
    for (int j = 0; j < 6; j++) {
      sum += row[j] * values[span - 5 + j];
      raised += choose[j] * pow(t, j) * pow(1 - t, 5 - j) * bezier[j];
    }
    assert_near(sum, CUBIC(t), 1e-13);
    assert_near(raised, CUBIC(t), 1e-13);
  }
}

static double rosenbrock(void *data, const double *x) {
  ++*(int *)data;
  if (x[0] < -1.5) return INFINITY;
  return pow(1 - x[0], 2) + 100 * pow(x[1] - x[0] * x[0], 2);
}

/* The banana valley, from its usual start; the minimum is (1, 1). */
static void test_minimize(void **state) {
  (void)state;
  int calls = 0;
  double x[] = {-1.2, 1};
  assert_near(lam_minimize(2, rosenbrock, &calls, 200, x), 0, 1e-10);
  assert_near(x[0], 1, 1e-5);
  assert_near(x[1], 1, 1e-5);
  assert_true(calls < 1000);
}

int main(void) {
  const struct CMUnitTest tests[] = {NET_TEST(test_solvers),      NET_TEST(test_singular_values),
                                     NET_TEST(test_least_energy), NET_TEST(test_quadrature),
                                     NET_TEST(test_collocation),  NET_TEST(test_minimize)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
