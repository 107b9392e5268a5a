/* Cutting sheets made by hand, as DXF and SVG: every line that is expected is written out. What
 * another program reads in them is tested in tests/cli/dxf.t. */
#include "formats/sheets/layer.h"
#include "tests/unit/text_fixture.h"

extern const lam_format lam_format_dxf, lam_format_svg;

/* ---- the sheets ---- */

/* A triangle. DXF has tenths of a micrometer: the second point is repeated (.04 of that beside it),
 * the last one falls on the first, once as it is and once rounded. .6 of it are another point. */
static lam_vec2 triangle[] = {{.1, .05},       {.2, .05}, {.200000004, .049999996},
                              {.2, .15000006}, {.2, .15}, {.100000004, .05},
                              {.1, .05}};

/* An open mark that comes back to where it began; a stroke of a letter; what is no line. The last
 * path and the last piece are beyond their counts: they must not show. */
static lam_vec2 mark[] = {{.12345678, .1}, {.13, .11}, {.12345678, .1}};
static lam_vec2 stroke[] = {{.11, .06}, {.115, .07}};
static lam_vec2 dot[] = {{.3, .1}, {.3, .1}};
static lam_path first_paths[] = {
    {.layer = LAM_LAYER_CUT, .closed = true, .count = 7, .points = triangle},
    {.layer = LAM_LAYER_ENGRAVE, .count = 3, .points = mark},
    {.layer = LAM_LAYER_LABEL, .count = 2, .points = stroke},
    {.layer = LAM_LAYER_CUT, .closed = true, .count = 2, .points = dot},
    {.layer = LAM_LAYER_LABEL, .count = 1, .points = dot},
    {.layer = LAM_LAYER_LABEL, .count = 2, .points = stroke},
};
static lam_vec2 square[] = {{.01, .02}, {.03, .02}, {.03, .04}, {.01, .04}};
static lam_path second_paths[] = {
    {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = square}};

/* A washer with two round holes, the larger one first: centers (.2, .2) and (.24, .2). Then a word
 * of two strokes, and another one. Outline 60 x 20 mm: larger than `square`, smaller than
 * `triangle`. */
static lam_vec2 plate[] = {{.18, .19}, {.24, .19}, {.24, .21}, {.18, .21}};
static lam_vec2 wide[] = {{.205, .2}, {.2, .205}, {.195, .2}, {.2, .195}};
static lam_vec2 narrow[] = {{.242, .2}, {.24, .202}, {.238, .2}, {.24, .198}};
static lam_vec2 bar[] = {{.19, .2}, {.19, .202}}, dash[] = {{.19, .201}, {.191, .201}};
static lam_path washer_paths[] = {
    {.layer = LAM_LAYER_CUT, .closed = true, .count = 4, .points = plate},
    {.layer = LAM_LAYER_CUT,
     .closed = true,
     .hole = true,
     .count = 4,
     .points = wide,
     .radius = .005},
    {.layer = LAM_LAYER_CUT,
     .closed = true,
     .hole = true,
     .count = 4,
     .points = narrow,
     .radius = .002},
    {.layer = LAM_LAYER_LABEL, .count = 2, .points = bar},
    {.layer = LAM_LAYER_LABEL, .joined = true, .count = 2, .points = dash},
    {.layer = LAM_LAYER_LABEL, .count = 2, .points = bar}};

static const lam_material steel = {.name = "steel"};
static lam_sheet_piece pieces[] = {{.label = "A&1", .path_count = 5, .paths = first_paths},
                                   {.label = "P1", .path_count = 1, .paths = second_paths},
                                   {.label = "X", .path_count = 1, .paths = second_paths}};
#define ONE_SQUARE .path_count = 1, .paths = second_paths
static lam_sheet_piece copies[] = {{.label = "A1", ONE_SQUARE}, {.label = "P1", ONE_SQUARE},
                                   {.label = "A1", ONE_SQUARE}, {.label = "P2", ONE_SQUARE},
                                   {.label = "A1", ONE_SQUARE}, {.label = "P1", ONE_SQUARE}};
static lam_path warnings[] = {
    {.layer = LAM_LAYER_SHEET, .count = 2, .points = bar},
    {.layer = LAM_LAYER_SHEET, .joined = true, .count = 2, .points = dash}};
static lam_sheet_piece mixed[] = {{.label = "A1", .path_count = 1, .paths = first_paths},
                                  {.label = "W1", .path_count = 6, .paths = washer_paths},
                                  {.label = "P1", .path_count = 1, .paths = second_paths}};
static const lam_sheet sheets[] = {{.name = "steel-1",
                                    .width = .5,
                                    .height = .25,
                                    .material = &steel,
                                    .thickness = .0015004,
                                    .piece_count = 2,
                                    .placed = pieces},
                                   {.name = "any-2",
                                    .width = 1.23456789,
                                    .height = 1,
                                    .thickness = .01200061,
                                    .kerf = .00020004,
                                    .piece_count = 6,
                                    .placed = copies},
                                   {.name = "mixed-3",
                                    .width = .5,
                                    .height = .25,
                                    .thickness = .002,
                                    .warning_count = 2,
                                    .warnings = warnings,
                                    .piece_count = 3,
                                    .placed = mixed}};
static const lam_model workshop = {
    .name = "hut", .title = "A \"hut\" & <shed>", .sheet_count = 3, .sheets = sheets};

/* ---- DXF ---- */

/* The text with code and value of a group on one line: "  0 SECTION". */
static const char *in_pairs(lam_arena *arena, const char *text) {
  char *pairs = lam_arena_copy(arena, text);
  int line = 0;
  for (char *c = pairs; *c; c++)
    if (*c == '\n' && line++ % 2 == 0) *c = ' ';
  return pairs;
}

/* A group that is expected. The groups stand in the DXF reference of release 12; 999 is a comment.
 */
#define HEADER(width, height)                                                                      \
  "  0 SECTION\n  2 HEADER\n  9 $ACADVER\n  1 AC1009\n  9 $DWGCODEPAGE\n  3 ANSI_1252\n"           \
  "  9 $INSUNITS\n 70 4\n  9 $MEASUREMENT\n 70 1\n"                                                \
  "  9 $INSBASE\n 10 0\n 20 0\n 30 0\n  9 $EXTMIN\n 10 0\n 20 0\n 30 0\n"                          \
  "  9 $EXTMAX\n 10 " width "\n 20 " height "\n 30 0\n"                                            \
  "  9 $LIMMIN\n 10 0\n 20 0\n  9 $LIMMAX\n 10 " width "\n 20 " height "\n  0 ENDSEC\n"
#define TABLES                                                                                     \
  "  0 SECTION\n  2 TABLES\n  0 TABLE\n  2 LTYPE\n 70 1\n  0 LTYPE\n  2 CONTINUOUS\n 70 0\n"       \
  "  3 Solid line\n 72 65\n 73 0\n 40 0\n  0 ENDTAB\n  0 TABLE\n  2 LAYER\n 70 5\n"                \
  "  0 LAYER\n  2 0\n 70 0\n 62 7\n  6 CONTINUOUS\n"                                               \
  "  0 LAYER\n  2 CUT\n 70 0\n 62 1\n  6 CONTINUOUS\n"                                             \
  "  0 LAYER\n  2 ENGRAVE\n 70 0\n 62 5\n  6 CONTINUOUS\n"                                         \
  "  0 LAYER\n  2 LABEL\n 70 0\n 62 3\n  6 CONTINUOUS\n"                                           \
  "  0 LAYER\n  2 DEFPOINTS\n 70 0\n 62 8\n  6 CONTINUOUS\n  0 ENDTAB\n  0 ENDSEC\n"               \
  "  0 SECTION\n  2 ENTITIES\n"
#define POLYLINE(layer, closed)                                                                    \
  "  0 POLYLINE\n  8 " layer "\n 66 1\n 10 0\n 20 0\n 30 0\n 70 " closed "\n"
#define VERTEX(layer, x, y) "  0 VERTEX\n  8 " layer "\n 10 " x "\n 20 " y "\n 30 0\n"
#define SEQEND(layer) "  0 SEQEND\n  8 " layer "\n"
#define CORNER(x, y) VERTEX("DEFPOINTS", x, y)
#define EDGE(w, h)                                                                                 \
  POLYLINE("DEFPOINTS", "1")                                                                       \
  CORNER("0", "0") CORNER(w, "0") CORNER(w, h) CORNER("0", h) SEQEND("DEFPOINTS")
#define TRIANGLE                                                                                   \
  POLYLINE("CUT", "1")                                                                             \
  VERTEX("CUT", "100", "50")                                                                       \
  VERTEX("CUT", "200", "50")                                                                       \
  VERTEX("CUT", "200", "150.0001") VERTEX("CUT", "200", "150") SEQEND("CUT")
#define SQUARE                                                                                     \
  POLYLINE("CUT", "1")                                                                             \
  VERTEX("CUT", "10", "20")                                                                        \
  VERTEX("CUT", "30", "20")                                                                        \
  VERTEX("CUT", "30", "40") VERTEX("CUT", "10", "40") SEQEND("CUT")
#define CIRCLE(x, y, r) "  0 CIRCLE\n  8 CUT\n 10 " x "\n 20 " y "\n 30 0\n 40 " r "\n"
#define END "  0 ENDSEC\n  0 EOF\n"

/* Millimeters with 4 decimals; points that fall together are written once, a closed line does not
 * repeat its first one, and what has fewer than two is left out. Edges are true without a kerf. */
static void dxf_of_a_sheet(void **state) {
  const char *const expected[] = {
      "999 hut, steel-1: steel, 1.5 mm thick; millimeters\n",
      "999 kerf is not compensated: lines are the true edges of the parts\n",
      HEADER("500", "250"),
      TABLES,
      EDGE("500", "250"),
      POLYLINE("ENGRAVE", "0"),
      VERTEX("ENGRAVE", "123.4568", "100"),
      VERTEX("ENGRAVE", "130", "110"),
      VERTEX("ENGRAVE", "123.4568", "100"),
      SEQEND("ENGRAVE"),
      POLYLINE("LABEL", "0"),
      VERTEX("LABEL", "110", "60"),
      VERTEX("LABEL", "115", "70"),
      SEQEND("LABEL"),
      SQUARE,
      TRIANGLE,
      END,
      NULL,
  };
  assert_pieces(*state, "steel-1.dxf",
                in_pairs(*state, text_of(*state, &lam_format_dxf, &workshop, 0)), expected);
}

/* Thickness and kerf with 3 decimals, the size of the sheet with 4. */
static void dxf_tells_the_kerf(void **state) {
  const char *const expected[] = {
      "999 hut, any-2: any material, 12.001 mm thick; millimeters\n",
      "999 kerf of 0.2 mm is compensated: cut along the lines\n",
      HEADER("1234.5679", "1000"),
      TABLES,
      EDGE("1234.5679", "1000"),
      SQUARE,
      SQUARE,
      SQUARE,
      SQUARE,
      SQUARE,
      SQUARE,
      END,
      NULL,
  };
  assert_pieces(*state, "any-2.dxf",
                in_pairs(*state, text_of(*state, &lam_format_dxf, &workshop, 1)), expected);
}

/* Marks, then holes, then outlines; the small hole and the small piece come first, although the
 * model has them last. */
static void dxf_in_the_order_of_work(void **state) {
  const char *const expected[] = {
      "999 hut, mixed-3: any material, 2 mm thick; millimeters\n",
      "999 kerf is not compensated: lines are the true edges of the parts\n",
      HEADER("500", "250"),
      TABLES,
      EDGE("500", "250"),
      POLYLINE("DEFPOINTS", "0"),
      CORNER("190", "200"),
      CORNER("190", "202"),
      SEQEND("DEFPOINTS"),
      POLYLINE("DEFPOINTS", "0"),
      CORNER("190", "201"),
      CORNER("191", "201"),
      SEQEND("DEFPOINTS"),
      POLYLINE("LABEL", "0"),
      VERTEX("LABEL", "190", "200"),
      VERTEX("LABEL", "190", "202"),
      SEQEND("LABEL"),
      POLYLINE("LABEL", "0"),
      VERTEX("LABEL", "190", "201"),
      VERTEX("LABEL", "191", "201"),
      SEQEND("LABEL"),
      POLYLINE("LABEL", "0"),
      VERTEX("LABEL", "190", "200"),
      VERTEX("LABEL", "190", "202"),
      SEQEND("LABEL"),
      CIRCLE("240", "200", "2"),
      CIRCLE("200", "200", "5"),
      SQUARE,
      POLYLINE("CUT", "1"),
      VERTEX("CUT", "180", "190"),
      VERTEX("CUT", "240", "190"),
      VERTEX("CUT", "240", "210"),
      VERTEX("CUT", "180", "210"),
      SEQEND("CUT"),
      TRIANGLE,
      END,
      NULL,
  };
  assert_pieces(*state, "mixed-3.dxf",
                in_pairs(*state, text_of(*state, &lam_format_dxf, &workshop, 2)), expected);
}

/* ---- SVG ---- */

#define SVG(width, height)                                                                         \
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "         \
  "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "                                \
  "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" "                         \
  "width=\"" width "mm\" height=\"" height "mm\" viewBox=\"0 0 " width " " height "\">\n"
#define STYLE                                                                                      \
  "<style>\npath, circle { fill: none; stroke-width: 0.1; stroke-linejoin: round; "                \
  "stroke-linecap: round }\n@media screen { path, circle { stroke-width: 1px; vector-effect: "     \
  "non-scaling-stroke } }\n.CUT { stroke: #ff0000 }\n.ENGRAVE { stroke: #0000ff }\n"               \
  ".LABEL { stroke: #00a000 }\n.SHEET { stroke: #f36926 }\n</style>\n"
#define LOOK(layer, color)                                                                         \
  " class=\"" layer "\" fill=\"none\" stroke=\"" color "\" stroke-width=\"0.1\""
#define LINE(layer, color, data) "<path" LOOK(layer, color) " d=\"" data "\"/>\n"
#define LAYER(name)                                                                                \
  "<g id=\"layer-" name "\" inkscape:groupmode=\"layer\" inkscape:label=\"" name "\">\n"
#define FRAME(data)                                                                                \
  "<g id=\"layer-SHEET\" inkscape:groupmode=\"layer\" inkscape:label=\"SHEET\" "                   \
  "sodipodi:insensitive=\"true\">\n" LINE("SHEET", "#f36926", data) "</g>\n"
#define PART(id) "<g class=\"part\" id=\"" id "\">\n"
#define SVG_SQUARE LINE("CUT", "#ff0000", "M10,980 L30,980 30,960 10,960 Z")

/* The sheet is 250 mm high: y = 50 stands at 200. Points are written as they are; Z closes. */
static void svg_of_a_sheet(void **state) {
  const char *const expected[] = {
      SVG("500", "250"),
      "<title>A &quot;hut&quot; &amp; &lt;shed&gt;: steel-1</title>\n",
      "<desc>steel, 1.5004 mm thick; kerf is not compensated</desc>\n",
      STYLE,
      FRAME("M0,250 L500,250 500,0 0,0 Z"),
      LAYER("ENGRAVE"),
      PART("A&amp;1-engrave"),
      LINE("ENGRAVE", "#0000ff", "M123.4568,150 L130,140 123.4568,150"),
      "</g>\n</g>\n",
      LAYER("LABEL"),
      PART("A&amp;1-label"),
      LINE("LABEL", "#00a000", "M110,190 L115,180"),
      LINE("LABEL", "#00a000", "M300,150"),
      "</g>\n</g>\n",
      LAYER("CUT"),
      PART("P1"),
      LINE("CUT", "#ff0000", "M10,230 L30,230 30,210 10,210 Z"),
      "</g>\n",
      PART("A&amp;1"),
      LINE("CUT", "#ff0000", "M100,200 L200,200 200,200 200,99.9999 200,100 100,200 100,200 Z"),
      LINE("CUT", "#ff0000", "M300,150 L300,150 Z"),
      "</g>\n</g>\n</svg>\n",
      NULL,
  };
  assert_pieces(*state, "steel-1.svg", text_of(*state, &lam_format_svg, &workshop, 0), expected);
}

/* The second and third piece of a label are copies 2 and 3: ids are unique. */
static void svg_tells_copies_apart(void **state) {
  const char *const expected[] = {
      SVG("1234.5679", "1000"),
      "<title>A &quot;hut&quot; &amp; &lt;shed&gt;: any-2</title>\n",
      "<desc>any material, 12.0006 mm thick; kerf of 0.2 mm is compensated</desc>\n",
      STYLE,
      FRAME("M0,1000 L1234.5679,1000 1234.5679,0 0,0 Z"),
      LAYER("CUT"),
      PART("A1") SVG_SQUARE "</g>\n",
      PART("P1") SVG_SQUARE "</g>\n",
      PART("A1-copy-2") SVG_SQUARE "</g>\n",
      PART("P2") SVG_SQUARE "</g>\n",
      PART("A1-copy-3") SVG_SQUARE "</g>\n",
      PART("P1-copy-2") SVG_SQUARE "</g>\n",
      "</g>\n</svg>\n",
      NULL,
  };
  assert_pieces(*state, "any-2.svg", text_of(*state, &lam_format_svg, &workshop, 1), expected);
}

/* A word is one path, a round hole a circle. */
static void svg_of_words_and_holes(void **state) {
  const char *const expected[] = {
      LINE("SHEET", "#f36926", "M190,50 L190,48 M190,49 L191,49"),
      "</g>\n",
      LAYER("LABEL"),
      PART("W1-label"),
      LINE("LABEL", "#00a000", "M190,50 L190,48 M190,49 L191,49"),
      LINE("LABEL", "#00a000", "M190,50 L190,48"),
      "</g>\n</g>\n",
      LAYER("CUT"),
      PART("W1-holes"),
      "<circle" LOOK("CUT", "#ff0000") " cx=\"240\" cy=\"50\" r=\"2\"/>\n",
      "<circle" LOOK("CUT", "#ff0000") " cx=\"200\" cy=\"50\" r=\"5\"/>\n",
      "</g>\n",
      PART("P1"),
      LINE("CUT", "#ff0000", "M10,230 L30,230 30,210 10,210 Z"),
      "</g>\n",
      PART("W1"),
      LINE("CUT", "#ff0000", "M180,60 L240,60 240,40 180,40 Z"),
      "</g>\n",
      PART("A1"),
      LINE("CUT", "#ff0000", "M100,200 L200,200 200,200 200,99.9999 200,100 100,200 100,200 Z"),
      "</g>\n</g>\n</svg>\n",
      NULL,
  };
  const char *text = text_of(*state, &lam_format_svg, &workshop, 2);
  assert_pieces(*state, "mixed-3.svg", strstr(text, "Z\"/>\n") + 5, expected);
}

/* ---- both ---- */

static void a_file_per_sheet(void **state) {
  static const lam_model nothing = {.name = "hut", .title = "hut"};
  assert_int_equal(lam_format_dxf.count(&workshop), 3);
  assert_int_equal(lam_format_svg.count(&workshop), 3);
  assert_int_equal(lam_format_dxf.count(&nothing), 0);
  assert_int_equal(lam_format_svg.count(&nothing), 0);
  assert_string_equal(text_path(*state, &lam_format_dxf, &workshop, 0), "sheets/steel-1.dxf");
  assert_string_equal(text_path(*state, &lam_format_svg, &workshop, 1), "sheets/any-2.svg");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(dxf_of_a_sheet),           TEXT_TEST(dxf_tells_the_kerf),
      TEXT_TEST(dxf_in_the_order_of_work), TEXT_TEST(svg_of_a_sheet),
      TEXT_TEST(svg_tells_copies_apart),   TEXT_TEST(svg_of_words_and_holes),
      TEXT_TEST(a_file_per_sheet),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
