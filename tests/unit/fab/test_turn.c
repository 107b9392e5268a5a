/* Pieces that are turned so that they fit: hand-made rectangles. */
#include "core/numbers.h"
#include "fab/flat/turn.h"
#include "tests/unit/asserts.h"
#include "tests/unit/fab_fixture.h"

#include <math.h>

/* Corners of a rectangle w x h turned by an angle, and a point inside. */
static lam_path tilted(lam_arena *arena, double w, double h, double angle) {
  lam_motion turn = {cos(angle), sin(angle), {3, -2}};
  const lam_vec2 corners[] = {{0, 0}, {w, 0}, {w, h}, {0, h}, {w / 2, h / 2}};
  lam_path path = {.layer = LAM_LAYER_CUT, .closed = true, .count = 5};
  path.points = LAM_NEW(arena, lam_vec2, 5);
  for (int i = 0; i < 5; i++) path.points[i] = lam_motion_apply(&turn, corners[i]);
  return path;
}

static lam_vec2 size_after(lam_arena *arena, const lam_path *path, const lam_motion *turn) {
  lam_vec2 min, max;
  lam_paths_bounds(lam_paths_placed(arena, path, 1, turn), 1, &min, &max);
  return lam_v2(max.x - min.x, max.y - min.y);
}

/* As it lies where that fits, even when a smaller box is there: 2 x 1 at 30 degrees has the box
 * 2 cos 30 + sin 30 by 2 sin 30 + cos 30 = 2.232 x 1.866. */
static void what_fits_is_not_turned(void **state) {
  lam_path path = tilted(*state, 2, 1, LAM_PI / 6);
  lam_motion turn;
  assert_true(lam_turn_to_fit(*state, &path, 1, (double[]){2.233, 1.867}, &turn));
  assert_true(turn.cosine == 1 && turn.sine == 0);
}

/* A quarter where that is enough: exactly as large counts. */
static void a_quarter_comes_first(void **state) {
  lam_path path = tilted(*state, 1, 2, 0);
  lam_motion turn;
  assert_true(lam_turn_to_fit(*state, &path, 1, (double[]){2, 1}, &turn));
  assert_true(turn.cosine == 0 && turn.sine == 1);
}

/* The box of least area is the rectangle itself, lying or standing as the room is. */
static void the_least_box_is_found(void **state) {
  lam_path path = tilted(*state, 2, 1, .4);
  lam_motion turn;
  assert_true(lam_turn_to_fit(*state, &path, 1, (double[]){2.1, 1.05}, &turn));
  lam_vec2 size = size_after(*state, &path, &turn);
  assert_near(size.x, 2, 1e-12);
  assert_near(size.y, 1, 1e-12);
  assert_near(hypot(turn.cosine, turn.sine), 1, 1e-15);

  assert_true(lam_turn_to_fit(*state, &path, 1, (double[]){1.05, 2.1}, &turn));
  size = size_after(*state, &path, &turn);
  assert_near(size.x, 1, 1e-12);
  assert_near(size.y, 2, 1e-12);
}

/* A rhombus with diagonals 2 and 1 has sides of sqrt(1.25) and the area 1: along a side its box is
 * 1/sqrt(1.25) high and 2/sqrt(1.25) long, 1.6 in area, where the box of its diagonals has 2. */
static void a_rhombus_lies_along_its_side(void **state) {
  lam_vec2 corners[] = {{-1, 0}, {0, -.5}, {1, 0}, {0, .5}};
  lam_path rhombus = {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = corners};
  lam_motion turn;
  assert_true(lam_turn_to_fit(*state, &rhombus, 1, (double[]){1.9, .95}, &turn));
  lam_vec2 size = size_after(*state, &rhombus, &turn);
  assert_near(size.x, 2 / sqrt(1.25), 1e-12);
  assert_near(size.y, 1 / sqrt(1.25), 1e-12);
}

/* A trapezoid of sides 4, 2 and 3: 4 x 3 along its base, and along its slanted side, which falls 1
 * on 4, 19/sqrt(17) x 12/sqrt(17) = 4.61 x 2.91: flatter, but of area 13.4. Both fit. */
static void the_least_area_is_taken(void **state) {
  lam_motion turn = {cos(.4), sin(.4), {0, 0}};
  lam_vec2 corners[] = {{0, 0}, {4, 0}, {4, 2}, {0, 3}};
  for (int i = 0; i < 4; i++) corners[i] = lam_motion_apply(&turn, corners[i]);
  lam_path trapezoid = {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = corners};
  assert_true(lam_turn_to_fit(*state, &trapezoid, 1, (double[]){4.7, 3.05}, &turn));
  lam_vec2 size = size_after(*state, &trapezoid, &turn);
  assert_near(size.x, 4, 1e-12);
  assert_near(size.y, 3, 1e-12);
}

/* An ellipse of 24 corners, with semi-axes 1 and .5 and sides across its axes: 2 c x c there, with c
 * = cos(pi/24). The points on a line inside are on no hull. */
static void a_round_outline_lies_along_its_axis(void **state) {
  lam_motion turn = {cos(.4), sin(.4), {0, 0}};
  lam_vec2 points[48];
  for (int i = 0; i < 24; i++) {
    double angle = (i + .5) * LAM_PI / 12;
    points[2 * i] = lam_motion_apply(&turn, lam_v2(cos(angle), .5 * sin(angle)));
    points[2 * i + 1] = lam_v2(.01 * i, .002 * i);
  }
  lam_path ellipse = {.layer = LAM_LAYER_CUT, .closed = true, .count = 48, .points = points};
  assert_true(lam_turn_to_fit(*state, &ellipse, 1, (double[]){2, 1}, &turn));
  lam_vec2 size = size_after(*state, &ellipse, &turn);
  assert_near(size.x, 2 * cos(LAM_PI / 24), 1e-12);
  assert_near(size.y, cos(LAM_PI / 24), 1e-12);
}

static void what_is_too_large_stays(void **state) {
  lam_path path = tilted(*state, 2, 1, .4);
  lam_motion turn;
  assert_false(lam_turn_to_fit(*state, &path, 1, (double[]){1.99, 1.99}, &turn));
  assert_true(turn.cosine == 1 && turn.sine == 0);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(what_fits_is_not_turned), TEST(a_quarter_comes_first),
      TEST(the_least_box_is_found),  TEST(a_rhombus_lies_along_its_side),
      TEST(the_least_area_is_taken), TEST(a_round_outline_lies_along_its_axis),
      TEST(what_is_too_large_stays),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
