/* The two files of an OpenSCAD model, line by line: a strip, panels and a solid made by hand.
 * Millimeters; faces clockwise seen from outside. What OpenSCAD makes of such files is in
 * tests/cli/scad.t. */
#include "tests/unit/text_fixture.h"

#include <stdio.h>

extern const lam_format lam_format_scad;

/* ---- the model ---- */

static const lam_record_column strip_columns[] = {{"x", true, 3}, {"turn", false, 7}},
                               panel_columns[] = {{"y", false, 1}};

/* Two kinds share the name "thickness"; the section Joint is named by both. */
static const lam_setting strip_settings[] = {
    {"thickness", "Sheet", "[0.5:0.1:20]", "Thickness of the sheet", .0015, true},
    {"slots", "Joint", NULL, "1: with\nslots", 1, false},
    {"play", "Sheet", NULL, "Play", .00001234567, true}};
static const lam_setting panel_settings[] = {
    {"thickness", "Panel", NULL, "Thickness of the panel", .018, true},
    {"depth", "Joint", "[0:9]", "Depth", .004, true}};
static const lam_record_kind kinds[] = {
    {"lamella", "lamella.scad", 2, strip_columns, 3, strip_settings},
    {"wall-panel", "scad/panel.scad", 1, panel_columns, 2, panel_settings}};

/* Bounds: 0.62 along x, 0.9 along z, 0.7 along y. The largest, 0.9 m, over four is 225 mm, which
 * become 230. */
static lam_vec3 along_x[2] = {{0, 0, 0}, {.62, 0, 0}}, along_z[2] = {{0, 0, -.4}, {0, 0, .5}};
static lam_vec3 seven[7] = {{0, 0, 0},  {.1, 0, 0},   {.2, 0, 0},         {.3, -.35, 0},
                            {.4, 0, 0}, {.5, .35, 0}, {.0000123456, 0, 0}};
static int faces[13][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6},
                           {1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 6}, {2, 3, 4},
                           {2, 4, 5}, {2, 5, 6}, {3, 4, 5}};
static lam_pose places[2] = {{{1, 2, 3.00000012}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}},
                             {{4, 5, 6}, {{1. / 3, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};

typedef struct fixture {
  lam_part parts[14];
  lam_record strip, panel;
  lam_sheet sheet;
  lam_model model;
} fixture;

static const double strip_values[4] = {1.2345678, -0.5, 0, 0.12345678}, panel_values[1] = {2.26};

/* A strip, eleven panels, a solid with two instances and one that stands where it is. A panel
 * without a record is a solid, too. */
static void fill(fixture *f) {
  static const char *const names[14] = {"A01", "P1", "P2", "P3",  "P4",  "P5",   "P6",
                                        "P7",  "P8", "P9", "P10", "P11", "node", "rod"};
  *f = (fixture){.strip = {"A01", 0, 2, 2, strip_values}, .panel = {"P", -1, 1, 1, panel_values}};
  for (int i = 0; i < 14; i++)
    f->parts[i] = (lam_part){.name = names[i],
                             .kind = i == 0 ? "lamella" : "wall-panel",
                             .family = i == 0 ? 1 : -1,
                             .solid = {2, i == 1 ? along_z : along_x, 0, NULL},
                             .record = i == 0   ? &f->strip
                                       : i < 12 ? &f->panel
                                                : NULL};
  f->parts[12].kind = "node";
  f->parts[12].solid = (lam_trimesh){7, seven, 13, faces};
  f->parts[12].instance_count = 2;
  f->parts[12].instances = places;
  f->sheet.kerf = .0002;
  f->model = (lam_model){.name = "thing",
                         .title = "A thing",
                         .source = "after\tN. N.",
                         .version = "7",
                         .part_count = 14,
                         .parts = f->parts,
                         .record_kind_count = 2,
                         .record_kinds = kinds,
                         .sheet_count = 1,
                         .sheets = &f->sheet};
}

/* ---- the main file ---- */

static const char main_file[] =
    "// A thing\n// after N. N.\n"
    "// Written by lamella 7. Millimeters. Change the values here or in OpenSCAD's Customizer.\n\n"
    "/* [Show] */\n// What to show\nshow = \"all parts\"; // [all parts, one part, family A, "
    "family "
    "B, nodes, exploded, flat outlines, engraving, one outline, one engraving]\n"
    "// The one part that is shown when one is asked for\npart = \"A01\"; // [A01, P1, P2, P3, P4, "
    "P5, P6, P7, P8, P9, P10, P11, node, rod]\n"
    "// How far families are raised above each other when exploded, mm\nraise = 230; // "
    "[0:10:920]\n\n"
    "/* [Sheet] */\n// Thickness of the sheet, mm\nthickness = 1.5; // [0.5:0.1:20]\n"
    "// Play, mm\nplay = 0.012346;\n\n"
    "/* [Joint] */\n// 1: with slots\nslots = 1;\n// Depth, mm\ndepth = 4; // [0:9]\n\n"
    "/* [Panel] */\n// Thickness of the panel, mm\nwall_panel_thickness = 18;\n\n"
    "/* [Flat outlines] */\n// Width that the cutting tool takes away, mm: outlines grow by half "
    "of "
    "it; 0 leaves it to the workshop\nkerf = 0.2; // [0:0.01:1]\n\n"
    "/* [Hidden] */\ninclude <thing_data.scad>\nuse <parts.scad>\nuse <lamella.scad>\n"
    "use <scad/panel.scad>\n\n"
    "// The chosen parts of a family: 0 is A, 1 is B, -1 what belongs to none.\n"
    "function family_solids(family) = concat(\n"
    "  [lamella_solid(of_family(chosen(lamella_records, show, part), family), thickness = "
    "thickness, slots = slots, play = play)],\n"
    "  [panel_solid(of_family(chosen(wall_panel_records, show, part), family), thickness = "
    "wall_panel_thickness, depth = depth)],\n"
    "  show == \"one part\" ? unplaced(of_family(chosen(solids, show, part), family)) :\n"
    "    placed(of_family(chosen(solids, show, part), family)));\n"
    "function outlines() = concat(lamella_outlines(chosen(lamella_records, show, part), "
    "part_names, "
    "thickness = thickness, slots = slots, play = play),\n"
    "  panel_outlines(chosen(wall_panel_records, show, part), part_names, thickness = "
    "wall_panel_thickness, depth = depth));\n\n"
    "if (is_flat(show)) show_flat(show, outlines(), kerf);\n"
    "else show_solids([for (family = [0, 1, -1]) family_solids(family)], show == \"exploded\" ? "
    "raise : 0);\n";

static void the_main_file_has_all_settings(void **state) {
  fixture f;
  fill(&f);
  assert_string_equal(text_path(*state, &lam_format_scad, &f.model, 0), "thing.scad");
  assert_lines("main", text_of(*state, &lam_format_scad, &f.model, 0), main_file);
  f.model.sheet_count = 0, f.model.source = NULL, f.model.title = NULL;
  const char *bare = text_of(*state, &lam_format_scad, &f.model, 0);
  assert_holds(bare, "\nkerf = 0; // [0:0.01:1]\n");
  assert_ptr_equal(strstr(bare, "// thing\n// Written by"), bare);
}

/* Whichever way a part is longest: 0.9 m over four is 225 mm, which become 230. */
static void the_longest_way_counts(void **state) {
  for (int axis = 0; axis < 3; axis++) {
    fixture f;
    fill(&f);
    lam_vec3 ends[2] = {{0, 0, 0}, {axis == 0 ? .9 : .1, axis == 1 ? .9 : .1, axis == 2 ? .9 : .1}};
    f.parts[0].solid.vertices = ends;
    f.model.part_count = 1;
    assert_holds(text_of(*state, &lam_format_scad, &f.model, 0), "\nraise = 230; // [0:10:920]\n");
  }
}

/* ---- the data file ---- */

#define PANEL(name) "[\"" name "\", -1, [\n[2.3]]],\n"
#define HERE "[0,0,0],[1,0,0],[0,1,0],[0,0,1]"

/* Twelve names in a line, six points, twelve faces; two corners of every face change places. */
static const char data_file[] =
    "// The numbers of thing.scad. Written by lamella 7. Millimeters.\n\npart_names = [\n"
    "\"A01\", \"P1\", \"P2\", \"P3\", \"P4\", \"P5\", \"P6\", \"P7\", \"P8\", \"P9\", \"P10\", "
    "\"P11\",\n\"node\", \"rod\"];\n\n"
    "// [name, family, rows]. A row is [x, turn].\nlamella_records = [\n"
    "[\"A01\", 1, [\n[1234.568,-0.5],\n[0,0.1234568]]],\n];\n\n"
    "// [name, family, rows]. A row is [y].\nwall_panel_records = [\n" PANEL("P1") PANEL("P2")
        PANEL("P3") PANEL("P4") PANEL("P5") PANEL("P6") PANEL("P7") PANEL("P8") PANEL("P9")
            PANEL("P10")
                PANEL("P11") "];\n\n"
                             "// [name, family, points, faces, frames]. A frame is [origin, x "
                             "axis, y axis, z axis].\n"
                             "solids = [\n"
                             "[\"node\", -1, "
                             "[\n[0,0,0],[100,0,0],[200,0,0],[300,-350,0],[400,0,0],[500,350,0],\n"
                             "[0.0123,0,0]], [\n"
                             "[0,2,1],[0,3,2],[0,4,3],[0,5,4],[0,6,5],[1,3,2],[1,4,3],[1,5,4],[1,6,"
                             "5],[2,4,3],[2,5,4],"
                             "[2,6,5],\n[3,5,4]], [\n"
                             "[[1000,2000,3000.0001],[0,1,0],[-1,0,0],[0,0,1]],\n"
                             "[[4000,5000,6000],[0.3333333,0,0],[0,1,0],[0,0,1]]]],\n"
                             "[\"rod\", -1, [\n[0,0,0],[620,0,0]], [], [\n[" HERE "]]],\n];\n";

static void the_data_file_has_all_numbers(void **state) {
  fixture f;
  fill(&f);
  assert_string_equal(text_path(*state, &lam_format_scad, &f.model, 1), "thing_data.scad");
  assert_lines("data", text_of(*state, &lam_format_scad, &f.model, 1), data_file);
}

static void templates_beside_it_are_named(void **state) {
  fixture f;
  fill(&f);
  const char *const *files = lam_format_scad.support(*state, &f.model);
  assert_string_equal(files[0], "scad/parts.scad");
  assert_string_equal(files[1], "scad/lamella.scad");
  assert_string_equal(files[2], "scad/scad/panel.scad");
  assert_null(files[3]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(the_main_file_has_all_settings),
      TEXT_TEST(the_longest_way_counts),
      TEXT_TEST(the_data_file_has_all_numbers),
      TEXT_TEST(templates_beside_it_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
