/* The text of STEP files (ISO 10303-21): what is read however it is written, and what is refused
 * and with which words; splines that do not fit together; names. */
#include "step_fixture.h"

/* Keywords in lower case, with digits and marks; comments and lines anywhere; a string that looks
 * like an entity; $ and * for what is left out; numbers with signs and without a leading digit. */
static void text_may_be_free(void **state) {
  static const char *const cases[] = {
      "#10=bezier_curve('',1,(#1,#5),.unspecified.,.f.,.f.);#5=cartesian_point('',(+1.,-.5,2.E+0))"
      ";",
      "/* #10=X( */#10 =\n POLYLINE ( $ , ( #1 /* ; */ , #5 ) ) ;\n"
      "#5=CARTESIAN_POINT(*,(1,-5e-1,\n2.));",
      "#10=POLYLINE('#11=POLYLINE('''',(#1));',(#1,#5));#5=CARTESIAN_POINT((1.,-0.5,2.));",
      "#10=POLYLINE('',(#1,#5));#5=CARTESIAN_POINT(\"0F\",(1.,-0.5,2.));"
      "#6=!OWN_9z(.Z_9.,TYPED(1.),((),(*)));",
      "#123456789012345=CARTESIAN_POINT('',(1.,-0.5,2.));#10=POLYLINE('',(#1,#123456789012345));"};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = curve_of(*state, cases[i]);
    assert_points(&c, 2, (lam_vec3[2]){{0, 0, 0}, {1, -.5, 2}}, cases[i]);
  }
}

/* Up to 64 brackets within brackets; numbers of entities of up to 15 digits; one message each. */
static void bad_text_is_refused(void **state) {
#define OPEN8 "(((((((("
#define CLOSE8 "))))))))"
#define OPEN63 OPEN8 OPEN8 OPEN8 OPEN8 OPEN8 OPEN8 OPEN8 "((((((("
#define CLOSE63 CLOSE8 CLOSE8 CLOSE8 CLOSE8 CLOSE8 CLOSE8 CLOSE8 ")))))))"
  static const char *const cases[][2] = {
      {"#6=X(" OPEN63 CLOSE63 ");#10=POLYLINE('',(#1,#2));", NULL},
      {"#6=X((" OPEN63 CLOSE63 "));", "\")\" given, fewer brackets within brackets expected"},
      {"#1234567890123456=X();", "\"=\" given, the number of an entity expected"},
      {"#=X();", "\"=\" given, the number of an entity expected"},
      {"#6=X(1 2);", "\"2\" given, , or ) expected"},
      {"#6=X(1,);", "\")\" given, a value expected"},
      {"#6=(X();", "\";\" given, a keyword expected"},
      {"#6=();", "\")\" given, a keyword expected"},
      {"#6=X(&);", "\"&\" given, a value expected"},
      {"#6 X();", "\"X\" given, = expected"},
      {"#6=X(1.2.3);", "number: \"1.2.3\" is not a number"},
      {"#6=X('", "the end of a string expected"},
      {"#6=X(\x7f);", "a value expected"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_curve_list list;
    const char *message = read_curves(*state, file_of(*state, METRE, cases[i][0]), &list);
    if (cases[i][1])
      assert_string_equal(message ? message : "it is read", cases[i][1]);
    else if (message)
      fail_msg("%s", message);
  }
}

/* Splines that do not fit together, with the message behind "curve #10: ". */
static void bad_splines_are_refused(void **state) {
#define FLAGS ",.UNSPECIFIED.,.F.,.F."
#define FIT "its number of points does not fit its degree"
  static const char *const cases[][2] = {
      {"UNIFORM_CURVE('',3,(#1,#3,#4)" FLAGS ")", FIT},
      {"QUASI_UNIFORM_CURVE('',2,(#1,#3)" FLAGS ")", FIT},
      {"BEZIER_CURVE('',2,(#1,#3,#4,#1)" FLAGS ")", FIT},
      {"BEZIER_CURVE('',1001,(#1,#3)" FLAGS ")", "its degree is not a whole number from 1 on"},
      {"BEZIER_CURVE('',1,()" FLAGS ")", "values are missing"},
      {"BEZIER_CURVE('',1,(#1,2.)" FLAGS ")",
       "a control point is not a CARTESIAN_POINT of three numbers"},
      {"B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3)" FLAGS ",(2,2))", "values are missing"},
      {"B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3)" FLAGS ",(2,2),(0.,1.,2.),.U.)",
       "expected as many knots as multiplicities"},
      {"B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3)" FLAGS ",(2,2),(0.,$),.U.)",
       "a knot is not a number"},
      {"B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3)" FLAGS ",(2,1),(0.,1.),.U.)",
       "its multiplicities do not fit its points"},
      {"B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3)" FLAGS ",(0,4),(0.,1.),.U.)",
       "its multiplicities do not fit its points"},
      {"(B_SPLINE_CURVE(1,(#1,#3)" FLAGS ")BEZIER_CURVE()RATIONAL_B_SPLINE_CURVE((1.)))",
       "expected as many weights as control points"},
      {"(B_SPLINE_CURVE(1,(#1,#3)" FLAGS ")BEZIER_CURVE()RATIONAL_B_SPLINE_CURVE((1.,$)))",
       "a weight is not a number"},
      {"(B_SPLINE_CURVE(1,(#1,#3)" FLAGS ")BEZIER_CURVE()RATIONAL_B_SPLINE_CURVE((1.,0.)))",
       "it has a weight that is not positive"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_curve_list list;
    const char *entities = lam_arena_printf(*state, "#10=%s;", cases[i][0]);
    const char *message = read_curves(*state, file_of(*state, METRE, entities), &list);
    const char *expected = lam_arena_printf(*state, "curve #10: %s", cases[i][1]);
    assert_string_equal(message ? message : "it is read", expected);
  }
}

/* Letters that are none are left out of names; a name of none of them is the entity's number; a
 * complex instance has its name in a record of its own. */
static void names_are_read(void **state) {
  lam_curve_list list;
  const char *message = read_curves(
      *state,
      file_of(*state, METRE,
              "#10=POLYLINE('a\tb\x7f c',(#1,#3));#11=POLYLINE('',(#1,#3));"
              "#12=POLYLINE($,(#1,#3));#13=POLYLINE('x',(#1,#3));#14=POLYLINE('\t',(#1,#3));"
              "#15=(B_SPLINE_CURVE(1,(#1,#3)" FLAGS ")BEZIER_CURVE()REPRESENTATION_ITEM('own'));"),
      &list);
  static const char *const names[] = {"ab c", "#11", "#12", "x", "own"};
  if (message) fail_msg("%s", message);
  for (int i = 0; i < 4; i++) assert_string_equal(list.items[i].name, names[i]);
  assert_string_equal(list.items[5].name, names[4]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(text_may_be_free),
      TEST(bad_text_is_refused),
      TEST(bad_splines_are_refused),
      TEST(names_are_read),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
