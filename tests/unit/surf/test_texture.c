/* Prints: the picture, the places of the vertices on it, and what glTF carries of them. */
#include "developable_fixture.h"
#include "formats/format.h"
#include "surf/flatten/texture.h"

extern const lam_format lam_format_gltf;

static double dark_share(const unsigned char *pixels, int size) {
  double dark = 0;
  for (int i = 0; i < size * size; i++) dark += pixels[3 * i + 1] < 128;
  return dark / size / size;
}

/* Half of a checkerboard of 16 x 16 fields is dark; a letter twice as high has four times the ink.
 */
static void pictures_have_the_right_ink(void **state) {
  dev_fixture *f = *state;
  dev_near(dark_share(lam_motif_draw(f->arena, LAM_MOTIF_CHECKER, 1, 1, 256), 256), 0.5, 1e-12);
  double small = dark_share(lam_motif_draw(f->arena, LAM_MOTIF_LETTER, 0.4, 0.7, 256), 256);
  double large = dark_share(lam_motif_draw(f->arena, LAM_MOTIF_LETTER, 0.8, 0.9, 256), 256);
  dev_near(large / small, 4, 0.1); /* the shorter side counts */
}

/* Through the flattening, distances on the picture are those in space, to the strain of D3 (6.6e-3
 * at most, .001 in the mean square) times one scale; through the parameters they are not. */
static void distances_are_kept_by_the_flattening(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D3"));
  lam_print *print = lam_print_make(f->arena, &s, LAM_MOTIF_LETTER, LAM_PRINT_COMPARE, 20);
  assert_int_equal(print->count, 4);
  for (int k = 0; k < 4; k++) {
    const lam_printed *sheet = &print->sheets[k];
    double low = INFINITY, high = 0;
    for (int t = 0; t < sheet->mesh.triangle_count; t++)
      for (int e = 0; e < 3; e++) {
        int a = sheet->mesh.triangles[t][e], b = sheet->mesh.triangles[t][(e + 1) % 3];
        double on_picture = hypot(sheet->texture[b].x - sheet->texture[a].x,
                                  sheet->texture[b].y - sheet->texture[a].y);
        double scale = lam_distance(sheet->mesh.vertices[a], sheet->mesh.vertices[b]) / on_picture;
        low = fmin(low, scale);
        high = fmax(high, scale);
      }
    bool flattened = !strncmp(sheet->name, "flattening", 10);
    if (flattened ? high / low > 1.02 : high / low < 1.5)
      fail_msg("%s: scales %.4g to %.4g", sheet->name, low, high);
    for (int v = 0; v < sheet->mesh.vertex_count; v++)
      assert_true(sheet->texture[v].x >= 0 && sheet->texture[v].x <= 1 &&
                  sheet->texture[v].y >= 0 && sheet->texture[v].y <= 1);
  }
  /* independent program, 40 cells: 2.93 and 1.0137 */
  print = lam_print_make(f->arena, &s, LAM_MOTIF_CHECKER, LAM_PRINT_COMPARE, 40);
  dev_near(print->sheets[0].max_stretch, 1.0137, 1e-4);
  dev_near(print->sheets[2].max_stretch, 2.93, 0.005);
}

/* Places on the color scale are the distortion around a vertex: on the sheet that was flattened
 * first all are near its dark end, (1.0137 - 1)/(2.93 - 1) of it at most; along the parameters they
 * go nearly to its light one. The triangle of the largest ratio has neighbors of a little less. */
static void distortion_has_the_colors_of_its_values(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D3"));
  lam_print *print = lam_print_make(f->arena, &s, LAM_MOTIF_DISTORTION, LAM_PRINT_COMPARE, 40);
  assert_int_equal(print->count, 4);
  for (int k = 0; k < 4; k++) {
    double low = INFINITY, high = 0;
    for (int v = 0; v < print->sheets[k].mesh.vertex_count; v++) {
      low = fmin(low, print->sheets[k].texture[v].x);
      high = fmax(high, print->sheets[k].texture[v].x);
    }
    assert_true(low >= 0 && low < 0.05);
    if (k < 2 ? high > 0.0085 : high < 0.9 || high > 1)
      fail_msg("%s: up to %.4g", print->sheets[k].name, high);
  }
  const unsigned char *pixels = lam_motif_draw(f->arena, LAM_MOTIF_DISTORTION, 1, 1, 64);
  for (int column = 1; column < 64; column++) /* lightness rises, so green does */
    assert_true(pixels[3 * column + 1] >= pixels[3 * (column - 1) + 1]);
  assert_memory_equal(pixels, pixels + 3 * 64 * 63, 3 * 64);
}

/* The scene names texture coordinates and holds the picture as it is: a PNG file. */
static void gltf_carries_the_print(void **state) {
  dev_fixture *f = *state;
  lam_spline_surface s = dev_solved(f->arena, dev_case(f, "D4"));
  lam_mesh net = {0};
  lam_model model = {.name = "print", .title = "print", .net = &net};
  model.print = lam_print_make(f->arena, &s, LAM_MOTIF_CHECKER, LAM_PRINT_FLATTENING, 8);
  lam_text out = {.arena = f->arena};
  assert_int_equal(lam_format_gltf.write(&model, 0, &out), LAM_OK);
  const unsigned char *b = (const unsigned char *)out.data;
  size_t json_size = b[12] + 256u * b[13] + 65536u * b[14];
  json_error_t error;
  json_t *scene = json_loadb(out.data + 20, json_size, 0, &error);
  json_t *mesh = json_array_get(json_object_get(scene, "meshes"), 0);
  json_t *primitive = json_array_get(json_object_get(mesh, "primitives"), 0);
  int accessor = (int)json_integer_value(
      json_object_get(json_object_get(primitive, "attributes"), "TEXCOORD_0"));
  json_t *places = json_array_get(json_object_get(scene, "accessors"), (size_t)accessor);
  assert_string_equal(json_string_value(json_object_get(places, "type")), "VEC2");
  assert_int_equal(json_integer_value(json_object_get(places, "count")), 81);
  json_t *image = json_array_get(json_object_get(scene, "images"), 0);
  assert_string_equal(json_string_value(json_object_get(image, "mimeType")), "image/png");
  size_t view = (size_t)json_integer_value(json_object_get(image, "bufferView"));
  json_t *bytes = json_array_get(json_object_get(scene, "bufferViews"), view);
  size_t at = 20 + json_size + 8 + (size_t)json_integer_value(json_object_get(bytes, "byteOffset"));
  assert_true(at + 8 < out.length);
  assert_memory_equal(out.data + at, "\x89PNG\r\n\x1a\n", 8);
  json_decref(scene);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      DEV_TEST(pictures_have_the_right_ink), DEV_TEST(distances_are_kept_by_the_flattening),
      DEV_TEST(distortion_has_the_colors_of_its_values), DEV_TEST(gltf_carries_the_print)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
