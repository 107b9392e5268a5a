/* Where long strips are cut, and what their pieces and splice plates look like. */
#include "core/numbers.h"
#include "fab/flat/lettering.h"
#include "fab/flat/splice.h"
#include "tests/unit/asserts.h"

#include <string.h>

/* A straight strip of 10 m x 0.1 m: an outline and what is added. */
static const lam_vec2 ends[2] = {{0, 0}, {10, 0}};
static const lam_vec2 rectangle[4] = {{0, -.05}, {10, -.05}, {10, .05}, {0, .05}};

typedef struct strip {
  lam_arena *arena;
  lam_paths paths;
  lam_flat flat;
  lam_part part;
  lam_flat_slot slots[4];
} strip;

static strip *strip_new(void) {
  lam_arena *arena = lam_arena_new();
  strip *s = LAM_NEW(arena, strip, 1);
  *s = (strip){.arena = arena, .paths = {.arena = arena}};
  lam_paths_add(&s->paths, LAM_LAYER_CUT, true, 4, rectangle);
  s->flat = (lam_flat){.thickness = .002, .height = .1, .axis_count = 2, .slots = s->slots};
  s->flat.axis = LAM_NEW(arena, lam_vec2, 2);
  memcpy(s->flat.axis, ends, sizeof ends);
  s->part = (lam_part){.name = "A01", .flat = &s->flat};
  lam_flat_set_paths(&s->flat, &s->paths);
  return s;
}

static void add_mark(strip *s, bool closed, int count, const lam_vec2 *points) {
  lam_paths_add(&s->paths, LAM_LAYER_ENGRAVE, closed, count, points);
  lam_flat_set_paths(&s->flat, &s->paths);
}

/* ---- the joint ---- */

/* The largest bolt whose hole (EN 20273, medium) is at most a tenth of the height. */
static void bolts_follow_the_height(void **state) {
  (void)state;
  static const struct {
    double height_mm;
    const char *bolt;
    double hole_mm;
  } cases[] = {{300, "M12", 13.5}, {135, "M12", 13.5}, {134, "M10", 11}, {110, "M10", 11},
               {109, "M8", 9},     {90, "M8", 9},      {89, "M6", 6.6},  {66, "M6", 6.6},
               {65, "M5", 5.5},    {55, "M5", 5.5},    {54, "M4", 4.5},  {45, "M4", 4.5},
               {44, "M3", 3.4},    {34, "M3", 3.4},    {33, "M2", 2.4},  {24, "M2", 2.4},
               {23, "pin", 2.3},   {10, "pin", 1}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_splice splice = lam_splice_for(cases[i].height_mm * 1e-3);
    assert_string_equal(splice.bolt, cases[i].bolt);
    assert_near_named(splice.hole, cases[i].hole_mm * 1e-3, 1e-10, splice.bolt);
  }
}

/* M8 in a strip of 100 mm: end distance 2 holes, spacing 3 holes, 2 holes to the end of the plate;
 * rows at a quarter of the height, the plate four fifths as high. */
static void plates_keep_their_distances(void **state) {
  (void)state;
  lam_splice splice = lam_splice_for(.1);
  assert_near(splice.columns[0], .018, 1e-15);
  assert_near(splice.columns[1], .045, 1e-15);
  assert_near(splice.half, .063, 1e-15);
  assert_near(splice.row, .025, 1e-15);
  assert_near(splice.height, .08, 1e-15);
}

/* ---- where cuts are ---- */

/* Expects these cuts. Half a plate is 63 mm. */
static void assert_cuts(strip *s, double longest, const double *avoid, int avoid_count,
                        double fraction, int expected, const double *at) {
  double *cuts;
  int count = lam_splice_cuts(s->arena, &s->flat, longest, avoid, avoid_count, fraction, &cuts);
  assert_int_equal(count, expected);
  for (int i = 0; i < count; i++) assert_near_named(cuts[i], at[i], 1e-12, "cut");
}

/* One cut for pieces of at most 6 m: from 4 m to 6 m. Two for 4 m: from 2 and 6 m to 4 and 8 m, the
 * second at most 4 m after the first. A cut keeps 63 + 9 mm from the ends. */
static void cuts_have_free_play(void **state) {
  (void)state;
  strip *s = strip_new();
  assert_cuts(s, 11, NULL, 0, .5, 0, NULL);
  assert_cuts(s, 10, NULL, 0, .5, 0, NULL);
  assert_cuts(s, 6, NULL, 0, .25, 1, (double[]){4.5});
  assert_cuts(s, 6, NULL, 0, 1, 1, (double[]){6});
  assert_cuts(s, 4, NULL, 0, .5, 2, (double[]){3, 7});
  assert_cuts(s, 4, NULL, 0, .75, 2, (double[]){3.5, 7.5});
  assert_cuts(s, 3.6, NULL, 0, 0, 2, (double[]){2.8, 6.4});
  assert_cuts(s, 9.99, NULL, 0, 0, 1, (double[]){.072});
  assert_cuts(s, 9.99, NULL, 0, 1, 1, (double[]){9.928});
  lam_arena_free(s->arena);
}

/* A slot from 4.4 to 4.6 m keeps its width of 0.2 m and half a plate free: 4.137 to 4.863 m. The
 * nearer end is taken. With a second one from 4.7 to 4.9 m: to 5.163 m. */
static void cuts_keep_clear_of_slots(void **state) {
  (void)state;
  strip *s = strip_new();
  s->slots[s->flat.slot_count++] = (lam_flat_slot){4.4, 4.6, 0, .05, 4.5};
  assert_cuts(s, 6, NULL, 0, .2, 1, (double[]){4.137});
  assert_cuts(s, 6, NULL, 0, .3, 1, (double[]){4.863});
  assert_cuts(s, 6, NULL, 0, .05, 1, (double[]){4.1});
  s->slots[s->flat.slot_count++] = (lam_flat_slot){4.7, 4.9, 0, .05, 4.8};
  assert_cuts(s, 6, NULL, 0, .3, 1, (double[]){4.137});
  assert_cuts(s, 6, NULL, 0, .4, 1, (double[]){5.163});
  /* the play is 4.2 to 5.8 m: the nearer end is out of it */
  assert_cuts(s, 5.8, NULL, 0, 0, 1, (double[]){5.163});
  /* and from 4 to 4.7 m the play ends in the slot */
  assert_cuts(s, 6, NULL, 0, 1, 1, (double[]){6});
  lam_arena_free(s->arena);
}

/* A mark from 4.45 to 4.55 m keeps half a plate free; a cut of another sheet keeps a plate free. */
static void marks_and_other_cuts_are_avoided(void **state) {
  (void)state;
  strip *s = strip_new();
  const double other[1] = {4.5};
  add_mark(s, false, 2, (lam_vec2[]){{4.55, 0}, {4.45, .01}});
  assert_cuts(s, 6, NULL, 0, .24, 1, (double[]){4.387});
  assert_cuts(s, 6, NULL, 0, .26, 1, (double[]){4.613});
  assert_cuts(s, 6, other, 1, .24, 1, (double[]){4.374});
  assert_cuts(s, 6, other, 1, .26, 1, (double[]){4.626});
  lam_arena_free(s->arena);
}

/* Where there is no room for a cut otherwise, marks are given up first, then the cuts of other
 * sheets, then both; slots never. */
static void wishes_are_given_up_in_turn(void **state) {
  (void)state;
  strip *s = strip_new();
  double everywhere[50];
  for (int i = 0; i < 50; i++) everywhere[i] = 0.1 + 0.2 * i;
  add_mark(s, false, 2, (lam_vec2[]){{4.55, 0}, {4.45, .01}});
  assert_cuts(s, 6, everywhere, 50, .24, 1, (double[]){4.387});
  add_mark(s, false, 2, (lam_vec2[]){{.1, 0}, {9.9, 0}});
  assert_cuts(s, 6, (double[]){4.5}, 1, .24, 1, (double[]){4.374});
  assert_cuts(s, 6, everywhere, 50, .24, 1, (double[]){4.48});
  s->slots[s->flat.slot_count++] = (lam_flat_slot){3, 7, 0, .05, 5};
  assert_cuts(s, 6, NULL, 0, .24, -1, NULL);
  lam_arena_free(s->arena);
}

/* ---- pieces ---- */

static const lam_path *path_of(const lam_piece *piece, lam_layer layer, bool hole, int number) {
  for (int i = 0; i < piece->path_count; i++) {
    const lam_path *path = &piece->paths[i];
    if (path->layer == layer && path->hole == hole && number-- == 0) return path;
  }
  fail_msg("%s has no such path", piece->label);
  return NULL;
}

/* The outline (or another path) has these corners, in any order of beginning. */
static void assert_corners(const lam_path *path, int count, const lam_vec2 *expected) {
  assert_int_equal(path->count, count);
  int shift = -1;
  for (int i = 0; i < count; i++)
    if (hypot(path->points[i].x - expected[0].x, path->points[i].y - expected[0].y) < 1e-12)
      shift = i;
  if (shift < 0) fail_msg("no corner at %g, %g", expected[0].x, expected[0].y);
  for (int i = 0; i < count; i++) {
    assert_near(path->points[(shift + i) % count].x, expected[i].x, 1e-12);
    assert_near(path->points[(shift + i) % count].y, expected[i].y, 1e-12);
  }
}

/* The centers of holes in turn. */
static void assert_holes(const lam_piece *piece, int count, const lam_vec2 *center) {
  int holes = 0;
  for (int i = 0; i < piece->path_count; i++) {
    lam_vec2 min, max;
    if (!piece->paths[i].hole) continue;
    assert_true(holes < count);
    lam_paths_bounds(&piece->paths[i], 1, &min, &max);
    assert_near((min.x + max.x) / 2, center[holes].x, 1e-12);
    assert_near((min.y + max.y) / 2, center[holes].y, 1e-12);
    assert_near(lam_path_area(&piece->paths[i]), LAM_PI / 4 * 81e-6, 1e-12);
    holes++;
  }
  assert_int_equal(holes, count);
}

/* Cut at 4 m and 7 m: three pieces and two plates, drilled 18 and 45 mm from the cuts. */
static void pieces_are_drilled_beside_the_cuts(void **state) {
  (void)state;
  strip *s = strip_new();
  lam_pieces pieces = {.arena = s->arena};
  lam_splice_pieces(&pieces, 7, &s->part, (double[]){4, 7}, 2);
  static const char *const labels[] = {"A01.1", "splice-100", "A01.2", "splice-100", "A01.3"};
  const double hole = LAM_PI / 4 * 81e-6, length[] = {4, .126, 3, .126, 3},
               area[] = {.4 - 4 * hole, .126 * .08 - 8 * hole, .3 - 8 * hole, .126 * .08 - 8 * hole,
                         .3 - 4 * hole};
  assert_int_equal(pieces.count, 5);
  for (int i = 0; i < 5; i++) {
    const lam_piece *piece = &pieces.items[i];
    assert_string_equal(piece->label, labels[i]);
    assert_int_equal(piece->part, i % 2 ? -1 : 7);
    assert_near(piece->length, length[i], 1e-12);
    assert_near(piece->area, area[i], 1e-12);
    assert_near(piece->thickness, .002, 0);
  }
  const lam_vec2 outline[3][4] = {{{0, -.05}, {4, -.05}, {4, .05}, {0, .05}},
                                  {{4, -.05}, {7, -.05}, {7, .05}, {4, .05}},
                                  {{7, -.05}, {10, -.05}, {10, .05}, {7, .05}}};
  for (int i = 0; i < 3; i++)
    assert_corners(path_of(&pieces.items[2 * i], LAM_LAYER_CUT, false, 0), 4, outline[i]);
  assert_holes(&pieces.items[0], 4,
               (lam_vec2[]){{3.982, -.025}, {3.982, .025}, {3.955, -.025}, {3.955, .025}});
  assert_holes(&pieces.items[2], 8,
               (lam_vec2[]){{4.018, -.025},
                            {4.018, .025},
                            {4.045, -.025},
                            {4.045, .025},
                            {6.982, -.025},
                            {6.982, .025},
                            {6.955, -.025},
                            {6.955, .025}});
  assert_corners(path_of(&pieces.items[1], LAM_LAYER_CUT, false, 0), 4,
                 (lam_vec2[]){{-.063, -.04}, {.063, -.04}, {.063, .04}, {-.063, .04}});
  assert_holes(&pieces.items[1], 8,
               (lam_vec2[]){{-.018, -.025},
                            {-.018, .025},
                            {-.045, -.025},
                            {-.045, .025},
                            {.018, -.025},
                            {.018, .025},
                            {.045, -.025},
                            {.045, .025}});
  lam_arena_free(s->arena);
}

/* Every piece is named near both ends, framed; its letters are 20 mm high, those of the plate 16 mm
 * and centered. */
static void pieces_and_plates_are_lettered(void **state) {
  (void)state;
  strip *s = strip_new();
  lam_pieces pieces = {.arena = s->arena};
  lam_splice_pieces(&pieces, 0, &s->part, (double[]){4}, 1);
  double width = lam_lettering_width("A01.1", .02) + .012;
  for (int end = 0; end < 2; end++) {
    const lam_path *frame = path_of(&pieces.items[0], LAM_LAYER_ENGRAVE, false, end);
    assert_near(frame->points[0].x, end ? 3.996 - width : .004, 1e-12);
    assert_near(frame->points[2].x, end ? 3.996 : .004 + width, 1e-12);
    assert_near(frame->points[0].y, -.016, 1e-12); /* between the rows of bolts */
    assert_near(frame->points[2].y, .016, 1e-12);
  }
  lam_vec2 min, max;
  const lam_piece *plate = &pieces.items[1];
  lam_paths_bounds(&plate->paths[9], plate->path_count - 9, &min, &max);
  double size = lam_lettering_width("M8", .016);
  assert_int_equal(plate->paths[9].layer, LAM_LAYER_LABEL);
  assert_near(max.y, .008, 1e-12);
  assert_near(min.y, -.008, 1e-12);
  assert_near(min.x, -size / 2, 1e-12);
  assert_near(max.x, size / 2, 1e-9);
  lam_arena_free(s->arena);
}

/* A mark goes to the piece it lies on; one that lies on several is cut into open strokes. */
static void marks_are_shared_among_the_pieces(void **state) {
  (void)state;
  strip *s = strip_new();
  add_mark(s, false, 2, (lam_vec2[]){{3, .01}, {8, .02}});                      /* over both cuts */
  add_mark(s, false, 2, (lam_vec2[]){{5, 0}, {3, .02}});                        /* backwards */
  add_mark(s, true, 3, (lam_vec2[]){{5, 0}, {6, 0}, {6, .01}});                 /* whole */
  add_mark(s, true, 4, (lam_vec2[]){{6, -.02}, {8, -.02}, {8, .02}, {6, .02}}); /* around a cut */
  lam_pieces pieces = {.arena = s->arena};
  lam_splice_pieces(&pieces, 0, &s->part, (double[]){4, 7}, 2);
  const struct {
    int piece, number, count;
    bool closed;
    lam_vec2 points[4];
  } expected[] = {{0, 0, 2, false, {{3, .01}, {4, .012}}},
                  {2, 0, 2, false, {{4, .012}, {7, .018}}},
                  {4, 0, 2, false, {{7, .018}, {8, .02}}},
                  {2, 1, 2, false, {{5, 0}, {4, .01}}},
                  {0, 1, 2, false, {{4, .01}, {3, .02}}},
                  {2, 2, 3, true, {{5, 0}, {6, 0}, {6, .01}}},
                  {2, 3, 2, false, {{6, -.02}, {7, -.02}}},
                  {4, 1, 4, false, {{7, -.02}, {8, -.02}, {8, .02}, {7, .02}}},
                  {2, 4, 3, false, {{7, .02}, {6, .02}, {6, -.02}}}};
  for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
    const lam_path *path =
        path_of(&pieces.items[expected[i].piece], LAM_LAYER_ENGRAVE, false, expected[i].number);
    assert_int_equal(path->count, expected[i].count);
    assert_int_equal(path->closed, expected[i].closed);
    for (int k = 0; k < path->count; k++) {
      assert_near(path->points[k].x, expected[i].points[k].x, 1e-12);
      assert_near(path->points[k].y, expected[i].points[k].y, 1e-12);
    }
  }
  lam_arena_free(s->arena);
}

/* On an axis that climbs by 3 in 5 a piece is laid down again: its ends lie on a line along x. */
static void pieces_lie_along_x(void **state) {
  (void)state;
  strip *s = strip_new();
  lam_vec2 slanted[4];
  for (int i = 0; i < 4; i++)
    slanted[i] = lam_v2(.8 * rectangle[i].x - .6 * rectangle[i].y,
                        .6 * rectangle[i].x + .8 * rectangle[i].y);
  memcpy(s->paths.items[0].points, slanted, sizeof slanted);
  s->flat.axis[1] = lam_v2(8, 6);
  lam_pieces pieces = {.arena = s->arena};
  lam_splice_pieces(&pieces, 0, &s->part, (double[]){4}, 1);
  assert_corners(path_of(&pieces.items[2], LAM_LAYER_CUT, false, 0), 4,
                 (lam_vec2[]){{4, -.05}, {10, -.05}, {10, .05}, {4, .05}});
  assert_holes(&pieces.items[2], 4,
               (lam_vec2[]){{4.018, -.025}, {4.018, .025}, {4.045, -.025}, {4.045, .025}});
  lam_arena_free(s->arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(bolts_follow_the_height),
      cmocka_unit_test(plates_keep_their_distances),
      cmocka_unit_test(cuts_have_free_play),
      cmocka_unit_test(cuts_keep_clear_of_slots),
      cmocka_unit_test(marks_and_other_cuts_are_avoided),
      cmocka_unit_test(wishes_are_given_up_in_turn),
      cmocka_unit_test(pieces_are_drilled_beside_the_cuts),
      cmocka_unit_test(pieces_and_plates_are_lettered),
      cmocka_unit_test(marks_are_shared_among_the_pieces),
      cmocka_unit_test(pieces_lie_along_x),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
