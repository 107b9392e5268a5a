/* The OpenSCAD writer as text. What OpenSCAD makes of it is tested in tests/cli/scad.t. */
#include "core/arena.h"
#include "formats/format.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

extern const lam_format lam_format_scad;

static const lam_record_column columns[] = {{"x", true, 3}, {"turn", false, 7}};
static const lam_setting settings[2][2] = {
    {{"thickness", "Sheet", "[0.5:0.1:20]", "Thickness of the sheet", .0015, true},
     {"slots", "Joint", NULL, "1: with slots", 1, false}},
    {{"thickness", "Panel", NULL, "Thickness of the panel", .018, true},
     {"depth", "Joint", NULL, "Depth of the groove", .004, true}},
};
static const lam_record_kind kinds[] = {
    {"lamella", "lamella.scad", 2, columns, 2, settings[0]},
    {"wall-panel", "scad/panel.scad", 2, columns, 2, settings[1]}};

typedef struct fixture {
  lam_vec3 points[4];
  int triangles[4][3];
  double values[4];
  lam_record record;
  lam_pose frame;
  lam_part parts[3];
  lam_model model;
} fixture;

/* A strip and a panel with records, and a tetrahedron as a solid with one instance. */
static void fill(fixture *f) {
  *f = (fixture){.points = {{0, 0, 0}, {.25, 0, 0}, {0, .5, 0}, {0, 0, 1}},
                 .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                 .values = {1.2345678, -0.5, 0, 0.12345678}};
  lam_trimesh solid = {4, f->points, 4, f->triangles};
  f->record = (lam_record){"A01", 0, 2, 2, f->values};
  f->frame = (lam_pose){{1, 2, 3}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  f->parts[0] = (lam_part){.name = "A01", .kind = "lamella", .solid = solid, .record = &f->record};
  f->parts[1] = (lam_part){
      .name = "P1", .kind = "wall-panel", .family = -1, .solid = solid, .record = &f->record};
  f->parts[2] = (lam_part){.name = "pin \"8\"",
                           .kind = "pin",
                           .family = -1,
                           .solid = solid,
                           .instance_count = 1,
                           .instances = &f->frame};
  f->model = (lam_model){.name = "thing",
                         .title = "Two\nlines",
                         .version = "0",
                         .part_count = 3,
                         .parts = f->parts,
                         .record_kind_count = 2,
                         .record_kinds = kinds};
}

static const char *written(lam_arena *arena, int file) {
  fixture f;
  fill(&f);
  lam_text out = {.arena = arena};
  assert_int_equal(lam_format_scad.count(&f.model), 2);
  assert_int_equal(lam_format_scad.write(&f.model, file, &out), LAM_OK);
  return out.data;
}

#define CONTAINS(text, part) assert_non_null(strstr((text), (part)))

/* Lengths are in millimeters with the decimals of their column; other numbers are as they are. */
static void records_are_in_millimeters(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const char *data = written(arena, 1);
  CONTAINS(data, "// [name, family, rows]. A row is [x, turn].");
  CONTAINS(data, "lamella_records = [\n[\"A01\", 0, [\n[1234.568,-0.5],\n[0,0.1234568]]],\n];");
  CONTAINS(data, "wall_panel_records = [\n[\"P1\", -1, [");
  lam_arena_free(arena);
}

/* OpenSCAD wants faces clockwise seen from outside: the model's triangle 0 2 1 becomes 0 1 2. */
static void solids_are_turned_and_placed(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  CONTAINS(
      written(arena, 1),
      "solids = [\n[\"pin \\\"8\\\"\", -1, [\n[0,0,0],[250,0,0],[0,500,0],[0,0,1000]], [\n"
      "[0,1,2],[0,3,1],[1,3,2],[2,3,0]], [\n[[1000,2000,3000],[0,1,0],[-1,0,0],[0,0,1]]]],\n];");
  lam_arena_free(arena);
}

/* OpenSCAD's Customizer reads literals up to the first brace: there is none in the main file. A
 * setting whose name an earlier kind has taken gets its kind in front, and groups are gathered. */
static void the_main_file_is_made_for_the_customizer(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const char *text = written(arena, 0);
  assert_null(strchr(text, '{'));
  assert_ptr_equal(strstr(text, "// Two lines\n"), text);
  CONTAINS(text, "// Thickness of the sheet, mm\nthickness = 1.5; // [0.5:0.1:20]\n");
  CONTAINS(text,
           "/* [Joint] */\n// 1: with slots\nslots = 1;\n// Depth of the groove, mm\ndepth = 4;\n");
  CONTAINS(text, "wall_panel_thickness = 18;");
  CONTAINS(text, "lamella_solid(of_family(chosen(lamella_records, show, part), family), thickness "
                 "= thickness, slots = "
                 "slots)");
  CONTAINS(text, "panel_outlines(chosen(wall_panel_records, show, part), part_names, thickness = "
                 "wall_panel_thickness, "
                 "depth = depth)");
  CONTAINS(text, "include <thing_data.scad>\n");
  lam_arena_free(arena);
}

static void a_model_without_parts_gives_no_file(void **state) {
  (void)state;
  lam_model model = {.name = "thing"};
  assert_int_equal(lam_format_scad.count(&model), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(records_are_in_millimeters),
      cmocka_unit_test(solids_are_turned_and_placed),
      cmocka_unit_test(the_main_file_is_made_for_the_customizer),
      cmocka_unit_test(a_model_without_parts_gives_no_file),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
