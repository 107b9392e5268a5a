/* The animation of a net and its color maps as glTF files, number by number; what is computed of
 * the hand-made nets is said beside it. */
#include "formats/plot/color_scale.h"
#include "tests/unit/gltf_fixture.h"

extern const lam_format lam_format_animation, lam_format_plot_gltf;

/* ---- the way of a net ---- */

/* A square in z = 0, folded up along its first side, then turned over; its normals are +z, -y, -z
 * (the cross product of the diagonals). Vertex 4 has no face. */
static const lam_vec3 flat[5] = {{3, 5, 7}, {4, 5, 7}, {4, 6, 7}, {3, 6, 7}, {9, 9, 9}},
                      wall[5] = {{3, 5, 7}, {4, 5, 7}, {4, 5, 8}, {3, 5, 8}, {9, 9, 9}},
                      over[5] = {{3, 5, 7}, {4, 5, 7}, {4, 4, 7}, {3, 4, 7}, {9, 9, 9}};
static int square[1][4] = {{0, 1, 2, 3}};
static int side[2] = {0, 3};
static const lam_polyline line = {0, false, 2, side};

static const double at_first[15] = {3, 5, 7, 4, 5, 7, 4, 6, 7, 3, 6, 7, 9, 9, 9},
                    up[15] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                    to_wall[15] = {0, 0, 0, 0, 0, 0, 0, -1, 1, 0, -1, 1, 0, 0, 0},
                    to_over[15] = {0, 0, 0, 0, 0, 0, 0, -2, 0, 0, -2, 0, 0, 0, 0},
                    turn_to_wall[15] = {0, -1, -1, 0, -1, -1, 0, -1, -1, 0, -1, -1, 0, 0, 0},
                    turn_to_over[15] = {0, 0, -2, 0, 0, -2, 0, 0, -2, 0, 0, -2, 0, 0, 0};

/* States are morph targets as displacements from the first. Three states take 4 s: 2 s each, there
 * and back; at each the weight of its target is 1. */
static void states_are_morphed(void **state) {
  const lam_vec3 *const frames[3] = {flat, wall, over};
  lam_vec3 vertices[5];
  memcpy(vertices, over, sizeof vertices);
  lam_mesh net = {5, vertices, 1, square};
  lam_model model = {.name = "fold",
                     .title = "A fold",
                     .net = &net,
                     .polyline_count = 1,
                     .polylines = &line,
                     .frame_count = 3,
                     .frames = frames};
  assert_int_equal(lam_format_animation.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_animation, &model, 0), "fold-animation.glb");
  scene s = read_scene(*state, &lam_format_animation, &model, 0);
  assert_node(&s, 0, "fold", -1, 2);
  assert_node(&s, 1, "faces", 0, 0);
  assert_node(&s, 2, "lines", 1, 0);

  const json_t *faces = primitive_of(&s, 0), *lines = primitive_of(&s, 1);
  assert_floats(&s, attribute(faces, "POSITION"), "VEC3", 5, at_first, "positions");
  assert_floats(&s, attribute(faces, "NORMAL"), "VEC3", 5, up, "normals");
  assert_indices(&s, faces, 6, (const int[6]){0, 1, 2, 0, 2, 3});
  const double *const moves[2] = {to_wall, to_over}, *const turns[2] = {turn_to_wall, turn_to_over};
  for (int t = 0; t < 2; t++) {
    const json_t *of_faces = json_array_get(json_object_get(faces, "targets"), (size_t)t);
    const json_t *of_lines = json_array_get(json_object_get(lines, "targets"), (size_t)t);
    assert_floats(&s, (int)number(of_faces, "POSITION"), "VEC3", 5, moves[t], "moves");
    assert_floats(&s, (int)number(of_faces, "NORMAL"), "VEC3", 5, turns[t], "turns");
    assert_floats(&s, (int)number(of_lines, "POSITION"), "VEC3", 5, moves[t], "moves of lines");
    assert_null(json_object_get(of_lines, "NORMAL"));
  }
  assert_floats(&s, attribute(lines, "POSITION"), "VEC3", 5, at_first, "positions of lines");
  assert_indices(&s, lines, 2, (const int[2]){0, 3});
  assert_int_equal(number(lines, "mode"), 1);
  assert_int_equal(number(lines, "material"), 1);

  static const double times[5] = {0, 2, 4, 6, 8}, still[2] = {0, 0},
                      weights[10] = {0, 0, 1, 0, 0, 1, 1, 0, 0, 0}, first = 0, last = 8;
  assert_list(json_object_get(item(&s, "meshes", 0), "weights"), 2, still, "weights at rest");
  const json_t *animation = item(&s, "animations", 0);
  assert_string_equal(json_string_value(json_object_get(animation, "name")), "deformation");
  for (int i = 0; i < 2; i++) {
    const json_t *channel = json_array_get(json_object_get(animation, "channels"), (size_t)i),
                 *target = json_object_get(channel, "target"),
                 *sampler = json_array_get(json_object_get(animation, "samplers"),
                                           (size_t)number(channel, "sampler"));
    assert_int_equal(number(channel, "sampler"), i);
    assert_int_equal(number(target, "node"), 1 + i);
    assert_string_equal(json_string_value(json_object_get(target, "path")), "weights");
    assert_floats(&s, (int)number(sampler, "input"), "SCALAR", 5, times, "times");
    assert_floats(&s, (int)number(sampler, "output"), "SCALAR", 10, weights, "weights");
    const json_t *input = item(&s, "accessors", (int)number(sampler, "input"));
    assert_list(json_object_get(input, "min"), 1, &first, "first time");
    assert_list(json_object_get(input, "max"), 1, &last, "last time");
    assert_null(
        json_object_get(item(&s, "bufferViews", (int)number(input, "bufferView")), "target"));
  }
}

/* Faces are a bright material seen from both sides, lines a dark one; without polylines there is
 * neither node nor mesh of lines. One state is no way. */
static void lines_may_be_missing(void **state) {
  static const double bright[4] = {.75, .75, .72, 1}, dark[4] = {.1, .1, .1, 1};
  const lam_vec3 *const frames[2] = {flat, wall};
  lam_vec3 vertices[5];
  memcpy(vertices, wall, sizeof vertices);
  lam_mesh net = {5, vertices, 1, square};
  lam_model model = {.name = "fold",
                     .title = "A fold",
                     .net = &net,
                     .polyline_count = 1,
                     .polylines = &line,
                     .frame_count = 2,
                     .frames = frames};
  scene s = read_scene(*state, &lam_format_animation, &model, 0);
  const json_t *m[2] = {item(&s, "materials", 0), item(&s, "materials", 1)};
  for (int i = 0; i < 2; i++) {
    const json_t *pbr = json_object_get(m[i], "pbrMetallicRoughness");
    assert_list(json_object_get(pbr, "baseColorFactor"), 4, i ? dark : bright, "color");
    assert_near(number(pbr, "metallicFactor"), 0, 0);
    assert_int_equal(json_is_true(json_object_get(m[i], "doubleSided")), !i);
  }
  assert_near(number(json_object_get(m[0], "pbrMetallicRoughness"), "roughnessFactor"), .8, 1e-12);

  assert_string_equal(json_string_value(json_object_get(item(&s, "scenes", 0), "name")), "A fold");
  model.polyline_count = 0, model.title = NULL;
  s = read_scene(*state, &lam_format_animation, &model, 0);
  assert_string_equal(json_string_value(json_object_get(item(&s, "scenes", 0), "name")), "fold");
  assert_int_equal(json_array_size(json_object_get(s.root, "nodes")), 2);
  assert_int_equal(json_array_size(json_object_get(s.root, "meshes")), 1);
  assert_int_equal(json_array_size(json_object_get(s.root, "materials")), 1);
  model.frame_count = 1;
  assert_int_equal(lam_format_animation.count(&model), 0);
  model.frame_count = 2, model.net = NULL;
  assert_int_equal(lam_format_animation.count(&model), 0);
}

/* ---- color maps ---- */

/* Two quads side by side, the second one upright: normals +z and -x. */
static lam_vec3 bent[6] = {{1, 4, 1}, {3, 4, 1}, {3, 4, 3}, {1, 5, 1}, {3, 5, 1}, {3, 5, 3}};
static int two[2][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}};
static const lam_vec3 normals[6] = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0},
                                    {0, 0, 1}, {0, 0, 0}, {-1, 0, 0}};

/* Colors of values 0, 1 ... 4 between 0 and 4: of the scale, whose own test is test_color_scale. */
static void color_of(const lam_map *map, double value, double *rgb) {
  lam_color_scale scale = lam_map_scale(map);
  lam_rgb c = lam_color_of(&scale, value);
  rgb[0] = c.r, rgb[1] = c.g, rgb[2] = c.b;
}

static void assert_colors(const scene *s, const lam_map *map, const int *of, int count) {
  double colors[3 * 24];
  for (int i = 0; i < count; i++) color_of(map, map->values[of[i]], colors + 3 * i);
  assert_floats(s, attribute(primitive_of(s, 0), "COLOR_0"), "VEC3", count, colors, "colors");
}

/* Values on vertices: faces share the net's vertices. The layout lies a tenth of the net's width
 * (2) beside it: its leftmost point at x = 3.2, its lowest at the net's lowest y, on the net's
 * lowest z. A normal of zero looks up. */
static void vertices_have_colors(void **state) {
  static const double values[6] = {0, 1, 2, 3, 4, NAN};
  static const lam_vec2 layout[6] = {{5, 7}, {7, 7}, {9, 7}, {5, 8}, {7, 8}, {9, 8}};
  lam_mesh net = {6, bent, 2, two};
  lam_map map = {LAM_MAP_VERTICES, "doc", {"height", "m", 0, 4, 2, 5}, 6, values, NULL, normals,
                 layout,           {0, 0}};
  lam_model model = {.name = "n", .title = "n", .net = &net, .map_count = 1, .maps = &map};
  assert_int_equal(lam_format_plot_gltf.count(&model), 1);
  assert_string_equal(text_path(*state, &lam_format_plot_gltf, &model, 0), "plots/height.glb");
  scene s = read_scene(*state, &lam_format_plot_gltf, &model, 0);
  static const double at[36] = {1,   4, 1, 3,   4, 1, 3,   4, 3, 1,   5, 1, 3,   5, 1, 3,   5, 3,
                                3.2, 4, 1, 5.2, 4, 1, 7.2, 4, 1, 3.2, 5, 1, 5.2, 5, 1, 7.2, 5, 1};
  static const double to[36] = {0, 0, 1, 0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 1, -1, 0, 0,
                                0, 0, 1, 0, 0, 1, 0,  0, 1, 0, 0, 1, 0, 0, 1, 0,  0, 1};
  const json_t *p = primitive_of(&s, 0);
  assert_floats(&s, attribute(p, "POSITION"), "VEC3", 12, at, "positions");
  assert_floats(&s, attribute(p, "NORMAL"), "VEC3", 12, to, "normals");
  assert_colors(&s, &map, (const int[12]){0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5}, 12);
  assert_indices(&s, p, 24, (const int[24]){0, 1, 4,  0, 4,  3, 1, 2, 5,  1, 5,  4,
                                            6, 7, 10, 6, 10, 9, 7, 8, 11, 7, 11, 10});
  assert_node(&s, 0, "n", -1, 1);
  assert_node(&s, 1, "height", 0, 0);
  char *extras =
      json_dumps(json_object_get(item(&s, "nodes", 1), "extras"), JSON_COMPACT | JSON_SORT_KEYS);
  assert_string_equal(
      extras, "{\"count\":5,\"max\":4,\"mean\":2,\"measure\":\"height\",\"min\":0,\"unit\":\"m\"}");
  free(extras);
  assert_true(json_is_true(json_object_get(item(&s, "materials", 0), "doubleSided")));
}

/* Values on faces: four vertices each, in the color and with the normal of the face. */
static void faces_have_colors(void **state) {
  static const double values[2] = {1, 3};
  lam_mesh net = {6, bent, 2, two};
  lam_map map = {LAM_MAP_FACES, "doc", {"slope", "", NAN, 4, 2, 2}, 2, values, NULL, normals,
                 NULL,          {0, 4}};
  lam_model model = {.name = "n", .title = "n", .net = &net, .map_count = 1, .maps = &map};
  scene s = read_scene(*state, &lam_format_plot_gltf, &model, 0);
  static const double at[24] = {1, 4, 1, 3, 4, 1, 3, 5, 1, 1, 5, 1,
                                3, 4, 1, 3, 4, 3, 3, 5, 3, 3, 5, 1};
  static const double to[24] = {0,  0, 1, 0,  0, 1, 0,  0, 1, 0,  0, 1,
                                -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0};
  const json_t *p = primitive_of(&s, 0);
  assert_floats(&s, attribute(p, "POSITION"), "VEC3", 8, at, "positions");
  assert_floats(&s, attribute(p, "NORMAL"), "VEC3", 8, to, "normals");
  assert_colors(&s, &map, (const int[8]){0, 0, 0, 0, 1, 1, 1, 1}, 8);
  assert_indices(&s, p, 12, (const int[12]){0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
  char *extras = json_dumps(json_object_get(item(&s, "nodes", 1), "extras"),
                            JSON_COMPACT | JSON_SORT_KEYS); /* without the undefined minimum */
  assert_string_equal(extras,
                      "{\"count\":2,\"max\":4,\"mean\":2,\"measure\":\"slope\",\"unit\":\"\"}");
  free(extras);
}

/* Values on edges: lines of two vertices each. */
static void edges_have_colors(void **state) {
  static const double values[3] = {0, 2, 4};
  static const int edges[3][2] = {{0, 1}, {1, 2}, {5, 2}};
  lam_mesh net = {6, bent, 2, two};
  lam_map map = {LAM_MAP_EDGES, "doc", {"length", "m", 0, 4, 2, 3}, 3, values, edges, normals,
                 NULL,          {0, 0}};
  lam_model model = {.name = "n", .title = "n", .net = &net, .map_count = 1, .maps = &map};
  scene s = read_scene(*state, &lam_format_plot_gltf, &model, 0);
  static const double at[18] = {1, 4, 1, 3, 4, 1, 3, 4, 1, 3, 4, 3, 3, 5, 3, 3, 4, 3};
  const json_t *p = primitive_of(&s, 0);
  assert_floats(&s, attribute(p, "POSITION"), "VEC3", 6, at, "positions");
  assert_int_equal(attribute(p, "NORMAL"), -1);
  assert_int_equal(number(p, "mode"), 1);
  assert_colors(&s, &map, (const int[6]){0, 0, 1, 1, 2, 2}, 6);
  assert_indices(&s, p, 6, (const int[6]){0, 1, 2, 3, 4, 5});
  model.net = NULL;
  assert_int_equal(lam_format_plot_gltf.count(&model), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(states_are_morphed),   TEXT_TEST(lines_may_be_missing),
      TEXT_TEST(vertices_have_colors), TEXT_TEST(faces_have_colors),
      TEXT_TEST(edges_have_colors),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
