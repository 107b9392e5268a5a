/* The part kind `flat-pattern`: a sheet on a cylinder, whose development is a rectangle. */
#include "core/numbers.h"
#include "fab_fixture.h"

#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "design/design.h"
#include "fab/flat/path.h"

/* 1.2 x 2 m on a cylinder of radius 1 m about the y axis. */
static lam_vec3 cylinder(double u, double v) { return lam_v3(sin(0.6 * u), v, cos(0.6 * u)); }

static void add(lam_workshop *shop, const char *text) {
  const lam_row_head *head = lam_registry_find(&lam_part_kinds, "flat-pattern");
  assert_non_null(head);
  void *params = lam_arena_alloc(shop->arena, 1, head->params_size);
  assert_true(
      lam_keys_parse(shop->arena, head->keys, text, strlen(text), NULL, shop->errors, params));
  ((const lam_part_kind *)head)->make(shop, params, (lam_location){0});
}

static int count_layer(const lam_flat *flat, lam_layer layer) {
  int count = 0;
  for (int i = 0; i < flat->path_count; i++) count += flat->paths[i].layer == layer;
  return count;
}

/* The outline is the rectangle 1.2 x 2 m; chords alone would make it 1.2 (h^2 / 24) = 110 um too
 * short at h = .047. Normals of the outermost vertices are estimated from one side, which costs 20
 * um. */
static void a_cylinder_becomes_a_rectangle(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_mesh mesh = fixture_grid(arena, 25, 33, cylinder);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  add(&shop, "{thickness: 4 mm, marks: 3, material: steel}");
  assert_int_equal(shop.errors->count, 0);
  assert_int_equal(shop.part_count, 1);
  const lam_part *part = &shop.parts[0];
  const lam_flat *flat = part->flat;
  double width = flat->max.x - flat->min.x, height = flat->max.y - flat->min.y;
  if (fabs(width - 2) > 1e-5 || fabs(height - 1.2) > 2e-5) fail_msg("%.7f x %.7f m", width, height);
  assert_true(flat->paths[0].layer == LAM_LAYER_CUT && flat->paths[0].closed &&
              !flat->paths[0].hole);
  assert_true(fabs(lam_path_area(&flat->paths[0]) - 2.4) < 5e-5);
  assert_int_equal(count_layer(flat, LAM_LAYER_CUT), 1);
  assert_int_equal(count_layer(flat, LAM_LAYER_ENGRAVE), 6);
  assert_true(count_layer(flat, LAM_LAYER_LABEL) > 0);
  assert_true(fabs(flat->thickness - 0.004) < 1e-15);
  assert_true(lam_part_is_sound(arena, part));
  /* The solid stands on chords: 2.4 m2 (1 - h^2/24) x 4 mm. */
  assert_true(fabs(lam_trimesh_volume(&part->solid) / (2.4 * 0.004) - 1) < 5e-4);
  assert_true(fabs(part->mass - 2.4 * 0.004 * part->material->density) < 1e-3 * part->mass);
  const lam_stage *stage = &shop.stages[shop.stage_count - 1];
  assert_true(stage->converged);
  for (int i = 0; i < stage->measure_count; i++) {
    if (!strcmp(stage->measures[i].name, "flattening_strain"))
      assert_true(stage->measures[i].max < 1e-4);
    if (!strcmp(stage->measures[i].name, "bending_strain")) /* t / 2r */
      assert_true(fabs(stage->measures[i].max - 0.002) < 5e-5);
  }
  lam_arena_free(arena);
}

/* What is drawn beside the outline lies inside of it. */
static void marks_and_name_lie_on_the_sheet(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_mesh mesh = fixture_grid(arena, 9, 9, cylinder);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  add(&shop, "{marks: 20}");
  add(&shop, "{marks: 0}");
  assert_int_equal(shop.part_count, 2);
  assert_string_equal(shop.parts[1].name, "F2");
  assert_int_equal(count_layer(shop.parts[0].flat, LAM_LAYER_ENGRAVE), 14); /* all lines inside */
  assert_int_equal(count_layer(shop.parts[1].flat, LAM_LAYER_ENGRAVE), 0);
  for (int p = 0; p < 2; p++) {
    const lam_flat *flat = shop.parts[p].flat;
    const lam_path *cut = &flat->paths[0];
    lam_vec2 low, high;
    lam_paths_bounds(cut, 1, &low, &high);
    for (int i = 1; i < flat->path_count; i++)
      for (int k = 0; k < flat->paths[i].count; k++) {
        lam_vec2 x = flat->paths[i].points[k];
        assert_true(x.x > low.x - 1e-9 && x.x < high.x + 1e-9 && x.y > low.y - 1e-9 &&
                    x.y < high.y + 1e-9);
      }
  }
  lam_arena_free(arena);
}

/* The tangents of the helix (cos a, sin a, a/2), from .3 to .7 m along them: a ramp whose pattern
 * is part of a ring. Per turn the ring is run through by 2 pi / sqrt(1.25), .89 turns: two turns of
 * ramp lie on each other when laid flat, with no triangle turned over. */
static double turns;
static lam_vec3 ramp(double u, double v) {
  double a = LAM_PI * turns * u, t = 0.5 - 0.2 * v;
  return lam_v3(cos(a) - t * sin(a), sin(a) + t * cos(a), (a + t) / 2);
}

static void patterns_that_lie_on_themselves_are_reported(void **state) {
  (void)state;
  for (int k = 0; k < 2; k++) {
    lam_arena *arena = lam_arena_new();
    turns = k ? 2 : 1;
    lam_mesh mesh = fixture_grid(arena, 61, 4, ramp);
    lam_workshop shop = fixture_workshop(arena, &mesh);
    add(&shop, "{thickness: 2 mm}");
    assert_int_equal(shop.part_count, 1);
    const lam_stage *stage = &shop.stages[shop.stage_count - 1];
    if (stage->converged != !k) fail_msg("%d: %s", k, stage->reason);
    if (k) assert_string_equal(stage->reason, "the pattern overlaps itself");
    for (int i = 0; i < stage->measure_count; i++) {
      if (!strcmp(stage->measures[i].name, "outline_crossings"))
        assert_true((stage->measures[i].max > 0) == k);
      if (!strcmp(stage->measures[i].name, "turned_triangles"))
        assert_true(stage->measures[i].max == 0);
    }
    lam_arena_free(arena);
  }
}

static lam_vec3 saddle(double u, double v) { return lam_v3(u, v, 0.5 * u * v); }

static void what_cannot_lie_flat_is_refused(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_mesh bent = fixture_grid(arena, 9, 9, saddle);
  lam_workshop shop = fixture_workshop(arena, &bent);
  add(&shop, "{strain: 0.001}");
  assert_int_equal(shop.errors->count, 1);
  assert_non_null(strstr(shop.errors->first->text, "strains it by"));
  lam_mesh ring = lam_mesh_grid(arena, 12, 4, true, false);
  for (int i = 0; i < 12; i++)
    for (int j = 0; j < 4; j++)
      ring.vertices[i * 4 + j] = lam_v3(cos(LAM_PI * i / 6), sin(LAM_PI * i / 6), j);
  lam_workshop round = fixture_workshop(arena, &ring);
  add(&round, "{}");
  assert_int_equal(round.part_count, 0);
  assert_non_null(strstr(round.errors->first->text, "no disk"));
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(a_cylinder_becomes_a_rectangle),
                                     cmocka_unit_test(patterns_that_lie_on_themselves_are_reported),
                                     cmocka_unit_test(marks_and_name_lie_on_the_sheet),
                                     cmocka_unit_test(what_cannot_lie_flat_is_refused)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
