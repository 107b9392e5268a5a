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

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_character_is_drawn_and_differs),
      cmocka_unit_test(strokes_stay_in_their_box),
      cmocka_unit_test(words_are_as_wide_as_told),
      cmocka_unit_test(text_turns_about_its_origin),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
