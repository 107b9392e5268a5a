/* Meshes and splines as they are written, line by line or byte by byte: net.obj and the states of a
 * net, parts.obj, STL, surface.obj, surface.json; and words and numbers where their limits are. */
#include "tests/unit/text_fixture.h"

#include <stdio.h>

extern const lam_format lam_format_obj, lam_format_frames, lam_format_stl, lam_format_surface_obj,
    lam_format_surface, lam_format_points;

/* ---- nets ---- */

static int faces[2][4] = {{0, 1, 4, 3}, {1, 2, 4, -1}};
static int line[3] = {0, 1, 2}, loop[3] = {0, 1, 4};
static const lam_polyline lines[4] = {
    {-1, true, 3, loop}, {1, false, 2, loop}, {0, false, 3, line}, {1, true, 3, line}};

#define NET_ELEMENTS                                                                               \
  "g net\nf 1 2 5 4\nf 2 3 5\ng family_0\nl 1 2 3\ng family_1\nl 1 2\nl 1 2 3 1\ng boundary\n"     \
  "l 1 2 5 1\n"

/* Twelve significant digits, at most twenty decimals, no zeros behind. */
static void nets_are_listed(void **state) {
  lam_vec3 x[5] = {{0, 1. / 3, 200. / 3},
                   {123456.789012345, -0.000123456789012345, 1},
                   {1234567890123.7, 1e-15 / 3, 10},
                   {-0., 1e-30, 1234567},
                   {.1, .2, .3}};
  lam_mesh net = {5, x, 2, faces};
  lam_model model = {
      .name = "vault", .net = &net, .polyline_count = 4, .polylines = lines, .frame_count = 0};
  assert_lines("net.obj", text_of(*state, &lam_format_obj, &model, 0),
               "# vault: net, meters\n"
               "v 0 0.333333333333 66.6666666667\n"
               "v 123456.789012 -0.000123456789012 1\n"
               "v 1234567890124 0.00000000000000033333 10\n"
               "v 0 0 1234567\nv 0.1 0.2 0.3\n" NET_ELEMENTS);
}

static void states_are_listed(void **state) {
  lam_vec3 x[5] = {{9, 9, 9}};
  static const lam_vec3 a[5] = {{1, 0, 0}}, b[5] = {{2, 0, 0}};
  const lam_vec3 *const frames[2] = {a, b};
  lam_mesh net = {5, x, 2, faces};
  lam_model model = {.name = "vault",
                     .net = &net,
                     .polyline_count = 4,
                     .polylines = lines,
                     .frame_count = 2,
                     .frames = frames};
  assert_int_equal(lam_format_frames.count(&model), 2);
  assert_string_equal(text_path(*state, &lam_format_frames, &model, 1), "frames/vault-001.obj");
  assert_lines("frame", text_of(*state, &lam_format_frames, &model, 1),
               "# vault: net, state 2 of 2, meters\n"
               "v 2 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\n" NET_ELEMENTS);
  model.net = NULL;
  assert_int_equal(lam_format_frames.count(&model), 0);
}

/* ---- parts ---- */

/* A triangle that looks up, and one (x -> y, y -> -x, moved by (1, 2, 3)) that stands twice. */
static lam_vec3 corners[3] = {{0, 0, 0}, {.5, 0, 0}, {0, .25, 0}};
static int triangle[1][3] = {{0, 1, 2}};
static lam_pose places[2] = {{{1, 2, 3}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}},
                             {{0, 0, 1}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}};

static void fill_parts(lam_part parts[2]) {
  parts[0] = (lam_part){.name = "A01", .solid = {3, corners, 1, triangle}};
  parts[1] = (lam_part){
      .name = "node", .solid = {3, corners, 1, triangle}, .instance_count = 2, .instances = places};
}

static void parts_are_groups(void **state) {
  lam_part parts[2];
  fill_parts(parts);
  lam_vec3 x[5] = {{0, 0, 0}};
  lam_mesh net = {5, x, 2, faces};
  lam_model model = {.name = "vault", .net = &net, .part_count = 2, .parts = parts};
  assert_int_equal(lam_format_obj.count(&model), 2);
  assert_string_equal(text_path(*state, &lam_format_obj, &model, 0), "net.obj");
  assert_string_equal(text_path(*state, &lam_format_obj, &model, 1), "parts.obj");
  assert_lines("parts.obj", text_of(*state, &lam_format_obj, &model, 1),
               "# vault: parts, meters\n"
               "g A01\nv 0 0 0\nv 0.5 0 0\nv 0 0.25 0\nf 1 2 3\n"
               "g node\nv 1 2 3\nv 1 2.5 3\nv 0.75 2 3\nf 4 5 6\n"
               "v 0 0 1\nv 0 0.5 1\nv 0 0 1.25\nf 7 8 9\n");
  net.face_count = 0;
  assert_int_equal(lam_format_obj.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_obj, &model, 0), "parts.obj");
}

/* Record i of a binary file: normal and corners, and two zero bytes. */
static void assert_record(const char *data, int i, const float expected[12]) {
  float value[12];
  const char *at = data + 84 + 50 * i;
  memcpy(value, at, sizeof value);
  for (int k = 0; k < 12; k++)
    if (value[k] != expected[k])
      fail_msg("record %d, number %d: %g, expected %g", i, k, value[k], expected[k]);
  assert_true(at[48] == 0 && at[49] == 0);
}

/* Normals are turned with their instances; corners are in millimeters. */
static void stl_has_its_bytes(void **state) {
  static const float records[3][12] = {
      {0, 0, 1, 0, 0, 0, 500, 0, 0, 0, 250, 0},
      {0, 0, 1, 1000, 2000, 3000, 1000, 2500, 3000, 750, 2000, 3000},
      {1, 0, 0, 0, 0, 1000, 0, 500, 1000, 0, 0, 1250}};
  lam_part parts[2];
  fill_parts(parts);
  lam_model model = {.name = "vault", .part_count = 2, .parts = parts}, none = {.name = "x"};
  assert_int_equal(lam_format_stl.count(&model), 3);
  assert_int_equal(lam_format_stl.count(&none), 0);
  const char *all = text_of(*state, &lam_format_stl, &model, 2),
             *node = text_of(*state, &lam_format_stl, &model, 1);
  char header[84] = "lamella: vault, mm";
  header[80] = 3;
  assert_memory_equal(all, header, 84);
  for (int i = 0; i < 3; i++) assert_record(all, i, records[i]);
  strcpy(header, "lamella: vault, node, mm");
  header[80] = 1;
  assert_memory_equal(node, header, 84);
  assert_record(node, 0, records[0]);
}

/* A file of 84 bytes has a number of triangles, one of 83 has none; "solid" alone is text. */
static void stl_is_told_by_its_size(void **state) {
  static const struct {
    const char *begin;
    size_t size;
    unsigned char triangles;
    const char *message;
  } cases[] = {
      {"x", 84, 1, "a binary STL file of 1 triangles has 134 bytes; this one has 84"},
      {"x", 83, 0, "is not an STL file: it neither begins with \"solid\" nor has a header"},
      {"x", 84, 0, "has no triangles"},
      {"solid", 5, 0, "has no triangles"},
      {"soli", 4, 0, "is not an STL file: it neither begins with \"solid\" nor has a header"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    char bytes[84] = {0};
    lam_errors errors = {.arena = *state};
    lam_trimesh mesh;
    strcpy(bytes, cases[i].begin);
    bytes[80] = (char)cases[i].triangles;
    assert_false(lam_format_stl.read_triangles(*state, bytes, cases[i].size,
                                               (lam_location){.file = "x"}, &errors, &mesh));
    assert_string_equal(errors.first->text, cases[i].message);
  }
}

/* Reading text stops at the first message, though more is wrong behind it. */
static void stl_stops_at_the_first_message(void **state) {
#define REST "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nbad\n"
  static const char *const cases[][2] = {
      {"solid x\nfacet normal 0 0\n" REST, "normal: 2 numbers given, 3 expected"},
      {"solid x\nfacet abnormal 0 0 1\n" REST, "\"abnormal\" given, \"normal\" expected"},
      {"solid x\nfacet normal 0 0 1\nouter hoop\nvertex 0\nbad\n",
       "\"hoop\" given, \"loop\" expected"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex x 0 0\nbad\n",
       "vertex: 2 numbers given, 3 expected"},
      {"solid x\nbad\nbad\n", "\"bad\" given, \"facet\" or \"endsolid\" expected"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
       "0\nend\nbad",
       "\"end\" given, \"endloop\" expected"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_errors errors = {.arena = *state};
    lam_trimesh mesh;
    assert_false(lam_format_stl.read_triangles(*state, cases[i][0], strlen(cases[i][0]),
                                               (lam_location){.file = "x"}, &errors, &mesh));
    assert_string_equal(errors.first->text, cases[i][1]);
    assert_int_equal(errors.count, 1);
  }
}

/* ---- splines ---- */

static const double knots_u[] = {0, 0, 0, 1, 1, 1}, knots_v[] = {0, 0, 2, 2},
                    weights[] = {1, 2, 3, 4, 5, 6};
static const lam_vec3 net[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 1e-9}};
static double long_knots[19];
static lam_vec3 long_points[17];

/* A rational surface, a polynomial line of 17 points (knots 0 0 1 .. 15 16 16), a rational one. */
static void fill_splines(lam_spline_surface *s, lam_named_curve curves[2], lam_model *model) {
  for (int i = 0; i < 19; i++) long_knots[i] = i == 0 ? 0 : i == 18 ? 16 : i - 1;
  for (int i = 0; i < 17; i++) long_points[i] = lam_v3(i, 0, .5);
  *s = (lam_spline_surface){"roof", {2, 1}, {3, 2}, {knots_u, knots_v}, net, weights};
  curves[0] = (lam_named_curve){"A01", 0, {1, 17, long_knots, long_points, NULL}};
  curves[1] = (lam_named_curve){"rim", -1, {1, 2, knots_v, net, weights}};
  *model = (lam_model){.name = "two",
                       .version = "0",
                       .surface_count = 1,
                       .surfaces = s,
                       .curve_count = 2,
                       .curves = curves};
}

/* Vertices are numbered through the file; a statement is broken after sixteen numbers, of which the
 * domain takes two (of a surface four). */
static const char surface_obj[] =
    "# two: smooth surfaces and curves, meters\n"
    "v 0.0 0.0 0.0 1.0\nv 1.0 0.0 0.0 3.0\nv 2.0 0.0 0.0 5.0\n"
    "v 0.0 1.0 0.0 2.0\nv 1.0 1.0 0.0 4.0\nv 2.0 1.0 1.0E-9 6.0\n"
    "g roof\ncstype rat bspline\ndeg 2 1\nsurf 0.0 1.0 0.0 2.0 1 2 3 4 5 6\n"
    "parm u 0.0 0.0 0.0 1.0 1.0 1.0\nparm v 0.0 0.0 2.0 2.0\nend\n"
    "v 0.0 0.0 0.5\nv 1.0 0.0 0.5\nv 2.0 0.0 0.5\nv 3.0 0.0 0.5\nv 4.0 0.0 0.5\nv 5.0 0.0 0.5\n"
    "v 6.0 0.0 0.5\nv 7.0 0.0 0.5\nv 8.0 0.0 0.5\nv 9.0 0.0 0.5\nv 10.0 0.0 0.5\nv 11.0 0.0 0.5\n"
    "v 12.0 0.0 0.5\nv 13.0 0.0 0.5\nv 14.0 0.0 0.5\nv 15.0 0.0 0.5\nv 16.0 0.0 0.5\n"
    "g A01\ncstype bspline\ndeg 1\n"
    "curv 0.0 16.0 7 8 9 10 11 12 13 14 15 16 17 18 19 20 \\\n 21 22 23\n"
    "parm u 0.0 0.0 1.0 2.0 3.0 4.0 5.0 6.0 7.0 8.0 9.0 10.0 11.0 12.0 13.0 14.0 \\\n"
    " 15.0 16.0 16.0\nend\n"
    "v 0.0 0.0 0.0 1.0\nv 0.0 1.0 0.0 2.0\n"
    "g rim\ncstype rat bspline\ndeg 1\ncurv 0.0 2.0 24 25\nparm u 0.0 0.0 2.0 2.0\nend\n";

static void surface_obj_is_listed(void **state) {
  lam_spline_surface s;
  lam_named_curve curves[2];
  lam_model model;
  fill_splines(&s, curves, &model);
  assert_string_equal(text_path(*state, &lam_format_surface_obj, &model, 0), "surface.obj");
  assert_lines("surface.obj", text_of(*state, &lam_format_surface_obj, &model, 0), surface_obj);
}

/* 17 x 2 points: twelve numbers stand behind the four of the domain. */
static void long_surfaces_are_broken(void **state) {
  lam_spline_surface s;
  lam_named_curve curves[2];
  lam_model model;
  lam_vec3 wide[34] = {{0, 0, 0}};
  fill_splines(&s, curves, &model);
  s = (lam_spline_surface){"long", {1, 1}, {17, 2}, {long_knots, knots_v}, wide, NULL};
  assert_holds(
      text_of(*state, &lam_format_surface_obj, &model, 0),
      "surf 0.0 16.0 0.0 2.0 1 2 3 4 5 6 7 8 9 10 11 12 \\\n 13 14 15 16 17 18 19 20 21 22 "
      "23 24 25 26 27 28 \\\n 29 30 31 32 33 34\n");
}

static const char surface_json[] =
    "{\n  \"unit\": \"m\",\n  \"order_of_points\": \"v runs fastest\",\n  \"surfaces\": [\n"
    "    {\n      \"name\": \"roof\",\n      \"degree\": [2, 1],\n      \"count\": [3, 2],\n"
    "      \"knots_u\": [0.0, 0.0, 0.0, 1.0, 1.0, 1.0],\n      \"knots_v\": [0.0, 0.0, 2.0, 2.0],\n"
    "      \"points\": [\n        [0.0, 0.0, 0.0],\n        [0.0, 1.0, 0.0],\n"
    "        [1.0, 0.0, 0.0],\n        [1.0, 1.0, 0.0],\n        [2.0, 0.0, 0.0],\n"
    "        [2.0, 1.0, 1.0E-9]],\n      \"weights\": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]\n    },\n"
    "    {\n      \"name\": \"flat\",\n      \"degree\": [1, 1],\n      \"count\": [2, 2],\n"
    "      \"knots_u\": [0.0, 0.0, 2.0, 2.0],\n      \"knots_v\": [0.0, 0.0, 2.0, 2.0],\n"
    "      \"points\": [\n        [0.0, 0.0, 0.0],\n        [0.0, 1.0, 0.0],\n"
    "        [1.0, 0.0, 0.0],\n        [1.0, 1.0, 0.0]]\n    }\n  ],\n  \"curves\": [\n"
    "    {\n      \"name\": \"rim\",\n      \"family\": -1,\n      \"degree\": 1,\n"
    "      \"count\": 2,\n      \"knots\": [0.0, 0.0, 2.0, 2.0],\n"
    "      \"points\": [\n        [0.0, 0.0, 0.0],\n        [0.0, 1.0, 0.0]],\n"
    "      \"weights\": [1.0, 2.0]\n    }\n  ]\n}\n";

static void surface_json_is_listed(void **state) {
  lam_spline_surface s[2];
  lam_named_curve curves[2];
  lam_model model;
  fill_splines(s, curves, &model);
  s[1] = (lam_spline_surface){"flat", {1, 1}, {2, 2}, {knots_v, knots_v}, net, NULL};
  model.surface_count = 2, model.curve_count = 1, model.curves = &curves[1];
  assert_string_equal(text_path(*state, &lam_format_surface, &model, 0), "surface.json");
  assert_lines("surface.json", text_of(*state, &lam_format_surface, &model, 0), surface_json);
}

/* ---- words and numbers ---- */

/* Reads points; the message with its line, or how many there are and the first one. */
static const char *points_of(lam_arena *arena, const char *text) {
  lam_errors errors = {.arena = arena};
  int count = 0;
  const lam_vec3 *x;
  if (lam_format_points.read_points(arena, text, strlen(text), (lam_location){.file = "x"}, &errors,
                                    &count, &x))
    return lam_arena_printf(arena, "%d: %g %g %g", count, x[0].x, x[0].y, x[0].z);
  return lam_arena_printf(arena, "%d: %s", errors.first->location.line, errors.first->text);
}

/* A number has at most 63 letters; of a word in a message 40 are shown. Only the first line may be
 * a heading; commas at the ends of words part them. */
static void limits_of_words_are_kept(void **state) {
#define TEN "0000000000"
#define SIXTY TEN TEN TEN TEN TEN TEN
  static const char *const cases[][2] = {
      {SIXTY "1.5 2 3\n", "1: 1.5 2 3"},
      {SIXTY "01.5 2 3\n", "1: coordinate: \"" TEN TEN TEN TEN "\" is not a number"},
      {"1 " TEN TEN TEN "000000000x 2\n",
       "1: coordinate: \"" TEN TEN TEN "000000000x\" is not a number"},
      {"x y z\n1 2 3\n", "1: 1 2 3"},
      {"1 2 3\nx y z\n", "2: coordinate: \"x\" is not a number"},
      {"17\n1 2 3\n", "1: 1 2 3"},
      {"17 4\n1 2 3\n", "1: 2 numbers given; expected x, y and z"},
      {"1 2 3\n17\n", "2: 1 number given; expected x, y and z"},
      {"1,2,3\n4,5,6,7\n", "2: 1 2 3"},
      {",1 ,2 ,3\n", "1: 1 2 3"},
      {"1, 2, 3\n", "1: 1 2 3"},
      {"1,5 2 3\n", "1: numbers with a comma given; expected a decimal point"},
      {"1 2 3 4,5\n", "1: numbers with a comma given; expected a decimal point"},
      {"\v1\f2\t3\r\n# 9 9 9\n", "1: 1 2 3"},
      {"+1 -2e1 .5E-1#x\n", "1: 1 -20 0.05"},
      {"1 2 3\n4 5 1-\n", "2: coordinate: \"1-\" is not a number"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    assert_string_equal(points_of(*state, cases[i][0]), cases[i][1]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(nets_are_listed),         TEXT_TEST(states_are_listed),
      TEXT_TEST(parts_are_groups),        TEXT_TEST(stl_has_its_bytes),
      TEXT_TEST(stl_is_told_by_its_size), TEXT_TEST(stl_stops_at_the_first_message),
      TEXT_TEST(surface_obj_is_listed),   TEXT_TEST(long_surfaces_are_broken),
      TEXT_TEST(surface_json_is_listed),  TEXT_TEST(limits_of_words_are_kept),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
