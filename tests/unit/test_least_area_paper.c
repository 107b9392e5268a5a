/* The steps of Wu & Wang, and the surface kind. Figures without a formula were computed by another program with the
 * paper's misprints corrected. */
#include "surf/least_area_paper.h"
#include "surf/spline_surface.h"
#include "tests/unit/least_area_fixture.h"
#include "tests/unit/surface_fixture.h"

/* Weights 1, w, w, 1 have the ratio 3/4 |1 - w|. */
static void test_ratio(void **state) {
  (void)state;
  static const double inner[] = {0.2, 1. / 3, 0.5, 1, 2, 7. / 3, 5};
  for (size_t i = 0; i < sizeof inner / sizeof *inner; i++) {
    double w[4] = {1, inner[i], inner[i], 1};
    assert_near(lam_hybrid_ratio(3, w), 0.75 * fabs(1 - inner[i]), 1e-9, "ratio", "w", inner[i], 0);
  }
}

/* Largest distance of the border v = 0 from its approximation. */
static double hybrid_error(area_fixture *f, const char *name, int r) {
  lam_spline_surface s = area_boundary(f, name);
  lam_vec3 from[4], to[32];
  double w[4], largest = 0;
  for (int i = 0; i < 4; i++) {
    from[i] = s.points[4 * i];
    w[i] = s.weights[4 * i];
  }
  lam_hybrid_approximate(3, from, w, r, r, to);
  for (int k = 0; k <= 500; k++) {
    double t = k / 500.0, sum = 0,
           b[4] = {(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t), t * t * t};
    lam_vec3 x = {0}, y[32];
    for (int i = 0; i < 4; i++) {
      x = lam_along(x, b[i] * w[i], from[i]);
      sum += b[i] * w[i];
    }
    for (int i = 0; i <= 2 * r; i++) y[i] = to[i];
    for (int n = 2 * r; n > 0; n--)
      for (int i = 0; i < n; i++) y[i] = lam_mix(y[i], y[i + 1], t);
    largest = fmax(largest, lam_distance(y[0], lam_scale(x, 1 / sum)));
  }
  return largest;
}

static void test_hybrid(void **state) {
  area_fixture *f = *state;
  static const struct {
    const char *name;
    int r;
    double error;
  } cases[] = {{"ex1", 3, 2.0e-2}, {"ex1", 6, 7.1e-4}, {"ex1", 10, 1.1e-5},
               {"ex3", 3, 9.6e-2}, {"ex3", 6, 1.6e-2}, {"ex3", 10, 1.6e-3}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_near(hybrid_error(f, cases[i].name, cases[i].r), cases[i].error, 0.1 * cases[i].error, cases[i].name,
                "error", cases[i].r, 0);
}

/* Steps to the tolerances of the paper at bidegree 6, areas on the approximated borders, and areas of the nearest
 * surfaces with the exact boundary and unit weights, which are between the least of their class and 2 % more. */
static void test_pipeline(void **state) {
  area_fixture *f = *state;
  static const struct {
    const char *name;
    double tolerance;
    int steps;
    double patches;
  } cases[] = {{"ex1", 0.01, 5, 0}, {"ex2", 0.04, 3, 0}, {"ex3", 0.01, 3, 0}, {"ex4", 0.01, 3, 8.1683}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *name = cases[i].name;
    lam_spline_surface b = area_boundary(f, name), unit;
    lam_paper_result r = lam_least_area_paper(f->arena, &b, 3, 3, cases[i].tolerance, 100);
    assert_true(r.patches.converged);
    assert_int_equal(r.patches.iterations, cases[i].steps);
    if (cases[i].patches > 0) assert_relative(r.patches.area, cases[i].patches, 1e-4, name, "patches");
    unit = lam_spline_surface_fit(f->arena, &b, &r.patches.surface);
    double least = area_expected(f, name, "class_unit"), area = lam_surface_area(f->arena, &unit, 40);
    if (!(area > least && area < 1.025 * least)) fail_msg("%s: refit has area %.8g, least %.8g", name, area, least);
    double exact = area_expected(f, name, "least");
    assert_true(lam_surface_area(f->arena, &r.nurbs, 40) > exact &&
                lam_surface_area(f->arena, &r.rational, 40) > exact);
  }
}

/* No step on the patches raises an area; the first borders and all four energies keep the outer border. */
static void test_steps(void **state) {
  area_fixture *f = *state;
  lam_spline_surface b = area_boundary(f, "ex2"), outer = lam_bezier_boundary(f->arena, &b, 3, 3);
  assert_int_equal(outer.count[0], 2 * 6 + 1);
  for (int energy = LAM_BEZIER_DIRICHLET; energy <= LAM_BEZIER_BIHARMONIC; energy++) {
    lam_spline_surface s = lam_bezier_borders(f->arena, &outer);
    s = lam_bezier_fill(f->arena, &s, (lam_bezier_energy)energy);
    double area = lam_surface_area(f->arena, &s, 16);
    if (!(area > 11 && area < 25)) fail_msg("energy %d: area %.6g", energy, area); /* discrete Coons points: 18.9 */
    for (int k = 0; k < 5; k++) {
      s = lam_bezier_improve(f->arena, &s);
      double next = lam_surface_area(f->arena, &s, 16);
      if (next > area * (1 + 1e-9)) fail_msg("energy %d, step %d: %.10g after %.10g", energy, k, next, area);
      area = next;
    }
    for (int i = 0; i < s.count[0]; i++)
      assert_true(lam_distance(s.points[i * s.count[1]], outer.points[i * s.count[1]]) == 0);
  }
}

/* A surface of the space is its own nearest surface, with its own weights. */
static void test_fit(void **state) {
  area_fixture *f = *state;
  lam_spline_surface s = area_boundary(f, "N8_nonuniform");
  s = lam_least_area_dirichlet(f->arena, &s);
  lam_spline_surface same = lam_spline_surface_fit(f->arena, &s, &s);
  assert_near(lam_spline_surface_distance(f->arena, &same, &s), 0, 1e-12, "fit", "distance", 0, 0);
  lam_spline_surface space = lam_least_area_separable_weights(f->arena, &s);
  same = lam_spline_surface_fit_weights(f->arena, &space, &s, 0.01, 30);
  assert_near(lam_spline_surface_distance(f->arena, &same, &s), 0, 1e-8, "fit with weights", "distance", 0, 0);
  for (int k = 0; k < s.count[0] * s.count[1]; k++)
    assert_near(same.weights[k], s.weights[k], 1e-6, "fit", "weight", k, 0);
}

/* Half a cylinder of radius 1 and length 3 is the surface of mean curvature 1/2 on its boundary; area 3 pi. The curves
 * are given in mixed directions. */
static void test_mean_curvature(void **state) {
  lam_fixture *f = *state;
  static const char arc[] =
      "degree: 2, weights: [1,0.7071067811865476,1,0.7071067811865476,1], knots: [0,0,0,1,1,2,2,2]";
  lam_surface s =
      made(f, "least-area",
           lam_arena_printf(f->arena,
                            "{mean_curvature: -0.5, curves: [{points: [-1,0,0, -1,0,1, 0,0,1, 1,0,1, 1,0,0], %s},"
                            " {points: [-1,3,0, -1,0,0]}, {points: [1,3,0, 1,3,1, 0,3,1, -1,3,1, -1,3,0], %s},"
                            " {points: [1,0,0, 1,3,0]}]}",
                            arc, arc));
  assert_near(lam_surface_area(f->arena, s.kind->spline(s.data), 8), 3 * M_PI, 1e-7, "half cylinder", "area", 0, 0);
  for (int k = 0; k < 20; k++) {
    lam_jet jet;
    lam_surface_eval(&s, k / 19.0, (7 * k % 20) / 19.0, &jet);
    assert_near(hypot(jet.x.x, jet.x.z), 1, 1e-5, "half cylinder", "radius", k, 0);
  }
}

static void test_wrong_input(void **state) {
  lam_fixture *f = *state;
  static const char *const wrong[][2] = {{"{points: [0,0,0, 1,1,1]}", "points"},
                                         {"{weights: [1, 2]}", "weights"},
                                         {"{weights: [1,1,1,1, 1,-1,1,1, 1,1,1,1]}", "weights"},
                                         {"{knots_u: [0,1,2,3,4,5,6,7]}", "knots_u"},
                                         {"{curves: [{points: [0,0,0, 1,0,0]}]}", "curves"},
                                         {"{curves: [{points: [0,0,0, 1,0,0]}, {points: [0,0,0, 0,1,0]}, {points: "
                                          "[0,1,0, 1,1,0]}, {points: [1,0,0, 1,1,1]}]}",
                                          "curves[3]"},
                                         {"{mean_curvature: 0.1, method: paper}", "mean_curvature"},
                                         {"{mean_curvature: 0.1, inner_weights: free}", "mean_curvature"}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    assert_null(make(f, "least-area", wrong[i][0]).kind);
    assert_int_equal(f->errors.count, 1);
    assert_string_equal(f->errors.first->key, wrong[i][1]);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {AREA_TEST(test_ratio), AREA_TEST(test_hybrid), AREA_TEST(test_pipeline),
                                     AREA_TEST(test_steps), AREA_TEST(test_fit),    TEST(test_mean_curvature),
                                     TEST(test_wrong_input)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
