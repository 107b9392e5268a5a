/* The curve that all lengths of a lamella are taken from, against curves and surfaces whose lengths
 * and curvatures have a closed form. */
#include "core/numbers.h"
#include "fab/flat/path.h"
#include "fab/lamella/lamella_curve.h"
#include "fab/lamella/lamella_flat.h"
#include "fab_fixture.h"
#include "tests/unit/asserts.h"

enum { N = 13 };

/* A point of a curve, its unit height direction, and the arc length from 0. */
typedef struct probe {
  lam_vec3 x, m;
  double s;
} probe;

/* A helix of radius r on the helicoid of pitch 1, an asymptotic line of it: the length is
 * t sqrt(r^2 + 1); the normal of (r cos t, r sin t, t) is (sin t, -cos t, r). */
static probe helix(double t) {
  double r = 2.5;
  lam_vec3 m = lam_unit(lam_v3(sin(t), -cos(t), r));
  return (probe){lam_v3(r * cos(t), r * sin(t), t), m, t * hypot(r, 1)};
}

/* A meridian of the catenoid of radius cosh z, z = t/2: the length is sinh z. */
static probe catenary(double t) {
  double z = t / 2;
  return (probe){lam_v3(cosh(z), 0, z), lam_unit(lam_v3(1, 0, -sinh(z))), sinh(z)};
}

/* A helix on the cylinder of radius 2 m, up by 45 degrees; m is the normal of the cylinder. */
static probe cylinder(double t) {
  return (probe){lam_v3(2 * cos(t), 2 * sin(t), 2 * t), lam_v3(cos(t), sin(t), 0), 2 * sqrt(2) * t};
}

/* The parallel at 40 degrees on the sphere of radius 3.8298 m. */
static probe parallel(double t) {
  double a = 40 * LAM_DEGREE, R = 3.8298;
  lam_vec3 m = lam_v3(cos(a) * cos(t), cos(a) * sin(t), sin(a));
  return (probe){lam_scale(m, R), m, R * cos(a) * t};
}

/* The curve through N places, t from 0 to 2. */
static lam_strip_curve through(lam_arena *arena, probe (*f)(double)) {
  lam_vec3 x[N], m[N];
  for (int i = 0; i < N; i++) x[i] = f(2. * i / (N - 1)).x, m[i] = f(2. * i / (N - 1)).m;
  return lam_strip_curve_make(arena, N, x, m);
}

static void lengths_are_those_of_the_smooth_curve(void **state) {
  probe (*const curves[])(double) = {helix, catenary, cylinder, parallel};
  for (int k = 0; k < 4; k++) {
    lam_strip_curve c = through(*state, curves[k]);
    double all = curves[k](2).s;
    for (int i = 0; i < N; i++)
      assert_near(c.s[i] / all, curves[k](2. * i / (N - 1)).s / all, 1e-6);
  }
}

/* Places two by two, 1/40 apart, as the sheets of a pair have them: the same lengths. */
static void places_need_not_be_even(void **state) {
  probe (*const curves[])(double) = {helix, catenary, cylinder, parallel};
  for (int k = 0; k < 4; k++) {
    lam_vec3 x[2 * N], m[2 * N];
    double s[2 * N];
    for (int i = 0; i < 2 * N; i++) {
      probe p = curves[k](2. * (i / 2) / (N - 1) + (i % 2 ? 1 / 240. : -1 / 240.));
      x[i] = p.x, m[i] = p.m, s[i] = p.s;
    }
    lam_strip_curve c = lam_strip_curve_make(*state, 2 * N, x, m);
    for (int i = 0; i < 2 * N; i++)
      assert_near(c.s[i] / s[2 * N - 1], (s[i] - s[0]) / s[2 * N - 1], 1e-6);
  }
}

/* Straight where the normal curvature is 0 (helices of the helicoid); a circle of the sphere's
 * radius on the sphere, whatever circle the strip stands on (spec of developments: every circle
 * of a sphere unrolls to its radius); of radius 2 R on the cylinder at 45 degrees. Bends towards
 * the inside, away from m. */
static void headings_follow_the_normal_curvature(void **state) {
  lam_strip_curve c = through(*state, helix), sphere = through(*state, parallel),
                  tube = through(*state, cylinder);
  for (int i = 0; i < N; i++) {
    assert_near(c.heading[i], 0, 1e-8);
    assert_near(sphere.flat[i], -1 / 3.8298, 1e-14);
    assert_near(sphere.heading[i], -sphere.s[i] / 3.8298, 1e-13);
    /* 2 m.E/|E|^2 for a turn of a between neighbors, which tends to 1 / (2 R) */
    double a = 1. / 6, exact = 1 / (2 + a * a / (1 - cos(a)));
    assert_near(tube.flat[i], -exact, 1e-12);
  }
}

/* Between places of the parallel, .49 m apart, to 1e-6 of the radius, with its directions; steps
 * keep chords within the sag they are asked for: k d^2/8, on the outer edge 1 + k h/2 of it. */
static void stations_between_places_lie_on_the_curve(void **state) {
  lam_strip_curve c = through(*state, parallel);
  double length = c.s[N - 1], a = 40 * LAM_DEGREE, R = 3.8298;
  for (int i = 0; i <= 100; i++) {
    double s = length * i / 100, t = s / (R * cos(a));
    lam_station q = lam_strip_curve_station(&c, s);
    probe exact = parallel(t);
    assert_near(lam_distance(q.x, exact.x), 0, 4e-6);
    assert_near(lam_distance(q.m, exact.m), 0, 2e-5);
    assert_near(lam_distance(q.t, lam_v3(-sin(t), cos(t), 0)), 0, 5e-5);
    assert_near(q.heading, -s / R, 1e-13);
    assert_int_equal(q.vertex, -1);
    assert_int_equal(q.partner, -1);
  }
  double k = 1 / (R * cos(a)), piece = c.s[4] - c.s[3], sag = .05e-3;
  int steps = lam_strip_curve_steps(&c, c.s[3], c.s[4], .2, sag);
  double most = sqrt(8 * sag / (k * (1 + k * .1)));
  assert_true(piece / steps <= most * (1 + 1e-3) && piece / (steps - 1) > most * (1 - 1e-3));
}

/* A straight line and a corner: lengths are those of the chords, or hardly more. */
static void corners_are_not_overshot(void **state) {
  const lam_vec3 m[6] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                 line[6] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2.5, 0, 0}, {4, 0, 0}, {5, 0, 0}},
                 corner[6] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0}};
  lam_strip_curve c = lam_strip_curve_make(*state, 6, line, m);
  assert_near(c.s[5], 5, 1e-14);
  c = lam_strip_curve_make(*state, 6, corner, m);
  assert_true(c.s[5] >= 5 && c.s[5] < 5.2);
  c = lam_strip_curve_make(*state, 2, corner, m);
  assert_near(c.s[1], 1, 1e-15);
}

/* ---- on nets: everything that is made has the same length ---- */

/* The helicoid with straight rulings and helices; v from 0 to 2 in 12 steps, r from .5 to 2.5. */
static lam_vec3 helicoid(double u, double v) {
  double r = 1.5 + u, t = 1 + v;
  return lam_v3(r * cos(t), r * sin(t), t);
}

/* The outermost helix is 2 sqrt(2.5^2 + 1) long; the strip runs on by .1 m at both ends. The part,
 * its record, its pattern and its nodes say so; the polyline of its solid's sections is shorter
 * by a third of the sag over the radius (2e-6 here), where the chords of the net are by 1e-3. */
static void all_that_is_made_has_one_length(void **state) {
  lam_mesh mesh = fixture_grid(*state, 9, 13, helicoid);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 0);
  double exact = 2 * hypot(2.5, 1), solid = 0;
  const lam_part *part = &shop.parts[shop.part_count - 1];
  assert_near(part->length / (exact + .2), 1, 1e-7);
  assert_near(part->flat->axis[part->flat->axis_count - 1].x / (exact + .2), 1, 1e-7);
  for (int i = 0; i < 13; i++)
    assert_near(part->flat->slots[i].at, .1 + exact * i / 12, exact * 1e-7);

  const lam_sheet_strip *strip = &shop.lamella_grid->strips[shop.part_count - 1];
  assert_int_equal(part->record->rows, strip->station_count);
  assert_near(part->record->values[15 * (strip->station_count - 1) + 9], part->length, 0);
  for (int i = 1; i < strip->station_count; i++)
    solid += lam_distance(strip->stations[i - 1].x, strip->stations[i].x);
  assert_near(solid / (exact + .2), 1, 1e-5);
  for (int i = 0, n = 0; i < shop.crossing_count; i++)
    if (shop.crossings[i].parts[1] == shop.part_count - 1)
      assert_near(shop.crossings[i].along[1], .1 + exact * n++ / 12, exact * 1e-7);
  assert_true(fixture_measure(&shop, "lamellas", "length_error")->max < 1e-6);
}

/* The place of a node on each sheet is the middle of its two slots there, from the start of that
 * sheet: on families that cross at 60 degrees the sheets of a pair begin pair/tan 60 apart. */
static lam_vec3 skew(double u, double v) { return lam_v3(1.5 * u + v, 2 * v * sin(LAM_PI / 3), 0); }

static void nodes_have_a_place_on_every_sheet(void **state) {
  lam_mesh mesh = fixture_grid(*state, 4, 5, skew);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.pair = .025;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.crossing_count, 20);
  for (int i = 0; i < 20; i++)
    for (int f = 0; f < 2; f++)
      for (int k = 0; k < 2; k++) {
        const lam_crossing *c = &shop.crossings[i];
        const lam_flat *flat = shop.parts[c->parts[f] + k].flat;
        double length = shop.parts[c->parts[f] + k].length, along = k ? c->second[f] : c->along[f];
        if (flat->reversed) along = length - along;
        int first = f ? i / 4 : i % 4;
        if (flat->reversed) first = (f ? 4 : 3) - first;
        assert_near((flat->slots[2 * first].at + flat->slots[2 * first + 1].at) / 2, along, 1e-12);
        assert_near(flat->slots[2 * first + 1].at - flat->slots[2 * first].at,
                    .025 / sin(LAM_PI / 3), 1e-12);
      }
}

/* The sphere of radius 2 m in steps of 8 degrees. */
static lam_vec3 sphere(double u, double v) {
  double a = u * 48 * LAM_DEGREE, b = v * 40 * LAM_DEGREE;
  return lam_v3(2 * cos(b) * cos(a), 2 * cos(b) * sin(a), 2 * sin(b));
}

/* Distance of p from the segment a b. */
static double distance_to(lam_vec2 p, lam_vec2 a, lam_vec2 b) {
  double dx = b.x - a.x, dy = b.y - a.y;
  double t = fmin(1, fmax(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy)));
  return hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

/* A strip inside a sphere is cut along circles of radius R -+ h/2 (m points outwards, so that the
 * upper edge is the outer one): every point of them lies within .05 mm of the outline, and the
 * other way round; the slots are left out. */
static void outlines_are_within_a_twentieth_of_a_millimeter(void **state) {
  lam_mesh mesh = fixture_grid(*state, 13, 11, sphere);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  keys.joint.kind = LAM_JOINT_NONE;
  keys.extend = 0;
  fixture_make(&shop, "lamella", &keys);
  assert_int_equal(shop.errors->count, 0);
  const lam_flat *flat = shop.parts[3].flat; /* a parallel, at 16 degrees */
  const lam_path *outline = &flat->paths[0];
  double length = shop.parts[3].length, half = length / 4, side = flat->axis[1].y > 0 ? 1 : -1;
  lam_vec2 center = {2 * sin(half), -side * 2 * cos(half)};
  for (int i = 0; i <= 2000; i++)
    for (int edge = -1; edge <= 1; edge += 2) {
      double a = half * (i / 1000. - 1), r = 2 + edge * .05, nearest = 1;
      lam_vec2 p = {center.x + r * sin(a), center.y + side * r * cos(a)};
      for (int k = 0; k < outline->count; k++)
        nearest = fmin(
            nearest, distance_to(p, outline->points[k], outline->points[(k + 1) % outline->count]));
      if (nearest > .05e-3) fail_msg("%g mm at %g rad", nearest * 1e3, a);
    }
}

/* A strip that bends in its own plane is cut as it develops: nothing is left to be straightened. A
 * strip that is cut straight is forced into its curve by h/2 times its curvature. */
static void only_what_is_cut_straight_is_straightened(void **state) {
  lam_mesh mesh = fixture_grid(*state, 13, 11, sphere);
  lam_workshop shop = fixture_workshop(*state, &mesh);
  lam_lamella_keys keys = fixture_keys();
  fixture_make(&shop, "lamella", &keys);
  assert_near(fixture_measure(&shop, "lamellas", "straightening_strain")->max, 0, 0);
  assert_true(fixture_measure(&shop, "lamellas", "sheet_straightness")->max > .1);
}

int main(void) {
#define TEST(name) cmocka_unit_test_setup_teardown(name, fixture_setup, fixture_teardown)
  const struct CMUnitTest tests[] = {TEST(lengths_are_those_of_the_smooth_curve),
                                     TEST(places_need_not_be_even),
                                     TEST(headings_follow_the_normal_curvature),
                                     TEST(stations_between_places_lie_on_the_curve),
                                     TEST(corners_are_not_overshot),
                                     TEST(all_that_is_made_has_one_length),
                                     TEST(nodes_have_a_place_on_every_sheet),
                                     TEST(outlines_are_within_a_twentieth_of_a_millimeter),
                                     TEST(only_what_is_cut_straight_is_straightened)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
