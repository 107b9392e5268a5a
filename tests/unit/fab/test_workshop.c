/* The workshop: what rows add to it is kept, and solids are told sound from unsound. */
#include "fab_fixture.h"
#include "tests/unit/mesh_fixture.h"

static lam_vec3 plane(double u, double v) { return lam_v3(3 * u, 2 * v, 0); }

static lam_workshop empty_shop(void **state) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 3, 3, plane);
  return fixture_workshop(fixture_arena(state), &mesh);
}

/* Twenty of each: enough for every list to grow. What is returned is the new entry. */
static void what_is_added_is_kept_in_order(void **state) {
  lam_workshop shop = empty_shop(state);
  for (int i = 0; i < 20; i++) {
    lam_part *part = lam_workshop_part(&shop, (lam_part){.name = "P", .mass = i});
    assert_near(part->mass, i, 0);
    lam_workshop_crossing(&shop, (lam_crossing){.angle = i});
    lam_workshop_record_kind(&shop, (lam_record_kind){.column_count = i});
    lam_workshop_surface(&shop, (lam_spline_surface){.degree = {i, 1}});
    assert_string_equal(lam_workshop_stage(&shop, "test")->name, "test");
  }
  assert_int_equal(shop.part_count, 20);
  assert_int_equal(shop.crossing_count, 20);
  assert_int_equal(shop.record_kind_count, 20);
  assert_int_equal(shop.surface_count, 20);
  assert_int_equal(shop.stage_count, 20);
  for (int i = 0; i < 20; i++) {
    assert_near(shop.parts[i].mass, i, 0);
    assert_near(shop.crossings[i].angle, i, 0);
    assert_int_equal(shop.record_kinds[i].column_count, i);
    assert_int_equal(shop.surfaces[i].degree[0], i);
    assert_true(shop.stages[i].converged);
  }
}

static void classes_go_on_after_the_largest(void **state) {
  lam_workshop shop = empty_shop(state);
  assert_int_equal(lam_workshop_next_class(&shop), 1);
  static const int given[] = {0, 2, 7, 3};
  static const int next[] = {1, 3, 8, 8};
  for (int i = 0; i < 4; i++) {
    lam_workshop_part(&shop, (lam_part){.congruence = given[i]});
    assert_int_equal(lam_workshop_next_class(&shop), next[i]);
  }
}

/* The curve runs from the first vertex of the line to its last, with its family; a line whose
 * vertices coincide adds nothing. */
static void lines_become_curves(void **state) {
  lam_workshop shop = empty_shop(state);
  int along[3] = {1, 4, 7}, still[2] = {4, 4};
  lam_workshop_curve(&shop, "A02", &(lam_polyline){1, false, 3, along});
  lam_workshop_curve(&shop, "A03", &(lam_polyline){0, false, 2, still});
  assert_int_equal(shop.curve_count, 1);
  const lam_named_curve *curve = &shop.curves[0];
  assert_string_equal(curve->name, "A02");
  assert_int_equal(curve->family, 1);
  const lam_vec3 *points = curve->spline.points;
  assert_near(lam_distance(points[0], lam_v3(-3, 0, 0)), 0, 1e-14);
  assert_near(lam_distance(points[curve->spline.count - 1], lam_v3(3, 0, 0)), 0, 1e-14);
}

static void facts_are_copied(void **state) {
  lam_part part = {.fact_count = 7};
  lam_fact facts[] = {{"length", "m", 3.5}, {"mass", "kg", 0.25}};
  lam_part_set_facts(fixture_arena(state), &part, facts, 2);
  facts[1].value = 9;
  assert_int_equal(part.fact_count, 2);
  assert_string_equal(part.facts[0].name, "length");
  assert_string_equal(part.facts[1].unit, "kg");
  assert_near(part.facts[0].value, 3.5, 0);
  assert_near(part.facts[1].value, 0.25, 0);
}

static bool sound(void **state, lam_trimesh solid) {
  lam_part part = {.solid = solid};
  return lam_part_is_sound(fixture_arena(state), &part);
}

/* A cube and a torus are sound. Not sound: turned inside out, with a triangle missing, with one
 * turned over, two cubes, and two cubes that share a vertex (one piece to look at, but two fans of
 * triangles at it). */
static void sound_solids_are_closed_outward_and_of_one_piece(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_trimesh cube = mesh_cube(arena, 0, 0, 0, 1);
  assert_true(sound(state, cube));
  assert_true(sound(state, mesh_torus(arena, 2, 0.5, 12, 8)));
  assert_false(sound(state, mesh_inverted(arena, &cube)));

  lam_trimesh open = cube;
  open.triangle_count--;
  assert_false(sound(state, open));

  lam_trimesh far = mesh_cube(arena, 3, 0, 0, 1), corner = mesh_cube(arena, 1, 1, 1, 1);
  assert_false(sound(state, mesh_pair(arena, &cube, &far)));
  assert_false(sound(state, mesh_pair(arena, &cube, &corner)));

  int *t = cube.triangles[5], keep = t[0];
  t[0] = t[1], t[1] = keep;
  assert_false(sound(state, cube));
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(what_is_added_is_kept_in_order),
      TEST(classes_go_on_after_the_largest),
      TEST(lines_become_curves),
      TEST(facts_are_copied),
      TEST(sound_solids_are_closed_outward_and_of_one_piece),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
