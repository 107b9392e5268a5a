/* Charts of every listed surface, and the curvatures that its name promises. */
#include "core/numbers.h"
#include "tests/unit/surface_fixture.h"

/* The tangents of the chart lines at (p, q), as derivatives of the position, and as directions (du,
 * dv). */
typedef struct tangents {
  lam_jet jet;
  lam_curvature c;
  lam_vec3 x[2];
  double d[2][2];
} tangents;

/* Positions are differenced, not (u, v), which may jump by a full turn; (du, dv) are their
 * components along x_u and x_v. Near a branch point the steps are small against the distance from
 * it. */
static tangents chart_tangents(const lam_surface *s, lam_chart chart, int sector, double p,
                               double q) {
  tangents t = {0};
  bool branched = s->kind->sectors && s->kind->sectors(s->data, chart) > 0;
  double u, v, h = branched ? fmin(2e-3, 0.02 * fmin(p, q)) : 2e-3;
  for (int k = 1; k <= 3; k++) {
    double factor = weights[k - 1] / (2 * k * h);
    t.x[0] = lam_along(t.x[0], factor,
                       lam_sub(lam_surface_point(s, chart, sector, p + k * h, q),
                               lam_surface_point(s, chart, sector, p - k * h, q)));
    t.x[1] = lam_along(t.x[1], factor,
                       lam_sub(lam_surface_point(s, chart, sector, p, q + k * h),
                               lam_surface_point(s, chart, sector, p, q - k * h)));
  }
  s->kind->locate(s->data, chart, sector, p, q, &u, &v);
  lam_surface_eval(s, u, v, &t.jet);
  t.c = lam_jet_curvature(&t.jet);
  double determinant = t.c.E * t.c.G - t.c.F * t.c.F;
  for (int i = 0; i < 2; i++) {
    double a = lam_dot(t.x[i], t.jet.u), b = lam_dot(t.x[i], t.jet.v);
    t.d[i][0] = (t.c.G * a - t.c.F * b) / determinant;
    t.d[i][1] = (t.c.E * b - t.c.F * a) / determinant;
  }
  return t;
}

/* II of two chart directions, as a curvature relative to the larger principal curvature. */
static double relative_second(const tangents *t, int i, int j) {
  const double *a = t->d[i], *b = t->d[j];
  double second =
      t->c.L * a[0] * b[0] + t->c.M * (a[0] * b[1] + a[1] * b[0]) + t->c.N * a[1] * b[1];
  return second / (lam_length(t->x[i]) * lam_length(t->x[j]) * fmax(fabs(t->c.k1), fabs(t->c.k2)));
}

static void check_chart_at(const lam_surface *s, lam_chart chart, int sector, double p, double q) {
  const char *name = s->kind->head.name;
  tangents t = chart_tangents(s, chart, sector, p, q);
  double lengths = lam_length(t.x[0]) * lam_length(t.x[1]),
         across = lam_dot(t.x[0], t.x[1]) / lengths;
  lam_vec3 normal = lam_scale(lam_cross(t.x[0], t.x[1]), 1 / lengths);
  assert_true(lam_dot(normal, t.c.normal) > 0.1); /* the chart turns like the natural parameters */
  if (chart == LAM_CHART_ASYMPTOTIC) {
    assert_near_at(relative_second(&t, 0, 0), 0, 1e-9, name, "II(p,p)", p, q);
    assert_near_at(relative_second(&t, 1, 1), 0, 1e-9, name, "II(q,q)", p, q);
  }
  if (chart == LAM_CHART_PRINCIPAL) {
    assert_near_at(across, 0, 1e-9, name, "F", p, q);
    assert_near_at(relative_second(&t, 0, 1), 0, 1e-9, name, "M", p, q);
  }
  if (chart == LAM_CHART_DIAGONAL) { /* diagonals of squares: orthogonal, of equal length, with
                                        normal curvature H */
    double mean = t.c.H / fmax(fabs(t.c.k1), fabs(t.c.k2));
    assert_near_at(across, 0, 1e-9, name, "F of diagonals", p, q);
    assert_near_at(lam_length(t.x[0]) / lam_length(t.x[1]), 1, 1e-9, name, "ratio of diagonals", p,
                   q);
    assert_near_at(relative_second(&t, 0, 0), mean, 1e-9, name, "II(a,a)", p, q);
    assert_near_at(relative_second(&t, 1, 1), mean, 1e-9, name, "II(b,b)", p, q);
  }
}

static void check_charts(lam_fixture *f, const lam_surface *s) {
  for (int chart = 0; chart < LAM_CHART_COUNT; chart++) {
    double p[2], q[2];
    bool closed[2];
    if (chart == LAM_CHART_NATURAL || !s->kind->domain(s->data, chart, p, q, closed)) continue;
    assert_non_null(s->kind->locate);
    int sectors = s->kind->sectors ? s->kind->sectors(s->data, chart) : 0;
    for (int sector = 0; sector < (sectors ? sectors : 1); sector++)
      for (int i = 0; i < POINTS; i++)
        check_chart_at(s, chart, sector, next_in(f, p), next_in(f, q));
  }
}

/* Every chart of every surface has the property of its name, in every sector. */
static void test_charts(void **state) {
  lam_fixture *f = *state;
  static const char *const variants[][2] = {{"enneper", "order: 2"},
                                            {"enneper", "order: 3"},
                                            {"enneper", "order: 9"},
                                            {"helicoid", "hand: left"},
                                            {"unduloid", "neck: 0.05"},
                                            {"unduloid", "neck: 1"},
                                            {"nodoid", "neck: 0.8"},
                                            {"torus", "{ring: 2, tube: 1.9}"},
                                            {"ellipsoid", "axes: [1, 3, 2]"},
                                            {"ellipsoid", "axes: [2, 1, 1]"},
                                            {"ellipsoid", "axes: [1, 1, 2]"},
                                            {"ellipsoid", "axes: [2, 3, 1]"},
                                            {"constant-ratio", "angle: 35 deg"},
                                            {"constant-ratio", "angle: 150 deg"}};
  for (int i = 0; i < lam_surfaces.count; i++) {
    lam_surface s = made(f, lam_surfaces.rows[i]->name, "");
    check_charts(f, &s);
  }
  for (size_t i = 0; i < sizeof variants / sizeof variants[0]; i++) {
    lam_surface s = made(f, variants[i][0], variants[i][1]);
    check_charts(f, &s);
  }
}

/* Where a domain closes up, position and derivatives agree at both ends. */
static void test_closed_domains(void **state) {
  lam_fixture *f = *state;
  int found = 0;
  for (int i = 0; i < lam_surfaces.count; i++) {
    lam_surface s = made(f, lam_surfaces.rows[i]->name, "");
    for (int chart = 0; chart < LAM_CHART_COUNT; chart++) {
      double range[2][2];
      bool closed[2];
      if (!s.kind->domain(s.data, chart, range[0], range[1], closed)) continue;
      for (int d = 0; d < 2; d++) {
        double other = next_in(f, range[1 - d]), a = range[d][0], b = range[d][1];
        lam_vec3 low = lam_surface_point(&s, chart, 0, d ? other : a, d ? a : other);
        lam_vec3 high = lam_surface_point(&s, chart, 0, d ? other : b, d ? b : other);
        assert_int_equal(lam_distance(low, high) <= 1e-12, closed[d]);
        found += closed[d];
      }
    }
  }
  /* In two charts each: the torus in both directions, and revolution, catenoid, constant-ratio,
   * pseudosphere, unduloid, nodoid, sphere and ellipsoid around the axis. */
  assert_int_equal(found, 2 * (2 + 8));
}

/* Mean curvature 0 on the minimal surfaces, and orthogonal asymptotic lines there. */
static void test_minimal(void **state) {
  lam_fixture *f = *state;
  static const char *const names[][2] = {{"enneper", ""},  {"enneper", "order: 3"},
                                         {"catenoid", ""}, {"helicoid", ""},
                                         {"scherk", ""},   {"constant-ratio", "angle: 90 deg"}};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    lam_surface s = made(f, names[i][0], names[i][1]);
    double p[2], q[2];
    bool closed[2];
    assert_true(s.kind->domain(s.data, LAM_CHART_ASYMPTOTIC, p, q, closed));
    for (int k = 0; k < POINTS; k++) {
      double a = next_in(f, p), b = next_in(f, q);
      tangents t = chart_tangents(&s, LAM_CHART_ASYMPTOTIC, 0, a, b);
      assert_near_at(t.c.H / t.c.k1, 0, 1e-12, names[i][0], "H", a, b);
      assert_near_at(lam_dot(t.x[0], t.x[1]) / lam_dot(t.x[0], t.x[0]), 0, 1e-9, names[i][0], "F",
                     a, b);
      assert_near_at(lam_length(t.x[0]) / lam_length(t.x[1]), 1, 1e-9, names[i][0], "squareness", a,
                     b);
    }
  }
}

/* H = -1 / (largest + signed smallest radius) on Delaunay surfaces (derived in delaunay.c),
 * extremes of the radius as stated. */
static void test_constant_mean_curvature(void **state) {
  lam_fixture *f = *state;
  static const struct {
    const char *name, *text;
    double neck, mean;
  } cases[] = {{"unduloid", "neck: 0.05", 0.05, -1 / 1.05},
               {"unduloid", "neck: 0.4", 0.4, -1 / 1.4},
               {"unduloid", "neck: 1", 1, -0.5},
               {"nodoid", "neck: 0.3", 0.3, -1 / 0.7},
               {"nodoid", "neck: 0.9", 0.9, -1 / 0.1}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    lam_surface s = made(f, cases[i].name, cases[i].text);
    double p[2], q[2];
    bool closed[2];
    assert_true(s.kind->domain(s.data, LAM_CHART_NATURAL, p, q, closed));
    lam_vec3 bulge = lam_surface_point(&s, LAM_CHART_NATURAL, 0, 0, 0),
             neck = lam_surface_point(&s, LAM_CHART_NATURAL, 0, 0, q[1]);
    assert_near_at(bulge.x, 1, 1e-15, cases[i].name, "bulge", 0, 0);
    assert_near_at(neck.x, cases[i].neck, 1e-14, cases[i].name, "neck", 0, q[1]);
    double far[2] = {3 * q[0], 3 * q[1]}; /* beyond the default domain, too */
    for (int k = 0; k < POINTS; k++) {
      lam_jet jet;
      double u = next_in(f, p), v = next_in(f, far);
      lam_surface_eval(&s, u, v, &jet);
      lam_curvature c = lam_jet_curvature(&jet);
      assert_near_at(c.H, cases[i].mean, 1e-12 * fmax(fabs(c.k1), fabs(c.k2)), cases[i].name, "H",
                     u, v);
      assert_near_at(c.G / c.E, 1, 1e-12, cases[i].name, "G/E", u, v);
    }
  }
}

/* Curvatures known in closed form: K = -1 on the pseudosphere, 1/r on the sphere, cos v / (r (R + r
 * cos v)) on the torus, -1/(1 + u^2)^2 on the helicoid. Along the asymptotic lines of the
 * pseudosphere the speed is 1. */
static void test_known_curvatures(void **state) {
  lam_fixture *f = *state;
  lam_surface pseudosphere = made(f, "pseudosphere", ""), sphere = made(f, "sphere", "radius: 2.5");
  lam_surface torus = made(f, "torus", ""), helicoid = made(f, "helicoid", "");
  const double range[2] = {0.2, 1.2};
  for (int i = 0; i < POINTS; i++) {
    lam_jet jet;
    double u = next_in(f, range), v = next_in(f, range);
    tangents t = chart_tangents(&pseudosphere, LAM_CHART_ASYMPTOTIC, 0, u, v);
    assert_near_at(t.c.K, -1, 1e-12, "pseudosphere", "K", u, v);
    assert_near_at(lam_length(t.x[0]), 1, 1e-9, "pseudosphere", "speed", u, v);
    assert_near_at(lam_length(t.x[1]), 1, 1e-9, "pseudosphere", "speed", u, v);
    lam_surface_eval(&sphere, u, v, &jet);
    lam_curvature c = lam_jet_curvature(&jet);
    assert_near_at(c.k1, -0.4, 1e-14, "sphere", "k1", u, v); /* the normal points outward */
    assert_near_at(c.k2, -0.4, 1e-14, "sphere", "k2", u, v);
    lam_surface_eval(&torus, u, 3 * v, &jet);
    assert_near_at(lam_jet_curvature(&jet).K, cos(3 * v) / (3 + cos(3 * v)), 1e-14, "torus", "K", u,
                   3 * v);
    lam_surface_eval(&helicoid, u, v, &jet);
    assert_near_at(lam_jet_curvature(&jet).K, -pow(1 + u * u, -2), 1e-14, "helicoid", "K", u, v);
  }
}

/* k_meridian = -cot^2(angle/2) k_parallel, and the chart lines cross at the angle asked for. */
static void test_constant_ratio(void **state) {
  lam_fixture *f = *state;
  for (int degrees = 20; degrees <= 160; degrees += 10) {
    double angle = degrees * LAM_PI / 180, a = pow(tan(angle / 2), -2), p[2], q[2];
    bool closed[2];
    lam_surface s = made(f, "constant-ratio", lam_arena_printf(f->arena, "angle: %d deg", degrees));
    assert_true(s.kind->domain(s.data, LAM_CHART_ASYMPTOTIC, p, q, closed));
    for (int i = 0; i < POINTS; i++) {
      double x = next_in(f, p), y = next_in(f, q);
      tangents t = chart_tangents(&s, LAM_CHART_ASYMPTOTIC, 0, x, y);
      assert_near_at((t.c.N / t.c.G) / (t.c.L / t.c.E), -a, 1e-9 * a, "constant-ratio", "ratio", x,
                     y);
      assert_near_at(lam_angle(t.x[0], t.x[1]), angle, 1e-9, "constant-ratio", "angle", x, y);
    }
  }
}

/* Neighboring sectors meet: the q-axis of one is the p-axis of the next, in the same bits, once
 * around. They turn counterclockwise around the normal, which points up. */
static void test_sectors(void **state) {
  lam_fixture *f = *state;
  for (int order = 2; order <= 9; order++) {
    lam_surface s = made(f, "enneper", lam_arena_printf(f->arena, "order: %d", order));
    int sectors = s.kind->sectors(s.data, LAM_CHART_ASYMPTOTIC);
    double turned = 0;
    assert_int_equal(sectors, 2 * (order + 1));
    for (int sector = 0; sector < sectors; sector++) {
      for (double r = 0; r < 0.5; r += 0.1) {
        lam_vec3 here = lam_surface_point(&s, LAM_CHART_ASYMPTOTIC, sector, 0, r);
        lam_vec3 next = lam_surface_point(&s, LAM_CHART_ASYMPTOTIC, (sector + 1) % sectors, r, 0);
        assert_true(here.x == next.x && here.y == next.y && here.z == next.z);
      }
      lam_vec3 from = lam_surface_point(&s, LAM_CHART_ASYMPTOTIC, sector, 0.1, 0);
      lam_vec3 to = lam_surface_point(&s, LAM_CHART_ASYMPTOTIC, sector, 0, 0.1);
      turned += atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    }
    assert_near_at(turned, 2 * LAM_PI, 1e-9, "enneper", "turn", order, 0);
    lam_jet jet;
    lam_surface_eval(&s, 0, 0, &jet);
    assert_near_at(lam_jet_curvature(&jet).normal.z, 1, 0, "enneper", "normal", 0, 0);
  }
  lam_surface classical = made(f, "enneper", "");
  assert_int_equal(classical.kind->sectors(classical.data, LAM_CHART_ASYMPTOTIC), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_charts),           TEST(test_closed_domains),
      TEST(test_minimal),          TEST(test_constant_mean_curvature),
      TEST(test_known_curvatures), TEST(test_constant_ratio),
      TEST(test_sectors),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
