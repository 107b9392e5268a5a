/* Pieces that readers and writers of splines share: arcs, parts of curves between points, borders,
 * problems and notes, and how near corners and sides must be to be one. By hand from straight
 * lines, squares and circles. */
#include "core/numbers.h"
#include "formats/spline/curves.h"
#include "formats/spline/shell.h"
#include "tests/unit/text_fixture.h"

static const double straight[] = {0, 0, 1, 1}, corner_knots[] = {0, 0, 1, 2, 2};

static void assert_points(const lam_spline_curve *c, int count, const lam_vec3 *points,
                          double tolerance, const char *what) {
  if (c->count != count) fail_msg("%s: %d points, expected %d", what, c->count, count);
  for (int i = 0; i < count; i++)
    if (!(lam_distance(c->points[i], points[i]) <= tolerance))
      fail_msg("%s, point %d: (%.17g, %.17g, %.17g), expected (%g, %g, %g)", what, i,
               c->points[i].x, c->points[i].y, c->points[i].z, points[i].x, points[i].y,
               points[i].z);
}

/* ---- arcs ---- */

/* Pieces of at most a quarter turn: 120 degrees are two of 60, whose middle points stand 1 / cos 30
 * out, with weight cos 30. */
static void arcs_have_pieces(void **state) {
  static const double knots[8] = {0, 0, 0, 1, 1, 2, 2, 2};
  const double c = cos(LAM_PI / 6), t = tan(LAM_PI / 6), s = sqrt(.75);
  lam_spline_curve a =
      lam_curve_arc(*state, lam_v3(5, 0, 1), lam_v3(2, 0, 0), lam_v3(0, 0, 1), 0, 2 * LAM_PI / 3);
  const lam_vec3 points[5] = {
      {7, 0, 1}, {7, 0, 1 + t}, {6, 0, 1 + s}, {5, 0, 1 + 1 / c}, {4, 0, 1 + s}};
  assert_points(&a, 5, points, 1e-14, "arc");
  for (int i = 0; i < 8; i++) assert_near(a.knots[i], knots[i], 0);
  for (int i = 0; i < 5; i++) assert_near(a.weights[i], i % 2 ? c : 1, 1e-15);
  int counts[3] = {3, 5, 9};
  double ends[3] = {LAM_PI / 2, LAM_PI / 2 + .001, 2 * LAM_PI};
  for (int i = 0; i < 3; i++)
    assert_int_equal(lam_curve_arc(*state, points[0], points[0], points[1], 0, ends[i]).count,
                     counts[i]);
}

/* ---- parts ---- */

/* A bent line from (0, 0) over (4, 0) to (4, 4), cut at the points nearest to two others; ends that
 * are given in either order, or fall together, leave it whole. */
static void parts_lie_between_feet(void **state) {
  static const lam_vec3 bent[3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
  const lam_spline_curve c = {1, 3, corner_knots, bent, NULL};
  const struct {
    lam_vec3 a, b;
    int count;
    lam_vec3 points[3];
  } cases[] = {
      {{1, -1, 0}, {5, 3, 0}, 3, {{1, 0, 0}, {4, 0, 0}, {4, 3, 0}}},
      {{5, 3, 0}, {1, -1, 0}, 3, {{1, 0, 0}, {4, 0, 0}, {4, 3, 0}}},
      {{1, 0, 2}, {3, 0, -2}, 2, {{1, 0, 0}, {3, 0, 0}}},
      {{5, -1, 0}, {4, 1, 0}, 2, {{4, 0, 0}, {4, 1, 0}}},
      {{-3, 0, 0}, {4, 9, 0}, 3, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
      {{0, 0, 0}, {2, 0, 0}, 2, {{0, 0, 0}, {2, 0, 0}}},
      {{2, 0, 0}, {0, 0, 0}, 2, {{0, 0, 0}, {2, 0, 0}}},
      {{4, 2, 0}, {4, 4, 0}, 2, {{4, 2, 0}, {4, 4, 0}}},
      {{4, 4, 0}, {4, 2, 0}, 2, {{4, 2, 0}, {4, 4, 0}}},
      {{0, 0, 0}, {4, 4, 0}, 3, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
      {{4, 4, 0}, {0, 0, 0}, 3, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
      {{2, 0, 0}, {2 + 1e-9, 0, 0}, 3, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
      {{2, 0, 0}, {2, 0, 0}, 3, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve part = lam_curve_between(*state, &c, cases[i].a, cases[i].b);
    assert_points(&part, cases[i].count, cases[i].points, 1e-12,
                  lam_arena_printf(*state, "case %d", (int)i));
  }
}

/* A line that comes back to where it was has its end twice; its ends are taken as they are. */
static void an_end_that_is_passed_before_stays_the_end(void **state) {
  static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
  static const lam_vec3 loop[5] = {{-4, 0, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 0, 0}};
  const lam_spline_curve c = {1, 5, knots, loop, NULL};
  lam_spline_curve forward = lam_curve_between(*state, &c, loop[0], loop[4]),
                   backward = lam_curve_between(*state, &c, loop[4], loop[0]);
  assert_points(&forward, 5, loop, 0, "forward");
  assert_points(&backward, 5, loop, 0, "backward");
}

/* What is too short to be cut is measured by the length of the domain, wherever it begins. */
static void domains_may_begin_anywhere(void **state) {
  static const double knots[] = {1e9, 1e9, 1e9 + 4, 1e9 + 4};
  static const lam_vec3 ends[2] = {{0, 0, 0}, {4, 0, 0}};
  const lam_spline_curve c = {1, 2, knots, ends, NULL};
  lam_spline_curve part = lam_curve_between(*state, &c, lam_v3(1, 1, 0), lam_v3(3, 1, 0));
  assert_points(&part, 2, (lam_vec3[2]){{1, 0, 0}, {3, 0, 0}}, 1e-6, "part"); /* eps x 1e9 */
}

/* A full circle is closed: both ends are one point, and it stays whole; two points on it cut it. */
static void a_closed_curve_stays_whole(void **state) {
  lam_spline_curve c =
      lam_curve_arc(*state, lam_v3(0, 0, 0), lam_v3(3, 0, 0), lam_v3(0, 3, 0), 0, 2 * LAM_PI);
  lam_spline_curve whole = lam_curve_between(*state, &c, lam_v3(3, 0, 0), lam_v3(3, 0, 0));
  assert_int_equal(whole.count, 9);
  lam_spline_curve half = lam_curve_between(*state, &c, lam_v3(0, 5, 0), lam_v3(0, -5, 0));
  assert_near(half.knots[0], 1, 1e-9);
  assert_near(half.knots[half.count + 2], 3, 1e-9);
}

/* ---- borders ---- */

/* The square of side 2, whose size (the largest distance from its first point) is 2 sqrt 2: a curve
 * on its border may be 2.83e-4 off. */
static void borders_are_told(void **state) {
  static const lam_vec3 square[4] = {{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}};
  const lam_spline_surface s = {"s", {1, 1}, {2, 2}, {straight, straight}, square, NULL};
  static const struct {
    lam_vec3 points[3];
    int count;
    bool border;
  } cases[] = {
      {{{2, 0, 0}, {2, 2, 0}}, 2, true},
      {{{2, 2, 0}, {2, 0, 0}}, 2, true},
      {{{2, .5, 0}, {2, 1, 0}}, 2, true},
      {{{0, 2, 0}, {1, 2, 0}}, 2, true},
      {{{0, .3, 0}, {0, .1, 0}}, 2, true},
      {{{1.5, 0, 0}, {.5, 0, 0}}, 2, true},
      {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, 3, true},
      {{{0, 0, 0}, {2, 2, 0}}, 2, false},
      {{{2, 0, 0}, {2, 3, 0}}, 2, false},
      {{{2, -.5, 0}, {2, 1, 0}}, 2, false},
      {{{2, .5, 2.7e-4}, {2, 1, 2.7e-4}}, 2, true},
      {{{2, .5, 3e-4}, {2, 1, 3e-4}}, 2, false},
      {{{1, 0, 0}, {1, 2, 0}}, 2, false},
      {{{2, 1, 0}, {2, 1, 1e-2}}, 2, false},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = {1, cases[i].count, cases[i].count == 3 ? corner_knots : straight,
                          cases[i].points, NULL};
    if (lam_curve_is_border(*state, &c, &s) != cases[i].border)
      fail_msg("case %d: %s a border", (int)i, cases[i].border ? "not" : "taken as");
  }
}

/* A side of 600 teeth, of which 256 samples would miss most: a border that has the parameters of
 * its side, forward or backward, is told by them. One of the other parity is none. */
static void toothed_borders_are_told(void **state) {
  enum { n = 601 };
  static double knots[n + 2];
  static lam_vec3 sides[2 * n], along[3][n];
  for (int i = 0; i < n + 2; i++) knots[i] = i == 0 ? 0 : i > n ? n - 1 : i - 1;
  for (int i = 0; i < n; i++) {
    sides[2 * i] = along[0][i] = along[1][n - 1 - i] = lam_v3(.01 * i, i % 2 * .5, 0);
    sides[2 * i + 1] = lam_v3(.01 * i, 10, 0);
    along[2][i] = lam_v3(.01 * i, (1 - i % 2) * .5, 0);
  }
  const lam_spline_surface s = {"s", {1, 1}, {n, 2}, {knots, straight}, sides, NULL};
  for (int k = 0; k < 3; k++) {
    const lam_spline_curve c = {1, n, knots, along[k], NULL};
    assert_int_equal(lam_curve_is_border(*state, &c, &s), k < 2);
  }
}

/* ---- problems and notes ---- */

static void problems_are_named(void **state) {
  (void)state;
  static const double falling[] = {0, 0, 1, .5}, empty[] = {0, 1, 1, 2},
                      undefined[] = {0, 0, NAN, 1};
  static const lam_vec3 ab[2] = {{0, 0, 0}, {1, 0, 0}}, far[2] = {{0, 0, 0}, {0, 1e200, 0}};
  static const double zero[] = {1, 0}, least[] = {1e-300, 1};
  static const struct {
    lam_spline_curve curve;
    const char *problem;
  } cases[] = {
      {{1, 2, straight, ab, NULL}, NULL},
      {{1, 2, straight, ab, least}, NULL},
      {{0, 2, straight, ab, NULL}, "a degree less than 1"},
      {{2, 2, straight, ab, NULL}, "too few points for its degree"},
      {{1, 2, falling, ab, NULL}, "knots that decrease"},
      {{1, 2, undefined, ab, NULL}, "knots that decrease"},
      {{1, 2, empty, ab, NULL}, "knots with an empty domain"},
      {{1, 2, straight, far, NULL}, "a point too far away"},
      {{1, 2, straight, ab, zero}, "a weight that is not positive"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const char *problem = lam_curve_problem(&cases[i].curve);
    assert_string_equal(problem ? problem : "none", cases[i].problem ? cases[i].problem : "none");
  }
  /* of a surface the last point and weight count, too, and either direction */
  static const lam_vec3 four[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 1e200}};
  static const double weights[4] = {1, 1, 1, 0};
  lam_spline_surface s = {"s", {1, 1}, {2, 2}, {straight, straight}, four, NULL};
  assert_string_equal(lam_spline_problem(&s), "a point too far away");
  static const lam_vec3 near[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  s.points = near, s.weights = weights;
  assert_string_equal(lam_spline_problem(&s), "a weight that is not positive");
  s.weights = NULL;
  assert_null(lam_spline_problem(&s));
  s.knots[1] = falling;
  assert_string_equal(lam_spline_problem(&s), "knots that decrease");
}

static void notes_say_what_is_not_read(void **state) {
  (void)state;
  assert_null(lam_spline_note(false, false));
  assert_null(strstr(lam_spline_note(true, false), "assembly"));
  assert_non_null(strstr(lam_spline_note(true, false), "trimmed"));
  assert_null(strstr(lam_spline_note(false, true), "trimmed"));
  assert_non_null(strstr(lam_spline_note(false, true), "assembly"));
  assert_non_null(strstr(strstr(lam_spline_note(true, true), "trimmed"), "assembly"));
}

/* ---- shells ---- */

/* Two squares of side `size` with a gap between their common sides: one vertex and edge up to a
 * billionth of the size (largest distance from the first point: sqrt 5 sides), or a nanometer for
 * what is smaller than a meter. */
static void near_sides_are_one(void **state) {
  static const struct {
    double size, gap;
    int vertices, edges;
  } cases[] = {{100, 2e-7, 6, 7}, {100, 2.3e-7, 8, 8}, {.1, .9e-9, 6, 7}, {.1, 1.1e-9, 8, 8}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    double l = cases[i].size, g = l + cases[i].gap;
    const lam_vec3 a[4] = {{0, 0, 0}, {0, l, 0}, {l, 0, 0}, {l, l, 0}},
                   b[4] = {{g, 0, 0}, {g, l, 0}, {2 * l, 0, 0}, {2 * l, l, 0}};
    const lam_spline_surface s[2] = {{"a", {1, 1}, {2, 2}, {straight, straight}, a, NULL},
                                     {"b", {1, 1}, {2, 2}, {straight, straight}, b, NULL}};
    lam_shell shell = lam_shell_make(*state, 2, s);
    assert_int_equal(shell.vertex_count, cases[i].vertices);
    assert_int_equal(shell.edge_count, cases[i].edges);
    assert_int_equal(shell.part_count, cases[i].vertices == 6 ? 1 : 2);
  }
}

/* Sides of one surface meet when points agree to a nanometer and weights to 1e-12 of themselves. */
static void sides_meet_by_points_and_weights(void **state) {
  (void)state;
  static const double ring[] = {0, 0, 1, 2, 2};
  static const struct {
    double gap, weight;
    bool meet;
  } cases[] = {{0, 2, true},           {.9e-9, 2, true},      {1.1e-9, 2, false},
               {0, 2 + 1.5e-12, true}, {0, 2 + 3e-12, false}, {0, 2 - 3e-12, false}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const lam_vec3 x[6] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0},
                           {1, 0, 1}, {0, 0, 0}, {0, cases[i].gap, 1}};
    const double w[6] = {1, 2, 1, 1, 1, cases[i].weight};
    const lam_spline_surface s = {"s", {1, 1}, {3, 2}, {ring, straight}, x, w};
    lam_spline_side low = lam_spline_side_of(&s, 3), high = lam_spline_side_of(&s, 1);
    if (lam_spline_sides_meet(&low, &high) != cases[i].meet) fail_msg("case %d", (int)i);
    assert_false(lam_spline_side_is_point(&low));
  }
  static const lam_vec3 pole[4] = {{0, 0, 0}, {0, 0, .9e-9}, {1, 0, 0}, {1, 0, 1.1e-9}};
  const lam_spline_surface s = {"s", {1, 1}, {2, 2}, {straight, straight}, pole, NULL};
  lam_spline_side low = lam_spline_side_of(&s, 3), high = lam_spline_side_of(&s, 1);
  assert_true(lam_spline_side_is_point(&low));
  assert_false(lam_spline_side_is_point(&high));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(arcs_have_pieces),
      TEXT_TEST(parts_lie_between_feet),
      TEXT_TEST(an_end_that_is_passed_before_stays_the_end),
      TEXT_TEST(domains_may_begin_anywhere),
      TEXT_TEST(toothed_borders_are_told),
      TEXT_TEST(a_closed_curve_stays_whole),
      TEXT_TEST(borders_are_told),
      TEXT_TEST(problems_are_named),
      TEXT_TEST(notes_say_what_is_not_read),
      TEXT_TEST(near_sides_are_one),
      TEXT_TEST(sides_meet_by_points_and_weights),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
