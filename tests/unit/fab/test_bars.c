/* Bars: sections, miters, mass, names; and convex solids cut by planes. */
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

#include "core/solid/convex.h"
#include "core/solid/solid.h"
#include "core/solid/triangles.h"

static void assert_solid(const lam_trimesh *solid) {
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold);
  assert_int_equal(facts.components, 1);
  assert_int_equal(facts.self_intersections, 0);
}

/* ---- cutting ---- */

static lam_convex unit_cube(lam_arena *arena) {
  const lam_vec3 square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  return lam_convex_prism(arena, square, 4, lam_v3(0, 0, 1), 1e-9);
}

/* The unit cube cut by x + y + z >= c: what is cut off is a corner tetrahedron of volume c^3/6 for
 * c <= 1; at c = 1 the plane runs through three corners, at c = 3/2 it halves the cube (a hexagon),
 * at c = 3 nothing is left. */
static void a_cube_loses_its_corner(void **state) {
  const double offsets[] = {-1, 0, 0.5, 1, 1.5, 2, 2.5},
               volumes[] = {1, 1, 1 - 0.125 / 6, 5. / 6, 0.5, 1. / 6, 0.125 / 6};
  lam_vec3 normal = lam_unit(lam_v3(1, 1, 1));
  for (int i = 0; i < 7; i++) {
    lam_convex cube = unit_cube(*state);
    lam_convex_cut(&cube, lam_v3(offsets[i], 0, 0), normal);
    lam_trimesh mesh = lam_convex_mesh(*state, &cube);
    assert_solid(&mesh);
    assert_near(lam_trimesh_volume(&mesh), volumes[i], 1e-12);
  }
  lam_convex cube = unit_cube(*state);
  lam_convex_cut(&cube, lam_v3(3.1, 0, 0), normal);
  assert_int_equal(lam_convex_mesh(*state, &cube).triangle_count, 0);
}

/* Planes through the middle m of the cube keep x >= m, y >= m, z >= m (an eighth), of that x >= y
 * (half) and y >= z (a sixth of the eighth); x + y - z >= m takes nothing more away. Every step
 * stays closed. */
static void cuts_follow_one_another(void **state) {
  lam_convex cube = unit_cube(*state);
  const lam_vec3 normals[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, -1, 0}, {0, 1, -1}, {1, 1, -1}};
  const double volumes[] = {1. / 2, 1. / 4, 1. / 8, 1. / 16, 1. / 48, 1. / 48};
  for (int i = 0; i < 6; i++) {
    lam_convex_cut(&cube, lam_v3(0.5, 0.5, 0.5), lam_unit(normals[i]));
    lam_trimesh mesh = lam_convex_mesh(*state, &cube);
    assert_solid(&mesh);
    assert_near(lam_trimesh_volume(&mesh), volumes[i], 1e-12);
  }
}

/* ---- the row ---- */
typedef struct bars_keys {
  lam_list families;
  double diameter, rim, wall, gap, offset;
  int profile, edges, material, second;
  bool second_given;
} bars_keys; /* as in gen/fab/parts/bars.c */

static int both[2] = {0, 1};
static bars_keys row_keys(void) {
  return (bars_keys){.families = {2, both}, .diameter = 0.06, .gap = 0.0002};
}

static lam_vec3 flat_square(double u, double v) { return lam_v3(u, v, 0); }
static lam_vec3 dome(double u, double v) {
  return lam_v3(2 * u, 2 * v, 1 - 0.4 * u * u - 0.3 * v * v + 0.2 * u * v);
}

/* Bars of one family only, in a plane: lines of 4 bars of 0.5 m. Bars meet end to end, half the gap
 * short of the node; at the ends of a line they end at the node. The section has the area of the
 * circle, or of the square. */
static void bars_end_at_their_nodes(void **state) {
  const double areas[] = {3.14159265358979324 * 0.03 * 0.03, 0.06 * 0.06};
  for (int profile = 0; profile < 2; profile++) {
    lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    bars_keys keys = row_keys();
    keys.families.count = 1;
    keys.profile = profile;
    keys.gap = 0.01;
    fixture_make(&shop, "bars", &keys);
    assert_int_equal(shop.part_count, 20);
    double least = INFINITY, most = 0;
    for (int i = 0; i < 20; i++) {
      double length = lam_trimesh_volume(&shop.parts[i].solid) / areas[profile];
      assert_solid(&shop.parts[i].solid);
      assert_near(shop.parts[i].length, 0.5, 1e-12);
      least = fmin(least, length);
      most = fmax(most, length);
    }
    assert_near(least, 0.49, 1e-9);
    assert_near(most, 0.495, 1e-9);
  }
}

/* A square bar of side s between two others at right angles to it is cut by two planes at 45
 * degrees: it ends in a ridge at the node and loses s/4 of its length at either end. Without a gap
 * its volume is s^2 (L - s/2). */
static void a_miter_at_right_angles(void **state) {
  lam_mesh mesh = fixture_grid(*state, 6, 6, flat_square);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  bars_keys keys = row_keys();
  keys.profile = 1;
  keys.gap = 0;
  fixture_make(&shop, "bars", &keys);
  assert_int_equal(shop.part_count, 60);
  int inside = 0;
  for (int i = 0; i < 60; i++)
    inside += fabs(lam_trimesh_volume(&shop.parts[i].solid) - 0.0036 * (0.4 - 0.03)) < 1e-12;
  assert_int_equal(inside,
                   40); /* all but the 20 on the boundary have a bar on either side at both ends */
}

/* On a dome with a stronger rim no two bars overlap, all are sound, and there are as many as edges.
 */
static void no_two_bars_overlap(void **state) {
  for (int profile = 0; profile < 2; profile++) {
    lam_mesh mesh = fixture_grid(*state, 8, 7, dome);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    bars_keys keys = row_keys();
    keys.profile = profile;
    keys.rim = 0.1;
    fixture_make(&shop, "bars", &keys);
    assert_int_equal(shop.part_count, 7 * 7 + 8 * 6);
    for (int i = 0; i < shop.part_count; i++) assert_solid(&shop.parts[i].solid);
    lam_workshop_clash(&shop);
    assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 0, 0);
    assert_true(fixture_measure(&shop, "clash", "pairs_checked")->max > 200);
    assert_near(fixture_measure(&shop, "bars", "unsound_bars")->max, 0, 0);
  }
}

/* Edges of a 4 x 4 grid: 40, of them 16 on the boundary. In the plane all are equally long. A tube
 * of 60 mm with a wall of 5 mm has 1 - (50/60)^2 of the mass of the full bar. */
static void choices_and_mass(void **state) {
  const int expected[] = {40, 24, 16};
  for (int edges = 0; edges < 3; edges++) {
    double mass[2];
    for (int tube = 0; tube < 2; tube++) {
      lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
      lam_workshop shop = fixture_workshop(*state, &mesh);
      bars_keys keys = row_keys();
      keys.edges = edges;
      keys.wall = tube ? 0.005 : 0;
      fixture_make(&shop, "bars", &keys);
      assert_int_equal(shop.part_count, expected[edges]);
      assert_near(fixture_measure(&shop, "bars", "distinct_lengths")->max, 1, 0);
      mass[tube] = fixture_measure(&shop, "bars", "bar_mass_sum")->max;
    }
    assert_near(mass[1] / mass[0], 1 - 25. / 36, 1e-12);
  }
}

static void a_wall_thicker_than_the_bar_is_an_error(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  bars_keys keys = row_keys();
  keys.wall = 0.05;
  fixture_row(&shop, (const lam_part_kind *)lam_registry_find(&lam_part_kinds, "bars"), &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_string_equal(shop.errors->first->key, "wall");
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(a_cube_loses_its_corner),
      TEST(cuts_follow_one_another),
      TEST(bars_end_at_their_nodes),
      TEST(a_miter_at_right_angles),
      TEST(no_two_bars_overlap),
      TEST(choices_and_mass),
      TEST(a_wall_thicker_than_the_bar_is_an_error),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
