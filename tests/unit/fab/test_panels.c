/* Panels: gap, thickness, flat patterns, twisted faces, patterns of faces, equal plates. */
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "fab/flat/path.h"
#include "fab/parts/panel.h"

static const lam_panel_layer layer = {0, 0.02, 0.03, 1e-3}; /* 20 mm outward, 30 mm apart */

/* A roof over [-1, 1]^2 that falls by `slope` to both sides of the ridge u = 0: all faces are flat.
 */
static double slope;
static lam_vec3 roof(double u, double v) { return lam_v3(u, v, -slope * fabs(u)); }
static lam_vec3 saddle(double u, double v) { return lam_v3(u, v, 0.2 * u * v); }
static lam_vec3 flat_square(double u, double v) { return lam_v3(u, v, 0); }

static lam_panel *make_panels(lam_arena *arena, const lam_mesh *mesh, const lam_panel_layer *l) {
  lam_workshop shop = fixture_workshop(arena, mesh);
  int(*neighbor)[4] = lam_arena_alloc(arena, (size_t)mesh->face_count, sizeof *neighbor);
  lam_panel *panels = LAM_NEW(arena, lam_panel, mesh->face_count);
  lam_panel_neighbors(shop.net, neighbor);
  for (int f = 0; f < mesh->face_count; f++)
    assert_true(lam_panel_make(shop.net, (const int(*)[4])neighbor, f, l, &panels[f]));
  return panels;
}

/* The least distance between the vertices of one solid and the surface of the other: walls of
 * neighbors run along the same edge, so the shortest way between two plates ends at a corner. */
static double distance_between(const lam_trimesh *a, const lam_trimesh *b) {
  double least = INFINITY;
  for (int turn = 0; turn < 2; turn++) {
    const lam_trimesh *from = turn ? b : a, *to = turn ? a : b;
    lam_tree *tree = lam_tree_new(to, NULL);
    assert_non_null(tree);
    for (int v = 0; v < from->vertex_count; v++) {
      lam_vec3 closest;
      int triangle;
      lam_tree_closest(tree, from->vertices[v], &closest, &triangle);
      least = fmin(least, lam_distance(from->vertices[v], closest));
    }
    lam_tree_free(tree);
  }
  return least;
}

static void assert_solid(const lam_trimesh *solid) {
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold);
  assert_int_equal(facts.components, 1);
  assert_int_equal(facts.self_intersections, 0);
  assert_true(facts.volume > 0);
}

/* Over a ridge, in a plane and in a valley, outward, centered, inward and off the net: plates on
 * both sides of the fold come exactly as close as the gap of 30 mm (2 x 1 faces, the fold between
 * them). */
static void the_gap_is_the_same_at_every_fold(void **state) {
  const double slopes[] = {0.6, 0, -0.6, 0.05, -1.2}, lows[] = {0, -0.01, -0.02, 0.06, -0.09};
  for (size_t s = 0; s < sizeof slopes / sizeof *slopes; s++)
    for (size_t k = 0; k < sizeof lows / sizeof *lows; k++) {
      lam_panel_layer l = {lows[k], lows[k] + 0.02, 0.03, 1e-3};
      slope = slopes[s];
      lam_mesh mesh = fixture_grid(*state, 3, 2, roof);
      lam_panel *panels = make_panels(*state, &mesh, &l);
      lam_trimesh a = lam_panel_solid(*state, &panels[0], &l),
                  b = lam_panel_solid(*state, &panels[1], &l);
      assert_solid(&a);
      assert_solid(&b);
      assert_near(distance_between(&a, &b), 0.03, 1e-12);
    }
}

/* In a plane grid of 4 x 4 faces of 0.5 m, edges inside the net lose half the gap and edges on its
 * boundary nothing: a corner plate is 0.485 m square, one in the middle 0.47 m. Volume: area times
 * thickness. The two faces of the plate are at 0 and 20 mm. */
static void plates_are_as_thick_and_large_as_they_must_be(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
  lam_panel *panels = make_panels(*state, &mesh, &layer);
  const int faces[] = {0, 5};
  const double sides[] = {0.485, 0.47};
  for (int k = 0; k < 2; k++) {
    lam_trimesh solid = lam_panel_solid(*state, &panels[faces[k]], &layer);
    lam_vec3 min, max;
    assert_solid(&solid);
    assert_near(lam_trimesh_volume(&solid), sides[k] * sides[k] * 0.02, 1e-12);
    lam_points_bounds(solid.vertices, solid.vertex_count, &min, &max);
    assert_near(min.z, 0, 1e-12);
    assert_near(max.z, 0.02, 1e-12);
    assert_near(max.x - min.x, sides[k], 1e-12);
  }
}

/* The outline in the plane has the sides and diagonals of the panel in space, and its area times
 * the thickness is the volume of the solid; it runs counterclockwise. Marks are on LABEL and inside
 * the bounds of the outline. */
static void the_flat_pattern_is_the_plate(void **state) {
  slope = 0.7;
  lam_mesh mesh = fixture_grid(*state, 5, 4, roof);
  for (int i = 0; i < mesh.vertex_count; i++) /* no two faces alike, all flat still */
    mesh.vertices[i].y *= 1 + 0.2 * mesh.vertices[i].x;
  lam_panel *panels = make_panels(*state, &mesh, &layer);
  for (int f = 0; f < mesh.face_count; f++) {
    lam_flat *flat = lam_panel_flat(*state, &panels[f], &layer, "P07");
    const lam_path *outline = &flat->paths[0];
    assert_true(panels[f].flat);
    assert_true(outline->layer == LAM_LAYER_CUT && outline->closed && outline->count == 4);
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < i; j++) {
        lam_vec2 a = outline->points[i], b = outline->points[j];
        assert_near(hypot(a.x - b.x, a.y - b.y),
                    lam_distance(panels[f].corner[i], panels[f].corner[j]), 1e-12);
      }
    lam_trimesh solid = lam_panel_solid(*state, &panels[f], &layer);
    assert_near(lam_path_area(outline) * 0.02, lam_trimesh_volume(&solid), 1e-12);
    assert_near(flat->thickness, 0.02, 1e-15);
    assert_true(flat->path_count > 1);
    for (int i = 1; i < flat->path_count; i++)
      assert_int_equal(flat->paths[i].layer, LAM_LAYER_LABEL);
    lam_vec2 min, max;
    lam_paths_bounds(outline, 1, &min, &max);
    assert_near(flat->max.x - flat->min.x, max.x - min.x, 1e-12);
    assert_near(flat->max.y - flat->min.y, max.y - min.y, 1e-12);
  }
}

/* ---- the row ---- */
typedef struct panels_keys {
  double thickness, gap, offset, flat;
  int side, faces, material, second;
  bool second_given;
} panels_keys; /* as in gen/fab/parts/panels.c */

enum { ALL, CHECKER, BANDS_0 };

static panels_keys row_keys(int faces) {
  return (panels_keys){.thickness = 0.02, .gap = 0.03, .flat = 1e-3, .faces = faces};
}

/* z = 0.2 u v on [-1,1]^2 in 8 x 8 cells of side h = 1/4: every face is twisted, most in the
 * middle, where its diagonals (h, h, 0.2 h^2) from the origin and (-h, h, 0) from (h, 0, 0) pass at
 * 0.1 h^2 / sqrt(1 + 2 (0.1 h)^2). Panels 1 mm apart, whose boxes overlap, do not hit each other.
 */
static void twisted_faces_are_solids_without_pattern(void **state) {
  lam_mesh mesh = fixture_grid(*state, 9, 9, saddle);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  panels_keys keys = row_keys(ALL);
  keys.gap = 0.001;
  fixture_make(&shop, "panels", &keys);
  assert_int_equal(shop.part_count, 64);
  assert_near(fixture_measure(&shop, "panels", "twisted_panels")->max, 64, 0);
  assert_near(fixture_measure(&shop, "panels", "unsound_panels")->max, 0, 0);
  for (int i = 0; i < 64; i++) {
    assert_null(shop.parts[i].flat);
    assert_int_equal(shop.parts[i].congruence, 0);
    assert_solid(&shop.parts[i].solid);
  }
  assert_near(fixture_measure(&shop, "panels", "warp")->max, 6.25 / sqrt(1 + 2 * 0.025 * 0.025),
              1e-9);
  lam_workshop_clash(&shop);
  assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 0, 0);
  assert_true(fixture_measure(&shop, "clash", "pairs_checked")->max > 50);
}

/* On 4 x 4 faces: a checkerboard has 8 of a color, and no two chosen faces share an edge; bands
 * along family 0 are 4 faces long, every second one. With a second material all 16 are there. */
static void patterns_choose_faces(void **state) {
  const int expected[] = {16, 8, 8};
  for (int pattern = ALL; pattern <= BANDS_0; pattern++) {
    lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
    lam_workshop shop = fixture_workshop(*state, &mesh);
    panels_keys keys = row_keys(pattern);
    fixture_make(&shop, "panels", &keys);
    assert_int_equal(shop.part_count, expected[pattern]);
    int pairs = 0;
    for (int i = 0; i < shop.part_count; i++)
      for (int j = 0; j < i; j++) {
        int f = atoi(shop.parts[i].name + 1) - 1, g = atoi(shop.parts[j].name + 1) - 1;
        pairs += abs(f / 4 - g / 4) + abs(f % 4 - g % 4) == 1;
      }
    assert_int_equal(pairs, pattern == ALL ? 24 : pattern == CHECKER ? 0 : 6);
    keys.second_given = true;
    keys.second = 1;
    lam_workshop both = fixture_workshop(*state, &mesh);
    fixture_make(&both, "panels", &keys);
    assert_int_equal(both.part_count, 16);
    int others = 0;
    for (int i = 0; i < 16; i++) others += both.parts[i].material == &lam_materials[1];
    assert_int_equal(others, 16 - expected[pattern]);
  }
}

/* A plane grid of 4 x 4 squares has three kinds of plates: corners, sides and middles. Mass: the
 * plane square of 2 m less the gaps, 20 mm, density of the first material: (4 .485^2 + 8 .485 .47 +
 * 4 .47^2) = (2 (.485 + .47))^2 m2. */
static void equal_plates_and_mass(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  panels_keys keys = row_keys(ALL);
  fixture_make(&shop, "panels", &keys);
  assert_near(fixture_measure(&shop, "panels", "distinct_panels")->max, 3, 0);
  assert_near(fixture_measure(&shop, "panels", "panel_mass_sum")->max,
              pow(2 * (0.485 + 0.47), 2) * 0.02 * lam_materials[0].density, 1e-9);
  assert_int_equal(shop.parts[0].congruence, shop.parts[3].congruence);
  assert_int_equal(shop.parts[1].congruence,
                   shop.parts[4].congruence); /* one is the other turned */
  assert_true(shop.parts[0].congruence != shop.parts[1].congruence);
}

/* A gap wider than the faces is an error that names the key. */
static void a_gap_that_leaves_nothing_is_an_error(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, flat_square);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  panels_keys keys = row_keys(ALL);
  keys.gap = 1.2;
  fixture_make(&shop, "panels", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_string_equal(shop.errors->first->key, "gap");
  assert_int_equal(shop.part_count, 0);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(the_gap_is_the_same_at_every_fold),
      TEST(plates_are_as_thick_and_large_as_they_must_be),
      TEST(the_flat_pattern_is_the_plate),
      TEST(twisted_faces_are_solids_without_pattern),
      TEST(patterns_choose_faces),
      TEST(equal_plates_and_mass),
      TEST(a_gap_that_leaves_nothing_is_an_error),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
