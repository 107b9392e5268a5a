/* Designs: defaults, overrides, names, and the default of every key of every table. */
#include "design/design.h"
#include "fab/workshop.h"
#include "net/net_kind.h"
#include "surf/placement.h"
#include "surf/surface.h"
#include "tests/unit/key_fixture.h"

static const char desk_model[] = "lamella: 1\n"
                                 "name: desk\n"
                                 "surface: {kind: enneper, size: 300 mm}\n"
                                 "net: {kind: asymptotic, grid: [9, 8]}\n"
                                 "parts:\n"
                                 "  - {kind: lamella, height: 20 mm, thickness: 1 mm}\n";

static bool parse_desk(run *r, const char *const *texts, lam_design *design) {
  lam_design_text text = {
      .bytes = desk_model, .count = sizeof desk_model - 1, .path = "desk.yaml", .overrides = texts};
  while (texts && texts[text.override_count]) text.override_count++;
  return lam_design_parse(r->arena, &text, &r->errors, design);
}

static void designs_have_defaults(void **state) {
  run *r = *state;
  lam_design design;
  bool good = parse_desk(r, NULL, &design);
  assert_string_equal(messages(r), "");
  assert_true(good);
  assert_string_equal(design.title, "desk");
  assert_string_equal(design.source, "");
  assert_string_equal(design.path, "desk.yaml");
  assert_false(design.has_render);
  assert_int_equal(design.render.size[0], 1600);
  assert_string_equal(design.render.quality, "draft");
  ASSERT_EXACT(design.sheets.stock[1], 1.5);
  const lam_placement_keys *location = design.surface.common;
  ASSERT_EXACT(location->size, 0.3);
  assert_true(location->ground);
  assert_false(location->u_given);
  assert_int_equal(design.parts.count, 1);
}

static void overrides_edit_the_tree(void **state) {
  run *r = *state;
  lam_design design;
  const char *texts[] = {"surface.size=1 m",
                         "sheets.kerf=0.2 mm",
                         "parts[0].height=30 mm",
                         "title=Another",
                         "render=alps",
                         "render.size=[320, 180]",
                         NULL};
  bool good = parse_desk(r, texts, &design);
  assert_string_equal(messages(r), "");
  assert_true(good);
  ASSERT_EXACT(((lam_placement_keys *)design.surface.common)->size, 1.0);
  ASSERT_EXACT(design.sheets.kerf, 0.0002);
  assert_true(design.has_sheets);
  assert_string_equal(design.title, "Another");
  assert_string_equal(design.render.setting,
                      "alps"); /* the short form survives a second override */
  assert_int_equal(design.render.size[1], 180);
}

static void expect_bad_override(run *r, const char *text, const char *expected) {
  lam_design design;
  assert_false(parse_desk(r, (const char *[]){text, NULL}, &design));
  assert_string_equal(messages(r), expected);
}

static void overrides_name_themselves_in_messages(void **state) {
  expect_bad_override(*state, "sheets.kerf=2",
                      "--set sheets.kerf: sheets.kerf: given 2; expected a length in m, cm, mm or "
                      "um from 0 to 10 mm, such as "
                      "2 mm\n");
  expect_bad_override(*state, "sheets.curf=2 mm",
                      "--set sheets.curf: sheets.curf: no such key; expected one of stock, kerf, "
                      "margin, spacing (did you mean "
                      "kerf?)\n");
  expect_bad_override(*state, "sheets",
                      "--set sheets: expected key=value, such as net.grid=[40,40]\n");
  expect_bad_override(*state, "parts[3].height=2 mm",
                      "--set parts[3].height: index [3] of a list of 1; expected 0 to 0\n");
  expect_bad_override(*state, "parts.height=2 mm",
                      "--set parts.height: height is a key, but a list of 1 stands here; expected "
                      "an index such as [0]\n");
  expect_bad_override(
      *state, "=2", "--set : expected a key such as net.grid or parts[0].height before the '='\n");
  expect_bad_override(*state, "parts[x]=2",
                      "--set parts[x]: expected an index such as [0], which counts from 0\n");
  expect_bad_override(*state, "title=[", "--set title: not valid YAML: a value is missing\n");
  expect_bad_override(*state, "title=", "--set title: title: given nothing; expected a text\n");
}

static void names_are_safe_as_file_names(void **state) {
  expect_bad_override(*state, "name=../up",
                      "--set name: name: given ../up; expected 1 to 64 letters, digits, - and _, "
                      "with no - at the start\n");
  expect_bad_override(
      *state, "render.setting=a/b",
      "--set render.setting: render.setting: given a/b; expected 1 to 64 letters, digits, - and _, "
      "with no - at the start\n");
  expect_bad_override(*state, "lamella=2", "--set lamella: lamella: given 2; expected 1\n");
  expect_bad_override(
      *state, "surface.u=[1, -1]",
      "3:10: surface.u: given [1, -1]; expected the smaller number first, then a larger one\n");
}

/* ---- all tables ---- */

/* Parses a row with the defaults that the table gives; keys that must be given are the only thing
 * that may be wrong. */
static void check_defaults(run *r, const lam_key *table, const char *row) {
  for (const lam_key *key = table; key && key->name; key++) {
    assert_non_null(key->doc);
    if (key->type == LAM_KEY_MAP) check_defaults(r, key->keys, row);
    if (!key->initial || !key->initial[0]) continue;
    lam_key alone[2] = {*key, {.name = NULL}};
    char *params = lam_arena_alloc(r->arena, 1, 4096);
    bool good = lam_keys_parse(r->arena, alone, "{}", 2, row, &r->errors, params);
    if (!good) fail_msg("%s.%s: %s", row, key->name, messages(r));
  }
}

static void every_default_is_valid(void **state) {
  const lam_registry *registries[] = {&lam_surfaces, &lam_nets, &lam_part_kinds};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < registries[i]->count; j++) {
      check_defaults(*state, registries[i]->rows[j]->keys, registries[i]->rows[j]->name);
    }
  }
  check_defaults(*state, lam_design_keys, "design");
  check_defaults(*state, lam_placement_key_table, "surface");
  check_defaults(*state, lam_net_common_keys, "net");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(designs_have_defaults),
      TEST(overrides_edit_the_tree),
      TEST(overrides_name_themselves_in_messages),
      TEST(names_are_safe_as_file_names),
      TEST(every_default_is_valid),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
