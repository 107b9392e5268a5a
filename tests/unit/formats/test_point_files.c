/* Points from text files. */
#include "formats/list/formats.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

static lam_arena *arena;

static int set_up(void **state) {
  (void)state;
  arena = lam_arena_new();
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  lam_arena_free(arena);
  return 0;
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

/* The same two points (1.5, -2, 3e2) and (4, 5, 6) in the dialects of scanners, surveyors and
 * spreadsheets. */
static void test_dialects(void **state) {
  (void)state;
  static const char *const texts[] = {
      "1.5 -2 3e2\n4 5 6\n",
      "1.5 -2 3e2\n4 5 6",
      "1.5\t-2\t3e2\r\n\r\n4\t5\t6\r\n",
      "x,y,z\n1.5,-2,3e2\n4,5,6\n",
      "X; Y; Z; R\n1.5; -2; 3e2; 255\n4; 5; 6; 0\n",
      "2\n1.5 -2 300 0.7 255 255 255\n4 5 6 0.1 0 0 0\n",
      "# scan of the vault\n1.5, -2, 300\n4, 5, 6 # last\n",
  };
  for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
    lam_errors errors = {.arena = arena};
    int count = 0;
    const lam_vec3 *points;
    bool sound = lam_format_named("points")->read_points(
        arena, texts[i], strlen(texts[i]), (lam_location){.file = "f"}, &errors, &count, &points);
    if (!sound || count != 2)
      fail_msg("%s: %d points, %s", texts[i], count, errors.first ? errors.first->text : "");
    assert_true(lam_distance(points[0], lam_v3(1.5, -2, 300)) == 0);
    assert_true(lam_distance(points[1], lam_v3(4, 5, 6)) == 0);
  }
}

/* What cannot be meant is refused at its line. */
static void test_refusals(void **state) {
  (void)state;
  static const struct {
    const char *text;
    int line;
    const char *part;
  } cases[] = {
      {"", 0, "no points"},
      {"x y z\n", 0, "no points"},
      {"1 2 3\n4 5\n", 2, "2 numbers given"},
      {"1 2 3\n\n4 5 abc\n", 3, "\"abc\" is not a number"},
      {"1,5 2,5 3,5\n", 1, "decimal point"},
      {"1,5; 2,5; 3,5\n", 1, "decimal point"},
      {"1 2 3\n1 2 1e999\n", 2, "not a number"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    lam_errors errors = {.arena = arena};
    int count = 0;
    const lam_vec3 *points;
    const char *text = cases[i].text;
    assert_false(lam_format_named("points")->read_points(
        arena, text, strlen(text), (lam_location){.file = "f"}, &errors, &count, &points));
    assert_int_equal(errors.count, 1);
    assert_int_equal(errors.first->location.line, cases[i].line);
    if (!strstr(errors.first->text, cases[i].part)) fail_msg("%s: %s", text, errors.first->text);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {TEST(test_dialects), TEST(test_refusals)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
