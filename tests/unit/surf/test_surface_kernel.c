/* Spline surfaces as such: forms and directions, derivatives, exact changes. */
#include "surf/directions.h"
#include "surf/spline/spline_surface.h"
#include "tests/unit/spline_surface_fixture.h"

enum { SURFACES = 18 };

static lam_spline_surface example(int k) {
  int degree[2] = {1 + k % 4, 1 + (k / 4) % 3};
  lam_spline_surface s = {.degree = {degree[0], degree[1]},
                          .count = {degree[0] + 1 + k % 3, degree[1] + 1 + k % 5}};
  int total = s.count[0] * s.count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, total);
  double *weights = LAM_NEW(arena, double, total);
  for (int i = 0; i < total; i++) {
    points[i] = next_point();
    weights[i] = next_in(0.5, 3);
  }
  for (int d = 0; d < 2; d++) s.knots[d] = next_knots(s.degree[d], s.count[d], k % 3 != 1);
  s.points = points;
  s.weights = k % 2 ? weights : NULL;
  return s;
}

/* (u, v, uv) at (.5, .5): E = G = 1.25, F = .25, area sqrt 1.5, M = 1 / sqrt 1.5, n = (-1,-1,2) /
 * sqrt 6, K = -M^2 / 1.5 = -4/9, H = -F M / 1.5 = -.1360827635. The parameter lines are straight,
 * so asymptotic. */
static void test_forms_of_a_saddle(void **state) {
  (void)state;
  const lam_jet jet = {{0.5, 0.5, 0.25}, {1, 0, 0.5}, {0, 1, 0.5}, {0, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  lam_curvature c = lam_jet_curvature(&jet);
  near3(c.normal, lam_scale(lam_v3(-1, -1, 2), 1 / sqrt(6)), 1e-15);
  near(c.E, 1.25, 1e-15);
  near(c.F, 0.25, 1e-15);
  near(c.G, 1.25, 1e-15);
  near(c.L, 0, 1e-15);
  near(c.M, 1 / sqrt(1.5), 1e-15);
  near(c.N, 0, 1e-15);
  near(c.K, -4.0 / 9, 1e-15);
  near(c.H, -0.1360827635, 1e-10);
  lam_directions d = lam_jet_directions(&jet);
  assert_int_equal(d.asymptotic_count, 2);
  for (int i = 0; i < 2; i++) near(d.asymptotic_uv[i].x * d.asymptotic_uv[i].y, 0, 1e-15);
  near(fabs(d.asymptotic_uv[0].x + d.asymptotic_uv[0].y), 1 / sqrt(1.25), 1e-15);
  near(fabs(lam_dot(d.principal[0], lam_unit(lam_sub(jet.u, jet.v)))), 0,
       1e-15); /* M > 0: k1 along x_u + x_v */
}

/* The same figures from II(d,d) / I(d,d) at random jets: k1, k2 in the principal directions, 0 in
 * the asymptotic ones, unit length, right angles. */
static lam_jet next_jet(void) {
  return (lam_jet){next_point(), next_point(), next_point(),
                   next_point(), next_point(), next_point()};
}

static double normal_curvature(const lam_curvature *c, lam_vec2 d) {
  double first = c->E * d.x * d.x + 2 * c->F * d.x * d.y + c->G * d.y * d.y;
  return (c->L * d.x * d.x + 2 * c->M * d.x * d.y + c->N * d.y * d.y) / first;
}

static void test_directions(void **state) {
  (void)state;
  int saddles = 0;
  for (int k = 0; k < 200; k++) {
    lam_jet jet = next_jet();
    lam_curvature c = lam_jet_curvature(&jet);
    lam_directions d = lam_jet_directions(&jet);
    double size = fabs(c.k1) + fabs(c.k2);
    near(normal_curvature(&c, d.principal_uv[0]), c.k1, 1e-10 * size);
    near(normal_curvature(&c, d.principal_uv[1]), c.k2, 1e-10 * size);
    near(lam_dot(d.principal[0], d.principal[1]), 0, 1e-14);
    near3(lam_along(lam_scale(jet.u, d.principal_uv[0].x), d.principal_uv[0].y, jet.v),
          d.principal[0], 1e-11);
    assert_int_equal(d.asymptotic_count, c.K < 0 ? 2 : 0);
    saddles += c.K < 0;
    for (int i = 0; i < d.asymptotic_count; i++) {
      near(normal_curvature(&c, d.asymptotic_uv[i]), 0, 1e-10 * size);
      near(lam_length(d.asymptotic[i]), 1, 1e-14);
    }
  }
  assert_true(saddles > 0 && saddles < 200); /* both sorts were tried */
  const lam_jet singular = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
  assert_int_equal(lam_jet_directions(&singular).asymptotic_count, 0);
  assert_true(
      isnan(lam_jet_darboux(&singular, (lam_vec2){1, 0}, (lam_vec2){0, 0}).normal_curvature));
}

/* The circle of latitude b on a sphere of radius R with outward normal: normal curvature -1/R,
 * geodesic curvature tan b / R, no geodesic torsion. The helix of slope angle a on a cylinder of
 * radius r: -cos^2 a / r, 0 and the torsion sin a cos a / r of the helix, as it is a geodesic. A
 * ruling of (u, v, uv): torsion +-sqrt(-K). */
static void test_darboux(void **state) {
  (void)state;
  double R = 2.5, b = 0.6, u = 0.8, cu = cos(u), su = sin(u), cb = cos(b), sb = sin(b);
  const lam_jet sphere = {
      lam_v3(R * cb * cu, R * cb * su, R * sb),   lam_v3(-R * cb * su, R * cb * cu, 0),
      lam_v3(-R * sb * cu, -R * sb * su, R * cb), lam_v3(-R * cb * cu, -R * cb * su, 0),
      lam_v3(R * sb * su, -R * sb * cu, 0),       lam_v3(-R * cb * cu, -R * cb * su, -R * sb)};
  lam_darboux d = lam_jet_darboux(&sphere, (lam_vec2){3, 0}, (lam_vec2){0.7, 0});
  near(d.normal_curvature, -1 / R, 1e-14);
  near(d.geodesic_curvature, tan(b) / R, 1e-14);
  near(d.geodesic_torsion, 0, 1e-14);
  double r = 1.5, a = 0.4;
  const lam_jet cylinder = {lam_v3(r * cu, r * su, 0), lam_v3(-r * su, r * cu, 0),
                            lam_v3(0, 0, 1),           lam_v3(-r * cu, -r * su, 0),
                            lam_v3(0, 0, 0),           lam_v3(0, 0, 0)};
  d = lam_jet_darboux(&cylinder, (lam_vec2){cos(a) / r, sin(a)}, (lam_vec2){0, 0});
  near(d.normal_curvature, -cos(a) * cos(a) / r, 1e-15);
  near(d.geodesic_curvature, 0, 1e-15);
  near(d.geodesic_torsion, sin(a) * cos(a) / r, 1e-15);
  const lam_jet saddle = {{0.5, 0.5, 0.25}, {1, 0, 0.5}, {0, 1, 0.5},
                          {0, 0, 0},        {0, 0, 1},   {0, 0, 0}};
  d = lam_jet_darboux(&saddle, (lam_vec2){1, 0}, (lam_vec2){0, 0});
  near(d.normal_curvature, 0, 1e-15);
  near(fabs(d.geodesic_torsion), 2.0 / 3, 1e-15);
}

/* On a spline surface along u = 2 + t, v = 2 - t / 2 + t^2: n' = -normal t - torsion s against
 * differences, and the curvature of the space curve is that of its parts. */
static void test_darboux_equations(void **state) {
  (void)state;
  lam_spline_surface s = example(2);
  for (int d = 0; d < 2; d++) {
    s.degree[d] = 3;
    s.count[d] = 4;
    s.knots[d] = next_knots(3, 4, true);
  }
  lam_vec3 net[16];
  for (int i = 0; i < 16; i++) net[i] = lam_along(lam_v3(i / 4, i % 4, 0), 0.3, next_point());
  s.points = net;
  s.weights = NULL;
  const lam_nurbs *nurbs = lam_nurbs_make(arena, &s);
  lam_jet jet;
  lam_vec3 normal[2], x[2];
  double h = 1e-4;
  for (int i = 0; i < 2; i++) {
    double t = i ? h : -h;
    lam_nurbs_eval(nurbs, 2 + t, 2 - t / 2 + t * t, &jet);
    normal[i] = lam_jet_curvature(&jet).normal;
    x[i] = jet.x;
  }
  lam_nurbs_eval(nurbs, 2, 2, &jet);
  lam_darboux d = lam_jet_darboux(&jet, (lam_vec2){1, -0.5}, (lam_vec2){0, 2});
  double speed = lam_length(lam_along(jet.u, -0.5, jet.v));
  lam_vec3 turn = lam_scale(lam_sub(normal[1], normal[0]), 1 / (2 * h * speed));
  near3(turn, lam_along(lam_scale(d.tangent, -d.normal_curvature), -d.geodesic_torsion, d.side),
        1e-6);
  lam_vec3 second = lam_scale(lam_sub(lam_add(x[0], x[1]), lam_scale(jet.x, 2)), 1 / (h * h));
  second =
      lam_scale(lam_along(second, -lam_dot(second, d.tangent), d.tangent), 1 / (speed * speed));
  near3(second, lam_along(lam_scale(d.normal, d.normal_curvature), d.geodesic_curvature, d.side),
        1e-5);
}

/* Derivatives to order 3 against differences, and to order 2 against the other evaluation. */
static void test_derivatives(void **state) {
  (void)state;
  const double factors[] = {1.5, -0.6, 0.1};
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k);
    lam_vec3 x[16], low[16], high[16], by[2][16] = {{{0, 0, 0}}};
    double p[2] = {1.6, 2.1}, h = 2e-3;
    for (int d = 0; d < 2; d++)
      for (int i = 0; i < s.count[d] + s.degree[d] + 1; i++)
        if (fabs(s.knots[d][i] - p[d]) < 4 * h) p[d] += 8 * h;
    lam_spline_surface_derivatives(&s, p[0], p[1], 3, x);
    for (int m = 1; m <= 3; m++)
      for (int d = 0; d < 2; d++) {
        double du = d ? 0 : m * h, dv = d ? m * h : 0;
        lam_spline_surface_derivatives(&s, p[0] - du, p[1] - dv, 3, low);
        lam_spline_surface_derivatives(&s, p[0] + du, p[1] + dv, 3, high);
        for (int i = 0; i < 16; i++)
          if (i / 4 + i % 4 <= 3)
            by[d][i] = lam_along(by[d][i], factors[m - 1] / (2 * m * h), lam_sub(high[i], low[i]));
      }
    for (int a = 0; a < 3; a++)
      for (int b = 0; a + b < 3; b++) {
        near3(by[0][4 * a + b], x[4 * (a + 1) + b], 1e-7 * (1 + lam_length(x[4 * (a + 1) + b])));
        near3(by[1][4 * a + b], x[4 * a + b + 1], 1e-7 * (1 + lam_length(x[4 * a + b + 1])));
      }
    lam_jet jet;
    lam_nurbs_eval(lam_nurbs_make(arena, &s), p[0], p[1], &jet);
    const lam_vec3 other[] = {jet.x, jet.v, jet.vv, jet.u, jet.uv, jet.uu};
    const int location[] = {0, 1, 2, 4, 5, 8};
    for (int i = 0; i < 6; i++) near3(x[location[i]], other[i], 1e-12 * (1 + lam_length(other[i])));
  }
}

/* Insertion, elevation, parts and patches leave the surface where it is; reversal and transposition
 * where they say. */
static void test_edits(void **state) {
  (void)state;
  const double all[] = {1, 4}, low[] = {1, 2.3};
  for (int k = 0; k < SURFACES; k++) {
    lam_spline_surface s = example(k), e = s;
    int count[2];
    for (int d = 0; d < 2; d++) {
      e = lam_spline_surface_insert(arena, &e, d, 2.7);
      e = lam_spline_surface_insert(arena, &e, d, next_in(1, 4));
    }
    same(&s, &e, all, all);
    e = lam_spline_surface_elevate(arena, &s, (int[2]){s.degree[0] + 2, s.degree[1] + 1});
    assert_int_equal(e.degree[0], s.degree[0] + 2);
    same(&s, &e, all, all);
    e = lam_spline_surface_part(arena, &s, 0, 1, 2.3);
    same(&s, &e, low, all);
    e = lam_spline_surface_part(arena, &s, 1, 1, 2.3);
    same(&s, &e, all, low);
    lam_spline_surface back[2], turned = lam_spline_surface_transpose(arena, &s);
    for (int d = 0; d < 2; d++) back[d] = lam_spline_surface_reverse(arena, &s, d);
    for (int i = 0; i < 20; i++) {
      double u = next_in(1, 4), v = next_in(1, 4);
      lam_vec3 x = at(&s, u, v);
      near3(at(&back[0], 5 - u, v), x, exact);
      near3(at(&back[1], u, 5 - v), x, exact);
      near3(at(&turned, v, u), x, exact);
    }
    const lam_spline_surface *patches = lam_spline_surface_patches(arena, &s, count);
    near(patches[0].knots[0][0], 1, 0);
    near(patches[count[0] * count[1] - 1].knots[1][s.degree[1] + 1], 4, 0);
    for (int i = 0; i < count[0] * count[1]; i++) {
      const double u[] = {patches[i].knots[0][0], patches[i].knots[0][s.degree[0] + 1]};
      const double v[] = {patches[i].knots[1][0], patches[i].knots[1][s.degree[1] + 1]};
      assert_int_equal(patches[i].count[0] * patches[i].count[1],
                       (s.degree[0] + 1) * (s.degree[1] + 1));
      same(&s, &patches[i], u, v);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_forms_of_a_saddle), TEST(test_directions),  TEST(test_darboux),
      TEST(test_darboux_equations), TEST(test_derivatives), TEST(test_edits),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
