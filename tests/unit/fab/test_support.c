/* Beams between a net and its offset, rings and balls on the circles of a net, its Gauss image:
 * sizes in closed form, no overlap. */
#include "core/numbers.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

#include "core/solid/solid.h"
#include "design/design.h"
#include "fab/flat/path.h"

static void make(lam_workshop *shop, const char *kind, const char *text) {
  const lam_part_kind *row = (const lam_part_kind *)lam_registry_find(&lam_part_kinds, kind);
  assert_non_null(row);
  void *params = lam_arena_alloc(shop->arena, 1, row->head.params_size);
  lam_keys_parse(shop->arena, row->head.keys, text, strlen(text), NULL, shop->errors, params);
  fixture_row(shop, row, params);
}

/* A prism of n sides and radius 1, three rings 1 apart. */
static lam_mesh prism(lam_arena *arena, int n) {
  lam_mesh mesh = lam_mesh_grid(arena, n, 3, true, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 3; j++)
      mesh.vertices[3 * i + j] = lam_v3(cos(2 * LAM_PI * i / n), sin(2 * LAM_PI * i / n), j);
  return mesh;
}

static double volume_of(const lam_workshop *shop, int part) {
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(&shop->parts[part].solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.self_intersections == 0);
  return facts.volume;
}

/* Twelve sides, beams .2 high and .01 thick along mirrored normals (radial): every plate is a quad
 * between two radii. Around the axis the angles to neighbors are 90 degrees where four beams meet,
 * and the setback is (gap/2 + t/2 cos 45) / sin 45. A vertical beam is 1 less two setbacks long, so
 * its volume is known; a beam of the ring is an isosceles trapezoid between chords of radius 1
 * and 1.2, with ends parallel to the radii, and the volume is that of the trapezoid less two
 * strips. */
static void beams_on_a_prism(void **state) {
  lam_arena *arena = fixture_arena(state);
  enum { n = 12 };
  lam_mesh mesh = prism(arena, n);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "support",
       "{height: 200 mm, thickness: 10 mm, gap: 2 mm, along: normals, material: steel}");
  assert_int_equal(shop.errors->count, 0);
  assert_int_equal(shop.part_count, shop.net->edge_count);
  double g = (.001 + .005 * cos(LAM_PI / 4)) / sin(LAM_PI / 4), low = 2 * sin(LAM_PI / n),
         high = 1.2 * low;
  double chord = .01 * ((low + high) / 2 * .2 * cos(LAM_PI / n) - 2 * g * .2);
  for (int i = 0; i < shop.part_count; i++) {
    const lam_edge *edge = &shop.net->edges[i];
    bool ring =
        shop.net->mesh.vertices[edge->vertex[0]].z == shop.net->mesh.vertices[edge->vertex[1]].z;
    assert_near(volume_of(&shop, i), ring ? chord : .01 * .2 * (1 - 2 * g), 1e-12);
    assert_near(lam_path_area(&shop.parts[i].flat->paths[0]) * .01, volume_of(&shop, i), 1e-12);
  }
  /* two shapes: vertical beams, and beams of the rings */
  assert_near(fixture_measure(&shop, "support", "distinct_supports")->max, 2, 0);
  assert_true(fixture_measure(&shop, "support", "warp")->max < 1e-11);
  lam_workshop_clash(&shop);
  assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 0, 0);
  assert_true(fixture_measure(&shop, "clash", "pairs_checked")->max > n);
}

/* Along axes the upper layer has its faces .2 further out: its corners are .2 / cos(pi / n) away.
 */
static void axes_keep_the_distance_of_faces(void **state) {
  lam_arena *arena = fixture_arena(state);
  enum { n = 12 };
  lam_mesh mesh = prism(arena, n);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "support", "{height: 200 mm, along: axes, gap: 0.2 mm, thickness: 1 mm}");
  assert_int_equal(shop.part_count, shop.net->edge_count);
  double radius = 0;
  for (int i = 0; i < shop.part_count; i++)
    for (int v = 0; v < shop.parts[i].solid.vertex_count; v++)
      radius =
          fmax(radius, hypot(shop.parts[i].solid.vertices[v].x, shop.parts[i].solid.vertices[v].y));
  assert_near(radius, 1 + .2 / cos(LAM_PI / n),
              1e-3); /* corners stop a millimeter before the axis */
  /* `auto` takes normals here: both are flat */
  lam_workshop other = fixture_workshop(arena, &mesh);
  make(&other, "support", "{height: 200 mm}");
  assert_non_null(strstr(other.stages[0].notes[0], "mirrored normals"));
}

static lam_vec3 twisted(double u, double v) { return lam_v3(u, v, u * v); }

/* Asymptotic lines have no such beams: the offset twists against the net along them. */
static void other_nets_are_refused(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_mesh mesh = fixture_grid(arena, 6, 6, twisted);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "support", "{height: 200 mm}");
  assert_int_equal(shop.errors->count, 1);
  assert_non_null(strstr(shop.errors->first->text, "no edge has a flat beam"));
  assert_int_equal(shop.part_count, 0);
}

static lam_vec3 plane(double u, double v) { return lam_v3(2 * u, 2 * v, 0); }

/* Unit squares: incircles of radius 1/2, spheres of radius 1/2, circumcircles of radius sqrt(1/2);
 * each one part with as many instances as there are faces or vertices. */
static void rings_and_balls_on_squares(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_mesh mesh = fixture_grid(arena, 5, 5, plane);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "circles", "{width: 50 mm, gap: 2 mm, thickness: 10 mm}");
  make(&shop, "circles", "{circles: none, spheres: yes, gap: 2 mm}");
  make(&shop, "circles", "{circles: circumcircles, width: 50 mm, gap: 0}");
  assert_int_equal(shop.part_count, 3);
  static const double outer[3] = {.499, .499, .70710678118654752};
  static const int count[3] = {16, 25, 16};
  double polygon = 48 / 2. * sin(2 * LAM_PI / 48);
  for (int i = 0; i < 3; i++) {
    const lam_part *part = &shop.parts[i];
    double reach = 0, inner = outer[i] - .05;
    assert_int_equal(part->instance_count, count[i]);
    for (int v = 0; v < part->solid.vertex_count; v++)
      reach = fmax(reach, lam_length(part->solid.vertices[v]));
    assert_near(reach, i == 1 ? outer[i] : hypot(outer[i], .005), 1e-14);
    double volume = volume_of(&shop, i);
    if (i == 1)
      assert_near(volume, 4 * LAM_PI / 3 * pow(outer[i], 3), .02);
    else
      assert_near(volume, polygon * (outer[i] * outer[i] - inner * inner) * .01, 1e-12);
    assert_int_equal(part->flat != NULL, i != 1);
    for (int k = 0; k < count[i]; k++) { /* in the middle of a face, or at a vertex */
      double at = part->instances[k].origin.x;
      assert_near(fabs(at - floor(at)), i == 1 ? 0 : .5, 1e-14);
      assert_near(part->instances[k].axis[2].z, 1, 1e-15);
    }
  }
}

static void rings_that_touch_do_not_overlap(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_mesh mesh = fixture_grid(arena, 5, 5, plane);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "circles", "{gap: 0}");
  lam_workshop_clash(&shop);
  assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 0, 0);
  make(&shop, "circles", "{width: 2 m}");
  assert_int_equal(shop.errors->count, 1);
  make(&shop, "circles", "{circles: none}");
  assert_int_equal(shop.errors->count, 2);
}

/* Circumcircles of unit squares cross: a clash when they are made, none when they are drawn; names
 * go on counting. */
static void drawn_rings_may_cross(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_mesh mesh = fixture_grid(arena, 3, 3, plane);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "circles", "{circles: circumcircles, gap: 0, drawn: yes}");
  assert_null(shop.parts[0].flat);
  lam_workshop_clash(&shop);
  assert_int_equal(shop.stage_count, 1); /* nothing to check */
  make(&shop, "circles", "{circles: circumcircles, gap: 0}");
  assert_string_equal(shop.parts[0].name, "ring-001");
  assert_string_equal(shop.parts[1].name, "ring-002");
  lam_workshop_clash(&shop);
  assert_true(fixture_measure(&shop, "clash", "clash_count")->max > 0);
  assert_near(fixture_measure(&shop, "clash", "pairs_checked")->max, 6,
              0); /* of the four rings that are made */
}

/* Two frustums of n-sided pyramids, one on the other: the normals of either lie on a circle of
 * latitude of the sphere, and the image is a belt of n trapezoids between both circles. */
static void gauss_image_of_a_faceted_vase(void **state) {
  lam_arena *arena = fixture_arena(state);
  enum { n = 12 };
  static const double radius[3] = {1, 2, 2.5};
  lam_mesh mesh = lam_mesh_grid(arena, n, 3, true, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 3; j++)
      mesh.vertices[3 * i + j] =
          lam_v3(radius[j] * cos(2 * LAM_PI * i / n), radius[j] * sin(2 * LAM_PI * i / n), j);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "gauss-image", "{radius: 2 m, at: [0, 0, 5 m], ball: yes}");
  assert_int_equal(shop.errors->count, 0);
  assert_int_equal(shop.net->mesh.vertex_count, 2 * n);
  assert_int_equal(shop.net->mesh.face_count, n);
  assert_true(fixture_measure(&shop, "gauss-image", "circularity")->max < 1e-12);
  assert_true(shop.part_count == 1 && shop.parts[0].drawn);
  /* the slope of a face: its rise is 1 for (r1 - r0) cos(pi / n) of run; outward normals point down
   * by that angle */
  for (int v = 0; v < 2 * n; v++) {
    lam_vec3 x = shop.net->mesh.vertices[v];
    double low = -2 * sin(atan(1. * cos(LAM_PI / n))), high = -2 * sin(atan(.5 * cos(LAM_PI / n))),
           z = x.z - 5;
    assert_near(lam_length(lam_v3(x.x, x.y, z)), 2, 1e-14);
    assert_near(fmin(fabs(z - low), fabs(z - high)), 0, 1e-13);
    assert_near(lam_length(shop.normals[v]), 1, 1e-14);
  }
  make(&shop, "panels", "{gap: 1 mm}"); /* on the image from now on */
  assert_int_equal(shop.part_count, 1 + n);
}

static void gauss_image_needs_inner_vertices(void **state) {
  lam_arena *arena = fixture_arena(state);
  lam_mesh mesh = fixture_grid(arena, 2, 4, plane);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  make(&shop, "gauss-image", "{}");
  assert_int_equal(shop.errors->count, 1);
  assert_non_null(strstr(shop.errors->first->text, "no inner vertex"));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(beams_on_a_prism, fixture_setup, fixture_teardown),
      cmocka_unit_test_setup_teardown(axes_keep_the_distance_of_faces, fixture_setup,
                                      fixture_teardown),
      cmocka_unit_test_setup_teardown(other_nets_are_refused, fixture_setup, fixture_teardown),
      cmocka_unit_test_setup_teardown(rings_and_balls_on_squares, fixture_setup, fixture_teardown),
      cmocka_unit_test_setup_teardown(rings_that_touch_do_not_overlap, fixture_setup,
                                      fixture_teardown),
      cmocka_unit_test_setup_teardown(drawn_rings_may_cross, fixture_setup, fixture_teardown),
      cmocka_unit_test_setup_teardown(gauss_image_of_a_faceted_vase, fixture_setup,
                                      fixture_teardown),
      cmocka_unit_test_setup_teardown(gauss_image_needs_inner_vertices, fixture_setup,
                                      fixture_teardown),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
