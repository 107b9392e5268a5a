/* What the report says of bars, beams, rings and balls, and of the Gauss image: every number from
 * plane nets and prisms whose measures are known. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "design/design.h"
#include "fab/flat/path.h"
#include "fab_fixture.h"
#include "mesh/offset.h"
#include "tests/unit/asserts.h"

/* Makes a row from its text in a design. */
static void make(lam_workshop *shop, const char *kind, const char *text) {
  const lam_part_kind *row = (const lam_part_kind *)lam_registry_find(&lam_part_kinds, kind);
  assert_non_null(row);
  void *params = lam_arena_alloc(shop->arena, 1, row->head.params_size);
  assert_true(
      lam_keys_parse(shop->arena, row->head.keys, text, strlen(text), NULL, shop->errors, params));
  fixture_row(shop, row, params);
}

static void assert_told(const lam_workshop *shop, const char *stage, const char *name,
                        const char *unit, double max, double mean, long count) {
  const lam_measure *m = fixture_measure(shop, stage, name);
  assert_string_equal(m->unit, unit);
  assert_near_named(m->max, max, 1e-9 * fmax(1, fabs(max)), name);
  if (!isnan(mean)) assert_near_named(m->mean, mean, 1e-9 * fmax(1, fabs(mean)), name);
  assert_int_equal(m->count, count);
}

static void assert_fact(const lam_part *part, int k, const char *name, const char *unit,
                        double value) {
  assert_true(k < part->fact_count);
  assert_string_equal(part->facts[k].name, name);
  assert_string_equal(part->facts[k].unit, unit);
  assert_near_named(part->facts[k].value, value, 1e-12, name);
}

static const lam_part *named(const lam_workshop *shop, const char *name) {
  for (int i = 0; i < shop->part_count; i++)
    if (strcmp(shop->parts[i].name, name) == 0) return &shop->parts[i];
  fail_msg("no part %s", name);
  return NULL;
}

/* ---- bars on 2 x 2 faces of 1 m x 2 m: six edges of 1 m, six of 2 m ---- */

static lam_vec3 field(double u, double v) { return lam_v3(u, 2 * v, 0); }

static lam_workshop shop_of(void **state, int n, int m, lam_vec3 (*f)(double, double)) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), n, m, f);
  return fixture_workshop(fixture_arena(state), &mesh);
}

/* A square bar of side s that meets others at right angles on both sides ends in a ridge and
 * loses s^3/4; with one on one side only (a bar that goes on beyond it) s^3/8; at a corner of
 * two it loses on the inside what it wins outside. So the four middles of the boundary cost
 * s^3/2 each, the middle s^3. */
static void bars_are_counted_and_weighed(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, field);
  make(&shop, "bars", "{profile: square, diameter: 60 mm, gap: 0, material: oak}");
  double s = .06, cube = s * s * s, sum = 690 * (18 * s * s - 3 * cube);
  assert_int_equal(shop.part_count, 12);
  assert_told(&shop, "bars", "bar_count", LAM_UNIT_COUNT, 12, 12, 1);
  assert_told(&shop, "bars", "bar_length", "m", 2, 1.5, 12);
  assert_told(&shop, "bars", "bar_length_sum", "m", 18, 18, 12);
  assert_told(&shop, "bars", "bar_mass", "kg", 690 * (2 * s * s - cube / 8), sum / 12, 12);
  assert_told(&shop, "bars", "bar_mass_sum", "kg", sum, sum, 12);
  assert_told(&shop, "bars", "distinct_lengths", LAM_UNIT_COUNT, 2, 2, 1);
  assert_told(&shop, "bars", "unsound_bars", LAM_UNIT_COUNT, 0, 0, 1);
  assert_true(shop.stages[0].converged);
  assert_string_equal(shop.stages[0].notes[0], "bars from node to node are 1 m to 2 m long");
  for (int i = 0; i < 12; i++) {
    const lam_part *part = &shop.parts[i];
    char name[8];
    snprintf(name, sizeof name, "E%02d", i + 1);
    assert_string_equal(part->name, name);
    assert_fact(part, 0, "length", "m", part->length);
    assert_fact(part, 1, "mass", "kg", 690 * lam_trimesh_volume(&part->solid));
    assert_fact(part, 2, "diameter", "m", .06);
    assert_near(part->mass, part->facts[1].value, 0);
    assert_true(part->family == -1 && part->group == -1);
  }
  make(&shop, "bars", "{edges: inner, offset: 300 mm}");
  assert_int_equal(shop.part_count, 12 + 4);
  assert_string_equal(shop.parts[12].name, "F1");
}

/* Square bars on a plane at 0.3 m, of one family: from 0.27 to 0.33 m up, 60 mm wide, from node to
 * node less the gap of 10 mm between them. */
static void bars_lie_on_their_edges(void **state) {
  lam_workshop shop = shop_of(state, 3, 2, field);
  make(&shop, "bars",
       "{profile: square, diameter: 60 mm, gap: 10 mm, families: [0], offset: 300 mm}");
  assert_int_equal(shop.part_count, 4);
  for (int i = 0; i < 4; i++) {
    lam_vec3 min, max;
    const lam_trimesh *solid = &shop.parts[i].solid;
    lam_points_bounds(solid->vertices, solid->vertex_count, &min, &max);
    bool left = min.x < -.5, low = min.y < 0;
    assert_near(min.z, .27, 1e-9);
    assert_near(max.z, .33, 1e-9);
    assert_near(min.y, (low ? -2 : 2) - .03, 1e-9);
    assert_near(max.y, (low ? -2 : 2) + .03, 1e-9);
    assert_near(min.x, left ? -1 : .005, 1e-9);
    assert_near(max.x, left ? -.005 : 1, 1e-9);
  }
}

/* A square bar stands on the mean of the normals at its ends: where these are upright and level, it
 * stands on an edge. */
static void bars_stand_on_the_mean_normal(void **state) {
  lam_workshop shop = shop_of(state, 2, 2, field);
  lam_vec3 normals[4] = {{0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
  shop.normals = normals;
  make(&shop, "bars", "{profile: square, diameter: 60 mm, families: [0]}");
  assert_int_equal(shop.part_count, 2);
  for (int i = 0; i < 2; i++) {
    lam_vec3 min, max;
    lam_points_bounds(shop.parts[i].solid.vertices, shop.parts[i].solid.vertex_count, &min, &max);
    assert_near(max.z, .03 * sqrt(2), 1e-9);
    assert_near(min.z, -.03 * sqrt(2), 1e-9);
    assert_near(max.y - min.y, .06 * sqrt(2), 1e-9);
  }
}

/* A rim of its own diameter makes the boundary whole, whatever the families; the second material is
 * that of family 1. A tube of 60 mm with a wall of 3 mm has 1 - .9^2 of the mass, one of 100 mm
 * 1 - .94^2. */
static void rims_tubes_and_second_materials(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, field);
  make(&shop, "bars",
       "{families: [1], rim: 100 mm, diameter: 60 mm, wall: 3 mm, material: steel, second: oak}");
  assert_int_equal(shop.part_count, 8 + 2);
  int rims = 0, oaks = 0;
  for (int i = 0; i < 10; i++) {
    const lam_part *part = &shop.parts[i];
    bool rim = part->facts[2].value > .09, oak = strcmp(part->material->name, "oak") == 0;
    double share = rim ? 1 - .94 * .94 : 1 - .9 * .9;
    rims += rim;
    oaks += oak;
    assert_near(part->facts[2].value, rim ? .1 : .06, 1e-15);
    assert_near(part->mass, lam_trimesh_volume(&part->solid) * part->material->density * share,
                1e-9);
    assert_near(part->length, oak ? 2 : 1, 1e-12);
  }
  assert_int_equal(rims, 8);
  assert_int_equal(oaks, 6);
}

/* The first column is 14 mm wide, less than a quarter of 60 mm: its three edges get no bar; the
 * others of that family are 1 m and 1.0005 m long, which is one length to a millimeter. */
static lam_vec3 narrow(double u, double v) {
  return lam_v3(u < -.9 ? 0 : u < -.2 ? .014 : u < .5 ? 1.014 : 2.0145, v, 0);
}

static void short_edges_get_no_bar(void **state) {
  lam_workshop shop = shop_of(state, 4, 3, narrow);
  make(&shop, "bars", "{families: [0]}");
  assert_int_equal(shop.part_count, 6);
  assert_told(&shop, "bars", "distinct_lengths", LAM_UNIT_COUNT, 1, 1, 1);
  assert_string_equal(shop.stages[0].notes[1], "3 edges are too short for a bar");
  lam_workshop none = shop_of(state, 3, 3, field);
  make(&none, "bars", "{diameter: 2 m, rim: 0, families: [0], edges: inner}");
  assert_int_equal(none.errors->count, 0);
  lam_workshop small = shop_of(state, 4, 3, narrow);
  make(&small, "bars", "{diameter: 2 m, families: [1]}");
  assert_int_equal(small.errors->count, 0);
  make(&small, "bars", "{diameter: 60 mm, wall: 31 mm}");
  assert_string_equal(small.errors->first->text, "31 mm is more than half the diameter of 60 mm");
}

/* ---- beams on a prism of twelve sides and radius 1, three rings 1 m apart ---- */

static lam_mesh prism(lam_arena *arena, int n, double step) {
  lam_mesh mesh = lam_mesh_grid(arena, n, 3, true, false);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 3; j++)
      mesh.vertices[3 * i + j] = lam_v3(cos(2 * LAM_PI * i / n), sin(2 * LAM_PI * i / n), step * j);
  return mesh;
}

/* Beams of 0.2 m x 10 mm along the radii. Four beams meet square to each other around each axis, so
 * they end g = (1 mm + 5 mm cos 45) / sin 45 before it (three on the boundary, square too). On the
 * rings the longer side is the chord of radius 1.2, less g/cos(pi/12) at both ends. */
static void beams_are_counted_and_weighed(void **state) {
  lam_mesh mesh = prism(*state, 12, 1);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  make(&shop, "support",
       "{height: 200 mm, thickness: 10 mm, gap: 2 mm, along: normals, material: aluminum}");
  double g = (.001 + .005 * sqrt(.5)) / sqrt(.5), a = LAM_PI / 12, up = 1 - 2 * g;
  double chord = 2.4 * sin(a) - 2 * g / cos(a), area = 2.2 * sin(a) * .2 * cos(a) - 2 * g * .2;
  double sum = 2660 * .01 * (24 * .2 * up + 36 * area);
  assert_told(&shop, "support", "support_count", LAM_UNIT_COUNT, 60, 60, 1);
  assert_told(&shop, "support", "support_length", "m", up, (24 * up + 36 * chord) / 60, 60);
  assert_told(&shop, "support", "support_mass", "kg", 2660 * .01 * .2 * up, sum / 60, 60);
  assert_told(&shop, "support", "support_mass_sum", "kg", sum, sum, 60);
  assert_told(&shop, "support", "distinct_supports", LAM_UNIT_COUNT, 2, 2, 1);
  assert_told(&shop, "support", "warp", "mm", 0, 0, 60);
  assert_told(&shop, "support", "unsound_supports", LAM_UNIT_COUNT, 0, 0, 1);
  assert_int_equal(shop.stages[0].note_count, 1);
  for (int i = 0; i < 60; i++) {
    const lam_part *part = &shop.parts[i];
    const int *v = shop.net->edges[i].vertex;
    bool ring = shop.net->mesh.vertices[v[0]].z == shop.net->mesh.vertices[v[1]].z;
    char name[8];
    snprintf(name, sizeof name, "S%02d", i + 1);
    assert_string_equal(part->name, name);
    assert_int_equal(part->family, shop.net->edges[i].family);
    assert_fact(part, 0, "length", "m", ring ? chord : up);
    assert_fact(part, 1, "mass", "kg", 26.6 * (ring ? area : .2 * up));
    assert_fact(part, 2, "thickness", "m", .01);
    assert_fact(part, 3, "warp", "m", 0);
    assert_near(part->flat->thickness, .01, 1e-15);
  }
  make(&shop, "support", "{height: 200 mm, offset: 300 mm, edges: inner, along: axes}");
  assert_int_equal(shop.parts[60].name[0], 'T');
  assert_int_equal(shop.part_count, 60 + 36);
  assert_non_null(strstr(shop.stages[1].notes[0], "beams stand along the axes of cones"));
}

/* Rings 80 mm apart: between nodes that take 37 mm each nothing sensible is left (at least a tenth
 * must remain), so the 24 upright edges are too short. */
static void beams_need_room_between_nodes(void **state) {
  lam_mesh mesh = prism(*state, 12, .08);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  make(&shop, "support", "{height: 200 mm, thickness: 70 mm, gap: 2.828 mm, along: normals}");
  assert_int_equal(shop.part_count, 36);
  assert_string_equal(shop.stages[0].notes[1], "24 edges are too short for their nodes");
}

/* On z = u v / 50 the quads are nearly flat. Their warp, from both ends of an edge and the
 * directions there: |(x1 - x0) . d0 x d1| times the height, over the cross product of the
 * diagonals. */
static lam_vec3 slight(double u, double v) { return lam_v3(u, v, u * v / 50); }

static void warped_beams_are_told(void **state) {
  lam_workshop shop = shop_of(state, 3, 4, slight);
  make(&shop, "support", "{height: 200 mm, along: normals, flat: 0.1}");
  int count = shop.net->edge_count;
  const lam_vec3 *x = shop.net->mesh.vertices;
  lam_vec3 *d = LAM_NEW(shop.arena, lam_vec3, shop.net->mesh.vertex_count);
  lam_net_mirrored_normals(shop.arena, shop.net, x, d);
  double most = 0, sum = 0;
  assert_int_equal(shop.part_count, count);
  for (int e = 0; e < count; e++) {
    const int *v = shop.net->edges[e].vertex;
    lam_vec3 along = lam_sub(x[v[1]], x[v[0]]), a = lam_scale(d[v[0]], .2),
             b = lam_scale(d[v[1]], .2);
    double volume = lam_dot(along, lam_cross(a, b));
    lam_vec3 up = lam_add(along, b), down = lam_sub(a, along);
    double warp = fabs(volume) / lam_length(lam_cross(up, down));
    assert_fact(&shop.parts[e], 3, "warp", "m", warp);
    most = fmax(most, warp);
    sum += warp;
  }
  assert_true(most > 1e-5);
  assert_told(&shop, "support", "warp", "mm", most * 1e3, sum / count * 1e3, count);
}

/* ---- rings and balls on 4 x 4 unit squares ---- */

static lam_vec3 squares(double u, double v) { return lam_v3(2 * u, 2 * v, 0); }

static void rings_and_balls_are_counted(void **state) {
  lam_workshop shop = shop_of(state, 5, 5, squares);
  make(&shop, "circles",
       "{spheres: yes, width: 50 mm, gap: 2 mm, thickness: 10 mm, material: brass}");
  double polygon = 24 * sin(LAM_PI / 24), ring = polygon * (.499 * .499 - .449 * .449) * .01;
  assert_told(&shop, "circles", "ring_count", LAM_UNIT_COUNT, 16, 16, 1);
  assert_told(&shop, "circles", "ring_diameter", "m", .998, .998, 16);
  assert_told(&shop, "circles", "distinct_rings", LAM_UNIT_COUNT, 1, 1, 1);
  assert_told(&shop, "circles", "ball_count", LAM_UNIT_COUNT, 25, 25, 1);
  assert_told(&shop, "circles", "ball_diameter", "m", .998, .998, 25);
  assert_told(&shop, "circles", "distinct_balls", LAM_UNIT_COUNT, 1, 1, 1);
  assert_told(&shop, "circles", "unsound_parts", LAM_UNIT_COUNT, 0, 0, 1);
  const lam_part *part = named(&shop, "ring-001");
  assert_near(part->mass, 8440 * ring, 1e-9);
  assert_fact(part, 0, "diameter", "m", .998);
  assert_fact(part, 1, "mass", "kg", part->mass);
  assert_near(lam_path_area(&part->flat->paths[0]), polygon * .499 * .499, 1e-12);
  assert_near(lam_path_area(&part->flat->paths[1]), LAM_PI * .449 * .449, 1e-12);
  assert_near(part->flat->thickness, .01, 0);
  assert_near(part->flat->max.x, .499, 1e-15);
  assert_fact(named(&shop, "ball-001"), 0, "diameter", "m", .998);
  for (int f = 0; f < 16; f++) { /* centers of faces, axes up, x towards the first corner */
    const lam_pose *pose = &part->instances[f];
    assert_near(lam_distance(pose->origin, lam_v3(f / 4 - 1.5, f % 4 - 1.5, 0)), 0, 1e-12);
    assert_near(lam_distance(pose->axis[2], lam_v3(0, 0, 1)), 0, 1e-12);
    assert_near(lam_distance(pose->axis[0], lam_v3(-sqrt(.5), -sqrt(.5), 0)), 0, 1e-12);
    assert_near(lam_distance(pose->axis[1], lam_v3(sqrt(.5), -sqrt(.5), 0)), 0, 1e-12);
  }
  for (int v = 0; v < 25; v++)
    assert_near(
        lam_distance(named(&shop, "ball-001")->instances[v].origin, shop.net->mesh.vertices[v]), 0,
        0);
}

/* Squares of 1 m and 0.5 m: two kinds of rings; those of 0.25 m radius are too small for 0.3 m of
 * width. Circumcircles go through the corners. */
static lam_vec3 steps(double u, double v) {
  return lam_v3(u < -.5 ? -1 : u < .5 ? 0 : .5, v < 0 ? 0 : 1, 0);
}
static lam_vec3 halves(double u, double v) {
  return lam_v3(u < -.5 ? -1 : u < .5 ? 0 : .5, v < -.5 ? -1 : v < .5 ? 0 : .5, 0);
}

static void circles_of_two_sizes(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, halves); /* 1 x 1, .5 x .5, and two oblongs */
  make(&shop, "circles", "{circles: circumcircles, width: 50 mm, gap: 0}");
  assert_told(&shop, "circles", "ring_count", LAM_UNIT_COUNT, 4, 4, 1);
  assert_told(&shop, "circles", "distinct_rings", LAM_UNIT_COUNT, 3, 3, 1);
  assert_told(&shop, "circles", "ring_diameter", "m", sqrt(2),
              (sqrt(2) + sqrt(.5) + 2 * sqrt(1.25)) / 4, 4);
  assert_int_equal(shop.parts[1].instance_count, 2);
  const lam_pose *pose = &shop.parts[0].instances[0];
  assert_near(lam_distance(pose->origin, lam_v3(-.5, -.5, 0)), 0, 1e-12);
  assert_near(lam_distance(pose->axis[2], lam_v3(0, 0, 1)), 0, 1e-12);

  lam_workshop small = shop_of(state, 3, 2, steps);
  make(&small, "circles", "{circles: circumcircles, width: 600 mm, gap: 0}");
  assert_told(&small, "circles", "ring_count", LAM_UNIT_COUNT, 1, 1, 1);
  assert_string_equal(small.stages[0].notes[0], "1 circles are too small for their width");
  lam_workshop none = shop_of(state, 3, 2, steps);
  make(&none, "circles", "{circles: none}");
  make(&none, "circles", "{width: 2 m}");
  assert_int_equal(none.errors->count, 2);
  assert_string_equal(none.errors->first->key, "spheres");
  assert_string_equal(none.errors->first->next->key, "width");
}

/* ---- the Gauss image ---- */

/* A vase of two frustums with twelve sides: 24 normals, 12 faces of the image; all of its normals
 * point away from the center, also where the net is a saddle (turned over then). */
static void images_are_measured_and_face_outward(void **state) {
  enum { n = 12 };
  for (int saddle = 0; saddle < 2; saddle++) {
    static const double radius[2][3] = {{1, 2, 2.5}, {2, 1, 2}};
    lam_mesh mesh = lam_mesh_grid(*state, n, 3, true, false);
    for (int i = 0; i < n; i++)
      for (int j = 0; j < 3; j++) {
        double r = radius[saddle][j], t = 2 * LAM_PI * i / n;
        mesh.vertices[3 * i + j] = lam_v3(r * cos(t), r * sin(t), j);
      }
    lam_workshop shop = fixture_workshop(*state, &mesh);
    make(&shop, "gauss-image", "{radius: 2 m, at: [1 m, 2 m, 3 m], ball: yes, material: glass}");
    assert_int_equal(shop.errors->count, 0);
    assert_true(shop.stages[0].converged);
    assert_string_equal(shop.stages[0].notes[0],
                        "the rows that follow are made on the image: 24 vertices, 12 faces");
    assert_told(&shop, "gauss-image", "face_planarity",
                fixture_measure(&shop, "gauss-image", "face_planarity")->unit, 0, 0, n);
    assert_below(fixture_measure(&shop, "gauss-image", "circularity")->max, 1e-12);
    assert_string_equal(shop.parts[0].name, "gauss-sphere");
    assert_string_equal(shop.parts[0].material->name, "glass");
    lam_vec3 center = lam_v3(1, 2, 3);
    for (int v = 0; v < shop.parts[0].solid.vertex_count; v++)
      assert_near(lam_distance(shop.parts[0].solid.vertices[v], center), 2, 1e-12);
    for (int v = 0; v < 2 * n; v++) {
      lam_vec3 x = lam_sub(shop.net->mesh.vertices[v], center);
      assert_near(lam_distance(x, lam_scale(shop.normals[v], 2)), 0, 1e-12);
    }
    for (int f = 0; f < n; f++) {
      const int *c = shop.net->mesh.faces[f];
      const lam_vec3 *x = shop.net->mesh.vertices;
      lam_vec3 up = lam_cross(lam_sub(x[c[2]], x[c[0]]), lam_sub(x[c[3]], x[c[1]]));
      assert_true(lam_dot(up, lam_sub(x[c[0]], center)) > 0);
    }
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(bars_are_counted_and_weighed),
      TEST(bars_lie_on_their_edges),
      TEST(bars_stand_on_the_mean_normal),
      TEST(rims_tubes_and_second_materials),
      TEST(short_edges_get_no_bar),
      TEST(beams_are_counted_and_weighed),
      TEST(beams_need_room_between_nodes),
      TEST(warped_beams_are_told),
      TEST(rings_and_balls_are_counted),
      TEST(circles_of_two_sizes),
      TEST(images_are_measured_and_face_outward),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
