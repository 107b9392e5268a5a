/* The tables (bom.csv, nodes.csv, assembly.csv) and report.json of a small workshop made by hand:
 * every line that is expected is written out. */
#include "core/numbers.h"
#include "formats/tables/csv.h"
#include "tests/unit/text_fixture.h"

extern const lam_format lam_format_bom, lam_format_nodes, lam_format_assembly, lam_format_report;

/* ---- the workshop ---- */

static const lam_material steel = {.name = "steel", .density = 8000},
                          ply = {.name = "ply, \"birch\"", .density = 500};

/* A slot from below may reach beyond the axis, but not as far as the upper edge at half of the
 * height; the second slot opens the other way and must not be asked. */
static lam_flat_slot from_above[] = {{.bottom = 0, .top = .04}, {.bottom = -.04, .top = .001}},
                     from_below[] = {{.bottom = -.04, .top = .03}, {.bottom = 0, .top = .04}};
static lam_flat up = {.height = .08, .thickness = .0015, .slot_count = 2, .slots = from_above},
                down = {.height = .0801234567,
                        .thickness = .00150051,
                        .slot_count = 1,
                        .slots = from_below},
                board = {.thickness = .012}; /* no strip, no slots */

/* A01 has two sheets, the other lamellas have one. The clamp is no sheet of A01, though its family
 * and group are the same. What stands last in a list here is beyond its count: it must not show. */
static lam_part parts[] = {
    {.name = "B01",
     .kind = "lamella",
     .family = 1,
     .congruence = 2,
     .material = &steel,
     .length = 1.5,
     .mass = 1.23456789,
     .flat = &down},
    {.name = "N1", .kind = "node", .family = -1, .group = -1, .instance_count = 3, .mass = .2},
    {.name = "A01a",
     .kind = "lamella",
     .congruence = 1,
     .material = &steel,
     .length = 2.50012345,
     .mass = 1.25,
     .flat = &up},
    {.name = "B02", .kind = "lamella", .family = 1, .group = 1, .material = &ply, .flat = &board},
    {.name = "A01b", .kind = "lamella", .material = &steel},
    {.name = "A02", .kind = "lamella", .group = 1},
    {.name = "N2", .kind = "node", .family = -1, .group = -1, .instance_count = 1},
    {.name = "C01", .kind = "clamp"},
    {.name = "X", .kind = "lamella"},
};

/* Pieces; a plate is a piece of no part, and a part may have the label of a plate. */
static lam_sheet_piece first[] = {
    {.part = 2, .label = "A01a.1"},
    {.part = -1, .label = "P1", .area = .002, .length = .12345678},
    {.part = 2, .label = "A01a.2"},
    {.part = 2, .label = "A01a.3"},
    {.part = -1, .label = "P1", .area = .002, .length = .12345678},
    {.part = 0, .label = "P2"},
    {.part = -1, .label = "X"},
};
static lam_sheet_piece second[] = {
    {.part = -1, .label = "P1", .area = .002, .length = .12345678},
    {.part = 0, .label = "B01.1"},
    {.part = 1, .label = "N1"},
    {.part = 1, .label = "N1"},
    {.part = -1, .label = "P2", .area = .00300001, .length = .2},
    {.part = 4, .label = "A01b.1"},
    {.part = 4, .label = "A01b.2"},
    {.part = 2, .label = "X"},
};
static lam_sheet_piece beyond[] = {{.part = 0, .label = "X"}, {.part = -1, .label = "X"}};
static lam_sheet_piece third[] = {{.part = -1, .label = "P1", .area = .002, .length = .1},
                                  {.part = 0, .label = "B01.2"}};
static lam_sheet_piece fourth[] = {{.part = -1, .label = "P1", .area = .002, .length = .1}};
static lam_sheet_piece fifth[] = {{.part = -1, .label = "P1", .area = .002}};
static const lam_sheet sheets[] = {
    {.name = "s1", .material = &steel, .thickness = .0015, .piece_count = 6, .placed = first},
    {.name = "s2", .material = &steel, .thickness = .0015, .piece_count = 7, .placed = second},
    {.name = "s3", .material = &steel, .thickness = .003, .piece_count = 2, .placed = third},
    {.name = "s4", .material = &ply, .thickness = .0015, .piece_count = 1, .placed = fourth},
    {.name = "s5", .thickness = .0015, .piece_count = 1, .placed = fifth},
    {.name = "X", .thickness = .0015, .piece_count = 2, .placed = beyond},
};

/* Along A01 node 2 comes before node 1; node 1 names the second sheet of A01. */
static const lam_crossing crossings[] = {
    {.position = {1, -2, .12345678},
     .normal = {.6, -.48, .64},
     .angle = LAM_PI / 2,
     .flat_angle = NAN,
     .parts = {4, 0},
     .along = {1.5, .25},
     .second = {1.4775, 0}},
    {.position = {.5, 0, 3},
     .normal = {.12345678, 0, -1},
     .angle = 1.1,
     .flat_angle = 1.2,
     .parts = {2, 3},
     .along = {.50012345, .3},
     .second = {.4776, NAN}},
    {.normal = {0, 0, 1}, .angle = 1, .flat_angle = 1, .parts = {5, 0}, .along = {.4, 1.25}},
    {.normal = {0, 0, 1}, .angle = 1, .flat_angle = 1, .parts = {5, 3}, .along = {1.4, 1.2}},
    {.parts = {5, 0}, .along = {1, 1}},
};

static const lam_model workshop = {.name = "hut",
                                   .title = "A hut",
                                   .part_count = 8,
                                   .parts = parts,
                                   .crossing_count = 4,
                                   .crossings = crossings,
                                   .sheet_count = 5,
                                   .sheets = sheets};

/* ---- fields ---- */

/* RFC 4180, 2: quotes around what holds a comma, a quote or a line break; quotes inside doubled. */
static void fields_are_quoted_where_they_must_be(void **state) {
  lam_text out = {.arena = *state};
  lam_csv_text(&out, "plain text");
  lam_csv_text(&out, "a,b");
  lam_csv_text(&out, "12\" \"x\"");
  lam_csv_text(&out, "two\nlines");
  lam_csv_text(&out, "two\rlines");
  lam_csv_empty(&out);
  lam_csv_integer(&out, -12);
  lam_csv_number(&out, 2.50049, 3);
  lam_csv_number(&out, NAN, 3);
  lam_csv_number(&out, INFINITY, 3);
  lam_csv_end_row(&out);
  lam_csv_text(&out, "next");
  assert_string_equal(out.data, "plain text,\"a,b\",\"12\"\" \"\"x\"\"\",\"two\nlines\","
                                "\"two\rlines\",,-12,2.5,,\r\nnext");
}

/* One family and group are not enough: a lamella's sheets are of one kind; parts of group -1 belong
 * to nothing else. */
static void sheets_of_one_lamella(void **state) {
  lam_text out = {.arena = *state};
  assert_true(lam_csv_same_lamella(&parts[2], &parts[4])); /* A01a, A01b */
  assert_true(lam_csv_same_lamella(&parts[1], &parts[1]));
  assert_false(lam_csv_same_lamella(&parts[1], &parts[6])); /* N1, N2: no group */
  assert_false(lam_csv_same_lamella(&parts[2], &parts[0])); /* A01a, B01: families */
  assert_false(lam_csv_same_lamella(&parts[2], &parts[5])); /* A01a, A02: groups */
  assert_false(lam_csv_same_lamella(&parts[2], &parts[7])); /* A01a, C01: kinds */
  lam_csv_sheets(&out, &workshop, 4);
  lam_csv_sheets(&out, &workshop, 6);
  assert_string_equal(out.data, "A01b A01a,N2");
}

/* ---- the bill of materials ---- */

/* Masses of plates: area x thickness x density, .002 x .0015 x 8000 = .024 kg each, .072 kg all
 * three; P2: .00300001 x .0015 x 8000 = .03600012; 3 mm: .048; plywood: .002 x .0015 x 500 = .0015.
 * Masses of parts: as given, times the number of instances. Millimeters have 3 decimals. */
static void bill_of_materials(void **state) {
  const char *expected =
      "part,kind,family,quantity,congruence,length_mm,height_mm,thickness_mm,material,mass_each_kg,"
      "mass_all_kg,slots,slots_open,pieces,sheets\r\n"
      "B01,lamella,B,1,2,1500,80.123,1.501,steel,1.234568,1.234568,1,down,3,s1 s2 s3\r\n"
      "N1,node,,3,,,,,,0.2,0.6,0,,2,s2\r\n"
      "A01a,lamella,A,1,1,2500.123,80,1.5,steel,1.25,1.25,2,up,3,s1\r\n"
      "B02,lamella,B,1,,,,12,\"ply, \"\"birch\"\"\",,,0,,0,\r\n"
      "A01b,lamella,A,1,,,,,steel,,,0,,2,s2\r\n"
      "A02,lamella,A,1,,,,,,,,0,,0,\r\n"
      "N2,node,,1,,,,,,,,0,,0,\r\n"
      "C01,clamp,A,1,,,,,,,,0,,0,\r\n"
      "P1,splice-plate,,3,,123.457,,1.5,steel,0.024,0.072,0,,3,s1 s2\r\n"
      "P2,splice-plate,,1,,200,,1.5,steel,0.036,0.036,0,,1,s2\r\n"
      "P1,splice-plate,,1,,100,,3,steel,0.048,0.048,0,,1,s3\r\n"
      "P1,splice-plate,,1,,100,,1.5,\"ply, \"\"birch\"\"\",0.0015,0.0015,0,,1,s4\r\n"
      "P1,splice-plate,,1,,,,1.5,,,,0,,1,s5\r\n";
  assert_lines("bom.csv", text_of(*state, &lam_format_bom, &workshop, 0), expected);
}

/* ---- nodes ---- */

/* 1.1 rad = 63.0253574644 and 1.2 rad = 68.7549354157 degrees; normals have 7 decimals. A first,
 * then B, each with the sheet that the node names in front; places on second sheets stand last. */
static void nodes(void **state) {
  const char *expected =
      "node,x_mm,y_mm,z_mm,normal_x,normal_y,normal_z,angle_deg,flat_angle_deg,a_parts,a_along_mm,"
      "b_parts,b_along_mm,a_second_along_mm,b_second_along_mm\r\n"
      "1,1000,-2000,123.457,0.6,-0.48,0.64,90,,A01b A01a,1500,B01,250,1477.5,\r\n"
      "2,500,0,3000,0.1234568,0,-1,63.025357,68.754935,A01a A01b,500.123,B02,300,477.6,\r\n"
      "3,0,0,0,0,0,1,57.29578,57.29578,A02,400,B01,1250,,\r\n"
      "4,0,0,0,0,0,1,57.29578,57.29578,A02,1400,B02,1200,,\r\n";
  assert_lines("nodes.csv", text_of(*state, &lam_format_nodes, &workshop, 0), expected);
}

/* ---- assembly ---- */

/* Family A, then B, then the rest, a step per lamella with both of its sheets. A01 is two sheets in
 * 3 + 2 pieces: 3 splices; B01 one sheet in 3 pieces (P2, B01.1 and B01.2): 2. What belongs to no
 * family has none, though two N1 lie on a sheet. The others are crossed in the order of the nodes
 * along the lamella. */
static void order_of_assembly(void **state) {
  const char *expected =
      "step,parts,family,kind,quantity,action,splices,crosses\r\n"
      "1,A01a A01b,A,lamella,2,\"lay out, slots up\",3,2: B02; 1: B01\r\n"
      "2,A02,A,lamella,1,\"lay out, slots up\",0,3: B01; 4: B02\r\n"
      "3,C01,A,clamp,1,\"lay out, slots up\",0,\r\n"
      "4,B01,B,lamella,1,lower into the slots of family A,2,1: A01b A01a; 3: A02\r\n"
      "5,B02,B,lamella,1,lower into the slots of family A,0,2: A01a A01b; 4: A02\r\n"
      "6,N1,,node,3,fix at its nodes,0,\r\n"
      "7,N2,,node,1,fix at its nodes,0,\r\n";
  assert_lines("assembly.csv", text_of(*state, &lam_format_assembly, &workshop, 0), expected);
}

/* ---- which files there are ---- */

static void a_table_is_written_when_it_has_rows(void **state) {
  static const lam_model nothing = {.name = "hut"};
  static const lam_model one = {.part_count = 1, .crossing_count = 1};
  static const lam_format *const tables[] = {&lam_format_bom, &lam_format_nodes,
                                             &lam_format_assembly};
  static const char *const names[] = {"bom.csv", "nodes.csv", "assembly.csv"};
  for (int i = 0; i < 3; i++) {
    assert_int_equal(tables[i]->count(&nothing), 0);
    assert_int_equal(tables[i]->count(&one), 1);
    assert_string_equal(text_path(*state, tables[i], &workshop, 0), names[i]);
  }
}

/* ---- the report ---- */

static lam_measure measures[] = {{"length", "m", 1 / 3., 12345678.912345, 2, 7},
                                 {"angle", "", NAN, INFINITY, -1.5, 0},
                                 {"beyond", "", 0, 0, 0, 0}};
static const char *notes[] = {"One thing.", "Another \"thing\".", "Beyond."};
static lam_stage stages[] = {
    {.name = "net",
     .converged = true,
     .reason = "small",
     .residual = 1e-13,
     .measure_count = 2,
     .measures = measures,
     .seconds = 1.5},
    {.name = "sheets",
     .reason = "done",
     .iterations = -1,
     .residual = 3,
     .note_count = 2,
     .notes = notes},
    {.name = "beyond", .reason = "done"},
};
static const lam_report report = {2, stages};

/* Ten significant digits; null for what is not finite; a stage that does not iterate has neither
 * iterations nor a residual; notes and seconds only when there are any. */
static void report_of_every_stage(void **state) {
  const lam_model model = {.name = "hut", .title = "A hut", .version = "1.2", .report = &report};
  const char *expected = "{\n"
                         "  \"name\": \"hut\",\n"
                         "  \"title\": \"A hut\",\n"
                         "  \"source\": \"\",\n"
                         "  \"lamella\": \"1.2\",\n"
                         "  \"stages\": [\n"
                         "    {\n"
                         "      \"stage\": \"net\",\n"
                         "      \"converged\": true,\n"
                         "      \"reason\": \"small\",\n"
                         "      \"iterations\": 0,\n"
                         "      \"residual\": 1e-13,\n"
                         "      \"measures\": {\n"
                         "        \"length\": {\n"
                         "          \"min\": 0.3333333333,\n"
                         "          \"mean\": 2.0,\n"
                         "          \"max\": 12345678.91,\n"
                         "          \"unit\": \"m\",\n"
                         "          \"count\": 7\n"
                         "        },\n"
                         "        \"angle\": {\n"
                         "          \"min\": null,\n"
                         "          \"mean\": -1.5,\n"
                         "          \"max\": null,\n"
                         "          \"unit\": \"\",\n"
                         "          \"count\": 0\n"
                         "        }\n"
                         "      },\n"
                         "      \"seconds\": 1.5\n"
                         "    },\n"
                         "    {\n"
                         "      \"stage\": \"sheets\",\n"
                         "      \"converged\": false,\n"
                         "      \"reason\": \"done\",\n"
                         "      \"measures\": {},\n"
                         "      \"notes\": [\n"
                         "        \"One thing.\",\n"
                         "        \"Another \\\"thing\\\".\"\n"
                         "      ]\n"
                         "    }\n"
                         "  ]\n"
                         "}\n";
  assert_int_equal(lam_format_report.count(&model), 1);
  assert_int_equal(lam_format_report.count(&workshop), 0);
  assert_string_equal(text_path(*state, &lam_format_report, &model, 0), "report.json");
  assert_lines("report.json", text_of(*state, &lam_format_report, &model, 0), expected);
}

/* JSON is UTF-8 (RFC 8259, 8.1): another title is refused, not written. */
static void a_title_that_is_no_utf8_is_refused(void **state) {
  const lam_model model = {
      .name = "hut", .title = "h\xfctte", .source = "a book", .version = "1.2", .report = &report};
  lam_text out = {.arena = *state};
  assert_int_equal(lam_format_report.write(&model, 0, &out), LAM_FAILED);
  assert_int_equal(out.length, 0);
}

static void the_source_is_told(void **state) {
  const lam_model model = {
      .name = "hut", .title = "A hut", .source = "a book", .version = "1.2", .report = &report};
  assert_holds(text_of(*state, &lam_format_report, &model, 0), "\"source\": \"a book\",\n");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(fields_are_quoted_where_they_must_be),
      TEXT_TEST(sheets_of_one_lamella),
      TEXT_TEST(bill_of_materials),
      TEXT_TEST(nodes),
      TEXT_TEST(order_of_assembly),
      TEXT_TEST(a_table_is_written_when_it_has_rows),
      TEXT_TEST(report_of_every_stage),
      TEXT_TEST(a_title_that_is_no_utf8_is_refused),
      TEXT_TEST(the_source_is_told),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
