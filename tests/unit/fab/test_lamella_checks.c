/* What the report says of lamellas, on strips made by hand: every measure against its closed
 * form. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"
#include "tests/unit/mesh_fixture.h"

enum { N = 7 };

static lam_material steel = {.name = "steel", .density = 7850, .max_strain = 0.0011};

/* A strip of N stations without crossings. */
static lam_sheet_strip strip_new(lam_arena *arena) {
  lam_sheet_strip strip = {
      .name = "A01", .station_count = N, .stations = LAM_NEW(arena, lam_station, N)};
  for (int i = 0; i < N; i++)
    strip.stations[i] = (lam_station){.t = {1, 0, 0}, .partner = -1, .crossing = -1};
  return strip;
}

/* On a circle of radius 3 m in steps of 0.1 rad; m across its plane (upright) or in it, outward. */
static lam_sheet_strip arc(lam_arena *arena, double radius, bool upright) {
  lam_sheet_strip strip = strip_new(arena);
  for (int i = 0; i < N; i++) {
    double a = 0.1 * (i - 3);
    strip.stations[i].x = lam_v3(radius * sin(a), radius * cos(a), 0);
    strip.stations[i].m = upright ? lam_v3(0, 0, 1) : lam_v3(sin(a), cos(a), 0);
  }
  return strip;
}

static const lam_lamella_grid grid = {.height = 0.1, .thickness = 0.002};

/* A strip that is bent only: 0.1 rad per chord of 2 R sin(0.05), times t/2. Its ends are
 * extensions: a sharper bend beside them does not count. */
static void bending(void **state) {
  lam_sheet_strip strip = arc(*state, 3, true);
  strip.stations[0].x = lam_v3(-3, 1, 0);
  strip.stations[6].x = lam_v3(3, 1, 0);
  strip.stations[2].partner = strip.stations[4].partner = 0;
  lam_strip_measures r = lam_strip_measure(*state, &grid, &strip);
  assert_near(r.bending_strain, 0.001 * 0.1 / (6 * sin(0.05)), 1e-15);
  assert_near(r.straightness, 0, 1e-14);
  assert_near(r.normal_straightness, 0, 1e-12);
  assert_near(r.straightening, 0, 1e-12);
  assert_near(r.twist, 0, 1e-14);
  assert_near(r.edge_difference, 0, 1e-14);
  assert_int_equal(r.slots, 2);
}

/* A strip that lies in the plane of its arc: it bows by R (1 - cos .3) on a length of 6 chords;
 * made straight it would strain by h/2 times the curvature; its edges are longer and shorter by
 * h/2R. */
static void bowing(void **state) {
  lam_sheet_strip strip = arc(*state, 3, false);
  lam_strip_measures r = lam_strip_measure(*state, &grid, &strip);
  double chord = 6 * sin(0.05), sagitta = 3 * (1 - cos(0.3));
  assert_near(r.straightness, sagitta / (6 * chord), 1e-14);
  assert_near(r.normal_straightness, sagitta / (6 * chord), 1e-12);
  assert_near(r.straightening, 0.05 * 0.1 / chord, 1e-12);
  assert_near(r.edge_difference, 0.05 / 3, 1e-14);
  assert_near(r.bending_strain, 0, 1e-12);
  assert_near(r.twist, 0, 1e-12);
}

/* A straight strip with m turning about it by 0.1 rad in 0.5 m, and by twice that in the
 * extensions, which count for the edges alone. */
static void twisting(void **state) {
  lam_sheet_strip strip = strip_new(*state);
  static const double angle[N] = {-.2, 0, .1, .2, .3, .4, .6};
  for (int i = 0; i < N; i++) {
    strip.stations[i].x = lam_v3(0.5 * i, 0, 0);
    strip.stations[i].m = lam_v3(0, -sin(angle[i]), cos(angle[i]));
  }
  lam_strip_measures r = lam_strip_measure(*state, &grid, &strip);
  assert_near(r.twist, 0.2, 1e-12);
  assert_near(r.twist_strain, 0.0004, 1e-15);
  assert_near(r.edge_strain, 0.05 * 0.05 * 0.2 * 0.2 / 2, 1e-17);
  assert_near(r.bending_strain, 0, 1e-15);
  assert_near(r.straightness, 0, 1e-14);
  double slow = hypot(.5, .1 * sin(.05)), fast = hypot(.5, .1 * sin(.1));
  assert_near(r.edge_difference, (4 * slow + 2 * fast) / 3 - 1, 1e-14);
}

/* The two stations of a crossing are one point, their mean: here the five points of an arc. */
static void crossings_are_one_point(void **state) {
  lam_sheet_strip strip = arc(*state, 3, true), points = arc(*state, 3, true);
  for (int i = 2; i < 5; i += 2) {
    int a = i == 2 ? 1 : 5; /* stations 1 and 2, and 4 and 5, about points 2 and 4 */
    lam_vec3 off = lam_v3(0.01, 0.02, 0);
    strip.stations[i].x = lam_add(points.stations[i].x, off);
    strip.stations[a].x = lam_sub(points.stations[i].x, off);
    strip.stations[i].crossing = strip.stations[a].crossing = i;
  }
  /* points 0, 2, 3, 4, 6: only the turn at 3 lies within */
  lam_strip_measures r = lam_strip_measure(*state, &grid, &strip);
  assert_near(r.bending_strain, 0.001 * 0.1 / (6 * sin(0.05)), 1e-15);
}

/* ---- the stage ---- */

static lam_vec3 plane(double u, double v) { return lam_v3(u, v, 0); }

static const lam_measure *told(const lam_workshop *shop, const char *name) {
  return fixture_measure(shop, "lamellas", name);
}

static void assert_told(const lam_workshop *shop, const char *name, const char *unit, double min,
                        double max, double mean, long count) {
  const lam_measure *m = told(shop, name);
  assert_string_equal(m->unit, unit);
  if (!isnan(min)) assert_near_named(m->min, min, 1e-12, name);
  assert_near_named(m->max, max, 1e-12, name);
  assert_near_named(m->mean, mean, 1e-12, name);
  assert_int_equal(m->count, count);
}

/* Two strips with numbers of their own, and their parts: cubes. */
static lam_workshop two_strips(lam_arena *arena, lam_lamella_grid *g) {
  lam_mesh mesh = fixture_grid(arena, 3, 3, plane);
  lam_workshop shop = fixture_workshop(arena, &mesh);
  *g = (lam_lamella_grid){.height = .1, .thickness = .002, .strip_count = 2, .material = &steel};
  g->strips = LAM_NEW(arena, lam_sheet_strip, 2);
  for (int i = 0; i < 2; i++) {
    g->strips[i] = arc(arena, 3, i == 0);
    g->strips[i].part = i;
    lam_workshop_part(&shop, (lam_part){.name = "A", .solid = mesh_cube(arena, 0, 0, 0, 1)});
  }
  return shop;
}

static const lam_strip_measures numbers[2] = {{0}};

static void every_measure_is_told_by_name(void **state) {
  lam_lamella_grid g;
  lam_workshop shop = two_strips(*state, &g);
  lam_strip_measures given[2] = {{.straightness = 1e-5,
                                  .straightening = 2e-5,
                                  .normal_straightness = 3e-5,
                                  .bending_strain = 4e-4,
                                  .twist = .5,
                                  .twist_strain = 6e-4,
                                  .edge_strain = 7e-5,
                                  .edge_difference = 8e-5},
                                 {.straightness = 3e-5,
                                  .straightening = 6e-5,
                                  .normal_straightness = 5e-5,
                                  .bending_strain = 2e-4,
                                  .twist = .1,
                                  .twist_strain = 2e-4,
                                  .edge_strain = 1e-5,
                                  .edge_difference = 2e-5}};
  lam_lamella_stage(&shop, &g, given);
  assert_told(&shop, "sheet_straightness", "of length", 1e-5, 3e-5, 2e-5, 2);
  assert_told(&shop, "straightening_strain", "", 2e-5, 6e-5, 4e-5, 2);
  assert_told(&shop, "normal_strip_straightness", "of length", 3e-5, 5e-5, 4e-5, 2);
  assert_told(&shop, "bending_strain", "", 2e-4, 4e-4, 3e-4, 2);
  assert_told(&shop, "twist", "rad/m", .1, .5, .3, 2);
  assert_told(&shop, "twist_strain", "", 2e-4, 6e-4, 4e-4, 2);
  assert_told(&shop, "edge_strain", "", 1e-5, 7e-5, 4e-5, 2);
  assert_told(&shop, "edge_length_difference", "of length", 2e-5, 8e-5, 5e-5, 2);
  double bow = 3 * (1 - cos(.3)) / (36 * sin(.05)); /* of the second strip; the first is straight */
  assert_told(&shop, "unrolled_straightness", "of length", 0, bow, bow / 2, 2);
  assert_string_equal(shop.stages[0].notes[0], "largest strain 0.0006; steel stays elastic up to "
                                               "0.0011: within the limit");
}

/* Each of the four strains may be the one that is too large. */
static void the_largest_strain_is_held_against_the_limit(void **state) {
  for (int k = 0; k < 4; k++) {
    lam_lamella_grid g;
    lam_workshop shop = two_strips(*state, &g);
    lam_strip_measures given[2] = {{0}};
    *(k == 0   ? &given[1].bending_strain
      : k == 1 ? &given[1].twist_strain
      : k == 2 ? &given[1].edge_strain
               : &given[1].straightening) = 0.0012;
    lam_lamella_stage(&shop, &g, given);
    assert_string_equal(shop.stages[0].notes[0],
                        "largest strain 0.0012; steel stays elastic up to 0.0011: beyond the "
                        "limit, lamellas would have to be formed");
  }
  lam_lamella_grid g;
  lam_workshop shop = two_strips(*state, &g);
  lam_lamella_stage(&shop, &g, (lam_strip_measures[2]){{.bending_strain = .0011}});
  assert_non_null(strstr(shop.stages[0].notes[0], "within the limit"));
}

/* The sheets of a pair bow to both sides; the lamella between them is straight. */
static void pairs_are_measured_in_their_middle(void **state) {
  lam_lamella_grid g;
  lam_workshop shop = two_strips(*state, &g);
  g.pair = .02;
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < N; i++) {
      lam_station *q = &g.strips[k].stations[i];
      q->x = lam_v3(.5 * i, (k ? .01 : -.01) * i * (6 - i), 0);
      q->m = lam_v3(0, 1, 0);
    }
  lam_lamella_stage(&shop, &g, numbers);
  assert_told(&shop, "unrolled_straightness", "of length", 0, 0, 0, 1);
}

/* A part with a hole, one that is two cubes in one, one with a triangle turned over. */
static void unsound_solids_are_counted(void **state) {
  lam_lamella_grid g;
  lam_workshop shop = two_strips(*state, &g);
  lam_lamella_stage(&shop, &g, numbers);
  assert_true(shop.stages[0].converged);
  assert_told(&shop, "open_parts", LAM_UNIT_COUNT, 0, 0, 0, 1);
  assert_told(&shop, "unoriented_parts", LAM_UNIT_COUNT, 0, 0, 0, 1);
  assert_told(&shop, "self_intersecting_parts", LAM_UNIT_COUNT, 0, 0, 0, 1);

  shop.stage_count = 0;
  shop.parts[1].solid.triangle_count--;
  lam_lamella_stage(&shop, &g, numbers);
  assert_told(&shop, "open_parts", LAM_UNIT_COUNT, 1, 1, 1, 1);
  assert_false(shop.stages[0].converged);

  lam_trimesh a = mesh_cube(*state, 0, 0, 0, 1), b = mesh_cube(*state, .5, .5, .5, 1);
  shop.stage_count = 0;
  shop.parts[1].solid = mesh_pair(*state, &a, &b);
  lam_lamella_stage(&shop, &g, numbers);
  assert_told(&shop, "open_parts", LAM_UNIT_COUNT, 1, 1, 1, 1); /* not of one piece */
  assert_told(&shop, "self_intersecting_parts", LAM_UNIT_COUNT, 1, 1, 1, 1);
  assert_told(&shop, "unoriented_parts", LAM_UNIT_COUNT, 0, 0, 0, 1);
  assert_false(shop.stages[0].converged);

  shop.stage_count = 0;
  int *t = a.triangles[5], keep = t[0];
  t[0] = t[1], t[1] = keep;
  shop.parts[0].solid = a;
  shop.parts[1].solid = mesh_cube(*state, 0, 0, 0, 1);
  lam_lamella_stage(&shop, &g, numbers);
  assert_told(&shop, "unoriented_parts", LAM_UNIT_COUNT, 1, 1, 1, 1);
  assert_false(shop.stages[0].converged);
}

/* ---- angles at nodes: families along (1, v/5) and (0, 1), which cross at 90 - atan(v/5) ---- */

static lam_vec3 fan(double u, double v) { return lam_v3(u, v * (1 + u / 5), 0); }

/* 5 x 5 nodes at v = -1, -.5, 0, .5, 1: nine of them inside the net. */
static void crossing_angles(void **state) {
  lam_mesh mesh = fixture_grid(*state, 5, 5, fan);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 0);
  double half = atan(.1) / LAM_DEGREE, full = atan(.2) / LAM_DEGREE;
  assert_told(&shop, "crossing_angle", "deg", 90 - half, 90 + half, 90, 9);
  assert_told(&shop, "crossing_angle_deviation", "deg", 0, half, 2. / 3 * half, 9);
  assert_told(&shop, "crossing_angle_deviation_boundary", "deg", 0, full,
              (10 * full + 4 * half) / 16, 16);
}

/* ---- clashes ---- */

/* Cubes of 1 m: B overlaps A by half, C overlaps B by a quarter; E stands twice, far away from all
 * and once in D by a tenth; F is only drawn. */
static void overlaps_are_told_pair_by_pair(void **state) {
  lam_mesh mesh = fixture_grid(*state, 3, 3, plane);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_pose places[2] = {{{50, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                        {{20.9, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  static const char *const names[] = {"C", "A", "B", "D", "E", "F"};
  static const double x[] = {1.25, 0, .5, 20, 0, .3};
  for (int i = 0; i < 6; i++)
    lam_workshop_part(&shop, (lam_part){.name = names[i],
                                        .solid = mesh_cube(*state, x[i], 0, 0, 1),
                                        .instance_count = i == 4 ? 2 : 0,
                                        .instances = i == 4 ? places : NULL,
                                        .drawn = i == 5});
  lam_workshop_clash(&shop);
  assert_near(fixture_measure(&shop, "clash", "pairs_checked")->max, 3, 0);
  assert_near(fixture_measure(&shop, "clash", "clash_count")->max, 3, 0);
  assert_near(fixture_measure(&shop, "clash", "clash_count")->mean, 3, 0);
  assert_near(fixture_measure(&shop, "clash", "clash_volume")->max, .5, 1e-12);
  assert_near(fixture_measure(&shop, "clash", "clash_volume")->mean, .85 / 3, 1e-12);
  assert_near(fixture_measure(&shop, "clash", "clash_volume_sum")->max, .85, 1e-12);
  assert_int_equal(fixture_measure(&shop, "clash", "clash_volume")->count, 3);
  const lam_stage *stage = &shop.stages[0];
  assert_false(stage->converged);
  assert_string_equal(stage->reason, "parts overlap");
  assert_string_equal(stage->notes[0], "1 parts are drawn only and were left out");
  assert_string_equal(stage->notes[1], "3 pairs of parts overlap, most of all A and B (5e+08 mm3)");
}

/* Without parts, or with nothing but drawn ones, there is no stage; a part that is no solid is told
 * as what could not be computed. */
static void clashes_need_solids(void **state) {
  lam_mesh mesh = fixture_grid(*state, 3, 3, plane);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_workshop_clash(&shop);
  lam_workshop_part(&shop,
                    (lam_part){.name = "F", .drawn = true, .solid = mesh_cube(*state, 0, 0, 0, 1)});
  lam_workshop_clash(&shop);
  assert_int_equal(shop.stage_count, 0);
  lam_part open = {.name = "G", .solid = mesh_cube(*state, 0, 0, 0, 1)};
  open.solid.triangle_count--;
  lam_workshop_part(&shop, open);
  lam_workshop_clash(&shop);
  assert_int_equal(shop.stage_count, 1);
  assert_false(shop.stages[0].converged);
  assert_string_equal(shop.stages[0].reason, "not computed");
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(bending),
      TEST(bowing),
      TEST(twisting),
      TEST(crossings_are_one_point),
      TEST(every_measure_is_told_by_name),
      TEST(the_largest_strain_is_held_against_the_limit),
      TEST(pairs_are_measured_in_their_middle),
      TEST(unsound_solids_are_counted),
      TEST(crossing_angles),
      TEST(overlaps_are_told_pair_by_pair),
      TEST(clashes_need_solids),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
