/* What stands in a glTF file of parts, of a net or of prints, number by number: nodes, matrices,
 * vertices, bounds, materials. Expected numbers are those of the hand-made models. */
#include "core/numbers.h"
#include "formats/gltf/gltf_scene.h"
#include "tests/unit/gltf_fixture.h"

extern const lam_format lam_format_gltf;

/* x, y, z (up) become x, -z, y (up); column-major. */
static const double y_up[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};

/* ---- parts ---- */

static const lam_material tin = {
    .name = "tin", .color = {.5, .25, .125}, .metallic = 1, .roughness = .4};
static lam_vec3 corners[3] = {{1, 2, 3}, {2, 2, 3}, {1, 4, 3}}; /* looks up */
static int triangle[1][3] = {{0, 1, 2}};

/* Root, family A with A07, family B, of no family "pin" with two instances; nodes are numbered in
 * that order. A part without triangles has a node without mesh. */
static void parts_are_nodes(void **state) {
  lam_trimesh solid = {3, corners, 1, triangle};
  lam_pose poses[2] = {{{1, 2, 3}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}},
                       {{4, 5, 1. / 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  lam_fact facts[3] = {{"splices", "", 2}, {"odd", "m", NAN}, {"slope", "rad", .1234567891234}};
  lam_part parts[3] = {
      {.name = "pin",
       .kind = "pin",
       .family = -1,
       .material = &tin,
       .solid = solid,
       .instance_count = 2,
       .instances = poses,
       .mass = .125},
      {.name = "B2", .kind = "lamella", .family = 1, .material = &tin, .solid = {0}},
      {.name = "A07",
       .kind = "lamella",
       .material = &tin,
       .solid = solid,
       .fact_count = 3,
       .facts = facts}};
  lam_model model = {.name = "thing", .title = "A Thing", .part_count = 3, .parts = parts};
  scene s = read_scene(*state, &lam_format_gltf, &model, 0);

  assert_int_equal(json_array_size(json_object_get(s.root, "nodes")), 8);
  assert_node(&s, 0, "thing", -1, 3);
  assert_node(&s, 1, "family A", -1, 1);
  assert_node(&s, 2, "A07", 0, 0);
  assert_node(&s, 3, "family B", -1, 1);
  assert_node(&s, 4, "B2", -1, 0);
  assert_node(&s, 5, "pin", -1, 2);
  assert_node(&s, 6, "pin 1", 1, 0);
  assert_node(&s, 7, "pin 2", 1, 0);
  assert_list(json_object_get(item(&s, "nodes", 0), "matrix"), 16, y_up, "root");
  static const double turned[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1},
                      moved[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 4, 5, .333333333, 1};
  assert_list(json_object_get(item(&s, "nodes", 6), "matrix"), 16, turned, "pin 1");
  assert_list(json_object_get(item(&s, "nodes", 7), "matrix"), 16, moved, "pin 2");
  assert_near(
      json_number_value(json_array_get(json_object_get(item(&s, "nodes", 7), "matrix"), 14)),
      .333333333, 1e-15); /* nine digits */
  char *extras = json_dumps(json_object_get(item(&s, "nodes", 2), "extras"),
                            JSON_COMPACT | JSON_SORT_KEYS | JSON_REAL_PRECISION(12));
  assert_string_equal(extras, "{\"family\":\"A\",\"kind\":\"lamella\",\"mass\":0,\"material\":"
                              "\"tin\",\"number\":7,\"slope\":0.123456789,\"splices\":2}");
  free(extras);
  extras =
      json_dumps(json_object_get(item(&s, "nodes", 5), "extras"), JSON_COMPACT | JSON_SORT_KEYS);
  assert_string_equal(extras, "{\"count\":2,\"kind\":\"pin\",\"mass\":0.125,\"material\":\"tin\"}");
  free(extras);
}

/* A mesh of one triangle: positions with their bounds, normals, indices, material, views. */
static void meshes_have_their_numbers(void **state) {
  lam_part part = {
      .name = "A07", .kind = "lamella", .material = &tin, .solid = {3, corners, 1, triangle}};
  lam_model model = {.name = "thing", .title = "A Thing", .part_count = 1, .parts = &part};
  scene s = read_scene(*state, &lam_format_gltf, &model, 0);
  static const double at[9] = {1, 2, 3, 2, 2, 3, 1, 4, 3}, up[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1},
                      low[3] = {1, 2, 3}, high[3] = {2, 4, 3}, color[4] = {.5, .25, .125, 1};
  const json_t *p = primitive_of(&s, 0);
  assert_floats(&s, attribute(p, "POSITION"), "VEC3", 3, at, "positions");
  assert_floats(&s, attribute(p, "NORMAL"), "VEC3", 3, up, "normals");
  assert_indices(&s, p, 3, (const int[3]){0, 1, 2});
  const json_t *a = item(&s, "accessors", attribute(p, "POSITION"));
  assert_list(json_object_get(a, "min"), 3, low, "lowest");
  assert_list(json_object_get(a, "max"), 3, high, "highest");

  const json_t *m = item(&s, "materials", (int)number(p, "material"));
  const json_t *pbr = json_object_get(m, "pbrMetallicRoughness");
  assert_list(json_object_get(pbr, "baseColorFactor"), 4, color, "color");
  assert_near(number(pbr, "roughnessFactor"), .4, 1e-12);
  assert_null(json_object_get(pbr, "metallicFactor")); /* 1 is what it is without */
  assert_null(json_object_get(m, "doubleSided"));
  const json_t *view = item(&s, "bufferViews", 0), *indices = item(&s, "bufferViews", 1);
  assert_int_equal(number(view, "byteStride"), 12);
  assert_int_equal(number(view, "byteLength"), 72);
  assert_int_equal(number(view, "target"), 34962);
  assert_int_equal(number(indices, "target"), 34963);
  assert_int_equal(number(indices, "byteOffset"), 72);
  assert_int_equal(number(indices, "byteLength"), 6);
  assert_int_equal(number(item(&s, "buffers", 0), "byteLength"), 80); /* padded to four */
  assert_string_equal(json_string_value(json_object_get(item(&s, "scenes", 0), "name")), "A Thing");
}

/* Two triangles that meet at an angle of less than 25 degrees share the vertices between them (four
 * in all); from there on each has its own. */
static void gentle_edges_are_shared(void **state) {
  static const double degrees[2] = {24.9, 25.1};
  for (int i = 0; i < 2; i++) {
    double a = degrees[i] * LAM_PI / 180;
    lam_vec3 x[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -cos(a), -sin(a)}};
    int two[2][3] = {{0, 1, 2}, {1, 0, 3}};
    lam_part part = {.name = "A07", .kind = "lamella", .material = &tin, .solid = {4, x, 2, two}};
    lam_model model = {.name = "thing", .title = "A Thing", .part_count = 1, .parts = &part};
    scene s = read_scene(*state, &lam_format_gltf, &model, 0);
    assert_int_equal(
        number(item(&s, "accessors", attribute(primitive_of(&s, 0), "POSITION")), "count"),
        i ? 6 : 4);
  }
}

/* A vector as floats: the bits of a negative zero would differ from those of zero. */
static void zeros_are_not_negative(void **state) {
  (void)state;
  static const float zeros[3] = {0, 0, 0}, numbers[3] = {-1.5f, 2.25f, -3};
  float value[3];
  lam_gltf_vector(value, lam_v3(-0., -0., -0.));
  assert_memory_equal(value, zeros, sizeof zeros);
  lam_gltf_vector(value, lam_v3(-1.5, 2.25, -3));
  assert_memory_equal(value, numbers, sizeof numbers);
}

/* ---- a net, prints ---- */

static lam_vec3 grid[6] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, -1}};
static int quads[2][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}};
static int open_line[3] = {0, 1, 2}, ring[4] = {0, 1, 4, 3};
static const lam_polyline lines[2] = {{0, false, 3, open_line}, {-1, true, 4, ring}};

/* An open polyline of three vertices has two edges, a closed one of four has four. */
static void a_net_is_lines(void **state) {
  lam_mesh net = {6, grid, 2, quads};
  lam_model model = {
      .name = "net", .title = "net", .net = &net, .polyline_count = 2, .polylines = lines};
  assert_int_equal(lam_format_gltf.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_gltf, &model, 0), "net.glb");
  scene s = read_scene(*state, &lam_format_gltf, &model, 0);
  const json_t *p = primitive_of(&s, 0);
  assert_node(&s, 0, "net", -1, 1);
  assert_node(&s, 1, "net", 0, 0);
  assert_int_equal(number(p, "mode"), 1); /* lines */
  assert_indices(&s, p, 12, (const int[12]){0, 1, 1, 2, 0, 1, 1, 4, 4, 3, 3, 0});
  assert_int_equal(attribute(p, "NORMAL"), -1);
  static const double gray[4] = {.2, .2, .2, 1};
  const json_t *pbr = json_object_get(item(&s, "materials", 0), "pbrMetallicRoughness");
  assert_list(json_object_get(pbr, "baseColorFactor"), 4, gray, "gray");
  assert_near(number(pbr, "metallicFactor"), 0, 0);
  model.polyline_count = 0;
  s = read_scene(*state, &lam_format_gltf, &model, 0);
  assert_node(&s, 1, "net", -1, 0);
}

/* 16 bits as long as no index can be 65535, which glTF forbids; 32 bits from 65535
 * vertices on. */
static void indices_are_as_wide_as_needed(void **state) {
  lam_vec3 *many = LAM_NEW(*state, lam_vec3, 65535);
  for (int wide = 0; wide < 2; wide++) {
    lam_mesh net = {65534 + wide, many, 2, quads};
    int ends[2] = {0, 65533 + wide};
    lam_polyline line = {0, false, 2, ends};
    lam_model model = {
        .name = "net", .title = "net", .net = &net, .polyline_count = 1, .polylines = &line};
    scene s = read_scene(*state, &lam_format_gltf, &model, 0);
    int accessor = (int)number(primitive_of(&s, 0), "indices");
    const char *bytes = data_of(&s, accessor, "SCALAR", wide ? 5125 : 5123, 2);
    uint16_t narrow;
    memcpy(&narrow, bytes + 2, 2);
    assert_int_equal(wide ? (int)word(bytes + 4) : narrow, ends[1]);
  }
}

/* Texture coordinates count from the upper left corner: v becomes 1 - v. */
static void prints_have_their_picture(void **state) {
  static const unsigned char pixels[3] = {10, 20, 30};
  static const lam_vec2 texture[3] = {{0, 0}, {1, .25}, {.5, 1}};
  lam_printed sheet = {.name = "sail", .mesh = {3, corners, 1, triangle}, .texture = texture};
  lam_print print = {1, 1, pixels, 1, &sheet};
  lam_mesh net = {6, grid, 2, quads};
  lam_model model = {.name = "p",
                     .title = "p",
                     .net = &net,
                     .polyline_count = 2,
                     .polylines = lines,
                     .print = &print};
  scene s = read_scene(*state, &lam_format_gltf, &model, 0);
  assert_int_equal(json_array_size(json_object_get(s.root, "nodes")), 2); /* no net */
  assert_node(&s, 1, "sail", 0, 0);
  static const double uv[6] = {0, 1, 1, .75, .5, 0}, white[4] = {1, 1, 1, 1},
                      up[9] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  const json_t *p = primitive_of(&s, 0), *m = item(&s, "materials", 0);
  assert_floats(&s, attribute(p, "TEXCOORD_0"), "VEC2", 3, uv, "texture");
  assert_floats(&s, attribute(p, "NORMAL"), "VEC3", 3, up, "normals");
  assert_true(json_is_true(json_object_get(m, "doubleSided")));
  const json_t *pbr = json_object_get(m, "pbrMetallicRoughness");
  if (json_object_get(pbr, "baseColorFactor"))
    assert_list(json_object_get(pbr, "baseColorFactor"), 4, white, "white");
  assert_near(number(pbr, "roughnessFactor"), .7, 1e-12);
  assert_near(number(pbr, "metallicFactor"), 0, 0);
  assert_non_null(json_object_get(pbr, "baseColorTexture"));
  const json_t *image = item(&s, "images", 0);
  assert_string_equal(json_string_value(json_object_get(image, "mimeType")), "image/png");
  const json_t *view = item(&s, "bufferViews", (int)number(image, "bufferView"));
  assert_memory_equal(s.binary + (size_t)number(view, "byteOffset"), "\x89PNG", 4);
  assert_memory_equal(
      s.binary + (size_t)(number(view, "byteOffset") + number(view, "byteLength")) - 8, "IEND", 4);
  const json_t *pairs =
      item(&s, "bufferViews",
           (int)number(item(&s, "accessors", attribute(p, "TEXCOORD_0")), "bufferView"));
  assert_int_equal(number(pairs, "byteStride"), 8);
  assert_int_equal(number(pairs, "target"), 34962);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(parts_are_nodes),
      TEXT_TEST(meshes_have_their_numbers),
      TEXT_TEST(gentle_edges_are_shared),
      TEXT_TEST(zeros_are_not_negative),
      TEXT_TEST(a_net_is_lines),
      TEXT_TEST(indices_are_as_wide_as_needed),
      TEXT_TEST(prints_have_their_picture),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
