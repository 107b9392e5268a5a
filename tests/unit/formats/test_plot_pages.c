/* The page around a color map and its histogram (plots/MEASURE.svg), and texts on it. */
#include "tests/unit/plot_fixture.h"

extern const lam_format lam_format_plot;

#define PAGE(heading)                                                                              \
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "         \
  "width=\"196mm\" height=\"112mm\" viewBox=\"0 0 196 112\" font-family=\"Helvetica, Arial, "      \
  "sans-serif\" fill=\"#202020\">\n<title>" heading "</title>\n"                                   \
  "<rect width=\"196\" height=\"112\" fill=\"#ffffff\"/>\n"
#define ROW(y, name, text) TEXT("134", y, "2.8", "start", name) TEXT("154", y, "2.8", "start", text)

/* Two faces in one point: all of the net is in the middle. */
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
  const char *const expected[] = {
      PAGE("A hut &amp; shed: area"),
      TEXT("8", "10", "4.4", "start", "A hut &amp; shed: area"),
      TEXT("8", "15", "2.8", "start", "Area of a face."),
      "<g class=\"view\" stroke-linejoin=\"round\" stroke-width=\"0.12\">\n",
      "<style>.line { fill: none; stroke: #202020; stroke-opacity: .55 } .edge { fill: none; "
      "stroke-linecap: round; stroke-width: 0.48 }</style>\n",
      FACE(MIDDLE),
      FACE(GRAY),
      "</g>\n",
      BEGIN,
      TEXT("134", "27", "2.6", "start", "Number of faces"),
      LINE("grid", "134", "72", "188", "72"),
      TEXT("132.8", "72.91", "2.6", "end", "0"),
      LINE("grid", "134", "32", "188", "32"),
      TEXT("132.8", "32.91", "2.6", "end", "1"),
      BAR("134", "32", "54", "40", MIDDLE, "1 from 2.5 to 2.5"),
      SAMPLE("134", "73", "54", MIDDLE),
      LINE("axis", "134", "72", "188", "72"),
      TEXT("161", "78.7", "2.6", "middle", "2.5"),
      TEXT("161", "83", "2.8", "middle", "area (m\u00b2)"),
      "</g>\n",
      ROW("91", "minimum", "2.5 m\u00b2"),
      ROW("95", "mean", "2.5 m\u00b2"),
      ROW("99", "maximum", "2.5 m\u00b2"),
      ROW("103", "counted", "1 faces"),
      ROW("107", "undefined", "1"),
      "<rect x=\"150\" y=\"105\" width=\"2.4\" height=\"2.4\" fill=\"" GRAY "\"/>\n</svg>\n",
      NULL,
  };
  assert_pieces(*state, "plot", page_of(*state, "A hut & shed", &area), expected);
}

/* Minimum, mean and maximum are three numbers of 6 digits; 0 has no sign; without a unit there is
 * no blank, and without undefined values no row of them. */
static void the_summary_is_in_words(void **state) {
  lam_map map = area;
  const double all[] = {-1.23456789, 1e7};
  map.values = all;
  map.summary = (lam_measure){"area", "", -1.23456789, 1e7, -0., 2};
  const char *text = page_of(*state, "hut", &map);
  assert_holds(text, ROW("91", "minimum", "-1.23457"));
  assert_holds(text, ROW("95", "mean", "0"));
  assert_holds(text, ROW("99", "maximum", "1e+07"));
  assert_holds(text, ROW("103", "counted", "2 faces"));
  assert_lacks(text, "undefined");
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

/* A heading is 4.4 mm high, or 300 mm by its letters: 94 of the title and 6 more give 3 mm. */
static void long_headings_are_smaller(void **state) {
#define TEN "A long hut"
#define LONG TEN TEN TEN TEN TEN TEN TEN TEN TEN "four"
  assert_holds(page_of(*state, LONG, &area), TEXT("8", "10", "3", "start", LONG ": area"));
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
  assert_holds(page_of(*state, "hut", &map), DOC("15", "x" OTHERS " abcd"));
  map.doc = "x" OTHERS " abcd  next " OTHERS " end";
  assert_holds(page_of(*state, "hut", &map), DOC("15", "x" OTHERS " abcd"));
  assert_holds(page_of(*state, "hut", &map), DOC("18.64", "next " OTHERS));
  assert_holds(page_of(*state, "hut", &map), DOC("22.28", "end"));
  map.doc = "xx" OTHERS " abcd"; /* 126 */
  assert_holds(page_of(*state, "hut", &map), DOC("15", "xx" OTHERS));
  assert_holds(page_of(*state, "hut", &map), DOC("18.64", "abcd"));
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

/* A hundredth of a millimeter is enough for texts; &, < and " are escaped. */
static void texts_have_two_decimals(void **state) {
  lam_text out = {.arena = *state};
  lam_plot_text(&out, 1.23456, -2.34567, 3.45678, "end", "\"a\" < b & c");
  assert_string_equal(out.data,
                      TEXT("1.23", "-2.35", "3.46", "end", "&quot;a&quot; &lt; b &amp; c"));
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
      TEXT_TEST(page_of_a_map),
      TEXT_TEST(the_summary_is_in_words),
      TEXT_TEST(a_map_without_values_says_so),
      TEXT_TEST(long_headings_are_smaller),
      TEXT_TEST(a_heading_names_the_design),
      TEXT_TEST(descriptions_are_broken_at_blanks),
      TEXT_TEST(units_are_raised),
      TEXT_TEST(texts_have_two_decimals),
      TEXT_TEST(a_plot_per_map_of_a_net),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
