/* Sheets from hand-made parts: where every piece comes to lie, what the kerf does, which stock is
 * asked for, where long parts are cut. */
#include "core/numbers.h"
#include "fab/flat/path.h"
#include "fab/flat/sheet.h"
#include "tests/unit/asserts.h"

#include <string.h>

/* A rectangle from the origin, with a hole of this diameter in its middle (0: none). */
static lam_flat *plate(lam_arena *arena, double width, double height, double hole) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4,
                (lam_vec2[]){{0, 0}, {width, 0}, {width, height}, {0, height}});
  if (hole > 0) lam_paths_hole(&paths, lam_v2(width / 2, height / 2), hole);
  flat->thickness = .002;
  lam_flat_set_paths(flat, &paths);
  return flat;
}

/* A straight strip of 10 m x 0.1 m about the x axis. */
static lam_flat *strip(lam_arena *arena, bool reversed) {
  lam_flat *flat = LAM_NEW(arena, lam_flat, 1);
  lam_paths paths = {.arena = arena};
  lam_paths_add(&paths, LAM_LAYER_CUT, true, 4,
                (lam_vec2[]){{0, -.05}, {10, -.05}, {10, .05}, {0, .05}});
  lam_flat_set_paths(flat, &paths);
  flat->thickness = .002;
  flat->height = .1;
  flat->reversed = reversed;
  flat->axis_count = 2;
  flat->axis = LAM_NEW(arena, lam_vec2, 2);
  flat->axis[1] = lam_v2(10, 0);
  return flat;
}

static const lam_material steel = {.name = "steel"}, oak = {.name = "oak"};

static void assert_bounds(const lam_path *path, double x0, double y0, double x1, double y1) {
  lam_vec2 min, max;
  lam_paths_bounds(path, 1, &min, &max); /* rounded to nanometers by the kerf */
  if (fmax(fmax(fabs(min.x - x0), fabs(min.y - y0)), fmax(fabs(max.x - x1), fabs(max.y - y1))) >
      3e-9)
    fail_msg("from %.9f, %.9f to %.9f, %.9f; expected %.9f, %.9f to %.9f, %.9f", min.x, min.y,
             max.x, max.y, x0, y0, x1, y1);
}

typedef struct table {
  lam_arena *arena;
  lam_errors errors;
  lam_part parts[6];
  lam_sheets sheets;
} table;

static void lay(table *t, int count, lam_sheet_options options) {
  t->errors = (lam_errors){.arena = t->arena};
  t->sheets =
      lam_sheets_make(t->arena, t->parts, count, options, (lam_location){"d", 3, 1}, &t->errors);
}

/* Two of 300 x 100 mm with a hole of 20 mm, one of 200 x 50 mm, one of oak; kerf 1 mm, margin 10
 * mm, spacing 4 mm. Outlines grow by half the kerf on every side, and holes shrink by it. */
static table four_parts(void) {
  table t = {.arena = lam_arena_new()};
  t.parts[0] = (lam_part){.name = "A", .material = &steel, .instance_count = 2, .length = .3};
  t.parts[1] = (lam_part){.name = "B", .material = &steel};
  t.parts[2] = (lam_part){.name = "no pattern", .material = &steel};
  t.parts[3] = (lam_part){.name = "C", .material = &oak};
  t.parts[0].flat = plate(t.arena, .3, .1, .02);
  t.parts[1].flat = plate(t.arena, .2, .05, 0);
  t.parts[3].flat = plate(t.arena, .1, .1, 0);
  return t;
}

static void pieces_lie_where_they_fit(void **state) {
  (void)state;
  table t = four_parts();
  lay(&t, 4, (lam_sheet_options){{1, .5}, .001, .01, .004});
  assert_int_equal(t.errors.count, 0);
  assert_int_equal(t.sheets.count, 2);
  const lam_sheet *sheet = &t.sheets.sheets[0], *second = sheet + 1;
  assert_string_equal(sheet->name, "sheet-01");
  assert_string_equal(second->name, "sheet-02");
  assert_true(sheet->material == &steel && second->material == &oak);
  for (int i = 0; i < 2; i++) {
    assert_near(sheet[i].width, 1, 0);
    assert_near(sheet[i].height, .5, 0);
    assert_near(sheet[i].kerf, .001, 0);
    assert_near(sheet[i].thickness, .002, 0);
    assert_int_equal(sheet[i].piece_count, i ? 1 : 3);
  }
  static const char *const labels[] = {"A", "A", "B"};
  static const int part[] = {0, 0, 1};
  static const double x[] = {.01, .315, .62}, width[] = {.301, .301, .201},
                      height[] = {.101, .101, .051};
  const double hole = LAM_PI / 4 * .0004, area[] = {.03 - hole, .03 - hole, .01};
  for (int i = 0; i < 3; i++) {
    const lam_sheet_piece *piece = &sheet->placed[i];
    assert_string_equal(piece->label, labels[i]);
    assert_int_equal(piece->part, part[i]);
    assert_near(piece->area, area[i], 1e-12);
    assert_near(piece->length, i < 2 ? .3 : 0, 0);
    assert_bounds(&piece->paths[0], x[i], .01, x[i] + width[i], .01 + height[i]);
  }
  assert_near(sheet->used, (.07 - 2 * hole) / .5, 1e-12);
  assert_bounds(&second->placed[0].paths[0], .01, .01, .111, .111);

  /* The hole: a circle whose radius is half a kerf smaller, and 48 corners that enclose its area:
   * they lie at sqrt(pi/24 / sin(pi/24)) of the radius. */
  const lam_path *round = &sheet->placed[1].paths[1];
  assert_true(round->hole);
  assert_near(round->radius, .0095, 1e-15);
  assert_near(fabs(lam_path_area(round)), LAM_PI * .0095 * .0095, 1e-12);
  double reach = .0095 * sqrt(LAM_PI / 24 / sin(LAM_PI / 24));
  assert_bounds(round, .4655 - reach, .0605 - reach, .4655 + reach, .0605 + reach);
  lam_arena_free(t.arena);
}

/* On stock of 0.5 x 1 m everything is turned to the left by a quarter: what lay along the lower
 * edge stands along the right one. */
static void upright_stock_turns_the_layout(void **state) {
  (void)state;
  table t = four_parts();
  lay(&t, 4, (lam_sheet_options){{.5, 1}, .001, .01, .004});
  const lam_sheet_piece *placed = t.sheets.sheets[0].placed;
  assert_bounds(&placed[0].paths[0], .389, .01, .49, .311);
  assert_bounds(&placed[1].paths[0], .389, .315, .49, .616);
  assert_bounds(&placed[2].paths[0], .439, .62, .49, .821);
  lam_arena_free(t.arena);
}

/* Without kerf a piece is the part itself; it may fill the sheet to its margins. */
static void a_part_may_fill_its_sheet(void **state) {
  (void)state;
  table t = {.arena = lam_arena_new()};
  const lam_sheet_options options = {{1, .5}, 0, .01, .004};
  t.parts[0] = (lam_part){.name = "A", .material = &steel};
  t.parts[0].flat = plate(t.arena, .98, .48, 0);
  lay(&t, 1, options);
  assert_int_equal(t.errors.count, 0);
  assert_bounds(&t.sheets.sheets[0].placed[0].paths[0], .01, .01, .99, .49);
  assert_near(t.sheets.sheets[0].used, .98 * .48 / .5, 1e-12);
  const double sizes[2][2] = {{.981, .48}, {.98, .481}};
  static const char *const texts[] = {
      "A needs 981.0 mm x 480.0 mm, the sheet has room for 980.0 mm x 480.0 mm inside its margins",
      "A needs 980.0 mm x 481.0 mm, the sheet has room for 980.0 mm x 480.0 mm inside its margins"};
  for (int i = 0; i < 2; i++) {
    t.parts[0].flat = plate(t.arena, sizes[i][0], sizes[i][1], 0);
    lay(&t, 1, options);
    assert_int_equal(t.errors.count, 1);
    assert_string_equal(t.errors.first->key, "sheets.stock");
    assert_string_equal(t.errors.first->text, texts[i]);
    assert_int_equal(t.sheets.count, 0);
  }
  lam_arena_free(t.arena);
}

static void wrong_sizes_are_told_in_numbers(void **state) {
  (void)state;
  table t = {.arena = lam_arena_new()};
  t.parts[0] = (lam_part){.name = "A", .material = &steel};
  t.parts[0].flat = plate(t.arena, .3, .1, .004);
  lay(&t, 1, (lam_sheet_options){{1, .5}, .0045, .01, .004});
  assert_string_equal(t.errors.first->key, "sheets.kerf");
  assert_string_equal(t.errors.first->text,
                      "A has a slot or hole narrower than the kerf of 4.500 mm");
  lay(&t, 1, (lam_sheet_options){{1, .5}, 0, .25, .004});
  assert_int_equal(t.errors.count, 1);
  assert_int_equal(t.sheets.count, 0);
  assert_string_equal(t.errors.first->text,
                      "the margins of 250.0 mm leave nothing of a sheet of 1000 mm x 500 mm");
  t.parts[0].flat = strip(t.arena, false);
  t.parts[0].flat->slot_count = 1;
  t.parts[0].flat->slots = &(lam_flat_slot){1, 9, 0, .05, 5};
  lay(&t, 1, (lam_sheet_options){{6, 1}, 0, .01, .004});
  assert_int_equal(t.errors.count, 1);
  assert_string_equal(t.errors.first->text,
                      "A is 10000 mm long, the sheet has room for 5980 mm x 980 mm, and its slots "
                      "leave no room for splices of 126 mm");
  assert_int_equal(t.sheets.count, 0);
  lam_arena_free(t.arena);
}

/* The length of the first piece of a part, where it is cut. */
static double first_cut(const table *t, int part) {
  for (int s = 0; s < t->sheets.count; s++)
    for (int i = 0; i < t->sheets.sheets[s].piece_count; i++) {
      const lam_sheet_piece *piece = &t->sheets.sheets[s].placed[i];
      if (piece->part == part && strstr(piece->label, ".1")) return piece->length;
    }
  fail_msg("part %d was not cut", part);
  return 0;
}

/* From 10 m in sheets of 6 m a cut has play from 4 to 6 m. The first sheet of a lamella is cut at
 * .15 of it, the second at .65; those of the next lamella at .4 and .9. */
static void splices_of_neighbors_are_staggered(void **state) {
  (void)state;
  table t = {.arena = lam_arena_new()};
  static const double expected[] = {4.3, 5.3, 4.8, 5.8, 4.3, 4.3};
  for (int i = 0; i < 6; i++)
    t.parts[i] = (lam_part){.name = "A",
                            .material = &steel,
                            .group = i < 4    ? i / 2
                                     : i == 4 ? 2
                                              : -1,
                            .flat = strip(t.arena, i == 3)};
  t.parts[5].group = 4;
  lay(&t, 6, (lam_sheet_options){{6.02, 1}, 0, .01, .004});
  for (int i = 0; i < 6; i++) assert_near_named(first_cut(&t, i), expected[i], 1e-9, "cut");
  /* with a kerf pieces are shorter by it: the play begins 1 mm later and ends 1 mm sooner */
  lay(&t, 6, (lam_sheet_options){{6.02, 1}, .001, .01, .004});
  assert_near(first_cut(&t, 0), 4.001 + .15 * 1.998, 1e-9);
  lam_arena_free(t.arena);
}

/* The third sheet would be cut at 4.3 m, where the first one is, which runs the other way: 5.7 m
 * in the direction of travel, 4.3 m in its own. It keeps a plate (126 mm) away, both ways
 * around. Parts without a lamella do not mind each other. */
static void reversed_sheets_keep_the_distance_too(void **state) {
  (void)state;
  for (int k = 0; k < 4; k++) {
    table t = {.arena = lam_arena_new()};
    bool first = k == 1 || k == 2, last = k == 2;
    for (int i = 0; i < 3; i++)
      t.parts[i] = (lam_part){
          .name = "A", .material = &steel, .group = k == 3 ? -1 : 0, .flat = strip(t.arena, false)};
    t.parts[0].flat->reversed = first;
    t.parts[2].flat->reversed = last;
    lay(&t, 3, (lam_sheet_options){{6.02, 1}, 0, .01, .004});
    double at = k == 3 ? 4.8 : 4.3; /* .4 of the play without a lamella */
    assert_near(fabs(first_cut(&t, 2) - at), k == 0 || k == 2 ? .126 : 0, 1e-9);
    lam_arena_free(t.arena);
  }
}

/* A strip of 6 m on an arc of radius 4 m, in sheets with room for 5 m less a kerf of 5 mm: cut
 * at .15 of the play, a piece of 4.3965 m is left, which is 4.05 - 3.95 cos(4.3965/8) = 0.68 m
 * high. The kerf counts sqrt(2) times where corners point askew. Where that is a millimeter too
 * much, pieces are shortened by a tenth. */
static void bent_pieces_leave_room_for_the_kerf(void **state) {
  (void)state;
  enum { n = 241 };
  const double kerf = .005, longest = 5 - kerf, high = 4.05 - 3.95 * cos(4.3965 / 8);
  for (int k = 0; k < 2; k++) {
    table t = {.arena = lam_arena_new()};
    lam_flat *flat = LAM_NEW(t.arena, lam_flat, 1);
    lam_paths paths = {.arena = t.arena};
    lam_vec2 edge[2 * n];
    flat->axis = LAM_NEW(t.arena, lam_vec2, n);
    for (int i = 0; i < n; i++) {
      double a = 1.5 * i / (n - 1), x = sin(a), y = -cos(a);
      flat->axis[i] = lam_v2(4 * x, 4 * y);
      edge[i] = lam_v2(4.05 * x, 4.05 * y);
      edge[2 * n - 1 - i] = lam_v2(3.95 * x, 3.95 * y);
    }
    lam_paths_add(&paths, LAM_LAYER_CUT, true, 2 * n, edge);
    lam_flat_set_paths(flat, &paths);
    flat->axis_count = n;
    flat->height = .1;
    flat->thickness = .002;
    t.parts[0] = (lam_part){.name = "A", .material = &steel, .flat = flat};
    double room = high + kerf * sqrt(2) + (k ? -.001 : .001), reach = k ? .9 * longest : longest;
    lay(&t, 1, (lam_sheet_options){{5.02, room + .02}, kerf, .01, .004});
    assert_int_equal(t.errors.count, 0);
    assert_near(first_cut(&t, 0), 6 - reach + .15 * (2 * reach - 6), 1e-3);
    lam_arena_free(t.arena);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(pieces_lie_where_they_fit),
      cmocka_unit_test(upright_stock_turns_the_layout),
      cmocka_unit_test(a_part_may_fill_its_sheet),
      cmocka_unit_test(wrong_sizes_are_told_in_numbers),
      cmocka_unit_test(splices_of_neighbors_are_staggered),
      cmocka_unit_test(reversed_sheets_keep_the_distance_too),
      cmocka_unit_test(bent_pieces_leave_room_for_the_kerf),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
