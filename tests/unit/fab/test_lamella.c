/* Lamellas on plane nets, where everything has a closed form. */
#include "core/numbers.h"
#include "core/solid/solid.h"
#include "core/solid/triangles.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

static const double H = 0.1, T = 0.002, C = 0.00025; /* fixture_keys */

/* 4 x 5 vertices, 1 m apart: five lines of family 0 along x, four of family 1 along y. */
static lam_vec3 plane_point(double u, double v) { return lam_v3(1.5 * u, 2 * v, 0); }
/* The same, sheared so that the families cross at 60 degrees; still 1 m apart along the lines. */
static lam_vec3 skew_point(double u, double v) {
  return lam_v3(1.5 * u + v, 2 * v * sin(LAM_PI / 3), 0);
}

static lam_workshop plane_shop(void **state, lam_vec3 (*f)(double, double)) {
  lam_mesh mesh = fixture_grid(fixture_arena(state), 4, 5, f);
  return fixture_workshop(fixture_arena(state), &mesh);
}

static void assert_sound(const lam_trimesh *solid) {
  lam_solid_facts facts;
  assert_int_equal(lam_solid_measure(solid, true, &facts), LAM_OK);
  assert_true(facts.closed && facts.oriented && facts.manifold);
  assert_int_equal(facts.components, 1);
  assert_int_equal(facts.euler, 2);
  assert_int_equal(facts.self_intersections, 0);
}

/* The volume is t (L H - slots w (H/2 + c)) with w = t + 2 c at right angles. */
static void plane_grid_is_exact(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 0);
  assert_int_equal(shop.part_count, 9);
  for (int i = 0; i < 9; i++) {
    const lam_part *part = &shop.parts[i];
    bool first = i < 5;
    double length = first ? 3.2 : 4.2, slots = first ? 4 : 5;
    assert_near(part->length, length, 1e-14);
    assert_near(lam_trimesh_volume(&part->solid),
                T * (length * H - slots * (T + 2 * C) * (H / 2 + C)), 1e-15);
    assert_near(part->mass, 7850 * lam_trimesh_volume(&part->solid), 1e-12);
    assert_sound(&part->solid);
    assert_int_equal(part->family, first ? 0 : 1);
    assert_int_equal(part->congruence, first ? 1 : 2);
    assert_non_null(part->flat);
  }
  assert_string_equal(shop.parts[0].name, "A01");
  assert_string_equal(shop.parts[8].name, "B04");
}

/* The bounds of a part of family 0 at y = -2, and slots that open up: the highest point inside a
 * slot is its floor. */
static void slots_open_to_their_side(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  for (int i = 0; i < 9; i += 8) {
    const lam_trimesh *solid = &shop.parts[i].solid;
    lam_vec3 min, max;
    lam_points_bounds(solid->vertices, solid->vertex_count, &min, &max);
    assert_near(max.z, H / 2, 1e-15);
    assert_near(min.z, -H / 2, 1e-15);
    assert_near(i ? max.x - min.x : max.y - min.y, T, 1e-15);
    double floor = i ? C : -C;
    int at_floor = 0;
    for (int v = 0; v < solid->vertex_count; v++)
      at_floor += fabs(solid->vertices[v].z - floor) < 1e-12;
    assert_int_equal(at_floor, solid->vertex_count / 3);
    /* a ray upwards in the middle of the first slot meets the floor (family 0), or begins at it
     * (family 1) */
    double above = 0;
    for (int t = 0; t < solid->triangle_count; t++) {
      const int *c = solid->triangles[t];
      lam_vec3 middle = lam_scale(
          lam_add(lam_add(solid->vertices[c[0]], solid->vertices[c[1]]), solid->vertices[c[2]]),
          1.0 / 3);
      lam_vec3 area = lam_scale(lam_cross(lam_sub(solid->vertices[c[1]], solid->vertices[c[0]]),
                                          lam_sub(solid->vertices[c[2]], solid->vertices[c[0]])),
                                0.5);
      if (fabs(middle.z - floor) < 1e-12) above += area.z;
    }
    /* the floors face upwards in family 0 and downwards in family 1: 4 or 5 slots of t (t + 2 c) */
    assert_near(above, (i ? -5 : 4) * T * (T + 2 * C), 1e-15);
  }
}

static void stations_and_records(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  const lam_sheet_strip *strip = &shop.lamella_grid->strips[1]; /* A02: y = -1 */
  assert_int_equal(strip->station_count, 6);
  static const double s[] = {0, 0.1, 1.1, 2.1, 3.1, 3.2};
  for (int i = 0; i < 6; i++) {
    const lam_station *q = &strip->stations[i];
    assert_near(q->s, s[i], 1e-14);
    assert_near(lam_distance(q->x, lam_v3(s[i] - 1.6, -1, 0)), 0, 1e-14);
    assert_near(lam_distance(q->t, lam_v3(1, 0, 0)), 0, 1e-14);
    assert_near(lam_distance(q->m, lam_v3(0, 0, 1)), 0, 1e-14);
    assert_int_equal(q->partner, i == 0 || i == 5 ? -1 : 5 + i - 1);
  }
  assert_int_equal(shop.record_kind_count, 1);
  assert_string_equal(shop.record_kinds[0].scad, "lamella.scad");
  const lam_record *record = shop.parts[1].record;
  assert_int_equal(record->columns, shop.record_kinds[0].column_count);
  assert_int_equal(record->rows, 6);
  assert_near(record->values[2 * 15 + 9], 1.1, 1e-14);
  assert_near(record->values[2 * 15 + 10], 6, 0);
  assert_near(record->values[2 * 15 + 11], 90, 1e-12);
  assert_int_equal(shop.crossing_count, 20);
  for (int i = 0; i < 20; i++) {
    assert_near(shop.crossings[i].angle, LAM_PI / 2, 1e-14);
    assert_near(shop.crossings[i].along[0], 0.1 + i % 4, 1e-14);
    assert_near(shop.crossings[i].along[1], 0.1 + i / 4, 1e-14);
    assert_int_equal(shop.crossings[i].parts[0], i / 4);
    assert_int_equal(shop.crossings[i].parts[1], 5 + i % 4);
  }
}

/* With slots nothing overlaps. Without, every crossing overlaps in t x t x H, and no three parts
 * meet: the fused grid has the Euler characteristic 9 - 20 of its handlebody, so the genus
 * (4-1)(5-1) = 12. */
static void clash_of_the_plane_grid(void **state) {
  for (int joint = 0; joint < 2; joint++) {
    lam_workshop shop = plane_shop(state, plane_point);
    lam_lamella_keys keys = fixture_keys();
    keys.joint.kind = joint;
    fixture_make(&shop, "lamella", &keys);
    for (int i = 0; i < shop.part_count; i++) assert_sound(&shop.parts[i].solid);
    lam_workshop_clash(&shop);
    assert_near(fixture_measure(&shop, "clash", "pairs_checked")->max, 20, 0);
    assert_near(fixture_measure(&shop, "clash", "clash_count")->max, joint ? 20 : 0, 0);
    assert_near(fixture_measure(&shop, "clash", "clash_volume")->max, joint ? T * T * H : 0, 1e-18);
    assert_near(fixture_measure(&shop, "clash", "clash_volume_sum")->max,
                joint ? 20 * T * T * H : 0, 1e-17);
    assert_int_equal(shop.stages[shop.stage_count - 1].converged, !joint);
    if (joint) assert_near(1 - (9 - fixture_measure(&shop, "clash", "clash_count")->max), 3 * 4, 0);
  }
}

/* 2 mm at 60 degrees: 2 (1 + 1/2) / (sqrt(3)/2) + 0.5 = 3.964 mm. */
static void slot_width(void **state) {
  (void)state;
  assert_near(lam_slot_width(T, C, LAM_PI / 3), 0.002 * 1.5 / 0.86602540378443865 + 0.0005, 1e-17);
  assert_near(lam_slot_width(T, C, LAM_PI / 2), T + 2 * C, 1e-17);
  assert_near(lam_slot_width(T, C, 2 * LAM_PI / 3), lam_slot_width(T, C, LAM_PI / 3), 1e-17);
}

/* Where the line at distance d to the left of the x axis meets the line at distance e to the left
 * of the direction theta: by solving the two line equations, sampled over all angles on the way. */
static double meet(double d, double e, double theta) {
  /* y = d;  -sin(theta) x + cos(theta) y = e */
  return (cos(theta) * d - e) / sin(theta);
}

static void scissor_sweep(void **state) {
  (void)state;
  const double offsets[] = {-0.0125, 0.0125}, angles[] = {50, 60, 75, 90, 110, 130};
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < 2; k++)
      for (int a = 0; a < 6; a++) {
        double d = offsets[i], e = offsets[k], angle = angles[a] * LAM_PI / 180,
               scissor = LAM_PI / 3;
        double from = fmin(angle, scissor), to = fmax(angle, LAM_PI - scissor), low = 0, high = 0;
        for (int s = 0; s <= 1000; s++) {
          double x = meet(d, e, from + (to - from) * s / 1000) - meet(d, e, angle);
          low = fmin(low, x), high = fmax(high, x);
        }
        lam_slot_range r = lam_slot_sweep(d, e, angle, scissor);
        assert_near(r.low, low, 1e-15);
        assert_near(r.high, high, 1e-15);
        assert_near(r.smallest, fmin(from, LAM_PI - to), 1e-15);
        r = lam_slot_sweep(d, e, angle, 0);
        assert_near(r.high - r.low, 0, 0);
        assert_near(r.smallest, fmin(angle, LAM_PI - angle), 1e-15);
      }
}

/* Both sheets of a crossing have a station at the same point with the same m, at the same angle;
 * sheets keep their distance. */
static void pairs_share_their_crossings(void **state) {
  lam_vec3 (*nets[])(double, double) = {plane_point, skew_point};
  for (int k = 0; k < 2; k++) {
    lam_workshop shop = plane_shop(state, nets[k]);
    lam_lamella_keys keys = fixture_keys();
    keys.pair = 0.025;
    fixture_make(&shop, "lamella", &keys);
    const lam_lamella_grid *grid = shop.lamella_grid;
    assert_int_equal(grid->strip_count, 18);
    assert_string_equal(shop.parts[17].name, "B04b");
    int crossings = 0;
    for (int i = 0; i < grid->strip_count; i++)
      for (int j = 0; j < grid->strips[i].station_count; j++) {
        const lam_station *q = &grid->strips[i].stations[j];
        if (q->partner < 0) continue;
        const lam_sheet_strip *other = &grid->strips[q->partner];
        int found = 0;
        for (int l = 0; l < other->station_count; l++) {
          const lam_station *r = &other->stations[l];
          if (r->partner != i) continue;
          assert_near(lam_distance(q->x, r->x), 0, 0);
          assert_near(lam_distance(q->m, r->m), 0, 0);
          assert_near(lam_angle(q->t, r->t), k ? LAM_PI / 3 : LAM_PI / 2, 1e-12);
          found++;
        }
        assert_int_equal(found, 1);
        crossings++;
        lam_vec3 line = shop.net->mesh.vertices[grid->nodes[q->crossing].vertex],
                 b = lam_cross(q->m, q->t);
        assert_near(lam_dot(lam_sub(q->x, line), b), grid->strips[i].offset, 1e-14);
      }
    assert_int_equal(crossings, 2 * 4 * 20);
    lam_workshop_clash(&shop);
    assert_near(fixture_measure(&shop, "clash", "clash_volume_sum")->max, 0, 0);
  }
}

static lam_pose turned(const lam_grid_node *node, double angle) {
  double c = cos(angle), s = sin(angle);
  lam_pose f = {.axis = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  lam_vec3 moved = lam_v3(c * node->x.x - s * node->x.y, s * node->x.x + c * node->x.y, 0);
  f.origin = lam_sub(node->x, moved);
  return f;
}

/* The two sheets through one node against the two that are turned about it. */
static double overlap_when_turned(const lam_workshop *shop, const lam_grid_node *node,
                                  double angle) {
  lam_solid_set *set = lam_solid_set_new();
  lam_pose frame = turned(node, angle);
  double sum = 0;
  for (int f = 0; f < 2; f++)
    for (int k = 0; k < 2; k++)
      assert_int_equal(
          lam_solid_set_add(set, &shop->parts[2 * node->lamella[f] + k].solid, f ? &frame : NULL),
          2 * f + k);
  for (int i = 0; i < 2; i++)
    for (int k = 2; k < 4; k++) {
      double volume = 0;
      assert_int_equal(lam_solid_set_overlap(set, i, k, &volume), LAM_OK);
      sum += volume;
    }
  lam_solid_set_free(set);
  return sum;
}

/* Slots for 60 degrees let the node turn from 90 to 60 and to 120 degrees, and not to 55 and 125.
 * Their length is the way of the partner d (tan 60 - tan 30) and the width at 60 degrees. */
static void scissoring_pairs(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.025;
  keys.joint.scissor = LAM_PI / 3;
  fixture_make(&shop, "lamella", &keys);
  double length = 0.0125 * (tan(LAM_PI / 3) - tan(LAM_PI / 6)) + lam_slot_width(T, C, LAM_PI / 3);
  /* sheets reach 12.5 mm further on both sides, to their own crossings */
  assert_near(lam_trimesh_volume(&shop.parts[0].solid), T * (3.225 * H - 8 * length * (H / 2 + C)),
              1e-15);
  const lam_grid_node *node = &shop.lamella_grid->nodes[9];
  for (int degrees = -30; degrees <= 30; degrees += 10)
    assert_near(overlap_when_turned(&shop, node, degrees * LAM_PI / 180), 0, 0);
  assert_true(overlap_when_turned(&shop, node, 35 * LAM_PI / 180) > 1e-9);
  assert_true(overlap_when_turned(&shop, node, -35 * LAM_PI / 180) > 1e-9);
}

/* Without `scissor` a pair locks its angle. */
static void pairs_without_scissor_lock(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.025;
  fixture_make(&shop, "lamella", &keys);
  assert_near(overlap_when_turned(&shop, &shop.lamella_grid->nodes[9], 0), 0, 0);
  assert_true(overlap_when_turned(&shop, &shop.lamella_grid->nodes[9], 5 * LAM_PI / 180) > 1e-9);
}

/* Every k-th polyline, and none on the boundary: of 5 lines those at y = -2, 0, 2, of 4 lines x =
 * -1.5, 0.5 (nothing divides 3 evenly, so the selection starts at the first). Lamellas end where
 * the last one crosses. */
static void every_and_boundary(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  keys.every = 2;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.part_count, 5);
  assert_int_equal(shop.lamella_grid->node_count, 6);
  assert_near(shop.parts[0].length, 2.2, 1e-14);
  assert_near(shop.parts[3].length, 4.2, 1e-14);
  shop = plane_shop(state, plane_point);
  keys.every = 1;
  keys.boundary = false;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.part_count, 5);
  assert_near(shop.parts[0].length, 1.2, 1e-14);
  assert_near(shop.parts[3].length, 2.2, 1e-14);
}

static void one_family(void **state) {
  static int one[1] = {1};
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  keys.families = (lam_list){1, one};
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.part_count, 4);
  assert_int_equal(shop.crossing_count, 0);
  assert_near(lam_trimesh_volume(&shop.parts[0].solid), 4.2 * H * T, 1e-15);
  assert_string_equal(shop.parts[0].name, "B01");
}

static void assert_message(void **state, lam_lamella_keys keys, const char *text) {
  lam_workshop shop = plane_shop(state, plane_point);
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.part_count, 0);
  assert_true(shop.errors->count == 1);
  assert_int_equal(shop.errors->first->location.line, 1);
  if (!strstr(shop.errors->first->text, text)) fail_msg("%s", shop.errors->first->text);
}

static void wrong_keys_are_named(void **state) {
  static int twice[2] = {1, 1};
  lam_lamella_keys keys = fixture_keys();
  keys.pair = 0.002;
  assert_message(
      state, keys,
      "2 mm is less than the thickness and twice the clearance: expected 0 or at least 2.5 mm");
  keys = fixture_keys();
  keys.families.items = twice;
  assert_message(state, keys, "expected [0], [1] or [0, 1]");
  keys = fixture_keys();
  keys.extend = 0.003;
  assert_message(
      state, keys,
      "A01 would keep 1.75 mm of material beside a slot, from 0.0 mm after its start on");
  keys = fixture_keys();
  keys.pair = 0.004; /* crossings 4 mm apart, slots 2.5 mm wide: 1.5 mm are left */
  assert_message(state, keys, "A01a would keep 1.50 mm of material beside a slot");
  keys = fixture_keys();
  keys.joint.clearance = 0.01;
  keys.height = 0.05;
  assert_message(state, keys, "10 mm is too much for a height of 50 mm");
}

static void a_family_is_made_once(void **state) {
  lam_workshop shop = plane_shop(state, plane_point);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 1);
  assert_int_equal(shop.part_count, 9);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {TEST(plane_grid_is_exact),
                                     TEST(slots_open_to_their_side),
                                     TEST(stations_and_records),
                                     TEST(clash_of_the_plane_grid),
                                     TEST(slot_width),
                                     TEST(scissor_sweep),
                                     TEST(pairs_share_their_crossings),
                                     TEST(scissoring_pairs),
                                     TEST(pairs_without_scissor_lock),
                                     TEST(every_and_boundary),
                                     TEST(one_family),
                                     TEST(wrong_keys_are_named),
                                     TEST(a_family_is_made_once)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
