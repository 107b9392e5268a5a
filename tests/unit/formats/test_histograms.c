/* Histograms of color maps, and the page around them (plots/MEASURE.svg): what is expected follows
 * by hand from the box that is given, in millimeters. Colors as in test_plots.c. */
#include "formats/plot/plot.h"
#include "tests/unit/text_fixture.h"

#include <stdio.h>

extern const lam_format lam_format_plot;

#define MIDDLE "#00929b"
#define GRAY "#dadada"
#define TEXT(x, y, size, anchor, text)                                                             \
  "<text x=\"" x "\" y=\"" y "\" font-size=\"" size "\" text-anchor=\"" anchor "\">" text          \
  "</text>\n"
#define LINE(class, x1, y1, x2, y2)                                                                \
  "<line class=\"" class "\" x1=\"" x1 "\" y1=\"" y1 "\" x2=\"" x2 "\" y2=\"" y2 "\"/>\n"
#define BAR(x, y, width, height, color, title)                                                     \
  "<rect class=\"bin\" x=\"" x "\" y=\"" y "\" width=\"" width "\" height=\"" height               \
  "\" fill=\"" color "\"><title>" title "</title></rect>\n"
#define SAMPLE(x, y, width, color)                                                                 \
  "<rect class=\"color\" x=\"" x "\" y=\"" y "\" width=\"" width "\" height=\"2\" fill=\"" color   \
  "\"/>\n"
#define BEGIN                                                                                      \
  "<g class=\"histogram\">\n<style>.axis { stroke: #202020; stroke-width: .2 } .grid { stroke: "   \
  "#d0d0d0; stroke-width: .12 } .mean { stroke: #202020; stroke-width: .3; stroke-dasharray: "     \
  "1 .7 } .bin { stroke: #202020; stroke-width: .1 } .color { shape-rendering: crispEdges "        \
  "}</style>\n"

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
 * last one. At most 4 in a bin: 10 mm of the 40 for each. Not counted: what is not finite. The mean,
 * 10, stands at 100 + 20. Five ticks: 24 / 6 = 4, the next of 1, 2, 5 is 5. */
static void bars_count_values(void **state) {
  const double values[] = {0, .5, 1, 12, 12.2, 12.4, 12.6, 23, 23.9, 24, NAN, INFINITY, -INFINITY};
  const lam_map map = {.on = LAM_MAP_VERTICES,
                       .summary = {"size", "m2", 0, 24, 10, 10},
                       .count = 13,
                       .values = values};
  static const int counts[24] = {[0] = 2, [1] = 1, [12] = 4, [23] = 3};
  lam_text expected = {.arena = *state};
  lam_text_add(
      &expected, BEGIN TEXT("100", "45", "2.6", "start", "Number of vertices") /* */
      LINE("grid", "100", "90", "148", "90") TEXT("98.8", "90.91", "2.6", "end", "0")
          LINE("grid", "100", "80", "148", "80") TEXT("98.8", "80.91", "2.6", "end", "1")
              LINE("grid", "100", "70", "148", "70") TEXT("98.8", "70.91", "2.6", "end", "2")
                  LINE("grid", "100", "60", "148", "60") TEXT("98.8", "60.91", "2.6", "end", "3")
                      LINE("grid", "100", "50", "148", "50")
                          TEXT("98.8", "50.91", "2.6", "end", "4"));
  for (int k = 0; k < 24; k++)
    lam_text_printf(&expected,
                    "<rect class=\"bin\" x=\"%d\" y=\"%d\" width=\"2\" height=\"%d\" fill=\"%s\">"
                    "<title>%d from %d to %d</title></rect>\n"
                    "<rect class=\"color\" x=\"%d\" y=\"91\" width=\"2\" height=\"2\" "
                    "fill=\"%s\"/>\n",
                    100 + 2 * k, 90 - 10 * counts[k], 10 * counts[k], bin_colors[k], counts[k], k,
                    k + 1, 100 + 2 * k, bin_colors[k]);
  lam_text_add(
      &expected, LINE("axis", "100", "90", "148", "90") /* */
      LINE("axis", "100", "93", "100", "94") TEXT("100", "96.68", "2.6", "middle", "0")
          LINE("axis", "110", "93", "110", "94") TEXT("110", "96.68", "2.6", "middle", "5") LINE(
              "axis", "120", "93", "120", "94") TEXT("120", "96.68", "2.6", "middle", "10")
              LINE("axis", "130", "93", "130", "94") TEXT("130", "96.68", "2.6", "middle", "15")
                  LINE("axis", "140", "93", "140", "94") TEXT("140", "96.68", "2.6", "middle", "20")
                      LINE("mean", "120", "49", "120", "90")
                          TEXT("120", "48.4", "2.6", "middle", "mean")
                              TEXT("124", "101", "2.8", "middle", "size (m\u00b2)") "</g>\n");
  assert_lines("histogram",
               histogram_of(*state, &map, &(lam_color_scale){0, 24, false, false},
                            (lam_box){100, 50, 48, 40}),
               expected.data);
}

/* A constant map has one bar of the whole width in the middle color, its value below, no mean. Bars
 * have 3 decimals, texts 2; a measure without a unit has no brackets. */
static void a_constant_has_one_bar(void **state) {
  const double value = 1 / 3., values[] = {value, value, NAN};
  const lam_map map = {.on = LAM_MAP_EDGES,
                       .summary = {"angle", "", value, value, value, 2},
                       .count = 3,
                       .values = values};
  const char *expected = BEGIN TEXT("1.23", "5", "2.6", "start", "Number of edges") /* */
      LINE("grid", "1.235", "18", "11.235", "18") TEXT("0.03", "18.91", "2.6", "end", "0")
          LINE("grid", "1.235", "14", "11.235", "14") TEXT("0.03", "14.91", "2.6", "end", "1")
              LINE("grid", "1.235", "10", "11.235", "10") TEXT("0.03", "10.91", "2.6", "end", "2")
                  BAR("1.235", "10", "10", "8", MIDDLE, "2 from 0.333333 to 0.333333")
                      SAMPLE("1.235", "19", "10", MIDDLE)
                          LINE("axis", "1.235", "18", "11.235", "18")
                              TEXT("6.23", "24.7", "2.6", "middle", "0.333333333")
                                  TEXT("6.23", "29", "2.8", "middle", "angle") "</g>\n";
  assert_lines("histogram",
               histogram_of(*state, &map, &(lam_color_scale){value, value, false, true},
                            (lam_box){1.2346, 10, 10, 8}),
               expected);
}

/* Maps that share a range show all of it, 0 to 48 in bins of 2, though these values go from 4 to 6;
 * what lies above is in the last bin. */
static void a_shared_range_is_shown_whole(void **state) {
  const double values[] = {4, 6, 50};
  const lam_map map = {.on = LAM_MAP_FACES,
                       .summary = {"size", "", 4, 6, 5, 2},
                       .count = 3,
                       .values = values,
                       .range = {0, 48}};
  const char *text =
      histogram_of(*state, &map, &(lam_color_scale){0, 48, false, false}, (lam_box){0, 0, 48, 10});
  assert_holds(text, BAR("0", "10", "2", "0", "#331a5c", "0 from 0 to 2"));
  assert_holds(text, BAR("4", "0", "2", "10", "#302e73", "1 from 4 to 6"));
  assert_holds(text, BAR("6", "0", "2", "10", "#2c397e", "1 from 6 to 8"));
  assert_holds(text, BAR("46", "0", "2", "10", "#e9e85d", "1 from 46 to 48"));
  assert_holds(text, LINE("mean", "5", "-1", "5", "10"));
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

/* ---- the page ---- */

#define PAGE(heading, size)                                                                        \
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "         \
  "width=\"196mm\" height=\"112mm\" viewBox=\"0 0 196 112\" font-family=\"Helvetica, Arial, "      \
  "sans-serif\" fill=\"#202020\">\n<title>" heading "</title>\n"                                   \
  "<rect width=\"196\" height=\"112\" fill=\"#ffffff\"/>\n" TEXT("8", "10", size, "start",         \
                                                                 heading)
#define ROW(y, name, text) TEXT("134", y, "2.8", "start", name) TEXT("154", y, "2.8", "start", text)

/* Two faces on the diagonal of the layout; the net itself is a point. */
static lam_vec3 vertices[8];
static int faces[][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}};
static const lam_mesh net = {8, vertices, 2, faces};
static const double values[] = {2.5, NAN};
static const lam_map area = {.on = LAM_MAP_FACES,
                             .doc = "Area of a face.",
                             .summary = {"area", "m2", 2.5, 2.5, 2.5, 1},
                             .count = 2,
                             .values = values};

static const char *page_of(lam_arena *arena, const char *title, const lam_map *map) {
  const lam_model model = {.name = "hut", .title = title, .net = &net, .map_count = 1, .maps = map};
  return text_of(arena, &lam_format_plot, &model, 0);
}

/* The view is in the box (6, 26), 108 mm x 80 mm, whose middle is (60, 66); the histogram in (134,
 * 32), 54 mm x 40 mm. */
static void page_of_a_map(void **state) {
#define POINT "M60,66 L60,66 60,66 60,66"
#define FACE(color)                                                                                \
  "<path d=\"" POINT " Z\" fill=\"" color "\" stroke=\"" color "\"/>\n"                            \
  "<path d=\"" POINT " Z\" class=\"line\"/>\n"
  const char *expected = PAGE("A hut &amp; shed: area", "4.4") TEXT(
      "8", "15", "2.8", "start",
      "Area of a face.") "<g class=\"view\" stroke-linejoin=\"round\" stroke-width=\"0.12\">\n"
                         "<style>.line { fill: none; stroke: #202020; stroke-opacity: .55 } .edge "
                         "{ fill: none; "
                         "stroke-linecap: round; stroke-width: 0.48 }</style>\n" FACE(MIDDLE) FACE(
                             GRAY) "</g>\n" BEGIN TEXT("134", "27", "2.6", "start",
                                                       "Number of faces") LINE("grid", "134", "72",
                                                                               "188", "72")
                             TEXT("132.8", "72.91", "2.6", "end",
                                  "0") LINE("grid", "134", "32", "188",
                                            "32") TEXT("132.8", "32.91", "2.6", "end", "1")
                                 BAR("134", "32", "54", "40", MIDDLE,
                                     "1 from 2.5 to 2.5") SAMPLE("134", "73", "54", MIDDLE)
                                     LINE("axis", "134", "72", "188",
                                          "72") TEXT("161", "78.7", "2.6", "middle", "2.5")
                                         TEXT("161", "83", "2.8", "middle",
                                              "area (m\u00b2)") "</g>\n" ROW("91", "minimum",
                                                                             "2.5 m\u00b2")
                                             ROW("95", "mean", "2.5 m\u00b2") ROW("99", "maximum",
                                                                                  "2.5 m\u00b2")
                                                 ROW("103", "counted", "1 faces") ROW(
                                                     "107", "undefined",
                                                     "1") "<rect x=\"150\" y=\"105\" width=\"2.4\" "
                                                          "height=\"2.4\" fill=\"" GRAY
                                                          "\"/>\n</svg>\n";
  assert_lines("plot", page_of(*state, "A hut & shed", &area), expected);
}

/* Minimum, mean and maximum are three numbers of 6 digits; 0 has no sign; without a unit there is no
 * blank, and without undefined values no row of them. */
static void the_summary_is_in_words(void **state) {
  lam_map map = area;
  const double all[] = {-1.23456789, 1e7};
  map.values = all;
  map.summary = (lam_measure){"area", "", -1.23456789, 1e7, -0., 2};
  const char *text = page_of(*state, "hut", &map);
  assert_holds(text, ROW("91", "minimum", "-1.23457") ROW("95", "mean", "0")
                         ROW("99", "maximum", "1e+07") ROW("103", "counted", "2 faces") "</svg>\n");
}

/* Without a value, or with a mean that is not a number, a sentence stands for the histogram. */
static void a_map_without_values_says_so(void **state) {
  lam_map map = area;
  map.summary = (lam_measure){"area", "m2", NAN, NAN, NAN, 0};
  assert_holds(page_of(*state, "hut", &map),
               "</g>\n" TEXT("134", "32", "2.8", "start", "No element has a value.") "</svg>\n");
  map.summary = (lam_measure){"area", "m2", 1, 2, INFINITY, 2};
  assert_holds(
      page_of(*state, "hut", &map),
      "</g>\n" TEXT("134", "32", "2.8", "start", "Some values are not numbers.") "</svg>\n");
  map.summary = (lam_measure){"area", "m2", 0, 0, 0, 0};
  assert_lacks(page_of(*state, "hut", &map), "histogram");
}

/* A heading is 4.4 mm high, or 300 mm by its letters: 3 mm for 94 of the title and 6 of ": area". */
static void long_headings_are_smaller(void **state) {
#define TEN "A long hut"
#define LONG TEN TEN TEN TEN TEN TEN TEN TEN TEN "four"
  const char *text = page_of(*state, LONG, &area);
  assert_ptr_equal(strstr(text, PAGE(LONG ": area", "3")), text);
}

/* Without a title, the name. */
static void a_heading_names_the_design(void **state) {
  assert_holds(page_of(*state, "", &area), "<title>hut: area</title>\n");
  assert_holds(page_of(*state, NULL, &area), "<title>hut: area</title>\n");
}

/* Lines of the measure's description have at most 125 letters and are broken at blanks, 1.3 times
 * 2.8 mm below each other. */
static void descriptions_are_broken_at_blanks(void **state) {
#define WORDS "abcd abcd abcd abcd abcd "
#define OTHERS WORDS WORDS WORDS WORDS "abcd abcd abcd abcd" /* 119 */
#define DOC(y, text) TEXT("8", y, "2.8", "start", text)
  lam_map map = area;
  map.doc = "x" OTHERS " abcd"; /* 125 */
  assert_holds(page_of(*state, "hut", &map), DOC("15", "x" OTHERS " abcd") "<g class=\"view\"");
  map.doc = "x" OTHERS " abcd  next " OTHERS " end";
  assert_holds(page_of(*state, "hut", &map),
               DOC("15", "x" OTHERS " abcd") DOC("18.64", "next " OTHERS)
                   DOC("22.28", "end") "<g class=\"view\"");
  map.doc = "xx" OTHERS " abcd"; /* 126 */
  assert_holds(page_of(*state, "hut", &map),
               DOC("15", "xx" OTHERS) DOC("18.64", "abcd") "<g class=\"view\"");
}

/* Square and cubic meters have a raised digit, also below a fraction bar; other units stay. */
static void units_are_raised(void **state) {
  static const char *const units[][2] = {
      {"m2", "m\u00b2"},     {"1/m3", "1/m\u00b3"}, {"m", "m"},   {"", ""},         {"2", "2"},
      {"m4", "m4"},          {"rad", "rad"},        {"s2", "s2"}, {"m2/s", "m2/s"}, {"1/m", "1/m"},
      {"1/m2", "1/m\u00b2"}, {"2m", "2m"}};
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    assert_string_equal(lam_plot_unit(*state, units[i][0]), units[i][1]);
}

static void a_plot_per_map_of_a_net(void **state) {
  lam_model model = {.name = "hut", .net = &net, .map_count = 3, .maps = &area};
  assert_int_equal(lam_format_plot.count(&model), 3);
  assert_string_equal(text_path(*state, &lam_format_plot, &model, 0), "plots/area.svg");
  model.net = NULL;
  assert_int_equal(lam_format_plot.count(&model), 0);
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
      TEXT_TEST(page_of_a_map),
      TEXT_TEST(the_summary_is_in_words),
      TEXT_TEST(a_map_without_values_says_so),
      TEXT_TEST(long_headings_are_smaller),
      TEXT_TEST(a_heading_names_the_design),
      TEXT_TEST(descriptions_are_broken_at_blanks),
      TEXT_TEST(units_are_raised),
      TEXT_TEST(a_plot_per_map_of_a_net),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
