/* Every listed surface: derivatives, its keys, and what each kind promises about positions. */
#include "core/numbers.h"
#include "surf/elliptic.h"
#include "tests/unit/surface_fixture.h"

static void check_derivatives(const lam_surface *s, double u, double v, double hu, double hv) {
  const char *name = s->kind->head.name;
  lam_jet at, low, high, by_u = {0}, by_v = {0};
  for (int k = 1; k <= 3; k++) {
    double factor_u = weights[k - 1] / (2 * k * hu), factor_v = weights[k - 1] / (2 * k * hv);
    lam_surface_eval(s, u - k * hu, v, &low);
    lam_surface_eval(s, u + k * hu, v, &high);
    by_u.x = lam_along(by_u.x, factor_u, lam_sub(high.x, low.x));
    by_u.u = lam_along(by_u.u, factor_u, lam_sub(high.u, low.u));
    by_u.v = lam_along(by_u.v, factor_u, lam_sub(high.v, low.v));
    lam_surface_eval(s, u, v - k * hv, &low);
    lam_surface_eval(s, u, v + k * hv, &high);
    by_v.x = lam_along(by_v.x, factor_v, lam_sub(high.x, low.x));
    by_v.u = lam_along(by_v.u, factor_v, lam_sub(high.u, low.u));
    by_v.v = lam_along(by_v.v, factor_v, lam_sub(high.v, low.v));
  }
  lam_surface_eval(s, u, v, &at);
  assert_near3(at.u, by_u.x, 1e-9, name, "x_u", u, v);
  assert_near3(at.v, by_v.x, 1e-9, name, "x_v", u, v);
  assert_near3(at.uu, by_u.u, 1e-9, name, "x_uu", u, v);
  assert_near3(at.uv, by_u.v, 1e-9, name, "x_uv by u", u, v);
  assert_near3(at.uv, by_v.u, 1e-9, name, "x_uv by v", u, v);
  assert_near3(at.vv, by_v.v, 1e-9, name, "x_vv", u, v);
}

static void check_all_derivatives(lam_fixture *f, const lam_surface *s) {
  double p[2], q[2];
  bool closed[2];
  assert_true(s->kind->domain(s->data, LAM_CHART_NATURAL, p, q, closed));
  assert_true(p[0] < p[1] && q[0] < q[1]);
  for (int i = 0; i < POINTS; i++)
    check_derivatives(s, next_in(f, p), next_in(f, q), 2e-3 * (p[1] - p[0]), 2e-3 * (q[1] - q[0]));
}

/* Derivatives of every surface with its defaults against differences of the positions and first
 * derivatives. */
static void test_derivatives(void **state) {
  lam_fixture *f = *state;
  for (int i = 0; i < lam_surfaces.count; i++) {
    const char *name = lam_surfaces.rows[i]
                           ->name; /* differences across a knot see the jump of third derivatives */
    lam_surface s = made(f, name, strcmp(name, "least-area") == 0 ? "spans: 1" : "");
    check_all_derivatives(f, &s);
  }
}

/* The same away from the defaults. */
static void test_derivatives_of_variants(void **state) {
  lam_fixture *f = *state;
  static const char *const variants[][2] = {
      {"enneper", "order: 2"},
      {"enneper", "order: 5"},
      {"helicoid", "hand: left"},
      {"unduloid", "neck: 0.05"},
      {"unduloid", "neck: 1"},
      {"nodoid", "neck: 0.8"},
      {"torus", "{ring: 2, tube: 1.9}"},
      {"ellipsoid", "axes: [1, 3, 2]"},
      {"constant-ratio", "angle: 35 deg"},
      {"constant-ratio", "angle: 140 deg"},
      {"monge", "{xy: 0.3, x3: 1, x2y: 0.2, xy2: -3, y3: 0.1, x4: 0.2, x3y: -0.4, x2y2: 0.3, xy3: "
                "0.6, y4: -0.5}"},
      {"revolution", "{profile: [0, 0, 1, 0.5, 1.4, 2], unit: cm}"},
      {"bezier", "{count: [2, 3], points: [0,0,0, 0,1,1, 0,2,0, 1,0,1, 1,1,0, 1,2,2], weights: "
                 "[1,2,1, 1,3,1], unit: mm}"},
      {"nurbs",
       "{degree: [1, 2], count: [2, 3], knots_v: [0, 1, 2, 3, 4, 5], weights: [1, 2, 1, 1, 3, 1],"
       " points: [0,0,0, 0,1,1, 0,2,0, 1,0,1, 1,1,0, 1,2,2]}"},
  };
  for (size_t i = 0; i < sizeof variants / sizeof variants[0]; i++) {
    lam_surface s = made(f, variants[i][0], variants[i][1]);
    check_all_derivatives(f, &s);
  }
}

/* For angle 60 deg, a = 3: dz/dv = cosh(3v)^(-2/3). Expected heights from a composite Simpson rule
 * with 2^16 steps, inside the table and beyond it; for 90 deg the catenoid, z = v. */
static void test_constant_ratio_height(void **state) {
  lam_fixture *f = *state;
  lam_surface s = made(f, "constant-ratio", ""),
              catenoid = made(f, "constant-ratio", "angle: 90 deg");
  const double places[] = {0.05, -0.7, 3, 15, -40};
  for (int i = 0; i < 5; i++) {
    int steps = 1 << 16;
    double v = places[i], h = v / steps, sum = 0;
    for (int k = 0; k <= steps; k++)
      sum += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * pow(cosh(3 * k * h), -2.0 / 3);
    assert_near_at(lam_surface_point(&s, LAM_CHART_NATURAL, 0, 1, v).z, sum * h / 3, 1e-12,
                   "constant-ratio", "z", 1, v);
    assert_near_at(lam_surface_point(&catenoid, LAM_CHART_NATURAL, 0, 1, v).z, v, 1e-13 * fabs(v),
                   "catenoid", "z", 1, v);
  }
}

/* A rational quadratic by linear NURBS patch with the weights of a quarter circle is a cylinder of
 * radius 1; the closed nine-point circle closes up. */
static void test_nurbs_cylinder(void **state) {
  lam_fixture *f = *state;
  lam_surface s =
      made(f, "nurbs",
           "degree: [2, 1]\ncount: [9, 2]\nknots_u: [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]\n"
           "points: [1,0,0, 1,0,2, 1,1,0, 1,1,2, 0,1,0, 0,1,2, -1,1,0, -1,1,2, -1,0,0, -1,0,2, "
           "-1,-1,0, -1,-1,2,"
           " 0,-1,0, 0,-1,2, 1,-1,0, 1,-1,2, 1,0,0, 1,0,2]\n"
           "weights: [1, 1, 0.70710678118654752, 0.70710678118654752, 1, 1, 0.70710678118654752, "
           "0.70710678118654752,"
           " 1, 1, 0.70710678118654752, 0.70710678118654752, 1, 1, 0.70710678118654752, "
           "0.70710678118654752, 1, 1]\n");
  double p[2], q[2];
  bool closed[2];
  assert_true(s.kind->domain(s.data, LAM_CHART_NATURAL, p, q, closed));
  assert_true(p[0] == 0 && p[1] == 4 && q[0] == 0 && q[1] == 1 && closed[0] && !closed[1]);
  for (int i = 0; i <= 100; i++) {
    lam_jet jet;
    lam_surface_eval(&s, 0.04 * i, 0.01 * i, &jet);
    lam_curvature c = lam_jet_curvature(&jet);
    assert_near_at(hypot(jet.x.x, jet.x.y), 1, 1e-15, "nurbs", "radius", 0.04 * i, 0.01 * i);
    assert_near_at(c.k2, -1, 1e-12, "nurbs", "k2", 0.04 * i, 0.01 * i);
    assert_near_at(c.k1, 0, 1e-12, "nurbs", "k1", 0.04 * i, 0.01 * i);
  }
}

/* A B-spline surface without inner knots is the Bezier surface of the same points. */
static void test_bezier_is_bspline(void **state) {
  lam_fixture *f = *state;
  lam_surface bezier = made(f, "bezier", ""), bspline = made(f, "bspline", "");
  for (int i = 0; i <= 10; i++)
    assert_near3(lam_surface_point(&bezier, LAM_CHART_NATURAL, 0, 0.1 * i, 1 - 0.07 * i),
                 lam_surface_point(&bspline, LAM_CHART_NATURAL, 0, 0.1 * i, 1 - 0.07 * i), 1e-15,
                 "bezier", "point", 0.1 * i, 0);
}

/* m = 0 is trigonometric; for m = 1/2, K = Gamma(1/4)^2 / (4 sqrt pi) and E = K/2 + pi/(4K)
 * (Abramowitz & Stegun 17.3). For other m, sn' = cn dn and epsilon' = dn^2, by differences. */
static void test_elliptic(void **state) {
  (void)state;
  lam_elliptic half = lam_elliptic_make(0.5), none = lam_elliptic_make(1);
  double k = tgamma(0.25) * tgamma(0.25) / (4 * sqrt(LAM_PI));
  assert_near_at(half.quarter, k, 1e-15, "elliptic", "K", 0.5, 0);
  assert_near_at(half.slope * half.quarter, k / 2 + LAM_PI / (4 * k), 1e-15, "elliptic", "E", 0.5,
                 0);
  for (double x = -9; x < 9; x += 0.37) {
    lam_jacobi j = lam_jacobi_eval(&none, x);
    assert_near_at(j.sn, sin(x), 1e-14, "elliptic", "sin", x, 0);
    assert_near_at(j.epsilon, x, 1e-14, "elliptic", "length", x, 0);
  }
  for (double complement = 1e-4; complement < 1; complement *= 3) {
    lam_elliptic e = lam_elliptic_make(complement);
    for (double x = -9; x < 9; x += 0.37) {
      const double h = 1e-2;
      lam_jacobi at = lam_jacobi_eval(&e, x);
      double slope = 0, sine = 0;
      for (int i = 1; i <= 3; i++) {
        lam_jacobi low = lam_jacobi_eval(&e, x - i * h), high = lam_jacobi_eval(&e, x + i * h);
        slope += weights[i - 1] * (high.epsilon - low.epsilon) / (2 * i * h);
        sine += weights[i - 1] * (high.sn - low.sn) / (2 * i * h);
      }
      assert_near_at(slope, at.dn * at.dn, 2e-11, "elliptic", "dn^2", complement, x);
      assert_near_at(sine, at.cn * at.dn, 2e-11, "elliptic", "cn dn", complement, x);
      assert_near_at(at.sn * at.sn + at.cn * at.cn, 1, 1e-15, "elliptic", "sn^2 + cn^2", complement,
                     x);
    }
  }
}

/* What cannot be built is refused, with a message that says why. */
static void test_refused(void **state) {
  lam_fixture *f = *state;
  static const char *const cases[][3] = {
      {"torus", "{ring: 1, tube: 2}", "smaller than ring"},
      {"hyperbolic-paraboloid", "corners: [0,0,1, 1,0,1, 1,1,1, 0,1,1]", "one plane"},
      {"revolution", "profile: [1, 0, 2]", "at least 2 points"},
      {"revolution", "profile: [1, 0, 1, 0]", "the same"},
      {"revolution", "profile: [1, 0, -1, 1]", "distance from the axis"},
      {"revolution", "profile: [2, 0, 0.01, 1, 0.01, 2, 2, 3]", "reaches the axis"},
      {"nurbs", "count: [3, 4]", "expected 36"},
      {"nurbs", "degree: [4, 3]", "at most 3"},
      {"nurbs", "knots_u: [0, 0, 0, 0, 1, 1, 1]", "as many"},
      {"nurbs", "weights: [1, 2]", "one per point"},
      {"bezier", "weights: [1,1,1,1, 1,0,1,1, 1,1,1,1, 1,1,1,1]", "positive"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    assert_null(make(f, cases[i][0], cases[i][1]).kind);
    const lam_error *found = f->errors.first;
    while (found && !strstr(found->text, cases[i][2])) found = found->next;
    if (!found) fail_msg("%s with %s: no message with '%s'", cases[i][0], cases[i][1], cases[i][2]);
  }
}

/* The curvature of a singular point is NaN with a zero normal. */
static void test_singular(void **state) {
  (void)state;
  lam_jet jet = {.u = {1, 2, 3}, .v = {2, 4, 6}, .uu = {1, 0, 0}};
  lam_curvature c = lam_jet_curvature(&jet);
  assert_true(isnan(c.K) && isnan(c.H) && isnan(c.k1) && isnan(c.k2) && lam_length(c.normal) == 0);
}

/* Every row says what it is, and every key what it means. */
static void test_rows(void **state) {
  (void)state;
  for (int i = 0; i < lam_surfaces.count; i++) {
    const lam_row_head *head = lam_surfaces.rows[i];
    assert_true(head->name && head->title && head->equation && head->source &&
                strlen(head->doc) > 100);
    assert_ptr_equal(lam_registry_find(&lam_surfaces, head->name), head);
    for (const lam_key *key = head->keys; key && key->name; key++)
      assert_true(key->doc && key->initial);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_derivatives),
      TEST(test_derivatives_of_variants),
      TEST(test_constant_ratio_height),
      TEST(test_nurbs_cylinder),
      TEST(test_bezier_is_bspline),
      TEST(test_elliptic),
      TEST(test_refused),
      TEST(test_singular),
      TEST(test_rows),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
