/* Histograms of color maps: what is expected follows by hand from the box that is given, in
 * millimeters. */
#include "tests/unit/plot_fixture.h"

#include <stdio.h>

static const char *histogram_of(lam_arena *arena, const lam_map *map, const lam_color_scale *scale,
                                lam_box box) {
  lam_text out = {.arena = arena};
  lam_plot_histogram(&out, map, scale, box);
  return out.data;
}

/* ---- bars ---- */

/* The sequential scale at (k + 1/2) / 24. */
static const char *const bin_colors[24] = {
    "#331a5c", "#322468", "#302e73", "#2c397e", "#244387", "#174e8f", "#005994", "#006493",
    "#006f94", "#007996", "#008398", "#008d9a", "#00979b", "#00a19b", "#00ac9a", "#00b696",
    "#1dc08f", "#48c888", "#67cf81", "#83d678", "#9ddb70", "#b7e068", "#d0e562", "#e9e85d"};

/* From 0 to 24 in 24 bins of 2 mm: a value on a limit is in the bin above it, the largest in the
 * last one. At most 4 in a bin: 10 mm of the 40 for each. Not counted: what is not finite. The
 * mean, 10, stands at 100 + 20. Five ticks: 24 / 6 = 4, the next of 1, 2, 5 is 5. */
static void bars_count_values(void **state) {
  const double values[] = {0,  .5,   1,  12,  12.2,     12.4,      12.6,
                           23, 23.9, 24, NAN, INFINITY, -INFINITY, 13};
  const lam_map map = {.on = LAM_MAP_VERTICES,
                       .summary = {"size", "m2", 0, 24, 10, 10},
                       .count = 13, /* not the last */
                       .values = values};
  static const int counts[24] = {[0] = 2, [1] = 1, [12] = 4, [23] = 3};
  lam_text bars = {.arena = *state};
  for (int k = 0; k < 24; k++)
    lam_text_printf(&bars,
                    "<rect class=\"bin\" x=\"%d\" y=\"%d\" width=\"2\" height=\"%d\" fill=\"%s\">"
                    "<title>%d from %d to %d</title></rect>\n"
                    "<rect class=\"color\" x=\"%d\" y=\"91\" width=\"2\" height=\"2\" "
                    "fill=\"%s\"/>\n",
                    100 + 2 * k, 90 - 10 * counts[k], 10 * counts[k], bin_colors[k], counts[k], k,
                    k + 1, 100 + 2 * k, bin_colors[k]);
  const char *const expected[] = {
      BEGIN,
      TEXT("100", "45", "2.6", "start", "Number of vertices"),
      LINE("grid", "100", "90", "148", "90"),
      TEXT("98.8", "90.91", "2.6", "end", "0"),
      LINE("grid", "100", "80", "148", "80"),
      TEXT("98.8", "80.91", "2.6", "end", "1"),
      LINE("grid", "100", "70", "148", "70"),
      TEXT("98.8", "70.91", "2.6", "end", "2"),
      LINE("grid", "100", "60", "148", "60"),
      TEXT("98.8", "60.91", "2.6", "end", "3"),
      LINE("grid", "100", "50", "148", "50"),
      TEXT("98.8", "50.91", "2.6", "end", "4"),
      bars.data,
      LINE("axis", "100", "90", "148", "90"),
      LINE("axis", "100", "93", "100", "94"),
      TEXT("100", "96.68", "2.6", "middle", "0"),
      LINE("axis", "110", "93", "110", "94"),
      TEXT("110", "96.68", "2.6", "middle", "5"),
      LINE("axis", "120", "93", "120", "94"),
      TEXT("120", "96.68", "2.6", "middle", "10"),
      LINE("axis", "130", "93", "130", "94"),
      TEXT("130", "96.68", "2.6", "middle", "15"),
      LINE("axis", "140", "93", "140", "94"),
      TEXT("140", "96.68", "2.6", "middle", "20"),
      LINE("mean", "120", "49", "120", "90"),
      TEXT("120", "48.4", "2.6", "middle", "mean"),
      TEXT("124", "101", "2.8", "middle", "size (m\u00b2)"),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "histogram",
                histogram_of(*state, &map, &(lam_color_scale){0, 24, false, false},
                             (lam_box){100, 50, 48, 40}),
                expected);
}

/* A constant map has one bar of the whole width in the middle color, its value below, no mean. Bars
 * have 3 decimals, texts 2; a measure without a unit has no brackets. */
static void a_constant_has_one_bar(void **state) {
  const double value = 1 / 3., values[] = {value, value, NAN};
  const lam_map map = {.on = LAM_MAP_EDGES,
                       .summary = {"angle", "", value, value, value, 2},
                       .count = 3,
                       .values = values};
  const char *const expected[] = {
      BEGIN,
      TEXT("1.23", "5", "2.6", "start", "Number of edges"),
      LINE("grid", "1.235", "18", "11.235", "18"),
      TEXT("0.03", "18.91", "2.6", "end", "0"),
      LINE("grid", "1.235", "14", "11.235", "14"),
      TEXT("0.03", "14.91", "2.6", "end", "1"),
      LINE("grid", "1.235", "10", "11.235", "10"),
      TEXT("0.03", "10.91", "2.6", "end", "2"),
      BAR("1.235", "10", "10", "8", MIDDLE, "2 from 0.333333 to 0.333333"),
      SAMPLE("1.235", "19", "10", MIDDLE),
      LINE("axis", "1.235", "18", "11.235", "18"),
      TEXT("6.23", "24.7", "2.6", "middle", "0.333333333"),
      TEXT("6.23", "29", "2.8", "middle", "angle"),
      "</g>\n",
      NULL,
  };
  assert_pieces(*state, "histogram",
                histogram_of(*state, &map, &(lam_color_scale){value, value, false, true},
                             (lam_box){1.2346, 10.0004, 10.0004, 7.9996}),
                expected);
}

/* Maps that share a range show all of it, 2 to 50 in bins of 2, though these values go from 4 to 6;
 * what lies above is in the last bin. */
static void a_shared_range_is_shown_whole(void **state) {
  const double values[] = {4, 6, 52};
  const lam_map map = {.on = LAM_MAP_FACES,
                       .summary = {"size", "", 4, 6, 5, 2},
                       .count = 3,
                       .values = values,
                       .range = {2, 50}};
  const char *text =
      histogram_of(*state, &map, &(lam_color_scale){2, 50, false, false}, (lam_box){0, 0, 48, 10});
  assert_holds(text, BAR("0", "10", "2", "0", "#331a5c", "0 from 2 to 4"));
  assert_holds(text, BAR("2", "0", "2", "10", "#322468", "1 from 4 to 6"));
  assert_holds(text, BAR("4", "0", "2", "10", "#302e73", "1 from 6 to 8"));
  assert_holds(text, BAR("46", "0", "2", "10", "#e9e85d", "1 from 48 to 50"));
  assert_holds(text, LINE("mean", "3", "-1", "3", "10"));
}

/* Bins from -5.5 to 18.5: the sixth lies around 0, where a scale of both signs is palest. */
static void bars_have_the_colors_of_the_scale(void **state) {
  const double values[] = {-5.5, 18.5};
  const lam_map map = {.summary = {"size", "", -5.5, 18.5, 0, 2}, .count = 2, .values = values};
  const char *text = histogram_of(*state, &map, &(lam_color_scale){-18.5, 18.5, true, false},
                                  (lam_box){0, 0, 48, 10});
  assert_holds(text, BAR("10", "10", "2", "0", "#eeeeee", "0 from -0.5 to 0.5"));
}

/* ---- axes ---- */

/* The labels of an axis with their places, "x label; x label; ", by what stands between the two in
 * the file. */
static const char *labels_of(lam_arena *arena, const char *text, bool of_counts) {
  lam_text list = {.arena = arena};
  lam_text_add(&list, "");
  for (const char *at = text; (at = strstr(at, "<text x=\"")) != NULL; at++) {
    char x[40], y[40], anchor[40], label[40];
    int found = sscanf(at,
                       "<text x=\"%39[^\"]\" y=\"%39[^\"]\" font-size=\"2.6\" "
                       "text-anchor=\"%39[^\"]\">%39[^<]",
                       x, y, anchor, label);
    if (found != 4) continue;
    if (of_counts && !strcmp(anchor, "end")) lam_text_printf(&list, "%s %s; ", y, label);
    if (!of_counts && !strcmp(y, "16.68")) lam_text_printf(&list, "%s %s; ", x, label);
  }
  return list.data;
}

/* The ticks of values from low to high on so many millimeters; 10 mm high. */
static void assert_ticks(lam_arena *arena, double low, double high, double width,
                         const char *expected) {
  const double values[] = {low, high};
  const lam_map map = {.summary = {"size", "", low, high, low, 2}, .count = 2, .values = values};
  const char *text = histogram_of(arena, &map, &(lam_color_scale){low, high, false, false},
                                  (lam_box){0, 0, width, 10});
  assert_lines(lam_arena_printf(arena, "from %.9g to %.9g on %g mm", low, high, width),
               labels_of(arena, text, false), expected);
}

/* Steps are 1, 2 or 5 times a power of ten, at least a sixth of the range. Whole numbers below a
 * million are written in full: 100 degrees were 1e+02 beside 80. */
static void ticks_have_round_steps(void **state) {
  assert_ticks(*state, 0, 13, 130, "0 0; 50 5; 100 10; ");
  assert_ticks(*state, 0, 48, 96, "0 0; 20 10; 40 20; 60 30; 80 40; ");
  assert_ticks(*state, 0, 240, 240, "0 0; 50 50; 100 100; 150 150; 200 200; ");
  assert_ticks(*state, 50, 130, 80, "10 60; 30 80; 50 100; 70 120; ");
  assert_ticks(*state, 0, 1.1e6, 110,
               "0 0; 20 200000; 40 400000; 60 600000; 80 800000; 100 1e+06; ");
  assert_ticks(*state, 1e6, 1e6 + 25, 150,
               "0 1000000; 30 1000005; 60 1000010; 90 1000015; 120 1000020; 150 1000025; ");
  assert_ticks(*state, 0, .03, 66,
               "0 0; 11 0.005; 22 0.01; 33 0.015; 44 0.02; 55 0.025; 66 0.03; ");
  assert_ticks(*state, -1, 24, 100, "4 0; 24 5; 44 10; 64 15; 84 20; ");
  assert_ticks(*state, -10, 15, 100, "0 -10; 20 -5; 40 0; 60 5; 80 10; 100 15; ");
}

/* A letter has .62 of 2.6 mm, 1.612 mm, and labels are 2 mm apart: "20" needs 5.224 mm. 24 in steps
 * of 5 have 5.25 on 25.2 mm, and 5.2 on 24.96 mm: the next step is 10. "100" at the end needs 6.836
 * mm: steps of 20 have 8 on 40 mm and 6 on 30. "-100" needs 8.448: steps of 50 have 10 on 20 mm.
 * Seven digits need 13.284 mm: steps of 1 have 20 on 48 mm, steps of 1/2 too little. */
static void labels_have_room(void **state) {
  assert_ticks(*state, 0, 24, 25.2, "0 0; 5.25 5; 10.5 10; 15.75 15; 21 20; ");
  assert_ticks(*state, 0, 24, 24.96, "0 0; 10.4 10; 20.8 20; ");
  assert_ticks(*state, 0, 100, 40, "0 0; 8 20; 16 40; 24 60; 32 80; 40 100; ");
  assert_ticks(*state, 0, 100, 30, "0 0; 15 50; 30 100; ");
  assert_ticks(*state, -100, 0, 20, "0 -100; 10 -50; 20 0; ");
  assert_ticks(*state, 1e6, 1e6 + 2.4, 48, "0 1000000; 20 1000001; 40 1000002; ");
  assert_ticks(*state, 0, 24, 1.5, "0 0; "); /* no room at all */
}

/* More digits than a double is sure to have (DBL_DIG, 15) are not written. */
static void labels_have_at_most_fifteen_digits(void **state) {
  assert_ticks(*state, 1e15, 1e15 + 4, 60, "0 1e+15; 15 1e+15; 30 1e+15; 45 1e+15; 60 1e+15; ");
}

/* The counts of a bin with so many values and one with a single one, 60 mm high. */
static void assert_counts(lam_arena *arena, int most, const char *expected) {
  double *values = LAM_NEW(arena, double, most + 1);
  values[most] = 1;
  const lam_map map = {
      .summary = {"size", "", 0, 1, .5, most + 1}, .count = most + 1, .values = values};
  const char *text =
      histogram_of(arena, &map, &(lam_color_scale){0, 1, false, false}, (lam_box){0, 0, 50, 60});
  assert_lines("counts", labels_of(arena, text, true), expected);
}

/* From 0 in whole steps of at least a fifth: 12 / 5 gives 5, 10 / 5 gives 2. */
static void counts_are_whole(void **state) {
  assert_counts(*state, 1, "60.91 0; 0.91 1; ");
  assert_counts(*state, 10, "60.91 0; 48.91 2; 36.91 4; 24.91 6; 12.91 8; 0.91 10; ");
  assert_counts(*state, 12, "60.91 0; 35.91 5; 10.91 10; ");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(bars_count_values),
      TEXT_TEST(a_constant_has_one_bar),
      TEXT_TEST(a_shared_range_is_shown_whole),
      TEXT_TEST(bars_have_the_colors_of_the_scale),
      TEXT_TEST(ticks_have_round_steps),
      TEXT_TEST(labels_have_room),
      TEXT_TEST(labels_have_at_most_fifteen_digits),
      TEXT_TEST(counts_are_whole),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
