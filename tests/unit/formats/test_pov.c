/* The scenes of POV-Ray, line by line: parts with instances, a net, prints. All numbers are those
 * of the hand-made models below; what is computed of them is said beside them. */
#include "core/numbers.h"
#include "formats/identifier.h"
#include "formats/print.h"
#include "tests/unit/text_fixture.h"

#include <png.h>
#include <stdio.h>

extern const lam_format lam_format_pov, lam_format_png;

static const lam_material steel = {.name = "steel",
                                   .color = {.5, .25, .12346},
                                   .metallic = 1,
                                   .roughness = .43218},
                          oak = {.name = "oak-1", .color = {.6, .4, .2}, .roughness = .75};

/* Nine triangles around the origin in z = 0, counterclockwise: all normals are (0, 0, 1). */
static lam_vec3 fan_points[11] = {{0, 0, 0},  {4, 0, 0},  {4, 1, 0}, {4, 2, 0},
                                  {3, 2, 0},  {2, 2, 0},  {1, 2, 0}, {0, 2, 0},
                                  {-1, 2, 0}, {-1, 1, 0}, {-1, 0, 0}};
static int fan_faces[9][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6},
                              {0, 6, 7}, {0, 7, 8}, {0, 8, 9}, {0, 9, 10}};

/* A triangle in y = 0; x cross z is -y. */
static lam_vec3 pin_points[3] = {{0, 0, 0}, {.25, 0, 0}, {0, 0, .5}};
static int pin_faces[1][3] = {{0, 1, 2}};

/* A triangle across the axes: its normal is (1, 1, 1) / sqrt(3) = 0.5774. */
static lam_vec3 tilted_points[3] = {{.1, 0, 0}, {0, .1, 0}, {0, 0, .1}};

static lam_trimesh tilted(void) { return (lam_trimesh){3, tilted_points, 1, pin_faces}; }
static lam_trimesh fan(void) { return (lam_trimesh){11, fan_points, 9, fan_faces}; }
static lam_trimesh pin(void) { return (lam_trimesh){3, pin_points, 1, pin_faces}; }

/* A quarter turn about z, then a move; a move alone. */
static lam_pose places[2] = {{{1, 2, 3}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}},
                             {{-2, 0, .123456789}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

static const lam_picture picture = {"meadow", "front", 640, 360, "thumb"};

#define FAN_VERTICES                                                                               \
  "11,\n    <0,0,0>,<4,0,0>,<4,1,0>,<4,2,0>,\n    <3,2,0>,<2,2,0>,<1,2,0>,<0,2,0>,\n"              \
  "    <-1,2,0>,<-1,1,0>,<-1,0,0> }\n"
#define FAN_NORMALS                                                                                \
  "11,\n    <0,0,1>,<0,0,1>,<0,0,1>,<0,0,1>,\n    <0,0,1>,<0,0,1>,<0,0,1>,<0,0,1>,\n"              \
  "    <0,0,1>,<0,0,1>,<0,0,1> }\n"
#define FAN_FACES                                                                                  \
  "  face_indices { 9,\n    <0,1,2>,<0,2,3>,<0,3,4>,<0,4,5>,<0,5,6>,<0,6,7>,<0,7,8>,<0,8,9>,\n"    \
  "    <0,9,10> }\n}\n"
#define TILTED_NORMALS                                                                             \
  "3,\n    <0.5774,0.5774,0.5774>,<0.5774,0.5774,0.5774>,<0.5774,0.5774,0.5774> }\n"
#define TILTED_MESH(name)                                                                          \
  "#declare " name " = mesh2 {\n  vertex_vectors { 3,\n    <0.1,0,0>,<0,0.1,0>,<0,0,0.1> }\n"      \
  "  normal_vectors { " TILTED_NORMALS "  face_indices { 1,\n    <0,1,2> }\n}\n"
#define PIN_MESH(name)                                                                             \
  "#declare " name " = mesh2 {\n  vertex_vectors { 3,\n    <0,0,0>,<0.25,0,0>,<0,0,0.5> }\n"       \
  "  normal_vectors { 3,\n    <0,-1,0>,<0,-1,0>,<0,-1,0> }\n  face_indices { 1,\n"                 \
  "    <0,1,2> }\n}\n"

/* ---- parts ---- */

/* Directions run x fastest from (-1, -1, -1) to (1, 1, 1) without (0, 0, 0); of points equally far
 * out the first counts. Instances of the pin stand at (1, 2, 3), (1, 2.25, 3), (1, 2, 3.5), and at
 * (-2, 0, .12346), (-1.75, 0, .12346), (-2, 0, .62346). The ground is the lowest support. */
static const char parts_scene[] =
    "// Two\n// Picture: povray \"render.ini[final]\" +Ithing.pov +W640 +H360\n"
    "// Part numbers as flat colors: \"render.ini[mask]\" instead. Meters, z up.\n#version 3.7;\n"
    "global_settings { assumed_gamma 1.0 }\n\n"
    "#declare Model_Min = <-2,0,0>;\n#declare Model_Max = <4,2.25,3.5>;\n"
    "#declare Model_Ground = 0.25;\n#declare Model_Support_Count = 5;\n"
    "#declare Model_Supports = array[5] {\n"
    "  <0,0,0.5>, <1,1,0.25>, <2,0,0.75>, <3,0,0.5>,\n  <4,0,0.5>\n}\n"
    "// The points that lie furthest out in 26 directions.\n#declare Model_Extremes = array[26] {\n"
    "  <-2,0,0.12346>, <0,0,0>, <4,0,0>, <-2,0,0.12346>,\n"
    "  <0,0,0>, <4,0,0>, <-1,2,0>, <4,2,0>,\n"
    "  <4,2,0>, <-2,0,0.12346>, <0,0,0>, <4,0,0>,\n"
    "  <-2,0,0.12346>, <4,0,0>, <-1,2,0>, <1,2.25,3>,\n"
    "  <4,2,0>, <-2,0,0.62346>, <1,2,3.5>, <4,0,0>,\n"
    "  <-2,0,0.62346>, <1,2,3.5>, <1,2,3.5>, <1,2,3.5>,\n"
    "  <1,2,3.5>, <1,2,3.5>\n}\n"
    "#declare View = \"front\";\n\n#include \"materials.inc\"\n"
    "#ifndef (Material_steel) #declare Material_steel = texture { "
    "Plain_Material(<0.5,0.25,0.1235>, 1, 0.4322) } #end\n"
    "#ifndef (Material_oak_1) #declare Material_oak_1 = texture { "
    "Plain_Material(<0.6,0.4,0.2>, 0, 0.75) } #end\n"
    "// roof: panel of steel\n#declare Part_1 = mesh2 {\n  vertex_vectors { " FAN_VERTICES
    "  normal_vectors { " FAN_NORMALS FAN_FACES
    "// pin: bolt of oak-1\n" PIN_MESH("Part_2") "// brace: bar of steel\n" TILTED_MESH(
        "Part_3") "\n// The setting calls this once.\n#macro Model_Parts()\n"
                  "object { Part_1 Look(1, Material_steel) }\n"
                  "object { Part_2 matrix <0,1,0,-1,0,0,0,0,1,1,2,3> Look(2, Material_oak_1) }\n"
                  "object { Part_2 matrix <1,0,0,0,1,0,0,0,1,-2,0,0.1234568> Look(3, "
                  "Material_oak_1) }\n"
                  "object { Part_3 Look(4, Material_steel) }\n#end\n\n#include \"meadow.inc\"\n";

static void parts_stand_where_they_are(void **state) {
  lam_part parts[3] = {{.name = "roof", .kind = "panel", .material = &steel, .solid = fan()},
                       {.name = "pin",
                        .kind = "bolt",
                        .material = &oak,
                        .solid = pin(),
                        .instance_count = 2,
                        .instances = places},
                       {.name = "brace", .kind = "bar", .material = &steel, .solid = tilted()}};
  static const lam_vec3 supports[5] = {
      {0, 0, .5}, {1, 1, .25}, {2, 0, .75}, {3, 0, .5}, {4, 0, .5}};
  lam_model model = {.name = "thing",
                     .title = "Two",
                     .part_count = 3,
                     .parts = parts,
                     .support_count = 5,
                     .supports = supports,
                     .picture = picture};
  assert_int_equal(lam_format_pov.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_pov, &model, 0), "thing.pov");
  assert_lines("parts", text_of(*state, &lam_format_pov, &model, 0), parts_scene);
}

/* Two triangles that meet at an angle of less than 30 degrees share the vertices between them (four
 * in all); from there on each has its own. */
static void gentle_edges_are_shared(void **state) {
  static const double degrees[2] = {29.9, 30.1};
  for (int i = 0; i < 2; i++) {
    double a = degrees[i] * LAM_PI / 180;
    lam_vec3 x[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -cos(a), -sin(a)}};
    int two[2][3] = {{0, 1, 2}, {1, 0, 3}};
    lam_part part = {.name = "roof", .kind = "panel", .material = &oak, .solid = {4, x, 2, two}};
    lam_model model = {
        .name = "p", .title = "p", .part_count = 1, .parts = &part, .picture = picture};
    assert_holds(text_of(*state, &lam_format_pov, &model, 0),
                 i ? "vertex_vectors { 6," : "vertex_vectors { 4,");
  }
}

/* ---- a net ---- */

/* 2 x 2 squares of side 0.5: all edges are as long as the mean, so lines have the radius
 * 0.5 x 0.026 = 0.013 and 0.026 along the boundary; balls as the thickest line. The desk-sized net
 * has seven decimals. A point counts as further out from a micrometer on: the one 0.84 um up does
 * not, the one 1.24 um up does. Quads are cut along their shorter diagonal or from corner 0. */
static const char net_scene[] =
    "#declare Model_Min = <0,0,0>;\n#declare Model_Max = <1,1,0.0000012>;\n"
    "#declare Model_Ground = 0;\n#declare Model_Support_Count = 0;\n"
    "// The points that lie furthest out in 26 directions.\n#declare Model_Extremes = array[26] {\n"
    "  <0,0,0>, <0,0,0>, <1,0,0>, <0,0,0>,\n"
    "  <0,0,0>, <1,0,0>, <0,1,0>, <0,1,0>,\n"
    "  <1,1,0>, <0,0,0>, <0,0,0>, <1,0,0>,\n"
    "  <0,0,0>, <1,0,0>, <0,1,0>, <0,1,0>,\n"
    "  <1,1,0>, <0,0,0>, <0,0,0>, <1,0,0>,\n"
    "  <0,0,0>, <1,0.5,0.0000012>, <1,0.5,0.0000012>, <0,1,0>,\n"
    "  <0,1,0>, <1,1,0>\n}\n";

static const char net_lines[] =
    "#declare Net_Lines = union {\n"
    "  cylinder { <0,0,0>, <0.5,0,0>, 0.026 }\n"
    "  cylinder { <0,0,0>, <0,0.5,0>, 0.026 }\n"
    "  cylinder { <0.5,0,0>, <1,0,0>, 0.026 }\n"
    "  cylinder { <0.5,0,0>, <0.5,0.5,0.0000008>, 0.013 }\n"
    "  cylinder { <1,0,0>, <1,0.5,0.0000012>, 0.026 }\n"
    "  cylinder { <0,0.5,0>, <0.5,0.5,0.0000008>, 0.013 }\n"
    "  cylinder { <0,0.5,0>, <0,1,0>, 0.026 }\n"
    "  cylinder { <0.5,0.5,0.0000008>, <1,0.5,0.0000012>, 0.013 }\n"
    "  cylinder { <0.5,0.5,0.0000008>, <0.5,1,0>, 0.013 }\n"
    "  cylinder { <1,0.5,0.0000012>, <1,1,0>, 0.026 }\n"
    "  cylinder { <0,1,0>, <0.5,1,0>, 0.026 }\n"
    "  cylinder { <0.5,1,0>, <1,1,0>, 0.026 }\n"
    "  sphere { <0,0,0>, 0.026 }\n  sphere { <0.5,0,0>, 0.026 }\n  sphere { <1,0,0>, 0.026 }\n"
    "  sphere { <0,0.5,0>, 0.026 }\n  sphere { <0.5,0.5,0.0000008>, 0.013 }\n"
    "  sphere { <1,0.5,0.0000012>, 0.026 }\n"
    "  sphere { <0,1,0>, 0.026 }\n  sphere { <0.5,1,0>, 0.026 }\n  sphere { <1,1,0>, 0.026 }\n}\n"
    "\n// The setting calls this once.\n#macro Model_Parts()\n"
    "object { Net_Faces Look(1, Material_net_faces) }\n"
    "object { Net_Lines Look(2, Material_net_lines) }\n#end\n\n#include \"meadow.inc\"\n";

static void a_net_has_faces_and_lines(void **state) {
  lam_vec3 x[9];
  for (int i = 0; i < 9; i++) x[i] = lam_v3(i % 3 * .5, i / 3 * .5, 0);
  x[4].z = .84e-6, x[5].z = 1.24e-6;
  int faces[4][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
  lam_mesh net = {9, x, 4, faces};
  lam_model model = {.name = "net", .title = "net", .net = &net, .picture = picture};
  assert_int_equal(lam_format_pov.count(&model), 1);
  const char *text = text_of(*state, &lam_format_pov, &model, 0);
  const char *head = strstr(text, "#declare Model_Min"), *lines = strstr(text, "#declare Net_Li");
  assert_non_null(head);
  assert_non_null(lines);
  const char *view = strstr(head, "#declare View");
  assert_lines("head", lam_arena_printf(*state, "%.*s", (int)(view - head), head), net_scene);
  assert_lines("lines", lines, net_lines);
  assert_holds(text, "  face_indices { 8,\n");
}

/* A triangle of which one side has no length: the mean of 0.4, 0 and 0.4 is 0.8 / 3, and all is
 * boundary: 2 x 0.026 x 0.8 / 3 = 0.013867, with a decimal more than coordinates, which have five
 * where the model is larger than 2 m. */
static void a_side_of_no_length_has_no_line(void **state) {
  lam_vec3 x[4] = {{0, 0, 0}, {.4, 0, 0}, {.4, 0, 0}, {2.1, 0, 0}};
  int faces[1][4] = {{0, 1, 2, -1}};
  lam_mesh net = {4, x, 1, faces};
  lam_model model = {.name = "net", .title = "net", .net = &net, .picture = picture};
  const char *text = text_of(*state, &lam_format_pov, &model, 0);
  assert_holds(text, "#declare Net_Lines = union {\n"
                     "  cylinder { <0,0,0>, <0.4,0,0>, 0.013867 }\n"
                     "  cylinder { <0,0,0>, <0.4,0,0>, 0.013867 }\n"
                     "  sphere { <0,0,0>, 0.013867 }\n  sphere { <0.4,0,0>, 0.013867 }\n"
                     "  sphere { <0.4,0,0>, 0.013867 }\n}\n");
}

/* ---- prints ---- */

static const char print_scene[] =
    "#declare Texture_Print = texture {\n  uv_mapping\n  pigment { image_map { png \"print.png\" "
    "interpolate 2 } }\n  finish { diffuse 0.8 specular 0.08 roughness 0.05 }\n}\n"
    "// print: sail\n#declare Sheet_1 = mesh2 {\n  vertex_vectors { " FAN_VERTICES
    "  normal_vectors { " FAN_NORMALS "  uv_vectors { 11,\n"
    "    <0,1>,<0.1,0.95>,<0.2,0.9>,<0.3,0.85>,<0.4,0.8>,<0.5,0.75>,\n"
    "    <0.6,0.7>,<0.7,0.65>,<0.8,0.6>,<0.9,0.55>,<1,0.5> }\n" FAN_FACES
    "// print: flag\n#declare Sheet_2 = mesh2 {\n  vertex_vectors { 3,\n"
    "    <0.1,0,0>,<0,0.1,0>,<0,0,0.1> }\n"
    "  normal_vectors { " TILTED_NORMALS "  uv_vectors { 3,\n    <0.12346,0.76543>,<1,0>,<0,1> }\n"
    "  face_indices { 1,\n    <0,1,2> }\n}\n"
    "\n// The setting calls this once.\n#macro Model_Parts()\n"
    "object { Part_1 matrix <0,1,0,-1,0,0,0,0,1,1,2,3> Look(1, Material_oak_1) }\n"
    "object { Part_1 matrix <1,0,0,0,1,0,0,0,1,-2,0,0.1234568> Look(2, Material_oak_1) }\n"
    "object { Sheet_1 #if (Mask) texture { pigment { color Mask_Color(3) } finish { ambient 0 "
    "diffuse 0 emission 1 } } #else texture { Texture_Print } #end }\n"
    "object { Sheet_2 #if (Mask) texture { pigment { color Mask_Color(4) } finish { ambient 0 "
    "diffuse 0 emission 1 } } #else texture { Texture_Print } #end }\n"
    "#end\n\n#include \"meadow.inc\"\n";

static void prints_are_meshes_with_a_picture(void **state) {
  static const unsigned char pixels[12] = {1, 2, 3, 40, 50, 60, 70, 80, 90, 255, 0, 128};
  static const lam_vec2 corners[3] = {{.1234567, .7654321}, {1, 0}, {0, 1}};
  lam_vec2 texture[11];
  for (int i = 0; i < 11; i++) texture[i] = (lam_vec2){i / 10., 1 - i / 20.};
  lam_printed sheets[2] = {{.name = "sail", .mesh = fan(), .texture = texture},
                           {.name = "flag", .mesh = tilted(), .texture = corners}};
  lam_print print = {4, 1, pixels, 2, sheets};
  lam_part part = {.name = "pin",
                   .kind = "bolt",
                   .material = &oak,
                   .solid = pin(),
                   .instance_count = 2,
                   .instances = places};
  lam_model model = {.name = "p",
                     .title = "p",
                     .part_count = 1,
                     .parts = &part,
                     .print = &print,
                     .picture = picture};
  assert_int_equal(lam_format_pov.count(&model), 2);
  assert_string_equal(text_path(*state, &lam_format_pov, &model, 1), "print.png");
  const char *text = text_of(*state, &lam_format_pov, &model, 0);
  assert_holds(text, "#declare Model_Max = <4,2.25,3.5>;\n#declare Model_Ground = 0;\n");
  assert_non_null(strstr(text, "#declare Texture_Print"));
  assert_lines("print", strstr(text, "#declare Texture_Print"), print_scene);

  lam_text png = {.arena = *state};
  assert_int_equal(lam_format_pov.write(&model, 1, &png), LAM_OK);

  png_image image = {.version = PNG_IMAGE_VERSION};
  unsigned char read[12];
  assert_true(png_image_begin_read_from_memory(&image, png.data, png.length));
  assert_int_equal(image.width, 4);
  assert_int_equal(image.height, 1);
  image.format = PNG_FORMAT_RGB;
  assert_true(png_image_finish_read(&image, NULL, read, 0, NULL));
  assert_memory_equal(read, pixels, sizeof pixels);
}

/* Triangles of area 0.5 in z = 0 and 1.5 in x = 0 share an edge: there the normal is (3, 0, 1) /
 * sqrt(10). A vertex without triangle looks up, and so does one whose triangles cancel. */
static void normals_of_prints_are_weighted_by_area(void **state) {
  lam_vec3 x[8] = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -3},
                   {5, 5, 5}, {0, 0, 9}, {1, 0, 9},  {0, 1, 9}};
  int faces[4][3] = {{0, 1, 2}, {1, 0, 3}, {5, 6, 7}, {5, 7, 6}};
  lam_trimesh mesh = {8, x, 4, faces};
  const lam_vec3 *n = lam_print_normals(*state, &mesh);
  double s = sqrt(10);
  const lam_vec3 expected[8] = {{3 / s, 0, 1 / s}, {3 / s, 0, 1 / s}, {0, 0, 1}, {1, 0, 0},
                                {0, 0, 1},         {0, 0, 1},         {0, 0, 1}, {0, 0, 1}};
  for (int v = 0; v < 8; v++) {
    char what[20];
    snprintf(what, sizeof what, "normal %d", v);
    assert_near_named(lam_distance(n[v], expected[v]), 0, 1e-15, what);
  }
}

/* ---- what stands beside a scene ---- */

/* Letters and digits of ASCII stay, every other byte becomes an underscore: also those that stand
 * beside them in the table of characters. */
static void names_become_identifiers(void **state) {
  lam_text text = {.arena = *state};
  lam_identifier_add(&text, "azAZ09-_ @[`{/:\u00e9");
  assert_string_equal(text.data, "azAZ09___________");
}

static void files_beside_the_scene_are_named(void **state) {
  static const char *const names[] = {"pov/render.ini", "pov/materials.inc", "pov/camera.inc",
                                      "pov/light.inc",  "pov/sky.inc",       "pov/ground.inc",
                                      "pov/people.inc", "pov/trees.inc",     "pov/meadow.inc"};
  lam_model model = {.name = "p", .picture = picture}, blank = {.name = "p"};
  const char *const *files = lam_format_pov.support(*state, &model);
  for (int i = 0; i < 9; i++) assert_string_equal(files[i], names[i]);
  assert_null(files[9]);
  assert_int_equal(lam_format_pov.count(&blank), 0);
  assert_int_equal(lam_format_png.count(&blank), 0);
  assert_int_equal(lam_format_png.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_png, &model, 0), "p.png");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(parts_stand_where_they_are),
      TEXT_TEST(gentle_edges_are_shared),
      TEXT_TEST(a_net_has_faces_and_lines),
      TEXT_TEST(a_side_of_no_length_has_no_line),
      TEXT_TEST(prints_are_meshes_with_a_picture),
      TEXT_TEST(normals_of_prints_are_weighted_by_area),
      TEXT_TEST(names_become_identifiers),
      TEXT_TEST(files_beside_the_scene_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
