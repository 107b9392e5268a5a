/* The surface around a vertex, stations on it, and the flat pattern of a strip line by line. */
#include "core/numbers.h"
#include "fab/flat/lettering.h"
#include "fab/lamella/lamella_patch.h"
#include "tests/unit/plane_grid.h"

static void assert_vec(lam_vec3 p, double x, double y, double z, const char *what) {
  if (!(lam_distance(p, lam_v3(x, y, z)) < 1e-12))
    fail_msg("%s: (%.12g, %.12g, %.12g), expected (%.12g, %.12g, %.12g)", what, p.x, p.y, p.z, x, y,
             z);
}

/* A cross of two lines through vertex 0 on z = x y / 2: 1 and 2 along x, 3 and 4 along y. */
static lam_vec3 places[5] = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
static int along_x[3] = {1, 0, 2}, along_y[3] = {3, 0, 4};
static const lam_polyline lines[2] = {{0, false, 3, along_x}, {1, false, 3, along_y}};

/* Normals of that surface are (-y, -x, 2) / sqrt(4 + x^2 + y^2). */
static lam_patch saddle_patch(void) {
  lam_vec3 normals[5];
  lam_net net = {.mesh = {5, places, 0, NULL}};
  for (int v = 0; v < 5; v++) normals[v] = lam_unit(lam_v3(-places[v].y, -places[v].x, 2));
  const lam_polyline *line[2] = {&lines[0], &lines[1]};
  return lam_patch_make(&net, normals, 0, line, (int[2]){1, 1}, 0);
}

/* From difference to difference over 2 m the normal turns by 2/sqrt(5): k = 1/sqrt(5) per meter.
 * Sheets at the distances d (family 0) and e (family 1) cross at A = -e, B = d, at the height
 * k A B; the normal there is (-k B, -k A, 1). */
static void stations_on_a_saddle(void **state) {
  (void)state;
  lam_patch p = saddle_patch();
  double k = 1 / sqrt(5), d = .01, e = -.03;
  assert_vec(p.dn[0], 0, -k, 0, "normals along x");
  assert_vec(p.dn[1], -k, 0, 0, "normals along y");
  assert_near(p.angle, LAM_PI / 2, 1e-15);
  lam_vec3 m = lam_unit(lam_v3(-k * d, k * e, 1)), n = lam_unit(lam_v3(-k * d, 0, 1));
  for (int family = 0; family < 2; family++) {
    lam_station q = lam_patch_crossing(&p, family, family ? e : d, family ? d : e, 0);
    lam_vec3 t = family ? lam_v3(0, 1, 0) : lam_v3(1, 0, 0);
    t = lam_unit(lam_along(t, -lam_dot(t, m), m));
    assert_vec(q.x, -e, d, -k * e * d, "crossing");
    assert_vec(q.m, m.x, m.y, m.z, "its normal");
    assert_vec(q.t, t.x, t.y, t.z, "its direction");
    assert_int_equal(q.partner, -1);
    assert_int_equal(q.crossing, -1);
  }
  lam_station q = lam_patch_station(&p, 0, d);
  assert_vec(q.x, 0, d, 0, "beside the line along x");
  assert_vec(q.m, n.x, n.y, n.z, "its normal");
  assert_vec(lam_patch_station(&p, 1, d).x, -d, 0, 0, "beside the line along y");
}

/* Lines at 60 degrees in a plane: the sheet at d = .01 beside the first line passes the vertex at
 * the foot of the perpendicular, and so does that beside the second. */
static void stations_beside_skew_lines(void **state) {
  (void)state;
  double c = cos(LAM_PI / 3), s = sin(LAM_PI / 3);
  lam_vec3 at[5] = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-c, -s, 0}, {c, s, 0}};
  lam_vec3 normals[5] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  lam_net net = {.mesh = {5, at, 0, NULL}};
  const lam_polyline *line[2] = {&lines[0], &lines[1]};
  lam_patch p = lam_patch_make(&net, normals, 0, line, (int[2]){1, 1}, 0);
  assert_near(p.angle, LAM_PI / 3, 1e-15);
  assert_near(p.sine, s, 1e-15);
  assert_near(p.cosine, c, 1e-15);
  assert_vec(lam_patch_station(&p, 0, .01).x, 0, .01, 0, "left of the first");
  assert_vec(lam_patch_station(&p, 1, .01).x, -.01 * s, .01 * c, 0, "left of the second");
  assert_vec(lam_patch_crossing(&p, 0, .01, 0, 0).x, .01 * c / s, .01, 0, "with its partner");
}

/* Slots for 45 degrees, on sheets at d = .01 and partners at e = .02 that cross at 90: at 45 and at
 * 135 degrees they meet at +-.01 - .02 sqrt(2), and now at -.02. Seen from the other family travel
 * runs against x. Where the second line runs backwards, it is the first family that is mirrored. */
static void slots_open_to_the_side_of_the_turn(void **state) {
  (void)state;
  lam_patch p = saddle_patch();
  double low = -.01 - .02 * sqrt(2) + .02, high = 0;
  lam_station q = lam_patch_crossing(&p, 0, .01, .02, LAM_PI / 4);
  assert_near(q.slot_angle, LAM_PI / 4, 1e-12);
  assert_near(q.slot_low, low, 1e-5); /* the angle on the surface is 90 degrees to 1e-4 */
  assert_near(q.slot_high, .01 - .02 * sqrt(2) + .02, 1e-5);
  q = lam_patch_crossing(&p, 1, .01, .02, LAM_PI / 4);
  assert_near(q.slot_low, -(.01 - .02 * sqrt(2) + .02), 1e-5);
  assert_near(q.slot_high, -low, 1e-5);
  assert_near(high, 0, 0);
  p.sine = -p.sine;
  q = lam_patch_crossing(&p, 0, .01, .02, LAM_PI / 4);
  assert_near(q.slot_high, -low, 1e-5);
}

/* At its end a line leaves as the arc would through the last points: on a circle, along its
 * tangent. Alone, the direction across is square to it; two vertices make a straight line. */
static void lines_end_as_arcs(void **state) {
  (void)state;
  lam_vec3 at[3], normals[3];
  int order[3] = {0, 1, 2};
  for (int i = 0; i < 3; i++) {
    at[i] = lam_v3(sin(.2 * i), cos(.2 * i), 0);
    normals[i] = lam_v3(0, .1 * i, 1);
  }
  lam_net net = {.mesh = {3, at, 0, NULL}};
  for (int family = 0; family < 2; family++) {
    const lam_polyline arc = {family, false, 3, order}, edge = {family, false, 2, order};
    const lam_polyline *line[2] = {family ? NULL : &arc, family ? &arc : NULL};
    for (int i = 0; i < 3; i++) {
      lam_vec3 up[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
      lam_patch p = lam_patch_make(&net, up, i, line, (int[2]){i, i}, family);
      assert_vec(p.t[family], cos(.2 * i), -sin(.2 * i), 0, "along the circle");
      if (family)
        assert_vec(p.t[0], -sin(.2 * i), -cos(.2 * i), 0, "square to the right");
      else
        assert_vec(p.t[1], sin(.2 * i), cos(.2 * i), 0, "square to the left");
      assert_near(p.angle, LAM_PI / 2, 0);
      assert_near(p.sine, 1, 1e-12);
    }
    const lam_polyline *one[2] = {family ? NULL : &edge, family ? &edge : NULL};
    lam_vec3 up[3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    lam_patch p = lam_patch_make(&net, up, 1, one, (int[2]){1, 1}, family);
    assert_vec(p.t[family], cos(.1), -sin(.1), 0, "along the chord");
    /* normals change by .1 over a chord of 2 sin .1, at an end and, by .2, in between */
    p = lam_patch_make(&net, normals, 0, line, (int[2]){0, 0}, family);
    assert_vec(p.dn[family], 0, .1 / (2 * sin(.1)), 0, "change at the start");
    p = lam_patch_make(&net, normals, 1, line, (int[2]){1, 1}, family);
    assert_vec(p.dn[family], 0, .1 / (2 * sin(.1)), 0, "change in between");
  }
}

/* Nearly parallel tangents are no axes: that of the family stays. */
static void parallel_lines_get_an_axis_across(void **state) {
  (void)state;
  lam_vec3 at[5] = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-1, -.01, 0}, {1, .01, 0}};
  lam_vec3 up[5] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  lam_net net = {.mesh = {5, at, 0, NULL}};
  const lam_polyline *line[2] = {&lines[0], &lines[1]};
  lam_patch p = lam_patch_make(&net, up, 0, line, (int[2]){1, 1}, 0);
  assert_vec(p.t[0], 1, 0, 0, "family 0");
  assert_vec(p.t[1], 0, 1, 0, "across it");
  p = lam_patch_make(&net, up, 0, line, (int[2]){1, 1}, 1);
  double r = hypot(1, .01);
  assert_vec(p.t[1], 1 / r, .01 / r, 0, "family 1");
  assert_vec(p.t[0], .01 / r, -1 / r, 0, "across it");
}

/* ---- what is drawn on a strip ---- */

/* The paths of the pattern in turn; those of texts are skipped by the numbers of their strokes. */
static const lam_path *next_on(const lam_flat *flat, lam_layer layer, int *at) {
  while (*at < flat->path_count && flat->paths[*at].layer != layer) ++*at;
  if (*at == flat->path_count) fail_msg("no more paths on layer %d", layer);
  return &flat->paths[(*at)++];
}

static void assert_stroke(const lam_path *path, bool closed, int count, const lam_vec2 *points) {
  assert_int_equal(path->count, count);
  assert_int_equal(path->closed, closed);
  for (int i = 0; i < count; i++)
    if (hypot(path->points[i].x - points[i].x, path->points[i].y - points[i].y) > 1e-7)
      fail_msg("point %d is (%.8f, %.8f), expected (%.8f, %.8f)", i, path->points[i].x,
               path->points[i].y, points[i].x, points[i].y);
}

/* A strip of 2 m x 0.1 m with one crossing in its middle; margin 4 mm, letters 20 mm, sign 16 mm.
 * Family 0 opens up: its tick stands below the floor at -0.25 mm, its names above the middle, the
 * partner's name and the sign below. Family 1 is the same upside down, with a square for a
 * triangle; but writing stays upright. */
static void marks_stand_where_they_are_looked_for(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid = plane_grid(arena, 1, 1, LAM_PI / 2, .1, .0015, 0, .00025, 1);
  for (int family = 0; family < 2; family++) {
    const lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[family]);
    double up = family ? -1 : 1; /* names stand at 25 mm to this side */
    double width = lam_lettering_width(family ? "B01" : "A01", .02) + .012, name = up * .025;
    int at = 0;
    assert_near(flat->slots[0].bottom, family ? -.05 : -.00025, 1e-15);
    assert_near(flat->slots[0].top, family ? .00025 : .05, 1e-15);
    assert_stroke(next_on(flat, LAM_LAYER_ENGRAVE, &at), false, 2,
                  family ? (lam_vec2[]){{1, .00425}, {1, .046}}
                         : (lam_vec2[]){{1, -.046}, {1, -.00425}});
    for (int end = 0; end < 2; end++) {
      double low = end ? 1.996 - width : .004;
      const lam_vec2 frame[4] = {{low, name - .016},
                                 {low + width, name - .016},
                                 {low + width, name + .016},
                                 {low, name + .016}};
      assert_stroke(next_on(flat, LAM_LAYER_ENGRAVE, &at), true, 4, frame);
    }
    double x = .004, y = -name - .008;
    const lam_vec2 shape[4] = {
        {x, y}, {x + .016, y}, {x + (family ? .016 : .008), y + .016}, {x, y + .016}};
    const lam_vec2 shaft[2] = {{x + .0272, y}, {x + .0272, y + .016}};
    const lam_vec2 head[3] = {{x + .0224, y + .0096}, {x + .0272, y + .016}, {x + .032, y + .0096}};
    assert_stroke(next_on(flat, LAM_LAYER_ENGRAVE, &at), true, family ? 4 : 3, shape);
    assert_stroke(next_on(flat, LAM_LAYER_ENGRAVE, &at), false, 2, shaft);
    assert_stroke(next_on(flat, LAM_LAYER_ENGRAVE, &at), false, 3, head);
    const lam_path *letter = next_on(flat, LAM_LAYER_ENGRAVE, &at); /* the U */
    assert_near(letter->points[0].x, x + 2.6 * .016, 1e-7);
    assert_near(letter->points[0].y, y + .016, 1e-7);

    lam_paths own = {.arena = arena}; /* the partner's name follows the own one, written twice */
    lam_lettering_add(&own, LAM_LAYER_LABEL, family ? "B01" : "A01", lam_v2(0, 0), 0, 1);
    at = 0;
    for (int i = 0; i < 2 * own.count; i++) next_on(flat, LAM_LAYER_LABEL, &at);
    lam_paths partner = {.arena = arena};
    lam_lettering_add(&partner, LAM_LAYER_LABEL, family ? "A01" : "B01", lam_v2(1.01, -name - .01),
                      0, .02);
    for (int i = 0; i < partner.count; i++)
      assert_stroke(next_on(flat, LAM_LAYER_LABEL, &at), false, partner.items[i].count,
                    partner.items[i].points);
  }
  lam_arena_free(arena);
}

static int engraved(const lam_flat *flat) {
  int count = 0;
  for (int i = 0; i < flat->path_count; i++) count += flat->paths[i].layer == LAM_LAYER_ENGRAVE;
  return count;
}

static int strokes(lam_arena *arena, const char *text) {
  lam_paths paths = {.arena = arena};
  lam_lettering_add(&paths, LAM_LAYER_LABEL, text, lam_v2(0, 0), 0, 1);
  return paths.count;
}

/* A sheet of a pair says OUT besides: ticks, two frames, symbol, arrow of two strokes, words. */
static void sheets_of_pairs_say_which_side_is_out(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  for (int pair = 0; pair < 2; pair++) {
    lam_lamella_grid *grid =
        plane_grid(arena, 1, 1, LAM_PI / 2, .1, .0015, pair ? .03 : 0, .00025, 1);
    const lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[0]);
    assert_int_equal(engraved(flat),
                     (pair ? 2 : 1) + 2 + 3 + strokes(arena, pair ? "UP OUT" : "UP"));
  }
  lam_arena_free(arena);
}

/* Left of a tick when there is no room on its right: two crossings 50 mm apart, a name of 37 mm.
 * The first one's is on its left: right of it the second tick is too near. */
static void partners_names_change_sides(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid = plane_grid(arena, 2, .05, LAM_PI / 2, .1, .0015, 0, .00025, 1);
  const lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[0]);
  double width = lam_lettering_width("B01", .02);
  int at = 0;
  assert_true(.01 + width + .004 > .05); /* it cannot stand between the ticks */
  for (int i = 0; i < 2 * strokes(arena, "A01"); i++) next_on(flat, LAM_LAYER_LABEL, &at);
  lam_paths partner = {.arena = arena};
  lam_lettering_add(&partner, LAM_LAYER_LABEL, "B01", lam_v2(.99 - width, -.035), 0, .02);
  for (int i = 0; i < partner.count; i++)
    assert_stroke(next_on(flat, LAM_LAYER_LABEL, &at), false, partner.items[i].count,
                  partner.items[i].points);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(stations_on_a_saddle),
      cmocka_unit_test(stations_beside_skew_lines),
      cmocka_unit_test(slots_open_to_the_side_of_the_turn),
      cmocka_unit_test(lines_end_as_arcs),
      cmocka_unit_test(parallel_lines_get_an_axis_across),
      cmocka_unit_test(marks_stand_where_they_are_looked_for),
      cmocka_unit_test(sheets_of_pairs_say_which_side_is_out),
      cmocka_unit_test(partners_names_change_sides),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
