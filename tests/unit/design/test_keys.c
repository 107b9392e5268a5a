/* The design language: types, units, defaults, ranges, short forms, places of messages. Expected
 * numbers are the written ones times the SI factor of their unit; expected messages follow from the
 * tables in this file. */
#include "core/key.h"
#include "core/numbers.h"
#include "design/design.h"
#include "tests/unit/key_fixture.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

/* ---- a small language for the tests ---- */

typedef struct joint {
  int kind;
  double clearance;
} joint;

typedef struct stack {
  double widths[2];
  int layers;
} stack;

typedef struct beam {
  double depth;
} beam;

typedef struct house {
  double height, angle, ratio;
  int floors, cells[2];
  bool has_roof, roof, flags[2], flags_given;
  int color;
  const char *owner;
  double corner[3];
  lam_list weights, names, numbers;
  joint joint;
  lam_list stacks;
  lam_row beam;
  lam_list beams;
} house;

static const char *const colors[] = {"red", "green", "blue", NULL};
static const char *const joints[] = {"half-lap", "none", NULL};

static const lam_key joint_keys[] = {
    {.name = "kind",
     .type = LAM_KEY_CHOICE,
     .offset = offsetof(joint, kind),
     .count = 1,
     .initial = "half-lap",
     .choices = joints},
    {.name = "clearance",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = offsetof(joint, clearance),
     .count = 1,
     .initial = "0.25 mm",
     .min = 0,
     .max = 0.01},
    {.name = NULL},
};
static const lam_key stack_keys[] = {
    {.name = "widths",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = offsetof(stack, widths),
     .count = 2},
    {.name = "layers",
     .type = LAM_KEY_INTEGER,
     .offset = offsetof(stack, layers),
     .count = 1,
     .initial = "3"},
    {.name = NULL},
};
static const lam_key beam_keys[] = {
    {.name = "depth",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = offsetof(beam, depth),
     .count = 1,
     .initial = "20 cm"},
    {.name = NULL},
};
static const lam_key beam_common[] = {
    {.name = "depth_factor", .type = LAM_KEY_NUMBER, .offset = 0, .count = 1, .initial = "2"},
    {.name = NULL},
};
static const lam_row_head steel_beam = {
    .name = "steel", .keys = beam_keys, .params_size = sizeof(beam)};
static const lam_row_head bare_beam = {.name = "bare"};
static const lam_row_head *const beam_rows[] = {&steel_beam, &bare_beam};
static const lam_registry beam_registry = {"beams", "beam", beam_rows, 2};

#define IN(member) offsetof(house, member)
static const lam_key keys[] = {
    {.name = "height",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN(height),
     .count = 1,
     .initial = "3 m",
     .min = 0.001,
     .max = 10},
    {.name = "angle",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_ANGLE,
     .offset = IN(angle),
     .count = 1,
     .initial = "90 deg"},
    {.name = "ratio",
     .type = LAM_KEY_NUMBER,
     .offset = IN(ratio),
     .count = 1,
     .initial = "0.5",
     .min = 0,
     .max = INFINITY},
    {.name = "floors",
     .type = LAM_KEY_INTEGER,
     .offset = IN(floors),
     .count = 1,
     .initial = "1",
     .min = 1,
     .max = 9},
    {.name = "cells",
     .type = LAM_KEY_INTEGER,
     .offset = IN(cells),
     .count = 2,
     .initial = "[2, 3]"},
    {.name = "roof",
     .type = LAM_KEY_FLAG,
     .offset = IN(roof),
     .count = 1,
     .initial = "yes",
     .given_offset = IN(has_roof)},
    {.name = "flags",
     .type = LAM_KEY_FLAG,
     .offset = IN(flags),
     .count = 2,
     .initial = "[yes, no]",
     .given_offset = IN(flags_given)},
    {.name = "color",
     .type = LAM_KEY_CHOICE,
     .offset = IN(color),
     .count = 1,
     .initial = "green",
     .choices = colors},
    {.name = "owner", .type = LAM_KEY_TEXT, .offset = IN(owner), .count = 1, .initial = ""},
    {.name = "corner",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN(corner),
     .count = 3,
     .initial = "[0, 0, 0]"},
    {.name = "weights", .type = LAM_KEY_NUMBER, .offset = IN(weights), .count = 0, .initial = "[]"},
    {.name = "names",
     .type = LAM_KEY_TEXT,
     .offset = IN(names),
     .count = 0,
     .initial = "[a, 'b c']"},
    {.name = "numbers",
     .type = LAM_KEY_INTEGER,
     .offset = IN(numbers),
     .count = 0,
     .initial = "[]"},
    {.name = "joint",
     .type = LAM_KEY_MAP,
     .offset = IN(joint),
     .count = 1,
     .initial = "{}",
     .keys = joint_keys,
     .size = sizeof(joint)},
    {.name = "stacks",
     .type = LAM_KEY_MAP,
     .offset = IN(stacks),
     .count = 0,
     .initial = "[]",
     .keys = stack_keys,
     .size = sizeof(stack)},
    {.name = "beam",
     .type = LAM_KEY_ROW,
     .offset = IN(beam),
     .count = 1,
     .initial = "",
     .keys = beam_common,
     .size = sizeof(double),
     .rows = &beam_registry},
    {.name = "beams",
     .type = LAM_KEY_ROW,
     .offset = IN(beams),
     .count = 0,
     .initial = "[]",
     .rows = &beam_registry},
    {.name = NULL},
};

static const lam_key strict_keys[] = {
    {.name = "height",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = IN(height),
     .count = 1},
    {.name = NULL},
};

/* ---- helpers ---- */

static house read_good(run *r, const char *yaml) {
  house h = {0};
  bool good = lam_keys_parse(r->arena, keys, yaml, strlen(yaml), "house.yaml", &r->errors, &h);
  assert_string_equal(messages(r), "");
  assert_true(good);
  return h;
}

static void expect_bad(run *r, const char *yaml, const char *expected) {
  house h = {0};
  assert_false(lam_keys_parse(r->arena, keys, yaml, strlen(yaml), "house.yaml", &r->errors, &h));
  assert_string_equal(messages(r), expected);
}

/* ---- values ---- */

/* A design number is the double nearest to the decimal number in meters. */
static void lengths_are_stored_in_meters(void **state) {
  ASSERT_EXACT(read_good(*state, "height: 25 mm").height, 0.025);
  ASSERT_EXACT(read_good(*state, "height: 1.5mm").height, 0.0015);
  ASSERT_EXACT(read_good(*state, "height: 120 cm").height, 1.2);
  ASSERT_EXACT(read_good(*state, "height: 2500 um").height, 0.0025);
  ASSERT_EXACT(read_good(*state, "height: +.5e1 m").height, 5.0);
  ASSERT_EXACT(read_good(*state, "corner: [0, -1 m, 2 mm]").corner[1], -1.0);
}

static void angles_are_stored_in_radians(void **state) {
  ASSERT_EXACT(read_good(*state, "angle: 90 deg").angle, LAM_PI / 2);
  ASSERT_EXACT(read_good(*state, "angle: 180deg").angle, LAM_PI);
  ASSERT_EXACT(read_good(*state, "angle: 1.25 rad").angle, 1.25);
  ASSERT_EXACT(read_good(*state, "angle: 0").angle, 0.0);
}

static void defaults_come_from_the_table(void **state) {
  house h = read_good(*state, "{}");
  ASSERT_EXACT(h.height, 3.0);
  ASSERT_EXACT(h.angle, LAM_PI / 2);
  assert_int_equal(h.cells[0], 2);
  assert_int_equal(h.cells[1], 3);
  assert_true(h.roof);
  assert_false(h.has_roof);
  assert_true(h.flags[0]);
  assert_false(h.flags[1]);
  assert_int_equal(h.color, 1);
  assert_null(h.owner);
  assert_int_equal(h.weights.count, 0);
  assert_int_equal(h.names.count, 2);
  assert_string_equal(((const char **)h.names.items)[1], "b c");
  ASSERT_EXACT(h.joint.clearance, 0.00025);
  assert_null(h.beam.head);
}

static void given_says_whether_the_design_has_the_key(void **state) {
  house h = read_good(*state, "roof: no");
  assert_true(h.has_roof);
  assert_false(h.roof);
  assert_false(h.flags_given);
}

static void flags_have_six_words(void **state) {
  assert_true(read_good(*state, "roof: on").roof);
  assert_true(read_good(*state, "roof: True").roof);
  assert_false(read_good(*state, "roof: off").roof);
  assert_false(read_good(*state, "roof: false").roof);
}

static void lists_have_their_length(void **state) {
  house h = read_good(*state, "weights: [1, 2.5, -3]\nnumbers: 7\ncells: [4, 5]");
  assert_int_equal(h.weights.count, 3);
  ASSERT_EXACT(((double *)h.weights.items)[2], -3.0);
  assert_int_equal(h.numbers.count, 1); /* a single value is a list of one */
  assert_int_equal(((int *)h.numbers.items)[0], 7);
  assert_int_equal(h.cells[1], 5);
}

static void maps_and_their_short_forms(void **state) {
  assert_int_equal(read_good(*state, "joint: none").joint.kind, 1);
  ASSERT_EXACT(read_good(*state, "joint: none").joint.clearance, 0.00025);
  ASSERT_EXACT(read_good(*state, "joint: {clearance: 1 mm}").joint.clearance, 0.001);
  house h = read_good(*state, "stacks: [{widths: [1 m, 2 m], layers: 5}, [3 m, 4 m]]");
  assert_int_equal(h.stacks.count, 2);
  const stack *stacks = h.stacks.items;
  assert_int_equal(stacks[0].layers, 5);
  ASSERT_EXACT(stacks[1].widths[1], 4.0);
  assert_int_equal(stacks[1].layers, 3);
}

static void rows_are_looked_up_by_kind(void **state) {
  house h = read_good(*state, "height: 1 m\nbeam: {kind: steel, depth: 1 cm, depth_factor: "
                              "4}\nbeams: [bare, {kind: steel}]");
  assert_ptr_equal(h.beam.head, &steel_beam);
  ASSERT_EXACT(((beam *)h.beam.params)->depth, 0.01);
  ASSERT_EXACT(*(double *)h.beam.common, 4.0);
  assert_int_equal(h.beam.location.line, 2);
  assert_int_equal(h.beam.location.column, 7);
  const lam_row *beams = h.beams.items;
  assert_int_equal(h.beams.count, 2);
  assert_ptr_equal(beams[0].head, &bare_beam);
  ASSERT_EXACT(((beam *)beams[1].params)->depth, 0.2);
  assert_int_equal(read_good(*state, "beams: steel").beams.count, 1);
}

static void aliases_repeat_a_value(void **state) {
  house h = read_good(*state, "beam: &b {kind: steel, depth: 7 mm}\nbeams: [*b, *b]");
  ASSERT_EXACT(((beam *)((lam_row *)h.beams.items)[1].params)->depth, 0.007);
}

/* ---- messages ---- */

static void numbers_need_their_unit(void **state) {
  expect_bad(*state, "height: 100",
             "1:9: height: given 100; expected a length in m, cm, mm or um from 1 mm to 10 m, such "
             "as 100 mm\n");
  expect_bad(*state, "height: 100 mn",
             "1:9: height: given 100 mn; expected a length in m, cm, mm or um from 1 mm to 10 m "
             "(did you mean mm?)\n");
  expect_bad(*state, "height: 60 deg",
             "1:9: height: given 60 deg; expected a length in m, cm, mm or um from 1 mm to 10 m\n");
  expect_bad(*state, "angle: 1",
             "1:8: angle: given 1; expected an angle in deg or rad, such as 1 deg\n");
  expect_bad(*state, "ratio: 3 m",
             "1:8: ratio: given 3 m; expected a number at least 0, without a unit\n");
  expect_bad(*state, "ratio: half", "1:8: ratio: given half; expected a number at least 0\n");
  expect_bad(*state, "ratio: nan", "1:8: ratio: given nan; expected a number at least 0\n");
  expect_bad(*state, "ratio: 1e999",
             "1:8: ratio: given 1e999; expected a number that fits (below 1e308)\n");
}

static void limits_are_shown_in_the_unit_given(void **state) {
  expect_bad(*state, "height: 12000 mm",
             "1:9: height: given 12000 mm; expected from 1 mm to 10000 mm\n");
  expect_bad(*state, "height: 0", "1:9: height: given 0; expected from 1 mm to 10 m\n");
  expect_bad(*state, "ratio: -1", "1:8: ratio: given -1; expected at least 0\n");
  expect_bad(*state, "floors: 10", "1:9: floors: given 10; expected from 1 to 9\n");
  expect_bad(*state, "numbers: [99999999999]",
             "1:11: numbers[0]: given 99999999999; expected a whole number from -2147483648 to "
             "2147483647\n");
  ASSERT_EXACT(read_good(*state, "height: 10000 mm").height, 10.0); /* limits are inclusive */
}

static void words_are_corrected(void **state) {
  expect_bad(*state, "color: gren",
             "1:8: color: given gren; expected one of red, green, blue (did you mean green?)\n");
  expect_bad(*state, "roof: maybe", "1:7: roof: given maybe; expected yes or no\n");
  expect_bad(*state, "floors: 2.5",
             "1:9: floors: given 2.5; expected a whole number from 1 to 9\n");
  expect_bad(*state, "joint: {clearence: 1 mm}",
             "1:9: joint.clearence: no such key; expected one of kind, clearance (did you mean "
             "clearance?)\n");
  expect_bad(
      *state, "beam: {kind: stel}",
      "1:14: beam.kind: given stel; expected one of the beams steel, bare (did you mean steel?)\n");
  expect_bad(*state, "beam: {depth: 1 m}",
             "1:7: beam.kind: missing; expected one of the beams steel, bare\n");
  expect_bad(*state, "beam: {kind: bare, depth: 1 m}",
             "1:20: beam.depth: no such key; expected one of kind, depth_factor (did you mean "
             "depth_factor?)\n");
}

static void lists_state_both_lengths(void **state) {
  expect_bad(*state, "cells: [1, 2, 3]",
             "1:8: cells: given a list of 3 values; expected a list of 2 whole numbers\n");
  expect_bad(*state, "cells: 4", "1:8: cells: given 4; expected a list of 2 whole numbers\n");
  expect_bad(*state, "height: [1 m]",
             "1:9: height: given a list of 1 value; expected a length in m, cm, mm or um from 1 mm "
             "to 10 m\n");
  expect_bad(
      *state, "joint: [1, 2]",
      "1:8: joint: given a list of 2 values; expected a map with keys out of kind, clearance\n");
  expect_bad(
      *state, "height:",
      "1:8: height: given nothing; expected a length in m, cm, mm or um from 1 mm to 10 m\n");
  expect_bad(*state, "weights:", "1:9: weights: given nothing; expected a list of numbers\n");
}

static void all_messages_come_at_once(void **state) {
  expect_bad(*state,
             "floors: 0\ncolr: red\nstacks:\n  - {layers: 1}\n  - {widths: [1 m, x]}\nfloors: 2\n",
             "1:9: floors: given 0; expected from 1 to 9\n"
             "2:1: colr: no such key; expected one of height, angle, ratio, floors, cells, roof, "
             "flags, color, owner, "
             "corner, weights, names, numbers, joint, stacks, beam, beams (did you mean color?)\n"
             "4:5: stacks[0].widths: missing; expected a list of 2 lengths in m, cm, mm or um\n"
             "5:20: stacks[1].widths[1]: given x; expected a length in m, cm, mm or um\n"
             "6:1: floors: given twice; expected once (first given in line 1)\n");
}

static void required_keys_are_missed(void **state) {
  run *r = *state;
  house h = {0};
  assert_false(lam_keys_parse(r->arena, strict_keys, "{}", 2, NULL, &r->errors, &h));
  assert_string_equal(messages(r), "1:1: height: missing; expected a length in m, cm, mm or um\n");
}

static void texts_are_one_line(void **state) {
  assert_string_equal(read_good(*state, "owner: 'Ada L.'").owner, "Ada L.");
  assert_string_equal(read_good(*state, "owner: 12 mm").owner, "12 mm");
  expect_bad(*state, "owner: \"a\\nb\"",
             "1:8: owner: given 'a b'; expected one line of at most 1000 characters\n");
  expect_bad(*state, "owner: \"\\e[2J\"",
             "1:8: owner: given ' [2J'; expected one line of at most 1000 characters\n");
}

static void broken_yaml_is_one_message(void **state) {
  expect_bad(*state, "cells: [1, 2\nroof: yes\n",
             "2:5: not valid YAML: a list is not closed; expected ',' or ']' (began at line 1, "
             "column 8)\n");
  expect_bad(
      *state, "a: b: c",
      "1:5: not valid YAML: a ':' stands where a value goes on; put a text with ': ' in quotes, or "
      "check the indentation\n");
  expect_bad(*state, "roof: yes\n\tcolor: red\n",
             "2:1: not valid YAML: a tab in the indentation; indent with spaces\n");
  expect_bad(*state, "", "1:1: the file is empty; expected a map that begins with 'lamella: 1'\n");
  expect_bad(*state, "roof: yes\n---\nroof: no\n",
             "2:1: a second document (---); expected one design per file\n");
  expect_bad(*state, "roof: !!int yes", "1:7: a YAML tag (!...); expected a value without a tag\n");
  expect_bad(*state, "[a]: yes", "1:1: a key that is not a word; expected 'key: value'\n");
  expect_bad(*state, "roof: yes\nowner: \xff\n", "2:8: not valid YAML: bytes that are not UTF-8\n");
}

/* Aliases of aliases grow by powers of two, and one that holds itself has no end: both stop at a
 * limit. */
static void no_file_grows_without_end(void **state) {
  run *r = *state;
  lam_text yaml = {.arena = r->arena};
  lam_text_add(&yaml, "a0: &a0 [x, x]\n");
  for (int i = 1; i < 30; i++)
    lam_text_printf(&yaml, "a%d: &a%d [*a%d, *a%d]\n", i, i, i - 1, i - 1);
  expect_bad(r, yaml.data, "1:10: more than 500000 values\n");
  expect_bad(r, "a: &a [*a]", "1:8: an alias (*name) inside what it stands for\n");
  expect_bad(r, "a: &a 1\nb: &a 2\n", "2:4: not valid YAML: an anchor (&name) is given twice\n");
}

/* Seconds of processor time that refusing a text takes. */
static double refuse(run *r, const char *unit, int times, const char *expected) {
  lam_text yaml = {.arena = r->arena};
  for (int i = 0; i < times; i++) lam_text_printf(&yaml, unit, i, i);
  clock_t start = clock();
  expect_bad(r, yaml.data, expected);
  return (double)(clock() - start) / CLOCKS_PER_SEC;
}

/* Texts on which libyaml works with the square of their length, or builds millions of nodes, when
 * it is let read to the end (20 s and more): refused by the limits while they are read. Each takes
 * some hundredths of a second; 2 s are for slow machines. */
static void no_text_takes_long(void **state) {
  run *r = *state;
  static const char deep[] = "maps and lists are nested more than 32 deep\n";
  char expected[100];
  double seconds = 0;
  snprintf(expected, sizeof expected, "1:34: %s", deep);
  seconds += refuse(r, "[", 1000000, expected);
  seconds += refuse(r, "{", 1000000, "1:34: maps and lists are nested more than 32 deep\n");
  snprintf(expected, sizeof expected, "1:67: %s", deep);
  seconds += refuse(r, "? ", 2000000, expected);
  seconds += refuse(r, "- ", 2000000, expected);
  seconds += refuse(r, "- &a%d x\n", 200000, "1001:3: more than 1000 anchors (&name)\n");
  seconds += refuse(r, "%%TAG !a%d! b\n", 200000, "house.yaml: more than 16 %TAG lines\n");
  seconds += refuse(r, "\n%%TAG !a%d! b\n", 17, "house.yaml: more than 16 %TAG lines\n");
  if (seconds > 2) fail_msg("%.1f s for six texts that are refused", seconds);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(lengths_are_stored_in_meters),
      TEST(angles_are_stored_in_radians),
      TEST(defaults_come_from_the_table),
      TEST(given_says_whether_the_design_has_the_key),
      TEST(flags_have_six_words),
      TEST(lists_have_their_length),
      TEST(maps_and_their_short_forms),
      TEST(rows_are_looked_up_by_kind),
      TEST(aliases_repeat_a_value),
      TEST(numbers_need_their_unit),
      TEST(limits_are_shown_in_the_unit_given),
      TEST(words_are_corrected),
      TEST(lists_state_both_lengths),
      TEST(all_messages_come_at_once),
      TEST(required_keys_are_missed),
      TEST(texts_are_one_line),
      TEST(broken_yaml_is_one_message),
      TEST(no_file_grows_without_end),
      TEST(no_text_takes_long),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
