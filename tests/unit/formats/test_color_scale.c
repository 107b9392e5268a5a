/* The color scales of maps: lightness is even, signs have their own sides, what is undefined is
 * gray. */
#include "formats/plot/color_scale.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

/* CIE lightness L* of a color, from its luminance (ITU-R BT.709 primaries): another measure of
 * evenness than the one that the scales are made with. */
static double lightness(lam_rgb c) {
  double y = .2126 * c.r + .7152 * c.g + .0722 * c.b;
  return y > 216. / 24389 ? 116 * cbrt(y) - 16 : y * 24389 / 27;
}

static void check_channels(lam_rgb c) {
  if (!(fmin(c.r, fmin(c.g, c.b)) >= -1e-9 && fmax(c.r, fmax(c.g, c.b)) <= 1 + 1e-9))
    fail_msg("%g %g %g is no color", c.r, c.g, c.b);
}

/* Dark to light: every tenth of the scale is lighter than the one before, none by more than twice
 * as much as another.
 */
static void sequential_is_even(void **state) {
  (void)state;
  double least = INFINITY, most = 0;
  for (int i = 0; i <= 100; i++) check_channels(lam_ramp_sequential(i / 100.));
  for (int i = 0; i < 10; i++) {
    double step =
        lightness(lam_ramp_sequential((i + 1) / 10.)) - lightness(lam_ramp_sequential(i / 10.));
    least = fmin(least, step), most = fmax(most, step);
  }
  if (!(least > 0 && most < 2 * least)) fail_msg("steps of lightness from %g to %g", least, most);
  assert_true(lightness(lam_ramp_sequential(0)) < 25 && lightness(lam_ramp_sequential(1)) > 85);
}

/* Lightest at the middle, blue below, red above; both sides equally dark at equal distance. */
static void diverging_has_two_sides(void **state) {
  (void)state;
  for (int i = 1; i <= 50; i++) {
    lam_rgb low = lam_ramp_diverging(.5 - i / 100.), high = lam_ramp_diverging(.5 + i / 100.);
    check_channels(low), check_channels(high);
    assert_true(low.b > low.r && high.r > high.b);
    if (fabs(lightness(low) - lightness(high)) > 4)
      fail_msg("%d: %g and %g", i, lightness(low), lightness(high));
    assert_true(lightness(low) < lightness(lam_ramp_diverging(.5 - (i - 1) / 100.)));
  }
  lam_rgb middle = lam_ramp_diverging(.5);
  assert_true(fabs(middle.r - middle.g) < 1e-3 && fabs(middle.g - middle.b) < 1e-3);
}

static lam_map map_of(double min, double max) {
  return (lam_map){.summary = {.min = min, .max = max, .count = 2}};
}

static void scales_fit_their_values(void **state) {
  (void)state;
  lam_map one_sided = map_of(2, 5), both = map_of(-1, 3), constant = map_of(90, 90 + 1e-9),
          zero = map_of(0, 0);
  lam_color_scale s = lam_map_scale(&one_sided);
  assert_true(s.low == 2 && s.high == 5 && !s.diverging && !s.constant);
  s = lam_map_scale(&both);
  assert_true(s.low == -3 && s.high == 3 && s.diverging);
  lam_rgb at_zero = lam_color_of(&s, 0), middle = lam_ramp_diverging(.5);
  assert_memory_equal(&at_zero, &middle, sizeof middle);
  assert_true(lam_map_scale(&constant).constant && lam_map_scale(&zero).constant);
}

static void assert_scale(lam_map map, double low, double high, bool diverging, bool constant) {
  lam_color_scale s = lam_map_scale(&map);
  if (!(s.low == low && s.high == high && s.diverging == diverging && s.constant == constant))
    fail_msg("%g to %g: scale from %g to %g, diverging %d, constant %d; expected %g, %g, %d, %d",
             map.summary.min, map.summary.max, s.low, s.high, s.diverging, s.constant, low, high,
             diverging, constant);
}

/* 0 is on one side; a range that is shared counts instead of the map's own; values are constant
 * within 1e-9 of the larger one, 9e-8 of 90. */
static void scales_have_limits(void **state) {
  (void)state;
  lam_map shared = map_of(1, 2), other = map_of(-1, 2);
  shared.range[0] = -2, shared.range[1] = 7;
  other.range[0] = 0, other.range[1] = 7;
  assert_scale(map_of(0, 3), 0, 3, false, false);
  assert_scale(map_of(-3, 0), -3, 0, false, false);
  assert_scale(map_of(-4, 1), -4, 4, true, false);
  assert_scale(map_of(-4, -1), -4, -1, false, false);
  assert_scale(map_of(90, 90 + 1e-7), 90, 90 + 1e-7, false, false);
  assert_scale(map_of(-90, -90 + 8e-8), -90, -90 + 8e-8, false, true);
  assert_scale(shared, -7, 7, true, false);
  assert_scale(other, 0, 7, false, false);
}

static void assert_color(lam_color_scale scale, double value, const char *expected) {
  lam_arena *arena = lam_arena_new();
  char color[8] = "";
  lam_text text = {.arena = arena};
  lam_rgb_write(&text, lam_color_of(&scale, value));
  if (text.length == 7) memcpy(color, text.data, 7);
  lam_arena_free(arena);
  if (strcmp(color, expected)) fail_msg("%g is %s, expected %s", value, color, expected);
}

/* Colors by a program of their own from Ottosson's formulas and the constants in core/ramp.c;
 * values beyond the ends have the colors of the ends, a constant that of the middle, what is not
 * finite is gray: .7 of linear light is 218. */
static void values_have_their_colors(void **state) {
  (void)state;
  const lam_color_scale one = {2, 6, false, false}, two = {-4, 4, true, false},
                        constant = {2, 2, false, true};
  assert_color(one, 2, "#321556");
  assert_color(one, 3, "#0b5493");
  assert_color(one, 4, "#00929b");
  assert_color(one, 6, "#f5ea5c");
  assert_color(one, 1, "#321556");
  assert_color(one, 7, "#f5ea5c");
  assert_color(two, -4, "#005bb4");
  assert_color(two, -2, "#7fa6d8");
  assert_color(two, 0, "#eeeeee");
  assert_color(two, 4, "#a82418");
  assert_color(two, -5, "#005bb4");
  assert_color(two, 5, "#a82418");
  assert_color(constant, 2, "#00929b");
  assert_color(one, NAN, "#dadada");
  assert_color(two, INFINITY, "#dadada");
}

/* 0.5 of linear light is 188 in sRGB (IEC 61966-2-1). */
static void colors_as_text(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_text text = {.arena = arena};
  lam_rgb_write(&text, (lam_rgb){0, .5, 1});
  assert_string_equal(text.data, "#00bcff");
  lam_color_scale s = {0, 1, false, false};
  lam_rgb undefined = lam_color_of(&s, -INFINITY), not_a_number = lam_color_of(&s, NAN);
  assert_true(undefined.r == undefined.g && undefined.g == undefined.b);
  assert_memory_equal(&undefined, &not_a_number, sizeof undefined);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sequential_is_even),       cmocka_unit_test(diverging_has_two_sides),
      cmocka_unit_test(scales_fit_their_values),  cmocka_unit_test(scales_have_limits),
      cmocka_unit_test(values_have_their_colors), cmocka_unit_test(colors_as_text),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
