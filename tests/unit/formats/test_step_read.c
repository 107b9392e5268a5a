/* What is read of STEP files: units, positions of circles, trimmed curves, forms of knots. Expected
 * numbers follow from the entities by hand; arcs are those of Piegl & Tiller, ch. 7.2. */
#include "core/numbers.h"
#include "step_fixture.h"

static void assert_knots(const double *knots, int count, const double *expected, const char *what) {
  for (int i = 0; i < count; i++) assert_near_named(knots[i], expected[i], 0, what);
}

/* ---- units ---- */

/* Sizes of prefixes: NIST SP 811, table 5. A SI_UNIT within a complex instance has its prefix and
 * its name; as an instance of its own its dimensions, which are derived, stand before them as an
 * asterisk (ISO 10303-21), and that is taken within a complex one, too. An inch is 25.4 mm, a foot
 * 12 of them. */
static void units_of_length_are_known(void **state) {
  static const struct {
    const char *unit;
    double size;
  } cases[] = {
      {METRE, 1},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.NANO.,.METRE.))", 1e-9},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MICRO.,.METRE.))", 1e-6},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))", 1e-3},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.))", 1e-2},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.DECI.,.METRE.))", 1e-1},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.DECA.,.METRE.))", 10},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.HECTO.,.METRE.))", 100},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.METRE.))", 1000},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(*,.MILLI.,.METRE.))", 1e-3},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(*,$,.METRE.))", 1},
      {"(CONVERSION_BASED_UNIT('INCH',#91)LENGTH_UNIT()NAMED_UNIT(*))", .0254},
      {"(CONVERSION_BASED_UNIT('INCH',#93)LENGTH_UNIT()NAMED_UNIT(*))", .0254},
      {"(CONVERSION_BASED_UNIT('FOOT',#95)LENGTH_UNIT()NAMED_UNIT(*))", .3048},
  };
  static const char more[] =
      "#91=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#92);\n#92=SI_UNIT(*,.MILLI.,.METRE.);\n"
      "#93=MEASURE_WITH_UNIT(LENGTH_MEASURE(2.54),#94);\n"
      "#94=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"
      "#95=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#96);\n"
      "#96=(CONVERSION_BASED_UNIT('INCH',#93)LENGTH_UNIT()NAMED_UNIT(*));\n"
      "#10=POLYLINE('',(#1,#2));";
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_curve_list list;
    const char *message = read_curves(*state, file_of(*state, cases[i].unit, more), &list);
    if (message) fail_msg("%s: %s", cases[i].unit, message);
    assert_near_named(list.items[0].spline.points[1].y, 2 * cases[i].size, 1e-15 * cases[i].size,
                      cases[i].unit);
  }
}

static void unknown_units_are_refused(void **state) {
  static const char *const cases[][2] = {
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MEGA.,.METRE.))",
       "unit #90 is no known unit of length"},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.RADIAN.))", "unit #90 is no known unit of length"},
      {"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.METRE.))", "unit #90 is no known unit of length"},
      {"(CONVERSION_BASED_UNIT('SELF',#91)LENGTH_UNIT())", "unit #90 is no known unit of length"},
      {"(CONVERSION_BASED_UNIT('ZERO',#92)LENGTH_UNIT())", "unit #90 is no known unit of length"},
      {"(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))", "names no unit of length"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_curve_list list;
    const char *message =
        read_curves(*state,
                    file_of(*state, cases[i][0],
                            "#91=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.),#90);\n"
                            "#92=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.),#93);\n#93=" METRE
                            ";\n#10=POLYLINE('',(#1,#2));"),
                    &list);
    assert_string_equal(message ? message : "it is read", cases[i][1]);
  }
}

/* A second context may repeat the unit, and may not bring another one. */
static void there_is_one_unit_of_length(void **state) {
  static const char same[] =
      "#81=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#91)));\n#91=" METRE ";\n#10=POLYLINE('',(#1,#2));",
                    other[] = "#81=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#91)));\n"
                              "#91=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
                              "#10=POLYLINE('',(#1,#2));";
  lam_curve_list list;
  assert_near(curve_of(*state, same).points[1].x, 1, 0);
  assert_string_equal(read_curves(*state, file_of(*state, METRE, other), &list),
                      "two units of length, 1 m and 0.001 m; one expected");
}

/* Parameters of circles are in the unit of plane angles: a quarter turn is 90 degrees, or pi / 2
 * where no unit that is known is given. */
static void angles_have_units(void **state) {
  static const char *const cases[][2] = {
      {"(CONVERSION_BASED_UNIT('DEGREE',#92)NAMED_UNIT(*)PLANE_ANGLE_UNIT())", "90."},
      {"(CONVERSION_BASED_UNIT('DEGREE',#94)NAMED_UNIT(*)PLANE_ANGLE_UNIT())", "90."},
      {"(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))", "1.5707963267948966"},
      {"(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT(.MILLI.,.RADIAN.))", "1570.7963267948966"},
      {"(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.STERADIAN.))", "1.5707963267948966"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = curve_of(
        *state,
        lam_arena_printf(
            *state,
            "#81=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#91)));\n#91=%s;\n"
            "#92=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#93);\n"
            "#93=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
            "#94=MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#93);\n"
            "#30=AXIS2_PLACEMENT_3D('',#1,$,$);\n#31=CIRCLE('',#30,2.);\n"
            "#32=TRIMMED_CURVE('',#31,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(%s)),.T.,"
            ".PARAMETER.);",
            cases[i][0], cases[i][1]));
    assert_points(&c, 3, (lam_vec3[3]){{2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, cases[i][0]);
  }
}

/* ---- circles and ellipses ---- */

/* A quarter turn of radius 2 around the origin, from x to y of its position: control points 2 x,
 * 2 x + 2 y and 2 y, weights 1, cos 45, 1. The axes by ISO 10303-42: z and x when they are
 * left out; x made at right angles to z; y instead of x where z is near x (0.9). */
static void positions_have_axes(void **state) {
  static const struct {
    const char *axes;
    lam_vec3 x, y;
  } cases[] = {
      {"$,$", {1, 0, 0}, {0, 1, 0}},         {"#20,$", {0, 1, 0}, {0, 0, 1}},
      {"#21,#22", {1, 0, 0}, {0, 1, 0}},     {"#23,$", {.6, 0, -.8}, {0, 1, 0}},
      {"#24,$", {0, 1, 0}, {-.28, 0, -.96}}, {"$,#25", {0, 1, 0}, {-1, 0, 0}},
  };
  static const double weights[3] = {1, .70710678118654752, 1}, knots[6] = {0, 0, 0, 1, 1, 1};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = curve_of(
        *state, lam_arena_printf(*state,
                                 "#20=DIRECTION('',(1.,0.,0.));\n#21=DIRECTION('',(0.,0.,2.));\n"
                                 "#22=DIRECTION('',(1.,0.,1.));\n#23=DIRECTION('',(.8,0.,.6));\n"
                                 "#24=DIRECTION('',(-.96,0.,.28));\n#25=DIRECTION('',(0.,3.,0.));\n"
                                 "#30=AXIS2_PLACEMENT_3D('',#1,%s);\n#31=CIRCLE('',#30,2.);\n"
                                 "#32=TRIMMED_CURVE('',#31,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE("
                                 "1.5707963267948966)),.T.,.PARAMETER.);",
                                 cases[i].axes));
    lam_vec3 x = lam_scale(cases[i].x, 2), y = lam_scale(cases[i].y, 2);
    assert_points(&c, 3, (lam_vec3[3]){x, lam_add(x, y), y}, cases[i].axes);
    assert_knots(c.knots, 6, knots, "knots");
    for (int k = 0; k < 3; k++) assert_near(c.weights[k], weights[k], 1e-15);
  }
}

/* Around (4, 0, 0), in the plane of x and y; c = cos 45: the middle of a quarter stands 1 / c
 * out. */
static void arcs_run_between_their_ends(void **state) {
  const double c = sqrt(.5);
  const struct {
    const char *curve, *trims;
    int count;
    lam_vec3 points[9];
  } cases[] = {
      {"CIRCLE('',#30,2.)",
       "(PARAMETER_VALUE(1.5707963267948966)),(PARAMETER_VALUE(0.)),.F.",
       3,
       {{6, 0, 0}, {6, 2, 0}, {4, 2, 0}}},
      {"ELLIPSE('',#30,2.,1.)",
       "(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.5707963267948966)),.T.",
       3,
       {{6, 0, 0}, {6, 1, 0}, {4, 1, 0}}},
      {"ELLIPSE('',#30,2.,1.)",
       "(#40),(#41),.T.",
       3,
       {{4 + 2 * c, c, 0}, {4, 1 / c, 0}, {4 - 2 * c, c, 0}}},
      {"CIRCLE('',#30,1.)", "(#42),(#43),.T.", 3, {{5, 0, 0}, {5, 1, 0}, {4, 1, 0}}},
      {"CIRCLE('',#30,1.)", "(#43),(#42),.F.", 3, {{5, 0, 0}, {5, 1, 0}, {4, 1, 0}}},
      {"CIRCLE('',#30,1.)",
       "(#42),(#42),.T.",
       9,
       {{5, 0, 0},
        {5, 1, 0},
        {4, 1, 0},
        {3, 1, 0},
        {3, 0, 0},
        {3, -1, 0},
        {4, -1, 0},
        {5, -1, 0},
        {5, 0, 0}}},
      {"CIRCLE('',#30,1.)",
       "(PARAMETER_VALUE(0.),#42),(PARAMETER_VALUE(3.),#43),.T.",
       3,
       {{5, 0, 0}, {5, 1, 0}, {4, 1, 0}}},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve arc = curve_of(
        *state, lam_arena_printf(*state,
                                 "#30=AXIS2_PLACEMENT_3D('',#3,$,$);\n#31=%s;\n"
                                 "#32=TRIMMED_CURVE('',#31,%s,.PARAMETER.);\n"
                                 "#40=CARTESIAN_POINT('',(%.17g,%.17g,0.));\n"
                                 "#41=CARTESIAN_POINT('',(%.17g,%.17g,0.));\n"
                                 "#42=CARTESIAN_POINT('',(5.,0.,0.));\n"
                                 "#43=CARTESIAN_POINT('',(4.,1.,0.));",
                                 cases[i].curve, cases[i].trims, 4 + 2 * c, c, 4 - 2 * c, c));
    assert_points(&arc, cases[i].count, cases[i].points, cases[i].trims);
  }
}

static void parallel_axes_are_refused(void **state) {
  lam_curve_list list;
  const char *message = read_curves(
      *state,
      file_of(*state, METRE,
              "#20=DIRECTION('',(0.,0.,1.));\n#30=AXIS2_PLACEMENT_3D('',#1,#20,#20);\n"
              "#31=CIRCLE('',#30,2.);\n#32=TRIMMED_CURVE('',#31,(#3),(#4),.T.,.CARTESIAN.);"),
      &list);
  assert_string_equal(message ? message : "it is read",
                      "curve #32: the axes of its position are parallel");
}

/* ---- splines ---- */

/* The same four or five points along x with the knots that each form stands for (ISO
 * 10303-42). */
static void knots_that_are_not_listed_are_known(void **state) {
  static const struct {
    const char *curve;
    double knots[9];
  } cases[] = {
      {"BEZIER_CURVE('',2,(#1,#3,#4,#3,#1),.UNSPECIFIED.,.F.,.F.)", {0, 0, 0, 1, 1, 2, 2, 2}},
      {"QUASI_UNIFORM_CURVE('',2,(#1,#3,#4,#3,#1),.UNSPECIFIED.,.F.,.F.)",
       {0, 0, 0, 1, 2, 3, 3, 3}},
      {"B_SPLINE_CURVE_WITH_KNOTS('',2,(#1,#3,#4,#3,#1),.UNSPECIFIED.,.F.,.F.,(3,1,1,3),"
       "(-1.,0.,5.,7.),.UNSPECIFIED.)",
       {-1, -1, -1, 0, 5, 7, 7, 7}},
      {"(B_SPLINE_CURVE(2,(#1,#3,#4,#3,#1),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS("
       "(3,2,3),(0.,1.,3.),.UNSPECIFIED.)RATIONAL_B_SPLINE_CURVE((1.,2.,3.,4.,5.)))",
       {0, 0, 0, 1, 1, 3, 3, 3}},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = curve_of(*state, lam_arena_printf(*state, "#10=%s;", cases[i].curve));
    assert_int_equal(c.degree, 2);
    assert_int_equal(c.count, 5);
    assert_knots(c.knots, 8, cases[i].knots, cases[i].curve);
    assert_near(c.points[2].y, 4, 0);
    assert_int_equal(c.weights != NULL, i == 3);
    if (c.weights) assert_near(c.weights[3], 4, 0);
  }
  /* uniform knots -2 .. 4 over the triangle (0,0), (4,0), (4,4): the curve begins in the middle of
   * the first two points and ends in the middle of the last two, with the second as its corner */
  lam_spline_curve u =
      curve_of(*state, "#10=UNIFORM_CURVE('',2,(#1,#3,#4),.UNSPECIFIED.,.F.,.F.);");
  assert_points(&u, 3, (lam_vec3[3]){{2, 0, 0}, {4, 0, 0}, {4, 2, 0}}, "uniform");
}

/* A straight cubic (t, 0, 0), 0 <= t <= 4 is linear, so its parts are known: cut at parameters in
 * either order, at points, and no further than it reaches. */
static void splines_are_cut(void **state) {
  static const struct {
    const char *trims;
    double from, to;
  } cases[] = {
      {"(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(3.)),.T.", 1, 3},
      {"(PARAMETER_VALUE(3.)),(PARAMETER_VALUE(1.)),.F.", 1, 3},
      {"(PARAMETER_VALUE(-1.)),(PARAMETER_VALUE(2.)),.T.", 0, 2},
      {"(PARAMETER_VALUE(2.)),(PARAMETER_VALUE(9.)),.T.", 2, 4},
      {"(PARAMETER_VALUE(2.)),(PARAMETER_VALUE(2.)),.T.", 0, 4},
      {"(#1),(#3),.T.", 0, 4},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    lam_spline_curve c = curve_of(
        *state, lam_arena_printf(*state,
                                 "#10=B_SPLINE_CURVE_WITH_KNOTS('',1,(#1,#3),.UNSPECIFIED.,.F.,.F.,"
                                 "(2,2),(0.,4.),.UNSPECIFIED.);\n"
                                 "#32=TRIMMED_CURVE('',#10,%s,.PARAMETER.);",
                                 cases[i].trims));
    assert_points(&c, 2, (lam_vec3[2]){{cases[i].from, 0, 0}, {cases[i].to, 0, 0}}, cases[i].trims);
  }
}

/* A polyline of degree 1 has its corners at whole numbers. */
static void polylines_have_whole_knots(void **state) {
  static const double knots[5] = {0, 0, 1, 2, 2};
  lam_spline_curve c = curve_of(*state, "#10=POLYLINE('',(#1,#3,#4));");
  assert_points(&c, 3, (lam_vec3[3]){{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, "polyline");
  assert_knots(c.knots, 5, knots, "polyline");
}

/* ---- which curves are listed ---- */

/* What other curves lie on, and what is drawn in the parameters of a surface, is no curve of its
 * own: of eight entities two are listed, in the order of their numbers. */
static void curves_that_serve_others_are_left_out(void **state) {
  lam_curve_list list;
  const char *message = read_curves(
      *state,
      file_of(*state, METRE,
              "#50=POLYLINE('z',(#1,#3));\n#51=SEAM_CURVE('',#50,(),.CURVE_3D.);\n"
              "#10=POLYLINE('a',(#1,#3));\n#11=INTERSECTION_CURVE('',#10,(),.CURVE_3D.);\n"
              "#12=POLYLINE('b',(#1,#3));\n#13=DEFINITIONAL_REPRESENTATION('',(#1,#12),#80);\n"
              "#14=POLYLINE('c',(#1,#3));\n#15=TRIMMED_CURVE('d',#14,(#1),(#3),.T.,.CARTESIAN.);\n"
              "#9=POLYLINE('',(#1,#3));"),
      &list);
  if (message) fail_msg("%s", message);
  assert_int_equal(list.count, 2);
  assert_string_equal(list.items[0].name, "#9");
  assert_string_equal(list.items[1].name, "d");
  assert_int_equal(list.items[0].family, -1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(units_of_length_are_known),
      TEST(unknown_units_are_refused),
      TEST(there_is_one_unit_of_length),
      TEST(angles_have_units),
      TEST(positions_have_axes),
      TEST(arcs_run_between_their_ends),
      TEST(parallel_axes_are_refused),
      TEST(knots_that_are_not_listed_are_known),
      TEST(splines_are_cut),
      TEST(polylines_have_whole_knots),
      TEST(curves_that_serve_others_are_left_out),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
