/* The surface kinds coons and interpolation as designs use them. */
#include "curve/bspline/basis.h"
#include "tests/unit/surface_fixture.h"

static lam_vec3 at(const lam_surface *s, double u, double v) {
  lam_jet jet;
  lam_surface_eval(s, u, v, &jet);
  return jet.x;
}

static const lam_measure *measure_of(lam_fixture *f, const lam_surface *s, const char *name) {
  lam_stage *stage = LAM_NEW(f->arena, lam_stage, 1);
  s->kind->report(f->arena, s->data, stage);
  for (int i = 0; i < stage->measure_count; i++)
    if (strcmp(stage->measures[i].name, name) == 0) return &stage->measures[i];
  fail_msg("no measure %s", name);
  return NULL;
}

/* Opposite sides x = 3u, y = 0 and 2, z = u^2 and 0; the others straight: by hand x = (3u, 2v,
 * (1-v) u^2). */
static void test_coons_by_hand(void **state) {
  lam_fixture *f = *state;
  lam_surface s = made(f, "coons",
                       "{curves: [{points: [0,0,0, 1.5,0,0, 3,0,1]}, {points: [0,0,0, 0,2,0]},"
                       " {points: [0,2,0, 3,2,0]}, {points: [3,0,1, 3,2,0]}]}");
  const double unit[] = {0, 1};
  for (int i = 0; i < POINTS; i++) {
    double u = next_in(f, unit), v = next_in(f, unit);
    assert_near3(at(&s, u, v), lam_v3(3 * u, 2 * v, (1 - v) * u * u), 1e-14, "coons", "x", u, v);
  }
  assert_true(measure_of(f, &s, "side_distance")->max < 1e-14);
  const lam_spline_surface *spline = s.kind->spline(s.data);
  assert_int_equal(spline->degree[0], 2);
  assert_int_equal(spline->degree[1], 1);
}

/* The default, B-spline sides with knots of their own, and units: sides are met to rounding. */
static void test_sides_are_met(void **state) {
  lam_fixture *f = *state;
  static const char *const designs[] = {
      "",
      "{blend: hermite}",
      "{curves: [{points: [0,0,0, 1,0,1, 2,0,0, 3,0,0], degree: 2, knots: [0,0,0,0.3,1,1,1]},"
      " {points: [0,0,0, 0,1,1, 0,2,0], degree: 1, knots: [0,0,1,5,5]}, {points: [3,2,0, 1,2,1, "
      "0,2,0]},"
      " {points: [3,0,0, 3,2,0]}], unit: cm, blend: hermite}",
  };
  for (size_t i = 0; i < sizeof designs / sizeof designs[0]; i++) {
    lam_surface s = made(f, "coons", designs[i]);
    assert_true(measure_of(f, &s, "side_distance")->max < 1e-14);
  }
  lam_surface small = made(f, "coons", designs[2]);
  assert_near3(at(&small, 1, 1), lam_v3(0.03, 0.02, 0), 1e-16, "coons", "corner", 1, 1);
}

/* Two Hermite patches with the same derivatives across their common side continue each other: over
 * y from 0 to 1 and on to 2, both leave and arrive with slopes (0, 1, 0.5) of equal size. */
static void test_hermite_patches_continue(void **state) {
  lam_fixture *f = *state;
  lam_surface a = made(f, "coons",
                       "{blend: hermite, curves: [{points: [0,0,0, 1,0,0.4, 2,0,0]},"
                       " {points: [0,0,0, 0,0.3333333333333333,0, "
                       "0,0.6666666666666666,-0.16666666666666666, 0,1,0]},"
                       " {points: [0,1,0, 1,1,0.4, 2,1,0], across: [0,1,0.5, 0,1,0.5, 0,1,0.5]},"
                       " {points: [2,0,0, 2,0.3333333333333333,0, "
                       "2,0.6666666666666666,-0.16666666666666666, 2,1,0]}]}");
  lam_surface b = made(
      f, "coons",
      "{blend: hermite, curves: ["
      " {points: [0,1,0, 1,1,0.4, 2,1,0], across: [0,1,0.5, 0,1,0.5, 0,1,0.5]},"
      " {points: [0,1,0, 0,1.3333333333333333,0.16666666666666666, 0,1.6666666666666667,0, 0,2,0]},"
      " {points: [0,2,0, 1,2,0.4, 2,2,0]},"
      " {points: [2,1,0, 2,1.3333333333333333,0.16666666666666666, 2,1.6666666666666667,0, "
      "2,2,0]}]}");
  assert_true(measure_of(f, &a, "twist_gap")->max < 1e-14);
  assert_true(measure_of(f, &a, "slope_gap")->max < 1e-14);
  for (int i = 0; i <= 10; i++) {
    lam_jet end, start;
    lam_surface_eval(&a, i / 10.0, 1, &end);
    lam_surface_eval(&b, i / 10.0, 0, &start);
    assert_near3(start.x, end.x, 1e-14, "coons", "x", i / 10.0, 1);
    assert_near3(end.v, lam_v3(0, 1, 0.5), 1e-14, "coons", "x_v", i / 10.0, 1);
    assert_near3(start.v, end.v, 1e-14, "coons", "x_v", i / 10.0, 1);
  }
}

static void test_interpolation_meets_points(void **state) {
  lam_fixture *f = *state;
  static const char *const designs[] = {"",
                                        "{ends: local}",
                                        "{ends: natural, parameters: centripetal}",
                                        "{ends: average, degree: [2, 1], parameters: uniform}",
                                        "{count: [2, 3], points: [0,0,0, 0,1,1, 0,2,0, 1,0,1, "
                                        "1,1,0, 1,2,2], unit: mm, ends: natural}",
                                        "{count: [5, 2], points: [0,0,0, 0,1,1, 1,0,1, 1,1,0, "
                                        "2,0,0, 2,1,0, 2.5,0,1, 2.5,1,0, 4,0,0, 4,1,1],"
                                        " parameters: modified-chord}"};
  for (size_t i = 0; i < sizeof designs / sizeof designs[0]; i++) {
    lam_surface s = made(f, "interpolation", designs[i]);
    const lam_measure *m = measure_of(f, &s, "point_distance");
    assert_true(m->max < 1e-13 && m->count >= 6);
  }
  lam_surface s = made(f, "interpolation", designs[4]);
  assert_near3(at(&s, 1, 1), lam_v3(0.001, 0.002, 0.002), 1e-15, "interpolation", "corner", 1, 1);
}

/* Three sides of a rectangle; nothing; a curve of degree 12. */
#define REST "{points: [0,0,0, 0,2,0]}, {points: [0,2,0, 3,2,0]}, {points: [3,0,0, 3,2,0]}"
#define POINT "{points: [0,0,0, 0,0,0]}"
#define TWELVE(y, first)                                                                           \
  "{degree: 12, points: [0," y ",0, 0.5," y ",0, 1," y ",0, 1.5," y ",0, 2," y ",0, 2.5," y        \
  ",0, 3," y ",0, 3.5," y ",0, 4," y ",0, 4.5," y ",0, 5," y ",0, 5.5," y ",0, 6," y               \
  ",0], weights: [" first ",1,1,3,1,1,1,1,1,1,1,1]}"

/* Wrong input is refused at the key that is wrong, with what was given. */
static void test_refusals(void **state) {
  lam_fixture *f = *state;
  static const char *const cases[][4] = {
      {"coons", "{curves: [{points: [0,0,0, 1,0]}, " REST "]}", "curves[0].points",
       "5 numbers given"},
      {"coons", "{curves: [" REST "]}", "curves", "3 curves given; expected 4"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0.5]}, " REST "]}", "curves[3]",
       "its start lies 0.5 m from the end of curves[0]"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0], degree: 5}, " REST "]}", "curves[0].degree",
       "at most 1"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0], knots: [0,0,1]}, " REST "]}", "curves[0].knots",
       "as many as"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0], weights: [1]}, " REST "]}", "curves[0].weights",
       "expected 2"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0], weights: [1, 0]}, " REST "]}",
       "curves[0].weights", "positive"},
      {"coons", "{curves: [{points: [0,0,0, 3,0,0], across: [0,1,0, 0,1,0]}, " REST "]}",
       "curves[0].across", "expected blend: hermite"},
      {"coons", "{blend: hermite, curves: [{points: [0,0,0, 3,0,0], across: [0,1,0]}, " REST "]}",
       "curves[0].across", "expected 6"},
      {"coons", "{curves: [" POINT ", " POINT ", " POINT ", " POINT "]}", "curves",
       "all points are one"},
      {"coons",
       "{curves: [" TWELVE("0", "1,2") ", {points: [0,0,0, 0,1,0]}, " TWELVE(
           "1", "1,1") ", {points: [6,0,0, 6,1,0]}]}",
       "curves", "degree 25 in u; expected at most 24"},
      {"interpolation", "{count: [3, 3]}", "count", "3 x 3 with 16 points"},
      {"interpolation", "{points: [0,0,0, 1]}", "points", "4 numbers given"},
      {"interpolation", "{degree: [4, 3]}", "degree", "expected 3"},
      {"interpolation", "{ends: average, degree: [4, 3]}", "degree", "at most 3"},
      {"interpolation", "{count: [2, 2], points: [0,0,0, 1,1,1, 0,0,0, 1,1,1]}", "points",
       "direction u"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    lam_surface s = make(f, cases[i][0], cases[i][1]);
    assert_null(s.kind);
    assert_non_null(f->errors.first);
    assert_string_equal(f->errors.first->key, cases[i][2]);
    if (!strstr(f->errors.first->text, cases[i][3]))
      fail_msg("%s: %s", cases[i][1], f->errors.first->text);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(test_coons_by_hand),
      TEST(test_sides_are_met),
      TEST(test_hermite_patches_continue),
      TEST(test_interpolation_meets_points),
      TEST(test_refusals),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
