/* Flat patterns of lamellas: lengths, slots, areas, marks. */
#include "core/numbers.h"
#include "plane_grid.h"

#include "fab/flat/lettering.h"
#include "fab/flat/path.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static const lam_path *outline_of(const lam_flat *flat) {
  const lam_path *found = NULL;
  for (int i = 0; i < flat->path_count; i++)
    if (flat->paths[i].layer == LAM_LAYER_CUT) {
      assert_null(found);
      found = &flat->paths[i];
    }
  assert_non_null(found);
  assert_true(found->closed && !found->hole);
  return found;
}

/* width = t (1 + |cos a|) / sin a + 2 c; the slot is half as deep as the strip is high, and the
 * clearance deeper. */
static double slot_area(const lam_lamella_grid *grid, double a) {
  return (grid->thickness * (1 + fabs(cos(a))) / sin(a) + 2 * grid->clearance) *
         (grid->height / 2 + grid->clearance);
}

/* Expected: area L h - n slots; 4 + 4 n corners; bounds L x h. */
static void outline_is_a_rectangle_with_slots(void **state) {
  (void)state;
  const double angles[] = {90 * LAM_DEGREE, 60 * LAM_DEGREE, 125 * LAM_DEGREE};
  for (int k = 0; k < 3; k++) {
    lam_arena *arena = lam_arena_new();
    lam_lamella_grid *grid = plane_grid(arena, 7, 0.05, angles[k], 0.02, 0.001, 0, 0.0001, 0.03);
    for (int i = 0; i < grid->strip_count; i++) {
      lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[i]);
      const lam_path *outline = outline_of(flat);
      assert_int_equal(outline->count, 4 + 4 * 7);
      assert_near(lam_path_area(outline), 0.36 * 0.02 - 7 * slot_area(grid, angles[k]), 1e-12);
      assert_near(flat->max.x - flat->min.x, 0.36, 1e-12);
      assert_near(flat->max.y - flat->min.y, 0.02, 1e-12);
      assert_int_equal(flat->slot_count, 7);
      for (int s = 0; s < 7; s++) assert_near(flat->slots[s].at, 0.03 + 0.05 * s, 1e-12);
    }
    lam_arena_free(arena);
  }
}

/* Family 0 opens up and its slots end the clearance below the middle; family 1 the other way round.
 */
static void slots_open_by_family(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid =
      plane_grid(arena, 3, 0.05, 90 * LAM_DEGREE, 0.02, 0.001, 0, 0.0001, 0.03);
  for (int i = 0; i < grid->strip_count; i++) {
    lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[i]);
    const lam_path *outline = outline_of(flat);
    double side = grid->strips[i].family == 0 ? 1 : -1;
    int floor_points = 0, top = 0, bottom = 0;
    for (int k = 0; k < outline->count; k++) {
      floor_points += fabs(outline->points[k].y + side * 0.0001) < 1e-12;
      top += fabs(outline->points[k].y - side * 0.01) < 1e-12;
      bottom += fabs(outline->points[k].y + side * 0.01) < 1e-12;
    }
    assert_int_equal(floor_points, 6); /* two per slot */
    assert_int_equal(top, 6 + 2);
    assert_int_equal(bottom, 2);
  }
  lam_arena_free(arena);
}

/* The sheets of a pair are the same part seen from the other side: the pattern of the one with
 * positive offset runs from its end to its start, so that slot `at` is the length less the arc
 * length of the station. */
static void second_sheet_is_reversed(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid =
      plane_grid(arena, 3, 0.5, 70 * LAM_DEGREE, 0.1, 0.0015, 0.025, 0.00025, 0.2);
  for (int i = 0; i < grid->strip_count; i++) {
    const lam_sheet_strip *strip = &grid->strips[i];
    lam_flat *flat = lam_lamella_flat(arena, grid, strip);
    assert_int_equal(flat->reversed, strip->offset > 0);
    assert_int_equal(flat->slot_count, 6);
    for (int k = 0; k < 6; k++) {
      double s = strip->stations[flat->reversed ? 6 - k : 1 + k].s;
      assert_near(flat->slots[k].at, flat->reversed ? strip->length - s : s, 1e-12);
    }
  }
  lam_arena_free(arena);
}

/* A slot widened to one side for erection, [low - w/2, high + w/2] about its station, keeps its
 * sides when the pattern is reversed: the wide side changes over. */
static void widened_slots_keep_their_side(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid =
      plane_grid(arena, 1, 0.5, 90 * LAM_DEGREE, 0.1, 0.0015, 0.025, 0.00025, 0.2);
  double half = 0.0015 / 2 + 0.00025;
  for (int i = 0; i < grid->strip_count; i++) {
    lam_sheet_strip *strip = &grid->strips[i];
    strip->stations[1].slot_low = -0.001;
    strip->stations[1].slot_high = 0.004;
    lam_flat *flat = lam_lamella_flat(arena, grid, strip);
    const lam_flat_slot *slot = &flat->slots[flat->reversed ? 1 : 0];
    assert_near(slot->at - slot->low, half + (flat->reversed ? 0.004 : 0.001), 1e-12);
    assert_near(slot->high - slot->at, half + (flat->reversed ? 0.001 : 0.004), 1e-12);
  }
  lam_arena_free(arena);
}

/* A strip that stands on a circle with m in the circle's plane, outward for side 1, inward for side
 * -1, cannot be straightened: it is a sector of a ring. */
static lam_flat *ring_flat(lam_arena *arena, double radius, double arc, int n, double offset,
                           double side) {
  lam_lamella_grid *grid = LAM_NEW(arena, lam_lamella_grid, 1);
  lam_sheet_strip *strips = LAM_NEW(arena, lam_sheet_strip, 2);
  *grid = (lam_lamella_grid){.height = 0.1,
                             .thickness = 0.002,
                             .clearance = 0.0005,
                             .pair = fabs(offset) * 2,
                             .strip_count = 2,
                             .strips = strips,
                             .material = &lam_materials[0]};
  strips[0] = (lam_sheet_strip){.name = "A01",
                                .station_count = n,
                                .offset = offset,
                                .stations = LAM_NEW(arena, lam_station, n)};
  strips[1].name = "B01";
  for (int i = 0; i < n; i++) {
    double a = arc * i / (n - 1);
    lam_station *station = &strips[0].stations[i];
    *station = (lam_station){.x = {radius * sin(a), 0, radius * cos(a)},
                             .t = {cos(a), 0, -sin(a)},
                             .m = {side * sin(a), 0, side * cos(a)},
                             .heading = -side * a,
                             .partner = -1,
                             .crossing = -1};
    station->s = 2 * radius * sin(arc / (n - 1) / 2) * i;
    if (i != (n - 1) / 2) continue;
    station->partner = 1;
    station->slot_angle = station->angle = 90 * LAM_DEGREE;
  }
  strips[0].length = strips[0].stations[n - 1].s;
  return lam_lamella_flat(arena, grid, &strips[0]);
}

/* Expected: axis points on a circle of the same radius, ends on the x axis, rise R (1 -
 * cos(arc/2)), area L h less the slot (a chord polygon: relative error about (arc/n)^2/8), the
 * middle slot exactly as wide as it must be. */
static void bent_strips_keep_their_shape(void **state) {
  (void)state;
  const double radius = 2, arc = 1.2, offsets[] = {0, 0.01};
  for (int k = 0; k < 2; k++) {
    lam_arena *arena = lam_arena_new();
    lam_flat *flat = ring_flat(arena, radius, arc, 81, offsets[k], 1);
    assert_int_equal(flat->axis_count, 83); /* one more at both ends */
    lam_vec2 first = flat->axis[0], last = flat->axis[82], middle = flat->axis[41];
    assert_near(first.x, 0, 1e-9);
    assert_near(first.y, 0, 1e-9);
    assert_near(last.x, 2 * radius * sin(arc / 2), 1e-6);
    assert_near(last.y, 0, 1e-9);
    assert_near(middle.y, radius * (1 - cos(arc / 2)), 1e-4); /* up is up, reversed or not */
    double length = radius * arc, expected = length * 0.1 - 0.003 * (0.05 + 0.0005);
    assert_near(lam_path_area(outline_of(flat)) / expected, 1, 1e-4);
    const lam_path *outline = outline_of(flat);
    double widest = 0;
    for (int i = 0; i < outline->count; i++) {
      lam_vec2 a = outline->points[i], b = outline->points[(i + 1) % outline->count];
      if (fabs(a.y - (middle.y - 0.0005)) < 1e-9 && fabs(b.y - a.y) < 1e-9)
        widest = fabs(b.x - a.x);
    }
    assert_near(widest, 0.003, 1e-9); /* 2 mm and twice .5 mm */
    lam_arena_free(arena);
  }
}

/* ---- marks ---- */
static bool inside(const lam_path *outline, lam_vec2 p) {
  bool in = false;
  for (int i = 0, j = outline->count - 1; i < outline->count; j = i++) {
    lam_vec2 a = outline->points[i], b = outline->points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

static double turn(lam_vec2 a, lam_vec2 b, lam_vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool crosses(lam_vec2 a, lam_vec2 b, lam_vec2 c, lam_vec2 d) {
  return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

/* Every stroke of every mark starts in the material and never meets its edge, slots included. */
static void check_marks(const lam_flat *flat) {
  const lam_path *outline = outline_of(flat);
  for (int i = 0; i < flat->path_count; i++) {
    const lam_path *path = &flat->paths[i];
    if (path == outline) continue;
    assert_true(path->layer == LAM_LAYER_ENGRAVE || path->layer == LAM_LAYER_LABEL);
    assert_true(inside(outline, path->points[0]));
    for (int k = 0; k + 1 < path->count; k++)
      for (int e = 0; e < outline->count; e++)
        assert_false(crosses(path->points[k], path->points[k + 1], outline->points[e],
                             outline->points[(e + 1) % outline->count]));
  }
}

static int strokes(lam_arena *arena, const char *text) {
  lam_paths paths = {.arena = arena};
  lam_lettering_add(&paths, LAM_LAYER_LABEL, text, lam_v2(0, 0), 0, 1);
  return paths.count;
}

static int on_layer(const lam_flat *flat, lam_layer layer) {
  int count = 0;
  for (int i = 0; i < flat->path_count; i++) count += flat->paths[i].layer == layer;
  return count;
}

/* Roomy and crowded strips, single and in pairs: all marks lie in the material, and all names are
 * there: the own name twice, and one per crossing. */
static void marks_are_complete_and_inside(void **state) {
  (void)state;
  const struct {
    int n;
    double spacing, angle, height, thickness, pair, extend;
  } cases[] = {{7, 0.05, 90, 0.02, 0.001, 0, 0.03},
               {15, 0.65, 90, 0.1, 0.0015, 0.025, 0.1},
               {12, 0.02, 60, 0.02, 0.001, 0, 0.008},
               {6, 0.05, 45, 0.1, 0.0015, 0.02, 0.05},
               {9, 0.3, 120, 0.12, 0.003, 0.03, 0.045}};
  for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
    lam_arena *arena = lam_arena_new();
    lam_lamella_grid *grid =
        plane_grid(arena, cases[c].n, cases[c].spacing, cases[c].angle * LAM_DEGREE,
                   cases[c].height, cases[c].thickness, cases[c].pair, 0.0001, cases[c].extend);
    for (int i = 0; i < grid->strip_count; i++) {
      const lam_sheet_strip *strip = &grid->strips[i];
      lam_flat *flat = lam_lamella_flat(arena, grid, strip);
      check_marks(flat);
      int expected = 2 * strokes(arena, strip->name);
      for (int k = 0; k < strip->station_count; k++)
        if (strip->stations[k].partner >= 0)
          expected += strokes(arena, grid->strips[strip->stations[k].partner].name);
      if (on_layer(flat, LAM_LAYER_LABEL) != expected)
        fail_msg("case %d: names are missing on %s", (int)c, strip->name);
      assert_true(on_layer(flat, LAM_LAYER_ENGRAVE) >=
                  flat->slot_count + 2 + 3); /* ticks, frames, sign */
    }
    lam_arena_free(arena);
  }
}

static void marks_follow_a_bent_strip(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  check_marks(ring_flat(arena, 2, 1.2, 81, 0, 1));
  check_marks(ring_flat(arena, 2, 1.2, 81, 0.01, -1));
  lam_arena_free(arena);
}

/* At a crossing the tick stands where the partner's middle line is, also when the slot is widened
 * to one side. */
static void ticks_stand_at_the_partner(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_lamella_grid *grid = plane_grid(arena, 2, 0.5, 90 * LAM_DEGREE, 0.1, 0.0015, 0, 0.00025, 0.2);
  grid->strips[0].stations[1].slot_high = 0.01;
  lam_flat *flat = lam_lamella_flat(arena, grid, &grid->strips[0]);
  int found = 0;
  for (int i = 0; i < flat->path_count; i++) {
    const lam_path *path = &flat->paths[i];
    if (path->layer != LAM_LAYER_ENGRAVE || path->count != 2 ||
        path->points[1].y - path->points[0].y < 0.03)
      continue;
    assert_near(path->points[0].x, found ? 0.7 : 0.2, 1e-12);
    assert_near(path->points[1].x, path->points[0].x, 1e-12);
    found++;
  }
  assert_int_equal(found, 2);
  lam_arena_free(arena);
}

/* Every part of the grid gets its pattern through the workshop, and a workshop without lamellas is
 * left alone. */
static void workshop_parts_get_their_flats(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_workshop workshop = {.arena = arena};
  lam_lamella_flats(&workshop);
  workshop.lamella_grid = plane_grid(arena, 3, 0.5, 90 * LAM_DEGREE, 0.1, 0.0015, 0, 0.00025, 0.2);
  workshop.part_count = 6;
  workshop.parts = LAM_NEW(arena, lam_part, 6);
  lam_lamella_flats(&workshop);
  for (int i = 0; i < 6; i++) {
    assert_non_null(workshop.parts[i].flat);
    assert_near(workshop.parts[i].flat->thickness, 0.0015, 0);
    assert_near(workshop.parts[i].flat->height, 0.1, 0);
  }
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(outline_is_a_rectangle_with_slots),
      cmocka_unit_test(slots_open_by_family),
      cmocka_unit_test(second_sheet_is_reversed),
      cmocka_unit_test(widened_slots_keep_their_side),
      cmocka_unit_test(bent_strips_keep_their_shape),
      cmocka_unit_test(marks_are_complete_and_inside),
      cmocka_unit_test(marks_follow_a_bent_strip),
      cmocka_unit_test(ticks_stand_at_the_partner),
      cmocka_unit_test(workshop_parts_get_their_flats),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
