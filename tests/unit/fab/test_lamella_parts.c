/* What a row of lamellas hands on: names, facts, records for OpenSCAD, curves and crossings; and
 * the messages about keys that do not fit. */
#include "core/numbers.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

/* Three by three vertices 1 m apart, in a plane; families cross at 60 degrees. */
static lam_vec3 skew(double u, double v) { return lam_v3(u + v / 2, v * sin(LAM_PI / 3), 0); }
static lam_vec3 square(double u, double v) { return lam_v3(u, v, 0); }

static lam_workshop shop_of(void **state, lam_vec3 (*f)(double, double)) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 3, 3, f);
  return fixture_workshop(fixture_arena(state), &mesh);
}

/* Pairs 20 mm apart that can be turned to 45 degrees. */
static lam_lamella_keys pair_keys(void) {
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.02;
  keys.joint.scissor = LAM_PI / 4;
  return keys;
}

static void parts_say_what_they_are(void **state) {
  lam_workshop shop = shop_of(state, skew);
  lam_lamella_keys keys = pair_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.part_count, 12);
  static const char *const names[] = {"A01a", "A01b", "A02a", "A02b", "A03a", "A03b",
                                      "B01a", "B01b", "B02a", "B02b", "B03a", "B03b"};
  static const char *const facts[][2] = {{"length", "m"},
                                         {"mass", "kg"},
                                         {"slots", ""},
                                         {"bending strain", ""},
                                         {"twist strain", ""},
                                         {"edge strain", ""},
                                         {"unrolled straightness", ""}};
  for (int i = 0; i < 12; i++) {
    const lam_part *part = &shop.parts[i];
    assert_string_equal(part->name, names[i]);
    assert_string_equal(part->kind, "lamella");
    assert_int_equal(part->family, i / 6);
    assert_int_equal(part->group, i / 2);
    assert_int_equal(part->fact_count, 7);
    for (int k = 0; k < 7; k++) {
      assert_string_equal(part->facts[k].name, facts[k][0]);
      assert_string_equal(part->facts[k].unit, facts[k][1]);
      if (k > 2) assert_near(part->facts[k].value, 0, 1e-12);
    }
    assert_near(part->facts[0].value, part->length, 0);
    assert_near(part->facts[1].value, part->mass, 0);
    assert_near(part->facts[2].value, 6, 0);
    assert_non_null(part->flat);
  }
}

/* The second sheet of A02 is 10 mm to the right of the line y = 0 (b = m x t points to the left).
 * The sheets of B02 meet it at (d cos a - e) / sin a, which is
 *   d = -.01, e = .01 (a):  (-.005 - .01) / sin 60 = -.0173205
 *   d = -.01, e = -.01 (b): (-.005 + .01) / sin 60 =  .0057735
 * Turned to 45 degrees they stand at (-.0070711 -+ .01) / .7071068, and to 135 degrees at
 * (.0070711 -+ .01) / .7071068. */
static void records_have_a_row_per_station(void **state) {
  lam_workshop shop = shop_of(state, skew);
  lam_lamella_keys keys = pair_keys();
  fixture_make(&shop, "lamella", &keys);
  const lam_record *record = shop.parts[3].record;
  assert_string_equal(record->name, "A02b");
  assert_int_equal(record->family, 0);
  assert_int_equal(record->columns, 15);
  assert_int_equal(record->rows, 8);
  double here[2] = {-.015 / sin(LAM_PI / 3), .005 / sin(LAM_PI / 3)}, root = sqrt(.5);
  for (int k = 0; k < 2; k++) {
    double e = k ? -.01 : .01, sharp = (-.01 * root - e) / root, blunt = (.01 * root - e) / root;
    double s = 1.1 - here[0] + here[k]; /* from 0.1 m before B01a */
    const double expected[15] = {here[k],
                                 -.01,
                                 0,
                                 1,
                                 0,
                                 0,
                                 0,
                                 0,
                                 1,
                                 s,
                                 8 + k,
                                 45,
                                 fmin(sharp, blunt) - here[k],
                                 fmax(sharp, blunt) - here[k],
                                 0};
    for (int c = 0; c < 15; c++)
      assert_near_named(record->values[(3 + k) * 15 + c], expected[c], 1e-12,
                        shop.record_kinds[0].columns[c].name);
  }
  const double *first = record->values; /* 0.1 m before its first crossing; no partner */
  assert_near(first[0], -1 + here[0] - .1, 1e-12);
  assert_near(first[9], 0, 0);
  assert_near(first[10], -1, 0);
  assert_near(first[11], 0, 0);
  /* B01a meets A01a and A01b, the parts with the numbers 0 and 1, in either order */
  const double *other = shop.parts[6].record->values;
  assert_near(other[15 + 10] + other[2 * 15 + 10], 1, 0);
  assert_near(other[15 + 10] * other[2 * 15 + 10], 0, 0);
}

/* Names, kinds and decimals of the columns, and the settings: what lamella.scad reads. */
static void records_are_described(void **state) {
  static const struct {
    const char *name;
    bool length;
    int decimals;
  } columns[] = {{"x", true, 4},        {"y", true, 4},         {"z", true, 4},
                 {"tx", false, 7},      {"ty", false, 7},       {"tz", false, 7},
                 {"mx", false, 7},      {"my", false, 7},       {"mz", false, 7},
                 {"s", true, 4},        {"partner", false, 0},  {"slot_angle", false, 6},
                 {"slot_low", true, 4}, {"slot_high", true, 4}, {"heading", false, 7}};
  static const char *const names[] = {"height", "thickness", "clearance", "slots"};
  for (int joint = 0; joint < 2; joint++) {
    lam_workshop shop = shop_of(state, square);
    lam_lamella_keys keys = fixture_keys();
    keys.joint.kind = joint;
    fixture_make(&shop, "lamella", &keys);
    const lam_record_kind *kind = &shop.record_kinds[0];
    const double values[] = {.1, .002, .00025, !joint};
    assert_string_equal(kind->kind, "lamella");
    assert_string_equal(kind->scad, "lamella.scad");
    assert_int_equal(kind->column_count, 15);
    assert_int_equal(kind->setting_count, 4);
    for (int c = 0; c < 15; c++) {
      assert_string_equal(kind->columns[c].name, columns[c].name);
      assert_int_equal(kind->columns[c].is_length, columns[c].length);
      assert_int_equal(kind->columns[c].decimals, columns[c].decimals);
    }
    for (int k = 0; k < 4; k++) {
      assert_string_equal(kind->settings[k].name, names[k]);
      assert_int_equal(kind->settings[k].is_length, k < 3);
      assert_near(kind->settings[k].value, values[k], 0);
    }
  }
}

/* Two rows, one per family, share their settings; with another thickness the second one has none,
 * and goes to OpenSCAD as solids. */
static void records_of_two_rows_share_their_settings(void **state) {
  static int family[2] = {0, 1};
  for (int k = 0; k < 2; k++) {
    lam_workshop shop = shop_of(state, square);
    lam_lamella_keys keys = fixture_keys();
    keys.families = (lam_list){1, &family[0]};
    fixture_make(&shop, "lamella", &keys);
    keys.families.items = &family[1];
    if (k) keys.thickness = .003;
    fixture_make(&shop, "lamella", &keys);
    assert_int_equal(shop.part_count, 6);
    assert_int_equal(shop.record_kind_count, 1);
    assert_non_null(shop.parts[0].record);
    assert_int_equal(shop.parts[3].record != NULL, !k);
    assert_int_equal(shop.parts[0].congruence, 1);
    assert_int_equal(shop.parts[3].congruence, 2);
  }
}

/* One curve per lamella, along its polyline, single or in pairs. */
static void axes_are_curves(void **state) {
  for (int pair = 0; pair < 2; pair++) {
    lam_workshop shop = shop_of(state, square);
    lam_lamella_keys keys = fixture_keys();
    if (pair) keys.pair = .02;
    fixture_make(&shop, "lamella", &keys);
    assert_int_equal(shop.curve_count, 6);
    for (int i = 0; i < 6; i++) {
      static const char *const names[] = {"A01", "A02", "A03", "B01", "B02", "B03"};
      const lam_named_curve *curve = &shop.curves[i];
      const lam_vec3 *points = curve->spline.points;
      double across = i % 3 - 1;
      assert_string_equal(curve->name, names[i]);
      assert_int_equal(curve->family, i / 3);
      lam_vec3 from = i < 3 ? lam_v3(-1, across, 0) : lam_v3(across, -1, 0);
      lam_vec3 to = i < 3 ? lam_v3(1, across, 0) : lam_v3(across, 1, 0);
      assert_near(lam_distance(points[0], from), 0, 1e-12);
      assert_near(lam_distance(points[curve->spline.count - 1], to), 0, 1e-12);
    }
  }
}

/* The first sheets of both lamellas are the parts of a crossing. Along A02a (d = .01) the sheets of
 * B02 pass at (.005 -+ .01) / sin 60: .01 / sin 60 before and after their mean. The first of all
 * crossings is .1 m after the start. */
static void crossings_of_pairs_are_means(void **state) {
  lam_workshop shop = shop_of(state, skew);
  lam_lamella_keys keys = pair_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.crossing_count, 9);
  const lam_crossing *c = &shop.crossings[4];
  double mean = .1 + .01 / sin(LAM_PI / 3);
  assert_int_equal(c->parts[0], 2);
  assert_int_equal(c->parts[1], 8);
  assert_near(c->along[0], 1 + mean, 1e-12);
  assert_near(c->along[1], 1 + mean, 1e-12);
  assert_near(c->angle, LAM_PI / 3, 1e-12);
  assert_true(isnan(c->flat_angle));
  assert_near(lam_length(c->position), 0, 1e-15);
  assert_near(lam_distance(c->normal, lam_v3(0, 0, 1)), 0, 1e-15);
  assert_near(shop.crossings[0].along[0], mean, 1e-12);
  assert_near(shop.crossings[8].along[0], 2 + mean, 1e-12);
}

static void assert_refused(void **state, lam_lamella_keys keys, const char *key, const char *text) {
  lam_workshop shop = shop_of(state, square);
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, text ? 1 : 0);
  if (!text) return;
  assert_int_equal(shop.part_count, 0);
  assert_string_equal(shop.errors->first->key, key);
  if (!strstr(shop.errors->first->text, text)) fail_msg("%s", shop.errors->first->text);
}

/* Each limit from both sides: a pair of thickness and two clearances, a height of eight clearances
 * or of the thickness; ribs as wide as the sheet is thick. */
static void keys_must_fit_each_other(void **state) {
  lam_lamella_keys keys = fixture_keys();
  keys.thickness = .11;
  keys.extend = .3;
  assert_refused(state, keys, "height", "100 mm is less than the thickness of 110 mm");
  keys = fixture_keys();
  keys.height = 8 * keys.joint.clearance;
  assert_refused(state, keys, "joint.clearance", NULL);
  keys.height = .0019;
  keys.thickness = .001;
  assert_refused(state, keys, "joint.clearance",
                 "0.25 mm is too much for a height of 1.9 mm: expected at most 0.2375 mm");
  keys = fixture_keys();
  keys.families.count = 0;
  assert_refused(state, keys, "families", "expected [0], [1] or [0, 1]");
  keys = fixture_keys();
  keys.extend = .00325; /* less half a slot of 2.5 mm: 2 mm are left */
  assert_refused(state, keys, "joint", NULL);
  keys.extend = .0032;
  assert_refused(
      state, keys, "joint",
      "A01 would keep 1.95 mm of material beside a slot, from 0.0 mm after its start on, "
      "and at least the thickness (2.00 mm) is needed");
}

/* A net of one face has only lines along its boundary. */
static void nets_without_lines_are_refused(void **state) {
  lam_mesh mesh = fixture_grid(*state, 2, 2, square);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.boundary = false;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_string_equal(shop.errors->first->text, "the net has no polylines of these families");
}

/* Families that cross at 4 degrees: 5 are needed. */
static lam_vec3 sharp(double u, double v) {
  return lam_v3(u + v * cos(4 * LAM_DEGREE), v * sin(4 * LAM_DEGREE), 0);
}
static lam_vec3 sharp_enough(double u, double v) {
  return lam_v3(u + v * cos(5.1 * LAM_DEGREE), v * sin(5.1 * LAM_DEGREE), 0);
}

static void sharp_crossings_are_refused(void **state) {
  for (int k = 0; k < 2; k++) {
    lam_workshop shop = shop_of(state, k ? sharp_enough : sharp);
    lam_lamella_keys keys = fixture_keys();
    fixture_make(&shop, "lamella", &keys);
    assert_int_equal(shop.errors->count, !k);
    if (k) continue;
    assert_string_equal(
        shop.errors->first->text,
        "lamellas A01 and B01 cross at 4.0 deg at net vertex 1: at least 5 deg are needed");
  }
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {
      TEST(parts_say_what_they_are),
      TEST(records_have_a_row_per_station),
      TEST(records_are_described),
      TEST(records_of_two_rows_share_their_settings),
      TEST(axes_are_curves),
      TEST(crossings_of_pairs_are_means),
      TEST(keys_must_fit_each_other),
      TEST(nets_without_lines_are_refused),
      TEST(sharp_crossings_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
