/* Washers and bolts at the nodes of paired lamellas: sizes from the standards, volumes in closed
 * form, places at skew nodes. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/flat/path.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

typedef struct connector_keys {
  int bolt;
  double washer, gap, arm;
  int material;
} connector_keys; /* as in gen/fab/lamella/node_connector.c */

/* Three by three nodes 1 m apart; families cross at 60 degrees. */
static lam_vec3 skew(double u, double v) { return lam_v3(u + v / 2, v * sin(LAM_PI / 3), 0); }
static lam_vec3 square(double u, double v) { return lam_v3(u, v, 0); }

/* Pairs 30 mm apart, sheets of 100 mm x 2 mm, and connectors of copper. */
static lam_workshop connected(void **state, lam_vec3 (*f)(double, double), connector_keys keys) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 3, 3, f);
  lam_workshop shop = fixture_workshop(fixture_arena(state), &mesh);
  lam_lamella_keys lamellas = fixture_keys();
  lamellas.pair = 0.03;
  fixture_make(&shop, "lamella", &lamellas);
  fixture_make(&shop, "node-connector", &keys);
  return shop;
}

static void assert_fact(const lam_part *part, int k, const char *name, const char *unit,
                        double value) {
  assert_string_equal(part->facts[k].name, name);
  assert_string_equal(part->facts[k].unit, unit);
  assert_near_named(part->facts[k].value, value, 1e-12, name);
}

/* Hexagon bolts ISO 4017 (k, s), nuts ISO 4032 (m), holes ISO 273, medium; mm. */
static const struct {
  const char *name;
  double d, s, k, m, hole;
} standard[4] = {{"M6", 6, 10, 4, 5.2, 6.6},
                 {"M8", 8, 13, 5.3, 6.8, 9},
                 {"M10", 10, 16, 6.4, 8.4, 11},
                 {"M12", 12, 18, 7.5, 10.8, 13.5}};

/* Head and nut are hexagons, sqrt(3)/2 s^2; the shank is a polygon of 24 corners on its circle,
 * 12 sin 15 r^2, and stands d/4 out of the nut. Between head and nut are the lamellas (100 mm),
 * twice the gap of 1 mm, washers of 4 mm and the seats of .05 mm. */
static void bolts_are_those_of_the_standards(void **state) {
  for (int i = 0; i < 4; i++) {
    lam_workshop shop = connected(state, square, (connector_keys){i, .004, .001, .04, 16});
    assert_int_equal(shop.errors->count, 0);
    assert_int_equal(shop.part_count, 12 + 2);
    const lam_part *bolt = &shop.parts[13];
    double s = standard[i].s * 1e-3, k = standard[i].k * 1e-3, m = standard[i].m * 1e-3,
           r = standard[i].d / 2 * 1e-3, outer = .05 + .001 + .004 + .00005, widest = 0;
    assert_string_equal(bolt->name + 5, standard[i].name);
    assert_int_equal(strncmp(bolt->name, "bolt-", 5), 0);
    double volume =
        sqrt(3) / 2 * s * s * (k + m) + 12 * sin(LAM_PI / 12) * r * r * (2 * outer + r / 2);
    assert_near(lam_trimesh_volume(&bolt->solid), volume, 1e-15);
    assert_near(bolt->mass, 8930 * volume, 1e-11);
    lam_vec3 min, max;
    lam_points_bounds(bolt->solid.vertices, bolt->solid.vertex_count, &min, &max);
    assert_near(max.z, outer + k, 1e-15);
    assert_near(min.z, -outer - m - r / 2, 1e-15);
    for (int v = 0; v < bolt->solid.vertex_count; v++)
      widest = fmax(widest, hypot(bolt->solid.vertices[v].x, bolt->solid.vertices[v].y));
    assert_near(widest, s / sqrt(3), 1e-15);
    assert_true(lam_part_is_sound(*state, bolt));
    assert_fact(bolt, 0, "mass", "kg", 8930 * volume);
    assert_fact(bolt, 1, "diameter", "m", 2 * r);
    assert_fact(bolt, 2, "size", "m", 2 * outer + m + r / 2);
    assert_fact(bolt, 3, "grip", "m", 2 * outer);
  }
}

/* A plus of two bars as wide as the head of the bolt, 2 arm long: 2 s 2a - s^2, less the hole. */
static void washers_are_stars(void **state) {
  for (int i = 0; i < 4; i++) {
    lam_workshop shop = connected(state, square, (connector_keys){i, .004, .001, .04, 16});
    const lam_part *washer = &shop.parts[12];
    double s = standard[i].s * 1e-3, hole = standard[i].hole * 1e-3;
    double area = 4 * s * .04 - s * s;
    assert_string_equal(washer->name + 7, standard[i].name);
    assert_int_equal(washer->flat->path_count, 2);
    assert_near(lam_path_area(&washer->flat->paths[0]), area, 1e-15);
    assert_near(lam_path_area(&washer->flat->paths[1]), LAM_PI / 4 * hole * hole, 1e-12);
    assert_true(washer->flat->paths[1].hole && washer->flat->paths[0].closed);
    assert_near(washer->flat->max.x, .04, 1e-15);
    assert_near(washer->flat->min.y, -.04, 1e-15);
    assert_near(washer->flat->thickness, .004, 0);
    /* every corner lies on one of the two bars' edges */
    for (int k = 0; k < washer->flat->paths[0].count; k++) {
      lam_vec2 p = washer->flat->paths[0].points[k];
      double x = fmax(fabs(p.x), fabs(p.y)), y = fmin(fabs(p.x), fabs(p.y));
      assert_true(fabs(y - s / 2) < 1e-14 || (fabs(x - .04) < 1e-14 && y < s / 2 + 1e-14));
    }
    lam_vec3 min, max;
    lam_points_bounds(washer->solid.vertices, washer->solid.vertex_count, &min, &max);
    assert_near(min.z, .051, 1e-15); /* half the height and the gap */
    assert_near(max.z, .055, 1e-15);
    assert_true(lam_part_is_sound(*state, washer));
    /* the hole in the solid has a corner in every direction of the star: within 2 % of a circle */
    double volume = lam_trimesh_volume(&washer->solid), round = LAM_PI / 4 * hole * hole;
    assert_near(volume, .004 * (area - round), .004 * .02 * round);
    assert_fact(washer, 0, "mass", "kg", 8930 * volume);
    assert_fact(washer, 1, "size", "m", .08);
    assert_fact(washer, 2, "thickness", "m", .004);
    assert_fact(washer, 3, "hole", "m", hole);
    assert_true(washer->congruence > 0 && washer->congruence + 1 == shop.parts[13].congruence);
    assert_int_equal(washer->family, -1);
    assert_int_equal(washer->group, -1);
    assert_string_equal(washer->kind, "node-connector");
  }
}

/* The arms of M8, 28 mm long: the corners at 13.07 degrees (6.5 mm to 28 mm) take the place of
 * those at 15 degrees; the hole has corners at 0, 13.07, 30, 45 ... degrees: r^2/2 sin of every
 * step. */
static void washers_have_no_corners_side_by_side(void **state) {
  lam_workshop shop = connected(state, square, (connector_keys){1, .004, .001, .028, 16});
  const lam_part *washer = &shop.parts[12];
  double tip = atan2(6.5, 28), step = LAM_PI / 12;
  double hole = 4 * .0045 * .0045 * (sin(tip) + sin(2 * step - tip) + sin(step));
  assert_int_equal(washer->flat->paths[0].count, 24);
  assert_near(lam_trimesh_volume(&washer->solid), .004 * (4 * .013 * .028 - .013 * .013 - hole),
              1e-15);
}

/* At 60 degrees the bisector is at 30 degrees: the arms lie along it and square to it. Washers
 * stand above and, turned about x, below; a bolt per node. */
static void connectors_stand_on_the_bisectors(void **state) {
  lam_workshop shop = connected(state, skew, (connector_keys){0, .004, .001, .04, 0});
  assert_int_equal(shop.errors->count, 0);
  const lam_part *washer = &shop.parts[12], *bolt = &shop.parts[13];
  assert_int_equal(washer->instance_count, 18);
  assert_int_equal(bolt->instance_count, 9);
  double c = cos(LAM_PI / 6), s = sin(LAM_PI / 6);
  for (int i = 0; i < 27; i++) {
    const lam_pose *pose = i < 18 ? &washer->instances[i] : &bolt->instances[i - 18];
    double side = i < 18 && i % 2 ? -1 : 1;
    lam_vec3 node = shop.lamella_grid->nodes[i < 18 ? i / 2 : i - 18].x;
    assert_near(lam_distance(pose->origin, node), 0, 0);
    assert_near(lam_distance(pose->axis[0], lam_v3(c, s, 0)), 0, 1e-12);
    assert_near(lam_distance(pose->axis[1], lam_v3(-side * s, side * c, 0)), 0, 1e-12);
    assert_near(lam_distance(pose->axis[2], lam_v3(0, 0, side)), 0, 1e-12);
  }
}

static void assert_refused(void **state, connector_keys keys, const char *key, const char *text) {
  lam_workshop shop = connected(state, skew, keys);
  assert_int_equal(shop.errors->count, text ? 1 : 0);
  if (!text) return;
  assert_int_equal(shop.part_count, 12);
  assert_string_equal(shop.errors->first->key, key);
  assert_string_equal(shop.errors->first->text, text);
}

/* At 60 degrees the crossings of sheets 30 mm apart are 15 / sin 30 = 30 mm from the node; 2 mm of
 * thickness more. M12 has a head of 18 mm. */
static void sizes_must_fit_the_grid(void **state) {
  assert_refused(state, (connector_keys){0, .004, .001, .0320001, 0}, NULL, NULL);
  assert_refused(state, (connector_keys){0, .004, .001, .0319, 0}, "arm",
                 "31.9 mm does not reach over the crossings of the sheets: at least 32.0 mm are "
                 "needed");
  lam_mesh mesh = fixture_grid(*state, 3, 3, square);
  static const double pairs[] = {.0149, .0151};
  for (int k = 0; k < 2; k++) {
    lam_workshop shop = fixture_workshop(*state, &mesh);
    lam_lamella_keys lamellas = fixture_keys();
    lamellas.pair = pairs[k];
    fixture_make(&shop, "lamella", &lamellas);
    connector_keys keys = {3, .004, .001, k ? .0179 : .04, 0};
    fixture_make(&shop, "node-connector", &keys);
    assert_int_equal(shop.errors->count, 1);
    assert_string_equal(
        shop.errors->first->text,
        k ? "17.9 mm is too short for the head of M12: at least 18 mm are needed"
          : "M12 does not fit between sheets that leave 12.9 mm: at least 13.0 mm are needed, so a "
            "pair of at least 15.0 mm");
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(bolts_are_those_of_the_standards),
      TEST(washers_are_stars),
      TEST(washers_have_no_corners_side_by_side),
      TEST(connectors_stand_on_the_bisectors),
      TEST(sizes_must_fit_the_grid),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
