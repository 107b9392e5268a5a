/* What sheets are made with: rectangles packed, polygons moved by the kerf. */
#include "plane_grid.h"

#include "fab/flat/nest.h"
#include "fab/flat/path.h"
#include "fab/flat/path_offset.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

typedef struct box {
  lam_vec2 min, max;
} box;

static box bounds(const lam_path *paths, int count) {
  box b;
  lam_paths_bounds(paths, count, &b.min, &b.max);
  return b;
}

/* Distance between two boxes; negative when they overlap. */
static double gap(box a, box b) {
  return fmax(fmax(a.min.x - b.max.x, b.min.x - a.max.x),
              fmax(a.min.y - b.max.y, b.min.y - a.max.y));
}

/* ---- nesting ---- */

/* 400 rectangles of many sizes (a linear congruential generator, fixed seed): none overlaps
 * another, none leaves its sheet, and the sheets are at least as many as the area asks for and at
 * most twice as many. */
static void rectangles_do_not_overlap(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  enum { N = 400 };
  lam_nest_item items[N] = {{0}};
  unsigned random = 12345;
  double area = 0;
  for (int i = 0; i < N; i++) {
    random = random * 1103515245u + 12345u;
    items[i].width = 0.02 + (random >> 16) % 1000 / 1000.0 * 0.9;
    random = random * 1103515245u + 12345u;
    items[i].height = 0.02 + (random >> 16) % 1000 / 1000.0 * 0.3;
    area += items[i].width * items[i].height;
  }
  int sheets = lam_nest(arena, items, N, 2, 1);
  assert_true(sheets >= area / 2 && sheets <= area);
  for (int i = 0; i < N; i++) {
    assert_true(items[i].sheet >= 0 && items[i].sheet < sheets);
    box a = {{items[i].x, items[i].y}, {items[i].x + items[i].width, items[i].y + items[i].height}};
    assert_true(a.min.x >= 0 && a.min.y >= 0 && a.max.x <= 2 + 1e-9 && a.max.y <= 1 + 1e-9);
    for (int k = 0; k < i; k++) {
      box b = {{items[k].x, items[k].y},
               {items[k].x + items[k].width, items[k].y + items[k].height}};
      assert_true(items[k].sheet != items[i].sheet || gap(a, b) >= -1e-9);
    }
  }
  lam_arena_free(arena);
}

/* Strips that fill a sheet exactly need exactly that many sheets: 2 x 10 of 1 m x 0.1 m on 2 m x 1
 * m. */
static void full_sheets_are_filled(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_nest_item items[40];
  for (int i = 0; i < 40; i++) items[i] = (lam_nest_item){1, 0.1, 0, 0, 0};
  assert_int_equal(lam_nest(arena, items, 40, 2, 1), 2);
  lam_arena_free(arena);
}

/* On sheets of 4 x 2: the highest first, then the widest; each in the free room that is the least
 * higher than it, and among equals in the lowest. What fits nowhere begins a sheet. */
static void shelves_are_filled_from_the_highest(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_nest_item items[] = {{1, .5, 0, 0, 0},  {2, 1, 0, 0, 0},   {1, 1, 0, 0, 0},  {4, .9, 0, 0, 0},
                           {.5, .4, 0, 0, 0}, {3, 1.5, 0, 0, 0}, {.5, .1, 0, 0, 0}};
  static const lam_nest_item expected[] = {
      {1, .5, 0, 0, 1.5},  {2, 1, 1, 0, 0},   {1, 1, 1, 2, 0},    {4, .9, 1, 0, 1},
      {.5, .4, 0, 1, 1.5}, {3, 1.5, 0, 0, 0}, {.5, .1, 0, 1, 1.9}};
  assert_int_equal(lam_nest(arena, items, 7, 4, 2), 2);
  for (int i = 0; i < 7; i++) {
    assert_int_equal(items[i].sheet, expected[i].sheet);
    assert_near(items[i].x, expected[i].x, 1e-12);
    assert_near(items[i].y, expected[i].y, 1e-12);
  }
  lam_arena_free(arena);
}

/* ---- kerf ---- */

/* A comb of 100 x 20 mm with a slot of 2 mm moved outward by 0.1 mm: 100.2 x 20.2, slot 1.8; moved
 * inward: the reverse. A slot of 2 mm cannot take a kerf of 2.2 mm. */
static void offset_moves_every_side(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const lam_vec2 comb[] = {{0, 0},        {0.1, 0},      {0.1, 0.02},   {0.051, 0.02},
                           {0.051, 0.01}, {0.049, 0.01}, {0.049, 0.02}, {0, 0.02}};
  lam_vec2 moved[LAM_OFFSET_ROOM(48)];
  int count;
  for (int side = -1; side <= 1; side += 2) {
    double d = side * 1e-4;
    assert_true(lam_offset_polygon(arena, comb, 8, d, moved, &count));
    lam_path path = {.layer = LAM_LAYER_CUT, .closed = true, .count = count, .points = moved};
    box b = bounds(&path, 1);
    assert_int_equal(count, 8);
    assert_near(b.max.x - b.min.x, 0.1 + 2 * d, 2e-9);
    assert_near(b.max.y - b.min.y, 0.02 + 2 * d, 2e-9);
    assert_near(lam_path_area(&path), (0.1 + 2 * d) * (0.02 + 2 * d) - (0.002 - 2 * d) * 0.01,
                1e-9);
  }
  assert_false(lam_offset_polygon(arena, comb, 8, 1.1e-3, moved, &count));
  assert_false(lam_offset_polygon(arena, comb, 8, -0.02, moved, &count));
  lam_arena_free(arena);
}

/* Two squares of 10 mm joined by a neck of 1 mm: no side vanishes when it shrinks by .6 mm, but the
 * neck's sides pass each other. .4 mm leave a neck of .2 mm: 2 * 9.2^2 + 10.8 * .2 mm2. */
static void a_neck_does_not_close(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_vec2 bone[12] = {{0, 0},   {10, 0},  {10, 4.5}, {20, 4.5}, {20, 0},  {30, 0},
                       {30, 10}, {20, 10}, {20, 5.5}, {10, 5.5}, {10, 10}, {0, 10}};
  for (int i = 0; i < 12; i++) bone[i] = lam_v2(bone[i].x * 1e-3, bone[i].y * 1e-3);
  lam_vec2 moved[LAM_OFFSET_ROOM(12)];
  int count;
  assert_false(lam_offset_polygon(arena, bone, 12, -6e-4, moved, &count));
  assert_true(lam_offset_polygon(arena, bone, 12, -4e-4, moved, &count));
  lam_path path = {.layer = LAM_LAYER_CUT, .closed = true, .count = count, .points = moved};
  assert_near(lam_path_area(&path), (2 * 9.2 * 9.2 + 10.8 * .2) * 1e-6, 1e-12);
  lam_arena_free(arena);
}

/* A triangle with a tip of 2 atan(1/20) = 5.7 degrees, by 1 mm: the cut at the tip is 1 mm away,
 * not 20; a step of 1 um in a side, as rounding leaves it, does not count as a slot. */
static void tips_are_cut_off_and_crumbs_do_not_count(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const lam_vec2 tip[] = {{0, -.01}, {.2, 0}, {0, .01}};
  const lam_vec2 step[] = {{0, 0},         {.1, 0},        {.1, .02}, {.05, .02},
                           {.05, .019999}, {.049999, .02}, {0, .02}};
  lam_vec2 moved[LAM_OFFSET_ROOM(48)];
  int count;
  assert_true(lam_offset_polygon(arena, tip, 3, 1e-3, moved, &count));
  lam_path path = {.layer = LAM_LAYER_CUT, .closed = true, .count = count, .points = moved};
  assert_int_equal(count, 4);
  assert_near(bounds(&path, 1).max.x, .201, 1e-9);
  assert_true(lam_offset_polygon(arena, step, 7, 1e-3, moved, &count));
  path = (lam_path){.layer = LAM_LAYER_CUT, .closed = true, .count = count, .points = moved};
  assert_near(lam_path_area(&path), .102 * .022, 2e-6);
  lam_arena_free(arena);
}

/* A hole for an M8 bolt keeps the area of its circle (pi/4 d^2), and loses the kerf from its
 * diameter. */
static void holes_shrink_by_the_kerf(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths paths = {.arena = arena};
  lam_paths_hole(&paths, lam_v2(1, 1), 0.009);
  assert_near(lam_path_area(&paths.items[0]), acos(-1) / 4 * 81e-6, 1e-12);
  lam_vec2 moved[LAM_OFFSET_ROOM(48)];
  int count;
  assert_true(lam_offset_polygon(arena, paths.items[0].points, paths.items[0].count, -0.0001, moved,
                                 &count));
  lam_path path = {
      .layer = LAM_LAYER_CUT, .closed = true, .hole = true, .count = count, .points = moved};
  box before = bounds(paths.items, 1), after = bounds(&path, 1);
  assert_near(before.max.x - before.min.x - (after.max.x - after.min.x), 0.0002, 1e-6);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rectangles_do_not_overlap),
      cmocka_unit_test(full_sheets_are_filled),
      cmocka_unit_test(shelves_are_filled_from_the_highest),
      cmocka_unit_test(offset_moves_every_side),
      cmocka_unit_test(a_neck_does_not_close),
      cmocka_unit_test(tips_are_cut_off_and_crumbs_do_not_count),
      cmocka_unit_test(holes_shrink_by_the_kerf),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
