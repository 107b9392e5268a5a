/* Spline surfaces as such: forms and directions, derivatives, exact changes, Coons patches, surfaces through points. */
#include "surf/coons_patch.h"
#include "surf/directions.h"
#include "surf/spline_edit.h"
#include "surf/spline_surface.h"
#include "surf/spline_through.h"
#include "tests/unit/curve_fixture.h"

enum { SURFACES = 18 };
static const double exact = 1e-12; /* points are of size 1 */

static lam_spline_surface example(int k) {
  int degree[2] = {1 + k % 4, 1 + (k / 4) % 3};
  lam_spline_surface s = {.degree = {degree[0], degree[1]}, .count = {degree[0] + 1 + k % 3, degree[1] + 1 + k % 5}};
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

static lam_vec3 at(const lam_spline_surface *s, double u, double v) {
  lam_vec3 x;
  lam_spline_surface_derivatives(s, u, v, 0, &x);
  return x;
}

static void same(const lam_spline_surface *a, const lam_spline_surface *b, const double u[2], const double v[2]) {
  for (int d = 0; d < 2; d++)
    assert_null(lam_knots_problem(b->degree[d], b->count[d], b->count[d] + b->degree[d] + 1, b->knots[d]));
  for (int i = 0; i < 30; i++) {
    double p = i == 0 ? u[0] : next_in(u[0], u[1]), q = i == 1 ? v[1] : next_in(v[0], v[1]);
    near3(at(b, p, q), at(a, p, q), exact);
  }
}

/* (u, v, uv) at (.5, .5): E = G = 1.25, F = .25, area sqrt 1.5, M = 1 / sqrt 1.5, n = (-1,-1,2) / sqrt 6, K = -M^2
 * / 1.5 = -4/9, H = -F M / 1.5 = -.1360827635. The parameter lines are straight, so asymptotic. */
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
  near(fabs(lam_dot(d.principal[0], lam_unit(lam_sub(jet.u, jet.v)))), 0, 1e-15); /* M > 0: k1 along x_u + x_v */
}

/* The same figures from II(d,d) / I(d,d) at random jets: k1, k2 in the principal directions, 0 in the asymptotic ones,
 * unit length, right angles. */
static lam_jet next_jet(void) {
  return (lam_jet){next_point(), next_point(), next_point(), next_point(), next_point(), next_point()};
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
    near3(lam_along(lam_scale(jet.u, d.principal_uv[0].x), d.principal_uv[0].y, jet.v), d.principal[0], 1e-11);
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
  assert_true(isnan(lam_jet_darboux(&singular, (lam_vec2){1, 0}, (lam_vec2){0, 0}).normal_curvature));
}

/* The circle of latitude b on a sphere of radius R with outward normal: normal curvature -1/R, geodesic curvature
 * tan b / R, no geodesic torsion. The helix of slope angle a on a cylinder of radius r: -cos^2 a / r, 0 and the torsion
 * sin a cos a / r of the helix, as it is a geodesic. A ruling of (u, v, uv): torsion +-sqrt(-K). */
static void test_darboux(void **state) {
  (void)state;
  double R = 2.5, b = 0.6, u = 0.8, cu = cos(u), su = sin(u), cb = cos(b), sb = sin(b);
  const lam_jet sphere = {lam_v3(R * cb * cu, R * cb * su, R * sb),   lam_v3(-R * cb * su, R * cb * cu, 0),
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
  const lam_jet saddle = {{0.5, 0.5, 0.25}, {1, 0, 0.5}, {0, 1, 0.5}, {0, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  d = lam_jet_darboux(&saddle, (lam_vec2){1, 0}, (lam_vec2){0, 0});
  near(d.normal_curvature, 0, 1e-15);
  near(fabs(d.geodesic_torsion), 2.0 / 3, 1e-15);
}

/* On a spline surface along u = 2 + t, v = 2 - t / 2 + t^2: n' = -normal t - torsion s against differences, and the
 * curvature of the space curve is that of its parts. */
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
  near3(turn, lam_along(lam_scale(d.tangent, -d.normal_curvature), -d.geodesic_torsion, d.side), 1e-6);
  lam_vec3 second = lam_scale(lam_sub(lam_add(x[0], x[1]), lam_scale(jet.x, 2)), 1 / (h * h));
  second = lam_scale(lam_along(second, -lam_dot(second, d.tangent), d.tangent), 1 / (speed * speed));
  near3(second, lam_along(lam_scale(d.normal, d.normal_curvature), d.geodesic_curvature, d.side), 1e-5);
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
    const int place[] = {0, 1, 2, 4, 5, 8};
    for (int i = 0; i < 6; i++) near3(x[place[i]], other[i], 1e-12 * (1 + lam_length(other[i])));
  }
}

/* Insertion, elevation, parts and patches leave the surface where it is; reversal and transposition where they say. */
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
      assert_int_equal(patches[i].count[0] * patches[i].count[1], (s.degree[0] + 1) * (s.degree[1] + 1));
      same(&s, &patches[i], u, v);
    }
  }
}

/* ---- Coons patches ---- */

/* Four sides of different degrees, knots and domains that meet. */
static lam_coons example_coons(void) {
  lam_coons coons = {0};
  const int degree[] = {3, 2, 1, 4}, count[] = {6, 4, 5, 5};
  for (int i = 0; i < 4; i++) coons.side[i] = next_curve(degree[i], count[i], false, true);
  for (int i = 1; i < 4; i += 2) /* sides 1 and 3 start and end on sides 0 and 2 */
    for (int end = 0; end < 2; end++) {
      const lam_spline_curve *other = &coons.side[2 * end];
      lam_vec3 *points = (lam_vec3 *)coons.side[i].points; /* this test made them */
      points[end ? count[i] - 1 : 0] = other->points[i == 3 ? other->count - 1 : 0];
    }
  return coons;
}

static lam_vec3 side_at(const lam_coons *coons, int i, double t) { return point_at(&coons->side[i], 1 + 3 * t); }

/* The patch is the formula at every point, not only on its sides. */
static void test_bilinear_coons(void **state) {
  (void)state;
  for (int k = 0; k < 10; k++) {
    lam_coons c = example_coons();
    lam_spline_surface s = lam_coons_bilinear(arena, &c);
    assert_int_equal(s.degree[0], 3);
    assert_int_equal(s.degree[1], 4);
    for (int i = 0; i < 40; i++) {
      double u = i == 0 ? 0 : i == 1 ? 1 : next_in(0, 1), v = i == 2 ? 0 : i == 3 ? 1 : next_in(0, 1);
      lam_vec3 ruled = lam_mix(side_at(&c, 0, u), side_at(&c, 2, u), v);
      lam_vec3 other = lam_mix(side_at(&c, 1, v), side_at(&c, 3, v), u);
      lam_vec3 corners = lam_mix(lam_mix(side_at(&c, 0, 0), side_at(&c, 0, 1), u),
                                 lam_mix(side_at(&c, 2, 0), side_at(&c, 2, 1), u), v);
      near3(at(&s, u, v), lam_sub(lam_add(ruled, other), corners), exact);
    }
    near(lam_coons_check(arena, &c).corner, 0, 1e-15);
  }
}

/* The sides and derivatives of a bicubic patch give it back; with simple blends of a spline surface too, the sides and
 * what crosses them are met. */
static void test_hermite_coons(void **state) {
  (void)state;
  for (int k = 0; k < 5; k++) {
    lam_vec3 net[16];
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i < 16; i++) net[i] = next_point();
    lam_spline_surface bicubic = {NULL, {3, 3}, {4, 4}, {knots, knots}, net, NULL};
    lam_coons c = {0};
    for (int i = 0; i < 4; i++) {
      lam_vec3 *side = LAM_NEW(arena, lam_vec3, 4), *across = LAM_NEW(arena, lam_vec3, 4);
      int step = i % 2 ? 1 : 4, jump = i % 2 ? 4 : 1; /* along the side; to the next row */
      for (int j = 0; j < 4; j++) {
        const lam_vec3 *p = net + j * step;
        side[j] = p[i / 2 ? 3 * jump : 0];
        across[j] = i / 2 ? lam_scale(lam_sub(p[3 * jump], p[2 * jump]), 3) : lam_scale(lam_sub(p[jump], p[0]), 3);
      }
      c.side[i] = (lam_spline_curve){3, 4, knots, side, NULL};
      lam_spline_curve crossing = {3, 4, knots, across, NULL};
      c.across[i] = lam_spline_curve_net(arena, &crossing, false);
    }
    lam_coons_gaps gaps = lam_coons_check(arena, &c);
    near(gaps.corner + gaps.slope + gaps.twist, 0, 1e-13);
    lam_spline_surface s = lam_coons_hermite(arena, &c);
    const double unit[] = {0, 1};
    same(&bicubic, &s, unit, unit);
  }
}

/* Without given derivatives those across a side are mixed linearly from the slopes at its ends; the twists then agree
 * only in the mean. Both sides and, at twist-free corners, derivatives are met. */
static void test_hermite_coons_from_sides(void **state) {
  (void)state;
  lam_coons c = example_coons();
  lam_spline_surface s = lam_coons_hermite(arena, &c);
  assert_true(lam_coons_check(arena, &c).twist > 0.1);
  for (int i = 0; i < 40; i++) {
    double t = next_in(0, 1);
    near3(at(&s, t, 0), side_at(&c, 0, t), exact);
    near3(at(&s, t, 1), side_at(&c, 2, t), exact);
    near3(at(&s, 0, t), side_at(&c, 1, t), exact);
    near3(at(&s, 1, t), side_at(&c, 3, t), exact);
  }
  /* all slopes across v = 0 equal, and those of the other sides: constant across, so no twists */
  const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  const lam_vec3 shift = {0.2, 3, 0.5};
  lam_vec3 bottom[4], top[4], left[4], right[4];
  for (int i = 0; i < 4; i++) {
    bottom[i] = lam_along(lam_v3(i, 0, 0), 0.3, next_point());
    top[i] = lam_add(bottom[i], shift);
  }
  for (int i = 0; i < 4; i++) {
    left[i] = lam_along(lam_along(bottom[0], i / 3.0, shift), i == 1 || i == 2, lam_v3(0, 0, 0.7));
    right[i] = lam_add(left[i], lam_sub(bottom[3], bottom[0]));
  }
  lam_coons t = {.side = {{3, 4, knots, bottom, NULL},
                          {3, 4, knots, left, NULL},
                          {3, 4, knots, top, NULL},
                          {3, 4, knots, right, NULL}}};
  near(lam_coons_check(arena, &t).twist, 0, 1e-13);
  s = lam_coons_hermite(arena, &t); /* the translational surface bottom(u) + left(v) - corner */
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    lam_vec3 x = lam_sub(lam_add(point_at(&t.side[0], u), point_at(&t.side[1], v)), bottom[0]);
    near3(at(&s, u, v), x, exact);
  }
}

/* ---- through points ---- */

static lam_vec3 bicubic_at(double u, double v) {
  return lam_v3(u + 0.2 * v * v * u, v - 0.1 * u * u * u, u * u * v * v * v - u * v + 0.5 * u * u * u);
}

/* Cubics come back; other points are met, whatever the ends and the parameters. */
static void test_through_points(void **state) {
  (void)state;
  enum { M = 7, N = 6 };
  const int count[] = {M, N}, cubic[] = {3, 3}, other[] = {4, 2};
  const double t0[M] = {0, 0.1, 0.3, 0.4, 0.7, 0.8, 1}, t1[N] = {0, 0.3, 0.4, 0.5, 0.9, 1};
  const double *const given[] = {t0, t1};
  lam_vec3 points[M * N];
  for (int i = 0; i < M * N; i++) points[i] = bicubic_at(t0[i / N], t1[i % N]);
  lam_spline_surface s = lam_surface_through(arena, LAM_ENDS_NOT_A_KNOT, cubic, count, given, points);
  for (int i = 0; i < 40; i++) {
    double u = next_in(0, 1), v = next_in(0, 1);
    near3(at(&s, u, v), bicubic_at(u, v), 1e-12);
  }
  for (int i = 0; i < M * N; i++) points[i] = lam_along(lam_v3(i / N, i % N, 0), 0.4, next_point());
  for (int kind = 0; kind < LAM_PARAMETERS_COUNT; kind++)
    for (int ends = 0; ends < LAM_ENDS_TANGENTS; ends++) {
      const double *t[2];
      lam_grid_parameters(arena, (lam_parameters)kind, count, points, t);
      s = lam_surface_through(arena, (lam_ends)ends, ends ? cubic : other, count, t, points);
      for (int i = 0; i < M * N; i++) near3(at(&s, t[0][i / N], t[1][i % N]), points[i], 1e-11);
    }
  for (int i = 0; i < N; i++) points[N + i] = points[i]; /* two rows alike */
  const double *t[2];
  lam_grid_parameters(arena, LAM_PARAMETERS_CHORD, count, points, t);
  assert_null(t[0]);
  assert_non_null(t[1]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_forms_of_a_saddle), TEST(test_directions),    TEST(test_darboux),
      TEST(test_darboux_equations), TEST(test_derivatives),   TEST(test_edits),
      TEST(test_bilinear_coons),    TEST(test_hermite_coons), TEST(test_hermite_coons_from_sides),
      TEST(test_through_points),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
