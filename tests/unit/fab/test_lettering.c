/* The stroke alphabet. */
#include "plane_grid.h"

#include "fab/flat/lettering.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static lam_paths letters(lam_arena *arena, const char *text, lam_vec2 origin, double angle,
                         double height) {
  lam_paths paths = {.arena = arena};
  lam_lettering_add(&paths, LAM_LAYER_LABEL, text, origin, angle, height);
  return paths;
}

static bool same_strokes(const lam_paths *a, const lam_paths *b) {
  if (a->count != b->count) return false;
  for (int i = 0; i < a->count; i++) {
    if (a->items[i].count != b->items[i].count) return false;
    for (int k = 0; k < a->items[i].count; k++)
      if (a->items[i].points[k].x != b->items[i].points[k].x ||
          a->items[i].points[k].y != b->items[i].points[k].y)
        return false;
  }
  return true;
}

/* The alphabet promised in the header is there, and no two characters look the same. */
static void every_character_is_drawn_and_differs(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const char *all = lam_lettering_characters();
  const char *promised = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-./()+:";
  lam_paths missing = letters(arena, "~", lam_v2(0, 0), 0, 9);
  assert_int_equal(missing.count, 1);
  for (const char *c = promised; *c; c++) {
    assert_non_null(strchr(all, *c));
    lam_paths shape = letters(arena, (char[]){*c, 0}, lam_v2(0, 0), 0, 9);
    assert_true(shape.count > 0);
    assert_false(same_strokes(&shape, &missing));
    for (const char *d = promised; d < c; d++) {
      lam_paths other = letters(arena, (char[]){*d, 0}, lam_v2(0, 0), 0, 9);
      if (same_strokes(&shape, &other)) fail_msg("%c and %c look the same", *c, *d);
    }
  }
  assert_int_equal(letters(arena, " ", lam_v2(0, 0), 0, 9).count, 0);
  lam_arena_free(arena);
}

/* By definition capitals are `height` high, descenders reach height/3, and lam_lettering_width is
 * the width of the box.
 */
static void strokes_stay_in_their_box(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  for (const char *c = lam_lettering_characters(); *c; c++) {
    char text[2] = {*c, 0};
    lam_paths shape = letters(arena, text, lam_v2(0, 0), 0, 0.012);
    lam_vec2 min, max;
    lam_paths_bounds(shape.items, shape.count, &min, &max);
    assert_true(min.x >= 0 && min.y >= -0.004 - 1e-15);
    assert_true(max.x <= lam_lettering_width(text, 0.012) + 1e-15 && max.y <= 0.012 + 1e-15);
    if (*c >= 'A' && *c <= 'Z') {
      assert_near(max.y - min.y, 0.012, 1e-15);
      assert_near(max.x, lam_lettering_width(text, 0.012), 1e-15);
    }
  }
  lam_arena_free(arena);
}

/* A word is as wide as its letters and the gaps between them: the last stroke of M8 ends where its
 * width says. */
static void words_are_as_wide_as_told(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_vec2 min, max;
  lam_paths word = letters(arena, "B12H", lam_v2(3, 4), 0, 2);
  lam_paths_bounds(word.items, word.count, &min, &max);
  assert_near(min.x, 3, 1e-12);
  assert_near(max.x, 3 + lam_lettering_width("B12H", 2), 1e-12);
  assert_near(min.y, 4, 1e-12);
  assert_near(max.y, 6, 1e-12);
  assert_near(lam_lettering_width("", 2), 0, 0);
  lam_arena_free(arena);
}

/* Turned by a quarter about its origin, (x, y) goes to (-y, x). */
static void text_turns_about_its_origin(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths flat = letters(arena, "A07a", lam_v2(0, 0), 0, 1),
            turned = letters(arena, "A07a", lam_v2(5, 7), acos(0), 1);
  assert_int_equal(flat.count, turned.count);
  for (int i = 0; i < flat.count; i++)
    for (int k = 0; k < flat.items[i].count; k++) {
      assert_near(turned.items[i].points[k].x, 5 - flat.items[i].points[k].y, 1e-12);
      assert_near(turned.items[i].points[k].y, 7 + flat.items[i].points[k].x, 1e-12);
    }
  lam_arena_free(arena);
}

static void assert_point(const lam_path *path, int k, double x, double y) {
  if (!(hypot(path->points[k].x - x, path->points[k].y - y) < 1e-12))
    fail_msg("point %d is (%.15g, %.15g), expected (%.15g, %.15g)", k, path->points[k].x,
             path->points[k].y, x, y);
}

/* On a grid with capitals 9 high, drawn .8 as wide: L is 5 wide, then come 2.5 of gap. The tail
 * of j is a parabola from (2, -1) over the control point (2, -3) to (0, -3): at t = 1/5 it is at
 * .64 a + .32 b + .04 c. */
static void letters_are_drawn_point_by_point(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths word = letters(arena, "Lj", lam_v2(1, 2), 0, 9);
  assert_int_equal(word.count, 3);
  const lam_path *l = &word.items[0], *tail = &word.items[1], *dot = &word.items[2];
  assert_true(l->layer == LAM_LAYER_LABEL && !l->closed);
  assert_int_equal(l->count, 3);
  assert_point(l, 0, 1, 11);
  assert_point(l, 1, 1, 2);
  assert_point(l, 2, 1 + .8 * 5, 2);
  assert_int_equal(tail->count, 7);
  assert_point(tail, 0, 1 + .8 * 9.5, 8);
  assert_point(tail, 1, 1 + .8 * 9.5, 1);
  assert_point(tail, 2, 1 + .8 * (7.5 + 1.92), 2 - .64 - .96 - .12);
  assert_point(tail, 6, 1 + .8 * 7.5, -1);
  assert_int_equal(dot->count, 2);
  assert_point(dot, 0, 1 + .8 * 9.5, 10);
  assert_near(lam_lettering_width("Lj", 9), .8 * (5 + 2.5 + 2), 1e-12);
  lam_arena_free(arena);
}

/* The upper bow of B runs from (3, 9) over the control points (5, 9) and (5, 5) to (3, 5): two
 * parabolas that meet halfway between these, in (5, 7). */
static void bows_of_two_parabolas_meet_halfway(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_paths letter = letters(arena, "B", lam_v2(0, 0), 0, 9);
  const lam_path *bow = &letter.items[0];
  assert_int_equal(bow->count, 3 + 5 + 5 + 1);
  assert_point(bow, 2, .8 * 3, 9);
  assert_point(bow, 4, .8 * (.36 * 3 + .48 * 5 + .16 * 5), .36 * 9 + .48 * 9 + .16 * 7);
  assert_point(bow, 7, .8 * 5, 7);
  assert_point(bow, 12, .8 * 3, 5);
  lam_arena_free(arena);
}

/* Letters are as wide as their strokes, from 0 on; but for t, which has a little room behind it,
 * and the space. */
static void letters_fill_their_width(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  for (const char *c = lam_lettering_characters(); *c; c++) {
    char text[2] = {*c, 0};
    lam_paths shape = letters(arena, text, lam_v2(0, 0), 0, 9);
    lam_vec2 min, max;
    lam_paths_bounds(shape.items, shape.count, &min, &max);
    double expected = *c == ' ' ? .8 * 3 : *c == 't' ? .8 * 4 : max.x;
    assert_near_named(lam_lettering_width(text, 9), expected, 1e-12, text);
  }
  /* what the alphabet lacks is a box of the size of a capital */
  lam_paths box = letters(arena, "~", lam_v2(0, 0), 0, 9);
  const double corner[5][2] = {{0, 0}, {0, 9}, {4.8, 9}, {4.8, 0}, {0, 0}};
  assert_int_equal(box.items[0].count, 5);
  for (int k = 0; k < 5; k++) assert_point(&box.items[0], k, corner[k][0], corner[k][1]);
  assert_near(lam_lettering_width("~", 9), 4.8, 1e-12);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_character_is_drawn_and_differs),
      cmocka_unit_test(strokes_stay_in_their_box),
      cmocka_unit_test(words_are_as_wide_as_told),
      cmocka_unit_test(text_turns_about_its_origin),
      cmocka_unit_test(letters_are_drawn_point_by_point),
      cmocka_unit_test(bows_of_two_parabolas_meet_halfway),
      cmocka_unit_test(letters_fill_their_width),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
