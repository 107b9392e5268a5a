/* Coordinates on strips, plain operations on paths, and developments point by point. */
#include "core/numbers.h"
#include "fab/flat/axis.h"
#include "fab/flat/unroll.h"
#include "tests/unit/asserts.h"

static void assert_point(lam_vec2 p, double x, double y, const char *what) {
  if (!(hypot(p.x - x, p.y - y) <= 1e-12))
    fail_msg("%s: (%.15g, %.15g), expected (%.15g, %.15g)", what, p.x, p.y, x, y);
}

/* ---- the axis: 3 m along x, then 4 m along y ---- */

static const lam_vec2 angle_points[3] = {{0, 0}, {3, 0}, {3, 4}};

static void an_axis_measures_its_length(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_axis axis = lam_axis_make(arena, angle_points, 3);
  assert_near(axis.s[0], 0, 0);
  assert_near(axis.s[1], 3, 0);
  assert_near(axis.s[2], 7, 0);
  assert_near(axis.length, 7, 0);
  assert_int_equal(axis.count, 3);
  assert_point(axis.normals[0], 0, 1, "left of the start");
  assert_point(axis.normals[1], -sqrt(.5), sqrt(.5), "along the bisector of the corner");
  assert_point(axis.normals[2], -1, 0, "left of the end");
  lam_arena_free(arena);
}

/* Normals turn steadily from one corner to the next: by 22.5 degrees at the middle of a side. */
static void points_have_two_coordinates(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_axis axis = lam_axis_make(arena, angle_points, 3);
  double c = cos(LAM_PI / 8), s = sin(LAM_PI / 8);
  lam_vec2 up;
  assert_point(lam_axis_point(&axis, 1.5, 2, &up), 1.5 - 2 * s, 2 * c, "in the first side");
  assert_point(up, -s, c, "the normal there");
  assert_point(lam_axis_point(&axis, 5, -1, &up), 3 + c, 2 - s, "in the second side, right of it");
  assert_point(up, -c, s, "the normal there");
  assert_point(lam_axis_point(&axis, 3, 2, NULL), 3 - sqrt(2), sqrt(2), "at the corner");
  assert_point(lam_axis_point(&axis, -1, 2, &up), -1, 2, "before the start");
  assert_point(up, 0, 1, "the normal there");
  assert_point(lam_axis_point(&axis, 8, 1, &up), 2, 5, "beyond the end");
  assert_point(up, -1, 0, "the normal there");
  lam_arena_free(arena);
}

/* A staircase of unit steps: positions in each of its eight sides. */
static void every_side_is_found(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_vec2 stairs[9];
  for (int i = 0; i < 9; i++) stairs[i] = lam_v2((i + 1) / 2, i / 2);
  lam_axis axis = lam_axis_make(arena, stairs, 9);
  for (int i = 0; i < 8; i++) {
    lam_vec2 a = stairs[i], b = stairs[i + 1];
    assert_point(lam_axis_point(&axis, i + .25, 0, NULL), a.x + .25 * (b.x - a.x),
                 a.y + .25 * (b.y - a.y), "a quarter into a side");
    assert_point(lam_axis_point(&axis, i, 0, NULL), a.x, a.y, "at a corner");
  }
  lam_arena_free(arena);
}

/* The nearest point of the axis counts, and the first of two that are equally near. */
static void points_are_located(void **state) {
  (void)state;
  static const struct {
    lam_vec2 at;
    double s, h;
  } cases[] = {{{1, 2}, 1, 2},     {{2.5, 1}, 4, .5},      {{4, 2}, 5, -1},
               {{1, -.5}, 1, -.5}, {{4, -1}, 3, -M_SQRT2}, {{-2, 1}, -2, 1},
               {{3, 6}, 9, 0},     {{2, 9}, 12, 1},        {{-2, -1.5}, -2, -1.5}};
  lam_arena *arena = lam_arena_new();
  lam_axis axis = lam_axis_make(arena, angle_points, 3);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_point(lam_axis_locate(&axis, cases[i].at), cases[i].s, cases[i].h, "located");
  lam_arena_free(arena);
}

/* ---- paths ---- */

static const lam_vec2 square[4] = {{1, 2}, {4, 2}, {4, 5}, {1, 5}};

static void areas_of_outlines_less_holes(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths paths = {.arena = arena};
  lam_vec2 turned[4] = {square[3], square[2], square[1], square[0]};
  lam_path path = {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = turned};
  assert_near(lam_path_area(&path), -9, 0); /* clockwise */
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4, square);
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4, turned);
  lam_paths_add(&paths, LAM_LAYER_CUT, false, 4, square);
  lam_paths_add(&paths, LAM_LAYER_ENGRAVE, true, 4, square);
  lam_paths_hole(&paths, lam_v2(2, 3), 0.4);
  assert_int_equal(paths.count, 5);
  assert_near(lam_path_area(&paths.items[0]), 9, 0);
  assert_near(lam_paths_area(paths.items, paths.count), 18 - LAM_PI * 0.04, 1e-12);
  lam_arena_free(arena);
}

/* A polygon of 48 corners with the area of the circle, on CUT and closed; the first corner lies to
 * the right of the center. */
static void holes_are_round(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths paths = {.arena = arena};
  lam_paths_hole(&paths, lam_v2(2, 3), 0.4);
  const lam_path *hole = &paths.items[0];
  double radius = sqrt(LAM_PI * 0.04 / (24 * sin(LAM_PI / 24)));
  assert_true(hole->closed && hole->hole && hole->layer == LAM_LAYER_CUT && hole->count == 48);
  for (int i = 0; i < 48; i++)
    assert_point(hole->points[i], 2 + radius * cos(LAM_PI * i / 24),
                 3 + radius * sin(LAM_PI * i / 24), "a corner");
  lam_arena_free(arena);
}

/* A quarter turn takes (x, y) to (-y, x); then the move. Copies keep what a path is. */
static void paths_are_moved(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_vec2 points[4] = {square[0], square[1], square[2], square[3]};
  const lam_path path = {
      .layer = LAM_LAYER_ENGRAVE, .closed = true, .hole = true, .count = 4, .points = points};
  const lam_motion quarter = {0, 1, {10, 20}}, slanted = {.6, .8, {0, 0}};
  lam_path *moved = lam_paths_placed(arena, &path, 1, &quarter);
  for (int i = 0; i < 4; i++)
    assert_point(moved->points[i], 10 - square[i].y, 20 + square[i].x, "moved");
  assert_true(moved->layer == LAM_LAYER_ENGRAVE && moved->closed && moved->hole);
  assert_int_equal(moved->count, 4);
  assert_point(points[1], 4, 2, "the original");
  assert_point(lam_motion_apply(&slanted, lam_v2(5, 10)), -5, 10, "by 3-4-5");
  lam_arena_free(arena);
}

static void bounds_are_those_of_all_points(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths paths = {.arena = arena};
  lam_flat flat = {0};
  lam_vec2 min, max;
  lam_paths_bounds(NULL, 0, &min, &max);
  assert_point(min, 0, 0, "no points");
  assert_point(max, 0, 0, "no points");
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4, square);
  lam_paths_add(&paths, LAM_LAYER_LABEL, false, 2, (lam_vec2[]){{3, 7}, {9, 3}});
  lam_flat_set_paths(&flat, &paths);
  assert_int_equal(flat.path_count, 2);
  assert_true(flat.paths == paths.items);
  assert_point(flat.min, 1, 2, "lower left");
  assert_point(flat.max, 9, 7, "upper right");
  lam_arena_free(arena);
}

/* Sides that cross: none on a square, one on a bow tie, five on a five-pointed star (drawn in one
 * stroke); a corner that touches a side does not cross it. */
static void crossings_of_outlines_are_counted(void **state) {
  (void)state;
  lam_vec2 star[5];
  for (int i = 0; i < 5; i++) star[i] = lam_v2(cos(4 * LAM_PI * i / 5), sin(4 * LAM_PI * i / 5));
  lam_vec2 box[4] = {square[0], square[1], square[2], square[3]},
           tie[4] = {square[0], square[2], square[1], square[3]},
           touching[5] = {{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}},
           last[4] = {{0, 1}, {2, 0}, {0, 0}, {2, 1}}; /* the last side crosses the second */
  const lam_path paths[] = {
      {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = box},
      {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = tie},
      {.layer = LAM_LAYER_CUT, .closed = true, .count = 5, .points = star},
      {.layer = LAM_LAYER_CUT, .closed = true, .count = 5, .points = touching},
      {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = last}};
  static const int expected[] = {0, 1, 5, 0, 1};
  for (int i = 0; i < 5; i++) assert_int_equal(lam_path_crossings(&paths[i]), expected[i]);
}

/* ---- developments ---- */

enum { n = 9 };

/* An arc of radius 3 m in steps of 0.1 rad, m in its plane, away from its center (side 1) or
 * towards it (-1). It lies in a plane already: the flat line bends away from m, or towards m. By
 * planes and by angles the first edge runs along x; by triangles the first section is upright. */
static void arcs_bend_to_their_side(void **state) {
  (void)state;
  const double radius = 3, step = 0.1, chord = 2 * radius * sin(step / 2);
  for (int side = -1; side <= 1; side += 2) {
    lam_vec3 x[n], m[n];
    lam_vec2 planes[n], angles[n], triangles[n], at = {0, 0};
    for (int i = 0; i < n; i++) {
      double a = i * step;
      x[i] = lam_v3(radius * sin(a), 0, radius * cos(a));
      m[i] = lam_v3(side * sin(a), 0, side * cos(a));
    }
    lam_unroll(x, m, n, planes);
    lam_unroll_angles(x, m, n, angles);
    lam_unroll_triangles(x, m, 0.2, n, triangles);
    for (int i = 0; i < n; i++) {
      assert_point(planes[i], at.x, at.y, "by planes");
      assert_point(angles[i], at.x, at.y, "by angles");
      at = lam_v2(at.x + chord * cos(i * step), at.y - side * chord * sin(i * step));
      assert_point(triangles[i], radius * sin(i * step), -side * radius * (1 - cos(i * step)),
                   "by triangles");
    }
  }
}

/* A helical ramp of planes: edges of a square tower that climbs, m upright. Every wall is a plane,
 * and unrolled the climb is straight: by 1 m across and 0.5 m up, the length is sqrt(1.25) each. */
static void walls_unroll_side_by_side(void **state) {
  (void)state;
  const lam_vec3 x[5] = {{0, 0, 0}, {1, 0, .5}, {1, 1, 1}, {0, 1, 1.5}, {0, 0, 2}};
  const lam_vec3 m[5] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  lam_vec2 flat[5];
  lam_unroll(x, m, 5, flat);
  for (int i = 0; i < 5; i++) assert_point(flat[i], i * sqrt(1.25), 0, "on the wall");
  lam_unroll_triangles(x, m, 1, 5, flat); /* sections upright: the climb shows */
  for (int i = 0; i < 5; i++) assert_point(flat[i], i, .5 * i, "with upright sections");
}

/* Distance from the chord over the length of the line: 1/3 on three sides of a square; where the
 * ends meet, from that point: the far corner of the square, sqrt(2) of 4; 0 for a point. */
static void straightness_is_a_share_of_the_length(void **state) {
  (void)state;
  const lam_vec2 corner[5] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}, still[2] = {{1, 1}, {1, 1}};
  assert_near(lam_straightness(corner, 4), 1. / 3, 1e-15);
  assert_near(lam_straightness(corner, 3), sqrt(2) / 4, 1e-15);
  assert_near(lam_straightness(corner, 5), sqrt(8) / 8, 1e-15);
  assert_near(lam_straightness(still, 2), 0, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(an_axis_measures_its_length),
      cmocka_unit_test(points_have_two_coordinates),
      cmocka_unit_test(every_side_is_found),
      cmocka_unit_test(points_are_located),
      cmocka_unit_test(areas_of_outlines_less_holes),
      cmocka_unit_test(holes_are_round),
      cmocka_unit_test(paths_are_moved),
      cmocka_unit_test(bounds_are_those_of_all_points),
      cmocka_unit_test(crossings_of_outlines_are_counted),
      cmocka_unit_test(arcs_bend_to_their_side),
      cmocka_unit_test(walls_unroll_side_by_side),
      cmocka_unit_test(straightness_is_a_share_of_the_length),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
