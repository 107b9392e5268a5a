/* A boundary out of a file: which four curves are taken, and what is said when they do not do. */
#include "curve_fixture.h"
#include "surf/spline/sides_keys.h"
#include <string.h>

static const double line_knots[] = {0, 0, 1, 1}, arc_knots[] = {0, 0, 0, 1, 1, 1};
static const double h = 0.70710678118654752440;

/* The unit square in no order, with a diagonal, a quarter of a circle in place of one side, and a
 * torn curve. */
static int make_curves(lam_named_curve *curves) {
  static const lam_vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0.2}};
  static const int ends[][2] = {{0, 2}, {2, 1}, {3, 0}, {0, 1}, {3, 2}, {4, 2}};
  static lam_vec3 points[6][2], arc[3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  static const double weights[] = {1, 0.70710678118654752440, 1}, torn[] = {0, 0, 0.5, 0.5, 1, 1};
  static const lam_vec3 four[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  static const char *const names[] = {"diagonal", "right", "left", "bottom", "top", "off"};
  for (int i = 0; i < 6; i++) {
    for (int k = 0; k < 2; k++) points[i][k] = corners[ends[i][k]];
    curves[i] = (lam_named_curve){names[i], -1, {1, 2, line_knots, points[i], NULL}};
  }
  curves[6] = (lam_named_curve){"arc", -1, {2, 3, arc_knots, arc, weights}};
  curves[7] = (lam_named_curve){"torn", -1, {1, 4, torn, four, NULL}};
  return 8;
}

static bool read(lam_sides_keys keys, lam_sides_limits limits, lam_sides *sides,
                 const char **message) {
  lam_errors errors = {.arena = arena};
  bool good =
      lam_sides_read(arena, &keys, limits, (lam_location){.file = "x.yaml"}, &errors, sides);
  assert_int_equal(errors.count, good ? 0 : 1);
  *message = good ? NULL : lam_arena_printf(arena, "%s: %s", errors.first->key, errors.first->text);
  return good;
}

static const lam_sides_limits any = {.degree = LAM_BASIS_MAX_DEGREE};

/* Right, top, left, bottom, by their numbers: the first is v = 0. */
static void test_picked(void **state) {
  (void)state;
  lam_named_curve curves[8];
  int picked[] = {2, 5, 3, 4};
  lam_sides_keys keys = {
      .file = "x.step", .pick = {4, picked}, .read_count = make_curves(curves), .read = curves};
  lam_sides sides;
  const char *message;
  if (!read(keys, any, &sides, &message)) fail_msg("%s", message);
  near3(point_at(&sides.side[0], 0.5), lam_v3(1, 0.5, 0), 1e-15);
  near3(point_at(&sides.side[2], 0.5), lam_v3(0, 0.5, 0), 1e-15);
  near3(point_at(&sides.side[1], 0.5), lam_v3(0.5, 1, 0), 1e-15);
  near3(point_at(&sides.side[3], 0.5), lam_v3(0.5, 0, 0), 1e-15);
  for (int u = 0; u < 2; u++)
    for (int v = 0; v < 2; v++)
      near3(point_at(&sides.side[2 * v], u), point_at(&sides.side[2 * u + 1], v), 0);
}

/* A file with four curves needs no pick; arcs are taken as they are. */
static void test_four_curves(void **state) {
  (void)state;
  lam_named_curve curves[8], four[4];
  make_curves(curves);
  static const lam_vec3 out[] = {{1, 0, 0}, {2, 0, 0}}, up[] = {{2, 0, 0}, {0, 2, 0}},
                        back[] = {{0, 2, 0}, {0, 1, 0}};
  four[0] = curves[6];
  four[1] = (lam_named_curve){"out", -1, {1, 2, line_knots, out, NULL}};
  four[2] = (lam_named_curve){"up", -1, {1, 2, line_knots, up, NULL}};
  four[3] = (lam_named_curve){"back", -1, {1, 2, line_knots, back, NULL}};
  lam_sides_keys keys = {.file = "x.step", .read_count = 4, .read = four};
  lam_sides sides;
  const char *message;
  if (!read(keys, any, &sides, &message)) fail_msg("%s", message);
  near3(point_at(&sides.side[0], 0.5), lam_v3(h, h, 0), 1e-15); /* halfway on the quarter circle */
  near3(point_at(&sides.side[2], 0.5), lam_v3(1, 1, 0), 1e-15);
  assert_false(read(keys, (lam_sides_limits){.degree = 9, .no_weights = true}, &sides, &message));
  assert_string_equal(
      message,
      "file: curve arc is rational (an arc is, too); expected polynomial curves: this surface "
      "is polynomial");
}

static void test_refused(void **state) {
  (void)state;
  static int twice[] = {2, 5, 5, 4}, far[] = {2, 5, 3, 9}, three[] = {2, 5, 3},
             gap[] = {6, 5, 3, 4}, bad[] = {2, 5, 3, 8};
  static const struct {
    int count;
    lam_list pick;
    const char *message;
  } cases[] = {
      {3, {0, NULL}, "file: x.step has 3 curves; expected four"},
      {1, {0, NULL}, "file: x.step has 1 curve; expected four"},
      {8, {0, NULL}, "file: x.step has 8 curves; expected four, or pick: with the numbers of four"},
      {8, {4, twice}, "pick: curve 5 picked twice; expected four different ones"},
      {8, {4, far}, "pick: curve 9 asked for, but x.step has 8"},
      {8, {3, three}, "pick: 3 curves picked; expected 4"},
      {8,
       {4, bad},
       "file: the knots of curve torn must not repeat an inner knot more often than the degree"},
      {8, {4, gap}, NULL},
  };
  lam_named_curve curves[8];
  make_curves(curves);
  lam_sides sides;
  const char *message;
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_sides_keys keys = {
        .file = "x.step", .pick = cases[i].pick, .read_count = cases[i].count, .read = curves};
    assert_false(read(keys, any, &sides, &message));
    if (cases[i].message)
      assert_string_equal(message, cases[i].message);
    else if (!strstr(message, "(off) lies 0.2 m from the ") &&
             !strstr(message, "lies 0.2 m from the start of curve 6 (off)"))
      fail_msg("%s", message);
  }
  lam_sides_keys unread = {.file = "x.step"}, both = {.file = "x.step", .curves_given = true},
                 lone = {.pick = {4, far}};
  assert_false(read(unread, any, &sides, &message));
  assert_string_equal(message, "file: x.step cannot be read: this caller loads no files");
  assert_false(read(both, any, &sides, &message));
  assert_string_equal(message, "file: given beside curves; expected one of them");
  assert_false(read(lone, any, &sides, &message));
  assert_string_equal(message, "pick: given without file; expected both");
}

int main(void) {
  const struct CMUnitTest tests[] = {TEST(test_picked), TEST(test_four_curves), TEST(test_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
