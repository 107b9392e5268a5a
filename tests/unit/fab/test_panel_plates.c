/* Plates on faces: what the report says of them, their outlines and names, which are equal; and
 * the pattern of a whole net as one sheet. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "design/design.h"
#include "fab/flat/lettering.h"
#include "fab/flat/path.h"
#include "fab/parts/panel.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

static void make(lam_workshop *shop, const char *kind, const char *text) {
  const lam_part_kind *row = (const lam_part_kind *)lam_registry_find(&lam_part_kinds, kind);
  assert_non_null(row);
  void *params = lam_arena_alloc(shop->arena, 1, row->head.params_size);
  assert_true(
      lam_keys_parse(shop->arena, row->head.keys, text, strlen(text), NULL, shop->errors, params));
  row->make(shop, params, (lam_location){"test", 1, 1});
}

static lam_workshop shop_of(void **state, int n, int m, lam_vec3 (*f)(double, double)) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), n, m, f);
  return fixture_workshop(fixture_arena(state), &mesh);
}

static void assert_told(const lam_workshop *shop, const char *stage, const char *name,
                        const char *unit, double max, double mean, long count) {
  const lam_measure *m = fixture_measure(shop, stage, name);
  assert_string_equal(m->unit, unit);
  assert_near_named(m->max, max, 1e-9 * fmax(1, fabs(max)), name);
  assert_near_named(m->mean, mean, 1e-9 * fmax(1, fabs(mean)), name);
  assert_int_equal(m->count, count);
}

static void assert_fact(const lam_part *part, int k, const char *name, const char *unit,
                        double value) {
  assert_string_equal(part->facts[k].name, name);
  assert_string_equal(part->facts[k].unit, unit);
  assert_near_named(part->facts[k].value, value, 1e-12, name);
}

/* ---- the row `panels` on 2 x 2 faces: columns of 1 m and 0.5 m, rows of 2 m and 1 m ---- */

static lam_vec3 field(double u, double v) {
  return lam_v3(u < -.5 ? -1 : u < .5 ? 0 : .5, v < -.5 ? -2 : v < .5 ? 0 : 1, 0);
}

/* Two sides of every plate lie on the boundary, and the other two 10 mm inside of the edges. */
static void panels_are_counted_and_weighed(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, field);
  make(&shop, "panels", "{thickness: 20 mm, gap: 20 mm, material: glass}");
  static const double width[] = {.99, .99, .49, .49}, height[] = {1.99, .99, 1.99, .99};
  double area = (.99 + .49) * (1.99 + .99), mass = 2500 * .02 * area, diagonal = 0;
  assert_int_equal(shop.part_count, 4);
  for (int i = 0; i < 4; i++) {
    const lam_part *part = &shop.parts[i];
    double w = width[i], h = height[i];
    char name[4];
    snprintf(name, sizeof name, "P%d", i + 1);
    diagonal += hypot(w, h) / 4;
    assert_string_equal(part->name, name);
    assert_int_equal(part->congruence, i + 1);
    assert_near(part->mass, 50 * w * h, 1e-10);
    assert_fact(part, 0, "mass", "kg", part->mass);
    assert_fact(part, 1, "area", "m2", w * h);
    assert_fact(part, 2, "side 1", "m", w);
    assert_fact(part, 3, "side 2", "m", h);
    assert_fact(part, 4, "side 3", "m", w);
    assert_fact(part, 5, "side 4", "m", h);
    assert_fact(part, 6, "warp", "m", 0);
    assert_true(part->family == -1 && part->group == -1);
  }
  assert_told(&shop, "panels", "panel_count", LAM_UNIT_COUNT, 4, 4, 1);
  assert_told(&shop, "panels", "panel_area", "m2", .99 * 1.99, area / 4, 4);
  assert_told(&shop, "panels", "panel_diagonal", "m", hypot(.99, 1.99), diagonal, 4);
  assert_told(&shop, "panels", "panel_mass", "kg", 50 * .99 * 1.99, mass / 4, 4);
  assert_told(&shop, "panels", "panel_mass_sum", "kg", mass, mass, 4);
  assert_told(&shop, "panels", "warp", "mm", 0, 0, 4);
  assert_told(&shop, "panels", "twisted_panels", LAM_UNIT_COUNT, 0, 0, 1);
  assert_told(&shop, "panels", "distinct_panels", LAM_UNIT_COUNT, 4, 4, 1);
  assert_told(&shop, "panels", "unsound_panels", LAM_UNIT_COUNT, 0, 0, 1);
  assert_true(shop.stages[0].converged);
  assert_int_equal(shop.stages[0].note_count, 0);
  make(&shop, "panels", "{}");
  assert_string_equal(shop.parts[4].name, "Q1");
  assert_int_equal(shop.parts[4].congruence, 5);
}

/* Outward from the net, about it, or inward; 0.3 m off it. */
static void plates_lie_on_their_side_of_the_net(void **state) {
  static const char *const sides[] = {"outward", "centered", "inward"};
  static const double low[] = {.3, .29, .28};
  for (int k = 0; k < 3; k++) {
    lam_workshop shop = shop_of(state, 3, 3, field);
    lam_vec3 min, max;
    make(&shop, "panels",
         lam_arena_printf(*state, "{side: %s, offset: 300 mm, thickness: 20 mm}", sides[k]));
    lam_points_bounds(shop.parts[0].solid.vertices, shop.parts[0].solid.vertex_count, &min, &max);
    assert_near(min.z, low[k], 1e-12);
    assert_near(max.z, low[k] + .02, 1e-12);
  }
}

/* A prism of three sides cannot be colored as a checkerboard: across one of its edges both faces
 * have one color. Bands of family 1 run around it and change along; those of family 0 run along it
 * and meet the same edge. */
static void patterns_that_do_not_close_are_told(void **state) {
  lam_mesh mesh = lam_mesh_grid(*state, 3, 2, true, false);
  for (int i = 0; i < 6; i++)
    mesh.vertices[i] = lam_v3(cos(i / 2 * LAM_PI / 1.5), sin(i / 2 * LAM_PI / 1.5), i % 2);
  static const char *const faces[] = {"checker", "bands-0", "bands-1", "all"};
  int told[4], made[4];
  for (int k = 0; k < 4; k++) {
    lam_workshop shop = fixture_workshop(*state, &mesh);
    make(&shop, "panels", lam_arena_printf(*state, "{faces: %s, gap: 1 mm}", faces[k]));
    told[k] = shop.stages[0].note_count;
    made[k] = shop.part_count;
    if (told[k])
      assert_string_equal(shop.stages[0].notes[0],
                          "the pattern of faces cannot be continued across 1 edges");
  }
  assert_int_equal(told[0], 1);
  assert_int_equal(told[1] + told[2], 1);
  assert_int_equal(told[3], 0);
  assert_int_equal(made[0], 1); /* the first face, and its two neighbors are of the other color */
  assert_int_equal(made[3], 3);
}

/* The columns of 0.5 m vanish between gaps of 1.1 m (0.55 m to the edge): two faces stay open. */
static void faces_too_small_for_the_gap_stay_open(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, field);
  make(&shop, "panels", "{gap: 1 m}");
  assert_int_equal(shop.part_count, 2);
  assert_string_equal(shop.stages[0].notes[0], "2 faces are too small for the gap and stay open");
}

/* One corner of four raised by 30 mm: the diagonals of a unit square then pass at
 * .03 / |d1 x d2| = .03 / sqrt(4 + .0018) m = 15 mm. */
static lam_vec3 raised(double u, double v) {
  return lam_v3(u / 2, v / 2, u > 0 && v > 0 ? .03 : 0);
}

static void twisted_panels_are_told(void **state) {
  double warp = .03 / sqrt(4 + 2 * .0009), diagonal = (sqrt(2) + sqrt(2.0009)) / 2;
  for (int flat = 0; flat < 2; flat++) {
    lam_workshop shop = shop_of(state, 2, 2, raised);
    make(&shop, "panels",
         lam_arena_printf(*state, "{flat: %.6f}", warp / diagonal * (flat ? 1.001 : .999)));
    assert_told(&shop, "panels", "twisted_panels", LAM_UNIT_COUNT, !flat, !flat, 1);
    assert_told(&shop, "panels", "warp", "mm", 1e3 * warp, 1e3 * warp, 1);
    assert_int_equal(shop.parts[0].flat != NULL, flat);
    assert_int_equal(shop.stages[0].note_count, !flat);
    if (!flat)
      assert_string_equal(shop.stages[0].notes[0],
                          "1 of 1 panels are twisted: their diagonals pass at up to 15 mm; they "
                          "have no flat pattern");
  }
}

/* ---- one plate ---- */

/* A trapezoid that stands in the plane x = 5, seen from its normal +x: along its first side and to
 * the left of it. */
static const lam_panel upright = {.corner = {{5, 1, 2}, {5, 4, 2}, {5, 4, 4}, {5, 2, 3}},
                                  .normal = {1, 0, 0},
                                  .flat = true,
                                  .diagonal = 3};
static const lam_panel_layer layer = {-.01, .03, 0, 1e-3};

/* 0.05 m is the largest height, written where the corners have their mean. */
static void a_plate_is_drawn_along_its_first_side(void **state) {
  lam_flat *flat = lam_panel_flat(*state, &upright, &layer, "P1");
  static const lam_vec2 expected[4] = {{0, 0}, {3, 0}, {3, 2}, {1, 1}};
  lam_vec2 min, max;
  for (int k = 0; k < 4; k++) {
    assert_near(flat->paths[0].points[k].x, expected[k].x, 1e-12);
    assert_near(flat->paths[0].points[k].y, expected[k].y, 1e-12);
  }
  assert_near(flat->thickness, .04, 1e-15);
  double width = lam_lettering_width("P1", .05);
  lam_paths_bounds(flat->paths + 1, flat->path_count - 1, &min, &max);
  assert_near(min.x, 1.75 - width / 2, 1e-12);
  assert_near(min.y, .75 - .025, 1e-12);
  assert_near(max.y, .75 + .025, 1e-12);
  lam_trimesh solid = lam_panel_solid(*state, &upright, &layer);
  lam_vec3 low, high;
  lam_points_bounds(solid.vertices, solid.vertex_count, &low, &high);
  assert_near(low.x, 4.99, 1e-12);
  assert_near(high.x, 5.03, 1e-12);
  assert_near(lam_trimesh_volume(&solid), .04 * 3.5, 1e-12); /* (6 + 1)/2 by the shoelace */
}

/* A patch over the unit square with one corner raised: z = c u v in 4 x 4 cells, thickened along
 * its own normals (-c v, -c u, 1). */
static void twisted_panels_are_thickened_along_their_normals(void **state) {
  const double c = .3;
  lam_panel panel = {.corner = {{0, 0, 0}, {1, 0, 0}, {1, 1, .3}, {0, 1, 0}}, .normal = {0, 0, 1}};
  lam_part part = {.solid = lam_panel_solid(*state, &panel, &layer)};
  assert_int_equal(part.solid.vertex_count, 2 * 25);
  for (int v = 0; v < 50; v++) {
    double a = v % 25 / 5 / 4., b = v % 5 / 4.;
    lam_vec3 n = lam_unit(lam_v3(-c * b, -c * a, 1));
    lam_vec3 expected = lam_along(lam_v3(a, b, c * a * b), v < 25 ? .03 : -.01, n);
    assert_near(lam_distance(part.solid.vertices[v], expected), 0, 1e-14);
  }
  assert_true(lam_part_is_sound(*state, &part));
}

/* A square of 0.1 m: from an eighth of the diagonal down in steps of .8 until the name keeps
 * half its height from the sides. In a strip of 20 mm x 1 m letters are smaller, in one of 10 mm
 * too small; with a name of two hundred letters nothing is written. */
static void names_are_as_large_as_they_fit(void **state) {
  lam_panel small = {.corner = {{0, 0, 0}, {.1, 0, 0}, {.1, .1, 0}, {0, .1, 0}},
                     .normal = {0, 0, 1},
                     .flat = true,
                     .diagonal = sqrt(.02)};
  double height = sqrt(.02) / 8;
  while (lam_lettering_width("P12345678", height) + height > .1) height *= .8;
  assert_true(height < sqrt(.02) / 8);
  lam_flat *flat = lam_panel_flat(*state, &small, &layer, "P12345678");
  lam_vec2 min, max;
  lam_paths_bounds(flat->paths + 1, flat->path_count - 1, &min, &max);
  assert_near(max.y - min.y, height, 1e-12);

  lam_panel slim = {.corner = {{0, 0, 0}, {0, 1, 0}, {-.02, 1, 0}, {-.02, 0, 0}},
                    .normal = {0, 0, 1},
                    .flat = true,
                    .diagonal = 1};
  height = .05;
  while (2 * height > .02) height *= .8;
  flat = lam_panel_flat(*state, &slim, &layer, "P1");
  lam_paths_bounds(flat->paths + 1, flat->path_count - 1, &min, &max);
  assert_near(max.y - min.y, height, 1e-12);
  slim.corner[2].x = slim.corner[3].x = -.01; /* 4.3 mm would fit: less than 1/200 of 1 m */
  assert_int_equal(lam_panel_flat(*state, &slim, &layer, "P1")->path_count, 1);
  char name[201] = {0};
  memset(name, 'W', 200);
  assert_int_equal(lam_panel_flat(*state, &small, &layer, name)->path_count, 1);
}

/* ---- equal plates ---- */

static lam_panel quad(double ax, double ay, double bx, double by, double cx, double cy) {
  return (lam_panel){.corner = {{0, 0, 0}, {ax, ay, 0}, {bx, by, 0}, {cx, cy, 0}}, .flat = true};
}

/* The same kite-like quad as it is, begun at each corner, turned over, moved by less than a
 * tenth of a millimeter, by more; with the same sides but other diagonals; not flat. */
static void plates_are_equal_however_they_lie(void **state) {
  const lam_panel q = quad(3, 0, 4, 2, 1, 3);
  lam_panel panels[11];
  for (int k = 0; k < 4; k++) {
    panels[k] = q;
    for (int i = 0; i < 4; i++) panels[k].corner[i] = q.corner[(k + i) % 4];
  }
  panels[4] = q; /* turned over: backwards and mirrored */
  for (int i = 0; i < 4; i++)
    panels[4].corner[i] = lam_v3(-q.corner[3 - i].x, q.corner[3 - i].y, 7);
  panels[5] = quad(3, 0, 4 + 5e-5, 2, 1, 3);
  panels[6] = quad(3, 0, 4 + 2e-4, 2, 1, 3);
  panels[7] = quad(1, 0, 1, 1, 0, 1); /* a square and a rhombus of the same sides */
  panels[8] = quad(1, 0, 1.6, .8, .6, .8);
  panels[9] = q;
  panels[9].flat = false;
  panels[10] = quad(1, 0, 1, 1, 0, 1);
  static const int expected[11] = {5, 5, 5, 5, 5, 5, 6, 7, 8, 0, 7};
  int class[11];
  assert_int_equal(lam_panel_classes(*state, panels, 11, 5, class), 4);
  for (int i = 0; i < 11; i++) assert_int_equal(class[i], expected[i]);
}

/* ---- the row `flat-pattern` ---- */

static lam_vec3 sheet(double u, double v) { return lam_v3(u, 2 * v, 0); }

/* A plane net of 2 m x 4 m is its own pattern: laid with its length along x, lines 2, 4 and 6 of
 * each direction engraved (of 0 to 8), which are the quarters. */
static void a_plane_sheet_is_its_own_pattern(void **state) {
  lam_workshop shop = shop_of(state, 9, 9, sheet);
  make(&shop, "flat-pattern", "{thickness: 3 mm, material: acrylic}");
  const lam_part *part = &shop.parts[0];
  double mass = 8 * .003 * 1190;
  assert_string_equal(part->name, "F1");
  assert_near(part->mass, mass, 1e-6);
  assert_fact(part, 0, "mass", "kg", part->mass);
  assert_string_equal(part->facts[1].name, "area");
  assert_near(part->facts[1].value, 8, 1e-7);
  assert_string_equal(part->facts[2].name, "flattening strain");
  assert_string_equal(part->facts[3].name, "bending strain");
  assert_near(part->facts[3].value, 0, 1e-12);
  const lam_stage *stage = &shop.stages[0];
  assert_true(stage->converged);
  assert_int_equal(stage->note_count, 0);
  assert_near(fixture_measure(&shop, "flat-pattern", "flat_area")->max, 8, 1e-7);
  assert_string_equal(fixture_measure(&shop, "flat-pattern", "flat_area")->unit, "m2");
  assert_near(fixture_measure(&shop, "flat-pattern", "sheet_mass")->max, mass, 1e-6);
  assert_below(fixture_measure(&shop, "flat-pattern", "flattening_strain")->max, 1e-8);
  assert_told(&shop, "flat-pattern", "turned_triangles", LAM_UNIT_COUNT, 0, 0, 1);
  assert_told(&shop, "flat-pattern", "outline_crossings", LAM_UNIT_COUNT, 0, 0, 1);
  assert_told(&shop, "flat-pattern", "unsound_sheets", LAM_UNIT_COUNT, 0, 0, 1);
  assert_near(part->flat->max.x, 2, 1e-7);
  assert_near(part->flat->max.y, 1, 1e-7);
  assert_int_equal(part->flat->paths[0].count, 32);
  assert_true(part->flat->paths[0].closed);
  int along[3] = {0}, across[3] = {0};
  for (int i = 1; i <= 6; i++) {
    lam_vec2 min, max;
    assert_int_equal(part->flat->paths[i].layer, LAM_LAYER_ENGRAVE);
    assert_int_equal(part->flat->paths[i].count, 9);
    lam_paths_bounds(&part->flat->paths[i], 1, &min, &max);
    for (int k = 0; k < 3; k++) {
      along[k] += max.y - min.y < 1e-6 && fabs(min.y - (k - 1) * .5) < 1e-6;
      across[k] += max.x - min.x < 1e-6 && fabs(min.x - (k - 1)) < 1e-6;
    }
  }
  for (int k = 0; k < 3; k++) assert_true(along[k] == 1 && across[k] == 1);

  /* The name stands around the vertex that is furthest from all of them: 0.25 m from two lines; its
   * corners reach two thirds of that, and it has the proportions of the letters. */
  lam_vec2 min, max;
  lam_paths_bounds(part->flat->paths + 7, part->flat->path_count - 7, &min, &max);
  double wide = lam_lettering_width("F1", 1);
  assert_near(max.y - min.y, 4. / 3 * .25 / hypot(1, wide), 1e-6);
  assert_near(max.x - min.x, wide * (max.y - min.y), 1e-6);
  assert_near(fmod(fabs(min.y + max.y) / 2 + 1e-9, .5), .25, 1e-6);
}

/* The only vertex inside lies 0.7 m from the nearest side, whose vertices are further away. */
static lam_vec3 off_center(double u, double v) {
  return u == 0 && v == 0 ? lam_v3(.2, .3, 0) : lam_v3(u, v, 0);
}

static void names_keep_clear_of_sides(void **state) {
  lam_workshop shop = shop_of(state, 3, 3, off_center);
  make(&shop, "flat-pattern", "{marks: 0}");
  const lam_flat *flat = shop.parts[0].flat;
  lam_vec2 min, max;
  lam_paths_bounds(flat->paths + 1, flat->path_count - 1, &min, &max);
  assert_near(max.y - min.y, 4. / 3 * .7 / hypot(1, lam_lettering_width("F1", 1)), 1e-6);
}

/* A quarter of a cylinder of radius 1 m, bent from 4 mm: strained by 2e-3 at its faces. Glass bears
 * 6.4e-4 and breaks, acrylic 1.06e-2. */
static lam_vec3 cylinder(double u, double v) { return lam_v3(sin(.6 * u), v, cos(.6 * u)); }

static void bending_is_held_against_the_limit(void **state) {
  for (int k = 0; k < 2; k++) {
    lam_workshop shop = shop_of(state, 33, 9, cylinder);
    make(&shop, "flat-pattern",
         k ? "{thickness: 4 mm, material: acrylic}" : "{thickness: 4 mm, material: glass}");
    /* Normals of the outermost vertices are estimated from one side: within 2 %. */
    assert_near(fixture_measure(&shop, "flat-pattern", "bending_strain")->max, .002, 4e-5);
    assert_int_equal(shop.stages[0].note_count, !k);
    if (!k)
      assert_string_equal(
          shop.stages[0].notes[0],
          "bent beyond the elastic limit of glass where it is curved most: it stays bent");
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(panels_are_counted_and_weighed),
      TEST(plates_lie_on_their_side_of_the_net),
      TEST(patterns_that_do_not_close_are_told),
      TEST(faces_too_small_for_the_gap_stay_open),
      TEST(twisted_panels_are_told),
      TEST(a_plate_is_drawn_along_its_first_side),
      TEST(twisted_panels_are_thickened_along_their_normals),
      TEST(names_are_as_large_as_they_fit),
      TEST(plates_are_equal_however_they_lie),
      TEST(a_plane_sheet_is_its_own_pattern),
      TEST(names_keep_clear_of_sides),
      TEST(bending_is_held_against_the_limit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
