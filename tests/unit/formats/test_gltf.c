/* Shading vertices and the glTF writer. What the files look like to others is tested in
 * tests/cli/gltf.t. */
#include "core/arena.h"
#include "core/numbers.h"
#include "formats/corner_normals.h"
#include "formats/format.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

extern const lam_format lam_format_gltf;

/* A prism over a regular polygon around the z axis, radius 1, height 1, closed and oriented. */
static lam_trimesh prism(lam_arena *arena, int sides) {
  lam_trimesh m = {2 * sides + 2, LAM_NEW(arena, lam_vec3, 2 * sides + 2), 4 * sides, NULL};
  m.triangles = lam_arena_alloc(arena, (size_t)m.triangle_count, sizeof(int[3]));
  int low = 2 * sides, high = low + 1;
  m.vertices[high] = lam_v3(0, 0, 1);
  for (int i = 0; i < sides; i++) {
    double angle = 2 * LAM_PI * i / sides;
    int a = 2 * i, b = 2 * ((i + 1) % sides);
    m.vertices[a] = lam_v3(cos(angle), sin(angle), 0);
    m.vertices[a + 1] = lam_v3(cos(angle), sin(angle), 1);
    const int triangles[4][3] = {
        {a, b, b + 1}, {a, b + 1, a + 1}, {low, b, a}, {high, a + 1, b + 1}};
    memcpy(m.triangles[4 * i], triangles, sizeof triangles);
  }
  return m;
}

/* A box has 3 normals at each of its 8 corners, and one at the center of its top and of its bottom;
 * at right angles nothing is smoothed, so every normal is that of its face. */
static void sharp_edges_are_split(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_trimesh box = prism(arena, 4);
  lam_shaded_mesh shaded = lam_shaded_mesh_make(arena, &box, LAM_PI / 6);
  assert_int_equal(shaded.vertex_count, 3 * 8 + 2);
  assert_int_equal(shaded.triangle_count, box.triangle_count);
  for (int t = 0; t < shaded.triangle_count; t++) {
    const int *c = box.triangles[t];
    lam_vec3 normal = lam_unit(lam_cross(lam_sub(box.vertices[c[1]], box.vertices[c[0]]),
                                         lam_sub(box.vertices[c[2]], box.vertices[c[0]])));
    for (int k = 0; k < 3; k++) {
      assert_int_equal(shaded.source[shaded.triangles[t][k]], c[k]);
      assert_true(lam_distance(shaded.normals[shaded.triangles[t][k]], normal) < 1e-12);
    }
  }
  lam_arena_free(arena);
}

/* With 36 sides of 10 deg the wall is smooth: its normals point away from the axis, and each rim
 * vertex has two normals, one for the wall and one for the cap. Weighting by corner angles makes
 * the two triangles of each quad count as one, so the normals are radial up to rounding. */
static void gentle_edges_are_smooth(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_trimesh drum = prism(arena, 36);
  lam_shaded_mesh shaded = lam_shaded_mesh_make(arena, &drum, LAM_PI / 6);
  assert_int_equal(shaded.vertex_count, 2 * 72 + 2);
  for (int i = 0; i < shaded.vertex_count; i++) {
    lam_vec3 x = drum.vertices[shaded.source[i]], n = shaded.normals[i];
    if (fabs(n.z) > 0.5) continue;
    assert_true(fabs(n.x - x.x) < 1e-12 && fabs(n.y - x.y) < 1e-12 && fabs(n.z) < 1e-12);
  }
  lam_arena_free(arena);
}

static void triangles_without_area_are_dropped(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_vec3 points[3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  int triangle[1][3] = {{0, 1, 2}};
  lam_trimesh flat = {3, points, 1, triangle};
  lam_shaded_mesh shaded = lam_shaded_mesh_make(arena, &flat, LAM_PI / 6);
  assert_int_equal(shaded.vertex_count, 0);
  assert_int_equal(shaded.triangle_count, 0);
  lam_arena_free(arena);
}

/* ---- the writer ---- */

static const lam_material tin = {
    .name = "tin", .color = {.5, .5, .5}, .metallic = 1, .roughness = .4};

typedef struct fixture {
  lam_part parts[2];
  lam_pose frames[3];
  lam_model model;
} fixture;

static void fill(lam_arena *arena, fixture *f) {
  for (int i = 0; i < 3; i++)
    f->frames[i] = (lam_pose){{i, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  f->parts[0] = (lam_part){.name = "B07a",
                           .kind = "lamella",
                           .family = 1,
                           .group = 0,
                           .congruence = 4,
                           .material = &tin,
                           .solid = prism(arena, 4),
                           .length = 2.5,
                           .mass = 1.25};
  f->parts[1] = (lam_part){.name = "pin",
                           .kind = "pin",
                           .family = -1,
                           .group = -1,
                           .material = &tin,
                           .solid = prism(arena, 6),
                           .instance_count = 3,
                           .instances = f->frames};
  f->model = (lam_model){.name = "thing", .version = "0", .part_count = 2, .parts = f->parts};
}

static uint32_t word(const lam_text *text, size_t at) {
  const unsigned char *b = (const unsigned char *)text->data + at;
  return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* The container as in the glTF 2.0 specification, chapter 4: magic, version, length, and chunks on
 * 4-byte boundaries.
 */
static void the_container_is_sound(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  fixture f;
  fill(arena, &f);
  lam_text out = {.arena = arena};
  assert_int_equal(lam_format_gltf.count(&f.model), 1);
  assert_int_equal(lam_format_gltf.write(&f.model, 0, &out), LAM_OK);
  assert_memory_equal(out.data, "glTF", 4);
  assert_int_equal(word(&out, 4), 2);
  assert_int_equal(word(&out, 8), out.length);
  uint32_t json = word(&out, 12), binary = word(&out, 20 + json);
  assert_int_equal(json % 4, 0);
  assert_int_equal(binary % 4, 0);
  assert_int_equal(20 + json + 8 + binary, out.length);
  char *text = lam_arena_printf(arena, "%.*s", (int)json, out.data + 20);
  assert_non_null(strstr(
      text, "\"extras\":{\"kind\":\"lamella\",\"material\":\"tin\",\"mass\":1.25,"
            "\"family\":\"B\",\"number\":7,\"length\":2.5,\"congruence\":4}"));
  assert_non_null(strstr(text, "\"name\":\"pin 3\""));
  lam_arena_free(arena);
}

static void the_same_model_gives_the_same_bytes(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  fixture f;
  fill(arena, &f);
  lam_text one = {.arena = arena}, two = {.arena = arena};
  lam_format_gltf.write(&f.model, 0, &one);
  lam_format_gltf.write(&f.model, 0, &two);
  assert_int_equal(one.length, two.length);
  assert_memory_equal(one.data, two.data, one.length);
  lam_arena_free(arena);
}

/* Every allocation of the writer fails once; the sanitizers say whether anything is lost. */
static void running_out_of_memory_is_survived(void **state) {
  (void)state;
  for (volatile long n = 0;; n++) {
    lam_arena *arena = lam_arena_new();
    fixture f;
    fill(arena, &f);
    volatile bool done = false;
    jmp_buf point;
    if (LAM_ARENA_TRY(arena, point)) {
      lam_text out = {.arena = arena};
      lam_alloc_fail_after(n);
      lam_format_gltf.write(&f.model, 0, &out);
      done = true;
    }
    lam_alloc_fail_after(-1);
    lam_arena_free(arena);
    if (done) return;
    assert_true(n < 1000);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sharp_edges_are_split),
      cmocka_unit_test(gentle_edges_are_smooth),
      cmocka_unit_test(triangles_without_area_are_dropped),
      cmocka_unit_test(the_container_is_sound),
      cmocka_unit_test(the_same_model_gives_the_same_bytes),
      cmocka_unit_test(running_out_of_memory_is_survived),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
