/* Files of surfaces that are wrong or cut off: one message that says where and why. */
#include "files_fixture.h"
#include "others_fixture.h"

static const lam_format *const readable[] = {&lam_format_surface, &lam_format_step,
                                             &lam_format_iges};
enum { readable_count = 3 };

static void check_refused(void **state, const lam_format *format, const char *text,
                          const bad_case *cases, size_t n) {
  for (size_t i = 0; i < n; i++) {
    char *bad = replaced(*state, text, cases[i].old, cases[i].by);
    lam_spline_list list;
    const char *message = NULL;
    if (try_read(*state, format, bad, strlen(bad), &list, &message))
      fail_msg("\"%s\" instead of \"%s\" is not refused", cases[i].by, cases[i].old);
    assert_string_equal(message, cases[i].message);
    assert_null(strchr(message, '\n'));
  }
}
#define CHECK_REFUSED(format, text, cases)                                                         \
  check_refused(state, format, text, cases, sizeof(cases) / sizeof *(cases))

static void bad_step_is_refused_with_a_reason(void **state) {
  static const bad_case cases[] = {
      {"ISO-10303-21;", "solid x;", "0: is not a STEP file: it does not begin with ISO-10303-21"},
      {"END-ISO-10303-21;", "", "19: is cut off: END-ISO-10303-21 expected"},
      {"(2,2),(2,2)", "(2,2),(2,1)", "10: surface #20: its multiplicities do not fit its points"},
      {"(2,2),(2,2)", "(2,2),(2,9999999999)",
       "10: surface #20: its multiplicities do not fit its points"},
      {"(0.,1.)", "(1.,0.)", "10: surface #20: it has knots that decrease"},
      {"(0.,1.)", "(0.)", "10: surface #20: expected as many knots as multiplicities"},
      {"'',1,1,", "'',0,1,", "10: surface #20: its degree is not a whole number from 1 on"},
      {"'',1,1,", "'',1.5,1,", "10: surface #20: its degree is not a whole number from 1 on"},
      {"(#12,#13)", "(#12)", "10: surface #20: its control points are not rows of equal length"},
      {"(#12,#13)", "(#12,#99)",
       "10: surface #20: a control point is not a CARTESIAN_POINT of three numbers"},
      {"(#12,#13)", "(#12,#13", "10: \";\" given, , or ) expected"},
      {"2.5E-1", "2.5e-1,", "9: \")\" given, a value expected"},
      {"2.5E-1", "2.5E-1.", "9: number: \"2.5E-1.\" is not a number"},
      {"2.5E-1", "1E999", "9: number: \"1E999\" is not a number"},
      {"#11 =", "#10 =", "7: entity #10 given twice"},
      {"(25.4)", "('x')", "12: unit #31 is no known unit of length"},
      {".METRE.", ".GRAM.", "12: unit #31 is no known unit of length"},
      {"GLOBAL_UNIT", "LOCAL_UNIT", "0: names no unit of length"},
      {"B_SPLINE_SURFACE_WITH_KNOTS", "PLANE",
       "0: has no B-spline surface, but PLANE; expected surfaces saved as NURBS"},
      {"B_SPLINE_SURFACE_WITH_KNOTS", "CURVE",
       "0: has no surface; expected at least one B-spline surface"},
  };
  CHECK_REFUSED(&lam_format_step, step_inch, cases);
}

static void bad_iges_is_refused_with_a_reason(void **state) {
  static const bad_case cases[] = {
      {"a comment", "x", "0: is not an IGES file: its lines are not of 80 columns"},
      {"S      1G      2D      4P      4", "S\n", "12: a line of 80 columns expected"},
      {"/1./1/2HIN", "/2./1/2HIN", "2: the scale of the model is not 1: such files are not read"},
      {"/1./1/2HIN", "/1./3/2HIN",
       "2: the unit of length is unknown; expected a flag of 1, 2 or 4 to 11"},
      {"     128       2 ", "     128       9 ",
       "6: entity 128 at D3: its directory entry points outside the parameter section"},
      {"     128       2 ", "     128       1 ",
       "6: entity 128 at D3: its parameters belong to another entity"},
      {"       1       000000000D      3", "       3       000000000D      3",
       "6: entity 128 at D3: it names a transformation that is none"},
      {"128/1/1/1/1/", "128/9/9/1/1/", "6: entity 128 at D3: parameters are missing"},
      {"128/1/1/1/1/", "128/1/1/0/1/",
       "6: entity 128 at D3: a number of points, degree or flag is out of range"},
      {"128/1/1/1/1/", "128/1/1/2/1/", "6: entity 128 at D3: it has too few points for its degree"},
      {"1.0D+0 ", "1.0F+0 ", "6: entity 128: \"1.0F+0\" is not a number"},
      {"1./1./1./1./0.", "1./1./1./-1/0.",
       "6: entity 128 at D3: it has a weight that is not positive"},
      {"     128       2 ", "     114       2 ",
       "0: has no B-spline surface (entity 128); expected surfaces saved as NURBS"},
  };
  CHECK_REFUSED(&lam_format_iges, iges_of_others(*state).data, cases);
}

static void bad_json_is_refused_with_a_reason(void **state) {
  static const char good[] =
      "{\"unit\": \"cm\", \"surfaces\": [{\"degree\": [1, 1], \"count\": [2, 2],\n"
      "\"knots_u\": [0, 0, 1, 1], \"knots_v\": [0, 0, 1, 1],\n"
      "\"points\": [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]]}]}";
  static const bad_case cases[] = {
      {"cm", "inch", "0: unit: expected m, cm or mm"},
      {"[1, 1]", "[1]", "0: surfaces[0].degree: expected two whole numbers from 1 on"},
      {"[2, 2]", "[2, 3]", "0: surfaces[0].points: expected as many points as count says"},
      {"[0, 1, 0]", "[0, 1]", "0: surfaces[0].points: expected three numbers for each"},
      {"[0, 0, 1, 1]", "[0, 1, 1]", "0: surfaces[0].knots_u: expected count + degree + 1 numbers"},
      {"[0, 0, 1, 1]", "[0, 0, 0, 0]", "0: surfaces[0] has knots with an empty domain"},
      {"\"knots_u\"", "\"weights\": [1, 1, 1], \"knots_u\"",
       "0: surfaces[0].weights: expected a number for each point"},
      {"\"knots_u\"", "\"weights\": [1, 1, 1, 0], \"knots_u\"",
       "0: surfaces[0] has a weight that is not positive"},
      {"\"surfaces\"", "\"surface\"", "0: has no surfaces; expected a map with unit and surfaces"},
  };
  lam_text text = {.arena = *state};
  lam_text_add(&text, good);
  lam_spline_list list = read_back(*state, &lam_format_surface, text);
  assert_near_named(list.items[0].points[3].z, 0.01, 1e-17, "a centimeter");
  CHECK_REFUSED(&lam_format_surface, good, cases);
  const char *message;
  assert_false(try_read(*state, &lam_format_surface, "{\n\"a\":\n,", 8, &list, &message));
  assert_memory_equal(message, "3: is not valid JSON: ", 22);
}

/* Cut anywhere, the files are refused with one message or, when only blanks are missing, read. */
static void files_may_end_anywhere(void **state) {
  lam_spline_surface s = some_surface(*state, 2, 1, 3, 2, true, true);
  lam_model model = model_of(&s, 1);
  for (int f = 0; f < readable_count; f++) {
    lam_text text = written(*state, readable[f], &model);
    for (size_t size = 0; size + 2 < text.length; size++) {
      lam_arena_mark mark = lam_arena_mark_get(*state);
      char *bytes = lam_arena_alloc(*state, size, 1); /* so that a step too far is found */
      memcpy(bytes, text.data, size);
      lam_spline_list list;
      const char *message;
      if (try_read(*state, readable[f], bytes, size, &list, &message) && size + 90 < text.length)
        fail_msg("%s: %zu of %zu bytes are read", readable[f]->name, size, text.length);
      lam_arena_release(*state, mark);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(bad_step_is_refused_with_a_reason),
      TEST(bad_iges_is_refused_with_a_reason),
      TEST(bad_json_is_refused_with_a_reason),
      TEST(files_may_end_anywhere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
