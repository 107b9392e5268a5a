/* The steps of Wu & Wang, and the surface kind. Figures without a formula were computed by another
 * program with the paper's misprints corrected. */
#include "core/numbers.h"
#include "surf/area/area_paper.h"
#include "surf/spline/spline_edit.h"
#include "surf/spline/spline_surface.h"
#include "tests/unit/least_area_fixture.h"
#include "tests/unit/surface_fixture.h"

/* Weights 1, w, w, 1 have the ratio 3/4 |1 - w|. */
static void test_ratio(void **state) {
  (void)state;
  static const double inner[] = {0.2, 1. / 3, 0.5, 1, 2, 7. / 3, 5};
  for (size_t i = 0; i < sizeof inner / sizeof *inner; i++) {
    double w[4] = {1, inner[i], inner[i], 1};
    assert_near_at(lam_hybrid_ratio(3, w), 0.75 * fabs(1 - inner[i]), 1e-9, "ratio", "w", inner[i],
                   0);
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
           b[4] = {(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t),
                   t * t * t};
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
    assert_near_at(hybrid_error(f, cases[i].name, cases[i].r), cases[i].error, 0.1 * cases[i].error,
                   cases[i].name, "error", cases[i].r, 0);
}

/* The paper's way with r = p = 3 to its tolerances: steps and areas by another program, whose
 * nearest surfaces had the class's free inner points; examples 1 to 4. Areas here may be less, down
 * to the least of the class (weights 1 inside); with separable weights that was 2.8468239
 * and 8.3419656 for examples 3 and 4, more than the figure in example 3. */
static const struct {
  const char *name;
  double tolerance;
  int steps;
  double patches; /* on approximated borders, which may be less than the least area; 0: not known */
  double refit;
  double separable; /* least with separable weights */
} pipeline[] = {{"ex1", 0.01, 5, 0, 12.8714, 12.8544469},
                {"ex2", 0.04, 3, 0, 11.997, 11.7541270},
                {"ex3", 0.01, 3, 0, 2.8461, 2.8468239},
                {"ex4", 0.01, 3, 8.1683, 8.3533, 8.3419656}};

static void test_pipeline(void **state) {
  area_fixture *f = *state;
  for (size_t i = 0; i < sizeof pipeline / sizeof *pipeline; i++) {
    const char *name = pipeline[i].name;
    double wanted = pipeline[i].refit, least = area_expected(f, name, "class_unit");
    lam_spline_surface b = area_boundary(f, name);
    lam_paper_result r = lam_least_area_paper(f->arena, &b, 3, 3, pipeline[i].tolerance, 100);
    assert_true(r.patches.converged);
    assert_int_equal(r.patches.iterations, pipeline[i].steps);
    if (pipeline[i].patches > 0)
      assert_relative(r.patches.area, pipeline[i].patches, 1e-4, name, "patches");
    double area = lam_surface_area(f->arena, &r.nurbs, 40);
    if (!(area > least && area <= wanted * 1.001))
      fail_msg("%s: %.8g, least %.8g, wanted %.8g", name, area, least, wanted);
    area = lam_surface_area(f->arena, &r.rational, 40);
    if (!(area > area_expected(f, name, "least") && area <= wanted * 1.001))
      fail_msg("%s, rational: %.8g, wanted %.8g", name, area, wanted);
    area = lam_surface_area(f->arena, &r.separable, 40);
    double bound = pipeline[i].separable;
    if (!(area > bound && area < bound * 1.005))
      fail_msg("%s, separable: %.8g, least %.8g", name, area, bound);
    lam_spline_surface free =
        lam_least_area_paper_weights(f->arena, &b, &r.patches.surface, 0.01, 30);
    area = lam_surface_area(f->arena, &free, 40);
    if (!(area > area_expected(f, name, "class_free") && area <= wanted * 1.001))
      fail_msg("%s, free weights: %.8g, wanted %.8g", name, area, wanted);
  }
}

/* Step 2 alone: r - 1 derivatives agree at the ends of every span (here by differences of the
 * border u = 0 and v = 0).
 */
static void test_boundary(void **state) {
  area_fixture *f = *state;
  lam_spline_surface b = area_boundary(f, "ex2"), patches = lam_bezier_boundary(f->arena, &b, 3, 3);
  const lam_nurbs *exact = lam_nurbs_make(f->arena, &b), *near = lam_nurbs_make(f->arena, &patches);
  for (int d = 0; d < 2; d++)
    for (int i = 0; i <= 2; i++) {
      double end = b.knots[d][3 + i], other = b.knots[1 - d][0];
      for (int side = -1; side <= 1; side += 2) {
        lam_jet x, y;
        double at = fmin(fmax(end + side * 1e-9, b.knots[d][3]), b.knots[d][5]);
        lam_nurbs_eval(exact, d ? other : at, d ? at : other, &x);
        lam_nurbs_eval(near, d ? other : at, d ? at : other, &y);
        assert_near_at(lam_distance(x.x, y.x), 0, 1e-9, "border", "place", end, side);
        assert_near_at(lam_distance(d ? x.v : x.u, d ? y.v : y.u), 0, 1e-6, "border",
                       "first derivative", end, side);
        assert_near_at(lam_distance(d ? x.vv : x.uu, d ? y.vv : y.uu), 0, 1e-5, "border",
                       "second derivative", end, side);
      }
    }
}

/* Step 3 and the first half of step 5 alone, on 2 x 3 patches of degree 2 with chosen points: the
 * formulas by hand. */
static void test_borders(void **state) {
  area_fixture *f = *state;
  static const double ku[] = {0, 0, 0, 1, 1, 2, 2, 2}, kv[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
  lam_vec3 x[5 * 7];
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 7; j++) x[7 * i + j] = lam_v3(i * i, j * j * j, i * j);
  lam_spline_surface s = {NULL, {2, 2}, {5, 7}, {ku, kv}, x, NULL};
  lam_spline_surface first = lam_bezier_borders(f->arena, &s),
                     mean = lam_bezier_average(f->arena, &s);
#define AT(surface, i, j) ((surface).points[7 * (i) + (j)])
  /* u border: half way between i = 0 and i = 4; v border: a third between j = 0 and j = 6; corner:
   * mean of both */
  assert_true(lam_distance(AT(first, 2, 3), lam_v3(8, 27, 6)) < 1e-12);
  assert_true(lam_distance(AT(first, 1, 2), lam_v3(1, 72, 2)) < 1e-12);
  assert_true(lam_distance(AT(first, 2, 2), lam_v3(6, 40, 4)) < 1e-12);
  assert_true(lam_distance(AT(mean, 2, 3), lam_v3(5, 27, 6)) < 1e-12);
  assert_true(lam_distance(AT(mean, 1, 2), lam_v3(1, 14, 2)) < 1e-12);
  assert_true(lam_distance(AT(mean, 2, 2), lam_v3(5, 14, 4)) < 1e-12);
  for (int k = 0; k < 35; k++) {
    int i = k / 7, j = k % 7;
    if (i > 0 && i < 4 && j > 0 && j < 6 && (i == 2 || j % 2 == 0)) continue;
    assert_true(lam_distance(AT(first, i, j), x[k]) == 0 &&
                lam_distance(AT(mean, i, j), x[k]) == 0);
  }
#undef AT
}

/* Step 4 alone: (u, v, u^3 - 3 u v^2) is harmonic, so its border gives it back, by every energy
 * whose least value it has: all but bending, which wants free edges to be straight. */
static void test_fill(void **state) {
  area_fixture *f = *state;
  static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  static const double powers[4][4] = {
      {1, 1, 1, 1}, {0, 1. / 3, 2. / 3, 1}, {0, 0, 1. / 3, 1}, {0, 0, 0, 1}};
  lam_vec3 x[16], whole[25];
  for (int k = 0; k < 16; k++) {
    int i = k / 4, j = k % 4;
    x[k] = lam_v3(i / 3.0, j / 3.0, powers[3][i] - 3 * powers[1][i] * powers[2][j]);
  }
  lam_spline_surface s = {NULL, {3, 3}, {4, 4}, {knots, knots}, x, NULL};
  s = lam_spline_surface_elevate(f->arena, &s, (int[2]){4, 4});
  memcpy(whole, s.points, sizeof whole);
  for (int energy = LAM_BEZIER_DIRICHLET; energy <= LAM_BEZIER_BIHARMONIC; energy++) {
    lam_vec3 given[25];
    double off = 0;
    for (int k = 0; k < 25; k++)
      given[k] = k / 5 % 4 && k % 5 % 4 ? lam_v3(3, sin(k), 1) : whole[k];
    s.points = given;
    lam_spline_surface full = lam_bezier_fill(f->arena, &s, (lam_bezier_energy)energy);
    for (int k = 0; k < 25; k++) off = fmax(off, lam_distance(full.points[k], whole[k]));
    if (energy == LAM_BEZIER_BENDING ? off < 1e-3 || off > 1 : off > 1e-9)
      fail_msg("energy %d: off by %.2e", energy, off);
  }
}

/* No step on the patches raises an area; the first borders and all four energies keep the outer
 * border. */
static void test_steps(void **state) {
  area_fixture *f = *state;
  lam_spline_surface b = area_boundary(f, "ex2"), outer = lam_bezier_boundary(f->arena, &b, 3, 3);
  assert_int_equal(outer.count[0], 2 * 6 + 1);
  for (int energy = LAM_BEZIER_DIRICHLET; energy <= LAM_BEZIER_BIHARMONIC; energy++) {
    lam_spline_surface s = lam_bezier_borders(f->arena, &outer);
    s = lam_bezier_fill(f->arena, &s, (lam_bezier_energy)energy);
    double area = lam_surface_area(f->arena, &s, 16);
    if (!(area > 11 && area < 25))
      fail_msg("energy %d: area %.6g", energy, area); /* discrete Coons points: 18.9 */
    for (int k = 0; k < 5; k++) {
      s = lam_bezier_improve(f->arena, &s);
      double next = lam_surface_area(f->arena, &s, 16);
      if (next > area * (1 + 1e-9))
        fail_msg("energy %d, step %d: %.10g after %.10g", energy, k, next, area);
      area = next;
    }
    lam_least_area_result end = lam_bezier_iterate(f->arena, &s, 0.02, 100);
    assert_true(end.converged && end.iterations > 0 && end.iterations < 100);
    assert_relative(lam_surface_area(f->arena, &end.surface, 16), end.area, 1e-4, "ex2",
                    "area of the iteration");
    s = end.surface;
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
  assert_near_at(lam_spline_surface_distance(f->arena, &same, &s), 0, 1e-12, "fit", "distance", 0,
                 0);
  lam_spline_surface space = lam_least_area_separable_weights(f->arena, &s);
  same = lam_spline_surface_fit_weights(f->arena, &space, &s, 0.01, 30);
  assert_near_at(lam_spline_surface_distance(f->arena, &same, &s), 0, 1e-8, "fit with weights",
                 "distance", 0, 0);
  for (int k = 0; k < s.count[0] * s.count[1]; k++)
    assert_near_at(same.weights[k], s.weights[k], 1e-6, "fit", "weight", k, 0);
}

/* Step 6 alone: a surface z = x y on the square, with inner points moved along it and off it, comes
 * back to a target that is parameterized otherwise (u^2 for u) and ends before the border, where
 * its tangent planes go on: at the last corner they are off by .03 * .02. */
static void test_nearest(void **state) {
  area_fixture *f = *state;
  static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  static const double square[] = {0, 0, 1. / 3, 1}, line[] = {0, 1. / 3, 2. / 3, 1};
  lam_vec3 whole[16], target[16];
  for (int k = 0; k < 16; k++) {
    int i = k / 4, j = k % 4;
    bool inner = i % 3 && j % 3;
    whole[k] = lam_v3(line[i], line[j], line[i] * line[j]);
    if (inner) whole[k] = lam_add(whole[k], lam_v3(0.05 * i, -0.03 * j, 0.1 + 0.1 * i));
    double x = 0.02 + 0.95 * square[i], y = 0.01 + 0.97 * line[j];
    target[k] = lam_v3(x, y, x * y);
  }
  lam_spline_surface start = {NULL, {3, 3}, {4, 4}, {knots, knots}, whole, NULL},
                     to = {NULL, {3, 3}, {4, 4}, {knots, knots}, target, NULL};
  lam_spline_surface s = lam_spline_surface_nearest(f->arena, &start, &to);
  const lam_nurbs *nurbs = lam_nurbs_make(f->arena, &s);
  for (int k = 0; k < 400; k++) {
    lam_jet jet;
    lam_nurbs_eval(nurbs, k / 20 / 19.0, k % 20 / 19.0, &jet);
    assert_near_at(jet.x.z, jet.x.x * jet.x.y, 6e-4, "nearest", "height", k, 0);
  }
  lam_spline_surface same = lam_spline_surface_nearest(f->arena, &to, &to);
  assert_near_at(lam_spline_surface_distance(f->arena, &same, &to), 0, 1e-12, "nearest to itself",
                 "distance", 0, 0);
}

/* Half a cylinder of radius 1 and length 3 is the surface of mean curvature 1/2 on its boundary;
 * area 3 pi. The curves are given in mixed directions. */
static void test_mean_curvature(void **state) {
  lam_fixture *f = *state;
  static const char arc[] =
      "degree: 2, weights: [1,0.7071067811865476,1,0.7071067811865476,1], knots: [0,0,0,1,1,2,2,2]";
  lam_surface s = made(
      f, "least-area",
      lam_arena_printf(
          f->arena,
          "{mean_curvature: -0.5, curves: [{points: [-1,0,0, -1,0,1, 0,0,1, 1,0,1, 1,0,0], %s},"
          " {points: [-1,3,0, -1,0,0]}, {points: [1,3,0, 1,3,1, 0,3,1, -1,3,1, -1,3,0], %s},"
          " {points: [1,0,0, 1,3,0]}]}",
          arc, arc));
  assert_near_at(lam_surface_area(f->arena, s.kind->spline(s.data), 8), 3 * LAM_PI, 1e-7,
                 "half cylinder", "area", 0, 0);
  for (int k = 0; k < 20; k++) {
    lam_jet jet;
    lam_surface_eval(&s, k / 19.0, (7 * k % 20) / 19.0, &jet);
    assert_near_at(hypot(jet.x.x, jet.x.z), 1, 1e-5, "half cylinder", "radius", k, 0);
  }
}

static double measured(const lam_stage *stage, const char *name) {
  for (int i = 0; i < stage->measure_count; i++)
    if (!strcmp(stage->measures[i].name, name)) return stage->measures[i].mean;
  fail_msg("the report has no %s", name);
  return 0;
}

/* A design gets the results by the wanted weights, and its report has the areas of all of them. The
 * default boundary is polynomial: weights 1 are separable, and the borders of the patches are
 * exact. */
static void test_report(void **state) {
  lam_fixture *f = *state;
  static const char *const keys[] = {
      "{method: paper}", "{method: paper, inner_weights: separable}",
      "{method: paper, weights: [1,2,2,1, 2,2, 2,2, 1,2,2,1]}",
      "{method: paper, inner_weights: separable, weights: [1,2,2,1, 2,2, 2,2, 1,2,2,1]}"};
  lam_surface newton = made(f, "least-area", "{tolerance: 1e-12}");
  double least = lam_surface_area(f->arena, newton.kind->spline(newton.data), 20);
  for (int k = 0; k < 4; k++) {
    lam_surface s = made(f, "least-area", keys[k]);
    lam_stage stage = {0};
    s.kind->report(f->arena, s.data, &stage);
    double area = lam_surface_area(f->arena, s.kind->spline(s.data), 20);
    assert_relative(measured(&stage, "area"), area, 1e-8, keys[k], "area");
    if (k % 2)
      assert_relative(measured(&stage, "area_separable"), area, 1e-8, keys[k], "separable");
    double patches = measured(&stage, "area_patches"), rational = measured(&stage, "area_rational");
    if (k < 2 && !(patches > least && rational > least && area > least && area < 1.001 * least))
      fail_msg("%s: patches %.10g, rational %.10g, area %.10g; least %.10g", keys[k], patches,
               rational, area, least);
    if (k == 3 && !(fabs(area / rational - 1) > 1e-6))
      fail_msg("separable weights make no difference: %.10g", area);
  }
}

static void test_wrong_input(void **state) {
  lam_fixture *f = *state;
  static const char *const wrong[][2] = {
      {"{points: [0,0,0, 1,1,1]}", "points"},
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
  const struct CMUnitTest tests[] = {
      AREA_TEST(test_ratio),     AREA_TEST(test_hybrid),   AREA_TEST(test_pipeline),
      AREA_TEST(test_steps),     AREA_TEST(test_boundary), AREA_TEST(test_borders),
      AREA_TEST(test_fill),      AREA_TEST(test_nearest),  AREA_TEST(test_fit),
      TEST(test_mean_curvature), TEST(test_report),        TEST(test_wrong_input)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
