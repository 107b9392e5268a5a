/* Curves in files: STEP, IGES, surface.json, OBJ. What OpenCASCADE reads is in tests/cli/step.t. */
#include "core/numbers.h"
#include "curve/curve.h"
#include "curve/length.h"
#include "files_fixture.h"
#include "formats/spline/curves.h"

/* Which format writes, and which reads that. */
static const struct {
  const lam_format *writes, *reads;
} formats[] = {{&lam_format_step, &lam_format_step},
               {&lam_format_iges, &lam_format_iges},
               {&lam_format_surface, &lam_format_surface},
               {&lam_format_surface_obj, &lam_format_obj}};
enum { format_count = 4 };

/* A clamped curve of numbers from a fixed sequence. */
static lam_spline_curve some_curve(lam_arena *arena, int degree, int count, bool rational) {
  lam_spline_surface s = some_surface(arena, degree, 1, count, 2, rational, true);
  return (lam_spline_curve){degree, count, s.knots[0], s.points, s.weights};
}

static bool try_curves(lam_arena *arena, const lam_format *format, const char *bytes, size_t size,
                       lam_curve_list *list, const char **message) {
  lam_errors errors = {.arena = arena};
  bool good = format->read_curves(arena, bytes, size, (lam_location){.file = "x"}, &errors, list);
  assert_int_equal(errors.count, good ? 0 : 1); /* one message */
  *message =
      good ? NULL
           : lam_arena_printf(arena, "%d: %s", errors.first->location.line, errors.first->text);
  return good;
}

static lam_curve_list curves_of(lam_arena *arena, const lam_format *format, const char *text) {
  lam_curve_list list;
  const char *message;
  if (!try_curves(arena, format, text, strlen(text), &list, &message))
    fail_msg("%s: %s", format->name, message);
  return list;
}

static void assert_same_curve(const lam_spline_curve *a, const lam_spline_curve *b,
                              const char *what) {
  assert_int_equal(a->degree, b->degree);
  assert_int_equal(a->count, b->count);
  assert_int_equal(a->weights != NULL, b->weights != NULL);
  for (int i = 0; i < a->count + a->degree + 1; i++) assert_true(a->knots[i] == b->knots[i]);
  for (int i = 0; i < a->count; i++) {
    assert_near_named(lam_distance(a->points[i], b->points[i]), 0, 1e-15 * lam_length(b->points[i]),
                      what);
    if (a->weights) assert_true(a->weights[i] == b->weights[i]);
  }
}

static lam_vec3 point_at(const lam_spline_curve *c, double t) {
  lam_vec3 x;
  lam_spline_curve_eval(c, t, 0, &x);
  return x;
}
static lam_vec3 start_of(const lam_spline_curve *c) { return point_at(c, c->knots[c->degree]); }
static lam_vec3 end_of(const lam_spline_curve *c) { return point_at(c, c->knots[c->count]); }

static void assert_place(lam_vec3 x, double a, double b, double c, const char *what) {
  double off = lam_distance(x, lam_v3(a, b, c));
  if (!(off <= 1e-15))
    fail_msg("%s: (%.17g, %.17g, %.17g), expected (%g, %g, %g)", what, x.x, x.y, x.z, a, b, c);
}

/* ---- there and back ---- */

/* Knots and weights come back as the same doubles, points to the last digit, with names and in
 * their order; a surface beside them does not get in the way. */
static void curves_come_back(void **state) {
  lam_spline_surface roof = some_surface(*state, 2, 2, 5, 4, true, true);
  lam_named_curve curves[] = {{"A01", 0, some_curve(*state, 3, 9, false)},
                              {"A02", 0, some_curve(*state, 2, 5, true)},
                              {"B01", 1, some_curve(*state, 1, 2, false)},
                              {"rim", -1, some_curve(*state, 5, 30, true)}};
  for (int f = 0; f < format_count; f++)
    for (int with_surface = 0; with_surface < 2; with_surface++) {
      lam_model model = model_of(&roof, with_surface);
      model.curve_count = 4;
      model.curves = curves;
      lam_text text = written(*state, formats[f].writes, &model);
      lam_curve_list list = curves_of(*state, formats[f].reads, text.data);
      bool sides = with_surface &&
                   f < 2; /* of the surface: edges of its face, and curves of their own in IGES */
      assert_int_equal(list.count, 4 + (sides ? 4 : 0));
      int seen = 0;
      for (int i = 0; i < list.count; i++)
        for (int k = 0; k < 4; k++)
          if (strcmp(list.items[i].name, curves[k].name) == 0) {
            assert_same_curve(&list.items[i].spline, &curves[k].spline, formats[f].writes->name);
            seen = 10 * seen + k;
          }
      assert_true(f == 0 ? seen == 3012 : seen == 123); /* in STEP curves of no family come first */
      if (with_surface) assert_int_equal(read_back(*state, formats[f].reads, text).count, 1);
    }
}

static void a_model_without_curves_has_none(void **state) {
  lam_spline_surface roof = some_surface(*state, 2, 2, 5, 4, false, true);
  lam_model none = model_of(NULL, 0), only_surface = model_of(&roof, 1);
  for (int f = 0; f < format_count; f++) {
    assert_int_equal(formats[f].writes->count(&none), 0);
    assert_null(strstr(written(*state, formats[f].writes, &only_surface).data, "CURVE_SET"));
  }
}

/* The sides of a surface are curves of its STEP and IGES files: a boundary can be taken from a
 * face. */
static void sides_of_a_face_are_curves(void **state) {
  lam_spline_surface roof = some_surface(*state, 3, 2, 6, 5, false, true);
  lam_model model = model_of(&roof, 1);
  for (int f = 0; f < 2; f++) {
    lam_curve_list list =
        curves_of(*state, formats[f].reads, written(*state, formats[f].writes, &model).data);
    assert_int_equal(list.count, 4);
    double ends = 0;
    for (int i = 0; i < 4; i++) /* every corner is an end of two sides */
      for (int k = 0; k < 4; k++)
        if (k != i)
          ends +=
              (lam_distance(start_of(&list.items[i].spline), start_of(&list.items[k].spline)) <
               1e-9) +
              (lam_distance(start_of(&list.items[i].spline), end_of(&list.items[k].spline)) <
               1e-9) +
              (lam_distance(end_of(&list.items[i].spline), end_of(&list.items[k].spline)) < 1e-9) +
              (lam_distance(end_of(&list.items[i].spline), start_of(&list.items[k].spline)) < 1e-9);
    assert_near_named(ends, 8, 0, "ends that meet, counted from both");
  }
}

/* ---- what other programs write ---- */

#define STEP_BEGIN "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
#define STEP_END                                                                                   \
  "#90=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#91,#92))REPRESENTATION_" \
  "CONTEXT('',''));\n"                                                                             \
  "#91=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"                                          \
  "#92=(CONVERSION_BASED_UNIT('DEGREE',#93)NAMED_UNIT(#95)PLANE_ANGLE_UNIT());\n"                  \
  "#93=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#94);\n"            \
  "#94=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"                                    \
  "#95=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);\nENDSEC;\nEND-ISO-10303-21;\n"

/* An edge on a line, one on a circle of radius 2 around (0,0,1) in the plane z = 1 with the x axis
 * along y, the other way around; one on a part of the cubic (t, 0, 0); a line and a circle trimmed
 * by parameters, in degrees; a polyline; a curve in the parameters of a surface, which is none. */
static const char step_curves[] = STEP_BEGIN
    "#1=CARTESIAN_POINT('',(0.,2.,1.));\n#2=CARTESIAN_POINT('',(2.,0.,1.));\n#3=VERTEX_POINT('',#1)"
    ";\n"
    "#4=VERTEX_POINT('',#2);\n#5=DIRECTION('',(1.,-1.,0.));\n#6=VECTOR('',#5,1.);\n#7=LINE('',#1,#"
    "6);\n"
    "#8=EDGE_CURVE('chord',#3,#4,#7,.T.);\n"
    "#10=CARTESIAN_POINT('',(0.,0.,1.));\n#11=DIRECTION('',(0.,0.,1.));\n#12=DIRECTION('',(0.,1.,0."
    "));\n"
    "#13=AXIS2_PLACEMENT_3D('',#10,#11,#12);\n#14=CIRCLE('',#13,2.);\n#15=SURFACE_CURVE('',#14,(#"
    "51),.PCURVE_S1.);\n"
    "#16=EDGE_CURVE('it''s round',#3,#4,#15,.F.);\n"
    "#20=CARTESIAN_POINT('',(0.,0.,0.));\n#21=CARTESIAN_POINT('',(1.,0.,0.));\n#22=CARTESIAN_POINT("
    "'',(2.,0.,0.));\n"
    "#23=CARTESIAN_POINT('',(3.,0.,0.));\n"
    "#24=B_SPLINE_CURVE_WITH_KNOTS('',3,(#20,#21,#22,#23),.UNSPECIFIED.,.F.,.F.,(4,4),(0.,3.),."
    "UNSPECIFIED.);\n"
    "#25=VERTEX_POINT('',#22);\n#26=VERTEX_POINT('',#21);\n#27=EDGE_CURVE('',#25,#26,#24,.F.);\n"
    "#30=TRIMMED_CURVE('half',#14,(PARAMETER_VALUE(90.)),(PARAMETER_VALUE(270.)),.T.,.PARAMETER.);"
    "\n"
    "#31=TRIMMED_CURVE('part',#7,(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);\n"
    "#32=TRIMMED_CURVE('third',#24,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);\n"
    "#40=POLYLINE('bent',(#20,#21,#2));\n"
    "#50=B_SPLINE_CURVE_WITH_KNOTS('flat',1,(#52,#53),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),."
    "UNSPECIFIED.);\n"
    "#52=CARTESIAN_POINT('',(0.,0.));\n#53=CARTESIAN_POINT('',(1.,0.));\n"
    "#60=PARABOLA('',#13,2.);\n#61=EDGE_CURVE('open',#3,#4,#60,.T.);\n"
    "#62=ELLIPSE('',#13,2.,1.);\n#63=TRIMMED_CURVE('oval',#62,(#1),(PARAMETER_VALUE(90.),#65),.T.,."
    "CARTESIAN.);\n"
    "#65=CARTESIAN_POINT('',(-1.,0.,1.));\n" STEP_END;

static void step_curves_of_others_are_read(void **state) {
  static const char *const names[] = {"chord", "it's round", "#27",  "half",
                                      "part",  "third",      "bent", "oval"};
  lam_curve_list list = curves_of(*state, &lam_format_step, step_curves);
  assert_int_equal(list.count, 8);
  assert_string_equal(list.other, "PARABOLA");
  for (int i = 0; i < 8; i++) assert_string_equal(list.items[i].name, names[i]);
  const lam_spline_curve c[] = {list.items[0].spline, list.items[1].spline, list.items[2].spline,
                                list.items[3].spline, list.items[4].spline, list.items[5].spline,
                                list.items[6].spline};
  assert_place(start_of(&c[0]), 0, 2, 1, "chord");
  assert_place(end_of(&c[0]), 2, 0, 1, "chord");
  /* the circle from (2,0,1), counterclockwise over (0,2,1)'s quarter: the edge runs against it */
  assert_near_named(lam_distance(start_of(&c[1]), lam_v3(2, 0, 1)), 0, 1e-15, "arc");
  assert_near_named(lam_distance(end_of(&c[1]), lam_v3(0, 2, 1)), 0, 1e-15, "arc");
  for (int i = 0; i <= 20; i++)
    assert_near_named(
        lam_distance(
            point_at(&c[1], c[1].knots[2] + i / 20.0 * (c[1].knots[c[1].count] - c[1].knots[2])),
            lam_v3(0, 0, 1)),
        2, 1e-15, "radius");
  lam_curve arc = lam_curve_of_spline(*state, &c[1]), half = lam_curve_of_spline(*state, &c[3]);
  assert_near_named(lam_curve_length(&arc, arc.from, arc.to, 1e-12), LAM_PI, 1e-12,
                    "a quarter of a circle of radius 2");
  assert_near_named(lam_distance(start_of(&c[2]), lam_v3(1, 0, 0)), 0, 1e-15,
                    "cut at the vertices");
  assert_near_named(lam_distance(end_of(&c[2]), lam_v3(2, 0, 0)), 0, 1e-15, "cut at the vertices");
  assert_near_named(lam_curve_length(&half, half.from, half.to, 1e-12), 2 * LAM_PI, 1e-12,
                    "half of a circle");
  assert_near_named(lam_distance(start_of(&c[3]), lam_v3(-2, 0, 1)), 0, 1e-15,
                    "90 degrees from the y axis");
  double h = sqrt(0.5);
  assert_near_named(lam_distance(start_of(&c[4]), lam_v3(h, 2 - h, 1)), 0, 1e-15,
                    "one step along the line");
  assert_near_named(lam_distance(end_of(&c[4]), lam_v3(2 * h, 2 - 2 * h, 1)), 0, 1e-15,
                    "two steps");
  assert_near_named(lam_distance(end_of(&c[5]), lam_v3(1, 0, 0)), 0, 1e-15,
                    "trimmed by parameters");
  const lam_spline_curve *oval = &list.items[7].spline;
  for (int i = 0; i <= 20; i++) { /* half axes: 2 along y, 1 along -x */
    lam_vec3 x =
        point_at(oval, oval->knots[2] + i / 20.0 * (oval->knots[oval->count] - oval->knots[2]));
    assert_near_named(x.x * x.x + x.y * x.y / 4, 1, 1e-14, "ellipse");
    assert_true(x.x < 1e-15 && x.y > -1e-15);
  }
  assert_near_named(lam_distance(end_of(oval), lam_v3(-1, 0, 1)), 0, 1e-15, "end of the ellipse");
  assert_place(point_at(&c[6], 1), 1, 0, 0, "a corner");
  assert_place(end_of(&c[6]), 2, 0, 1, "its end");
}

/* In inches, with other delimiters: a line, an arc and a polyline that entity 124 turns by 90
 * degrees about z and moves by 10 inches along x, a curve of which only the middle third counts,
 * and one in the parameters of a surface; data that are no polyline. */
static const char *iges_curves(lam_arena *arena) {
  static const char *const directory[] = {
      "     124       1       0       0       0       0       0       000000000",
      "     124       0       0       1       0                               0",
      "     110       2       0       0       0       0       1       000000000",
      "     110       0       0       1       0                    line       0",
      "     100       3       0       0       0       0       1       000000000",
      "     100       0       0       1       0                               0",
      "     126       4       0       0       0       0       0       000010000",
      "     126       0       0       2       0                   third       0",
      "     126       6       0       0       0       0       0       000010500",
      "     126       0       0       1       0                               0",
      "     106       7       0       0       0       0       1       000000000",
      "     106       0       0       1      11                    bent       0",
      "     106       7       0       0       0       0       0       000000000",
      "     106       0       0       1      20                    axis       0"};
  static const char *const parameters[] = {
      "124/0./-1./0./10./1./0./0./0./0./0./1./0.$                            1",
      "110/0./0./0./1./0./2.$                                                3",
      "100/3./0./0./1./0./0./1.$                                             5",
      "126/1/1/0/0/1/0/0./0./3./3./1./1./0./0./0./                           7",
      "3./0./0./1./2./0./0./1.$                                              7",
      "126/1/1/0/0/1/0/0./0./3./3./1./1./0./0./0./3./0./0./1./2./0./0./1.$   9",
      "106/1/3/2./0./0./1./0./1./1.$                                        11"};
  lam_text text = {.arena = arena};
  add_line(&text, "a comment", 'S', 1);
  add_line(&text, "1H//1H$/3Ha/b/4Ha.ig/1Hx/1Hy/32/38/6/38/15/1Hz/1./1/2HIN/1/.1/", 'G', 1);
  add_line(&text, "15H20000101.000000/1.D-3/10.$", 'G', 2);
  for (int i = 0; i < 14; i++) add_line(&text, directory[i], 'D', i + 1);
  for (int i = 0; i < 7; i++) add_line(&text, parameters[i], 'P', i + 1);
  add_line(&text, "S      1G      2D     14P      7", 'T', 1);
  return text.data;
}

static void iges_curves_of_others_are_read(void **state) {
  lam_curve_list list = curves_of(*state, &lam_format_iges, iges_curves(*state));
  assert_int_equal(list.count, 4);
  assert_string_equal(list.items[3].name, "bent");
  assert_string_equal(list.items[0].name, "line");
  assert_string_equal(list.items[1].name, "D5");
  assert_string_equal(list.items[2].name, "third");
  const lam_spline_curve *line = &list.items[0].spline, *arc = &list.items[1].spline,
                         *third = &list.items[2].spline;
  const double inch = 0.0254;
  assert_near_named(lam_distance(start_of(line), lam_v3(10 * inch, 0, 0)), 0, 1e-15, "line");
  assert_near_named(lam_distance(end_of(line), lam_v3(10 * inch, inch, 2 * inch)), 0, 1e-15,
                    "line");
  assert_near_named(lam_distance(start_of(arc), lam_v3(10 * inch, inch, 3 * inch)), 0, 1e-15,
                    "arc");
  assert_near_named(lam_distance(end_of(arc), lam_v3(9 * inch, 0, 3 * inch)), 0, 1e-15, "arc");
  lam_curve quarter = lam_curve_of_spline(*state, arc);
  assert_near_named(lam_curve_length(&quarter, quarter.from, quarter.to, 1e-12), LAM_PI / 2 * inch,
                    1e-14, "a quarter turn");
  const lam_spline_curve *bent = &list.items[3].spline;
  assert_near_named(lam_distance(point_at(bent, 1), lam_v3(10 * inch, inch, 2 * inch)), 0, 1e-15,
                    "the corner of the polyline");
  assert_near_named(lam_distance(end_of(bent), lam_v3(9 * inch, inch, 2 * inch)), 0, 1e-15,
                    "its end");
  assert_near_named(lam_distance(start_of(third), lam_v3(inch, 0, 0)), 0, 1e-15, "third");
  assert_near_named(lam_distance(end_of(third), lam_v3(2 * inch, 0, 0)), 0, 1e-15, "third");
}

/* A part of a curve is the curve: random cuts of rational curves with open and repeated knots. */
static void parts_are_the_curve(void **state) {
  for (int open = 0; open < 2; open++) {
    lam_spline_surface s = some_surface(*state, 4, 1, 9, 2, true, !open);
    lam_vec3 points[9];
    for (int i = 0; i < 9; i++) points[i] = lam_v3(i, sin(2 * i), cos(i));
    lam_spline_curve c = {4, 9, s.knots[0], points, s.weights};
    double low = c.knots[4], high = c.knots[9], size = 8;
    const double cuts[][2] = {{low, high},
                              {low, 0.3 * low + 0.7 * high},
                              {0.6 * low + 0.4 * high, high},
                              {c.knots[5], c.knots[8]},
                              {0.9 * low + 0.1 * high, 0.85 * low + 0.15 * high}};
    for (int k = 0; k < 5; k++) {
      lam_spline_curve part = lam_curve_part(*state, &c, cuts[k][0], cuts[k][1]);
      assert_null(lam_curve_problem(&part));
      assert_true(part.knots[0] == cuts[k][0] && part.knots[part.count + 4] == cuts[k][1]);
      for (int i = 0; i <= 16; i++) {
        double t = cuts[k][0] + (cuts[k][1] - cuts[k][0]) * i / 16;
        assert_near_named(lam_distance(point_at(&part, t), point_at(&c, t)), 0, 1e-13 * size,
                          "part");
      }
      lam_spline_side side = lam_spline_side_of_curve(&c);
      lam_vec3 slope, exact[2];
      lam_spline_curve_eval(&c, cuts[k][0], 1, exact);
      lam_spline_side_slope(*state, &side, cuts[k][0], &slope);
      assert_near_named(lam_distance(slope, exact[1]), 0, 1e-12 * lam_length(exact[1]),
                        "derivative");
      lam_spline_curve again =
          lam_curve_between(*state, &c, point_at(&c, cuts[k][1]), point_at(&c, cuts[k][0]));
      assert_near_named(again.knots[0], cuts[k][0], 1e-9, "found by its ends");
      assert_near_named(again.knots[again.count], cuts[k][1], 1e-9, "found by its ends");
    }
  }
}

/* ---- units ---- */

/* One curve in STEP and IGES files of other units: what is 1 in the file. Sizes: NIST SP 811;
 * IGES 5.3, 2.2.4.3.14. */
static void units_are_honored(void **state) {
  static const struct {
    const char *step;
    int iges;
    double size;
  } units[] = {{"SI_UNIT($,.METRE.)", 6, 1},
               {"SI_UNIT(.MILLI.,.METRE.)", 2, 1e-3},
               {"SI_UNIT(.CENTI.,.METRE.)", 10, 1e-2},
               {"SI_UNIT(.MICRO.,.METRE.)", 9, 1e-6},
               {"SI_UNIT(.KILO.,.METRE.)", 7, 1e3},
               {"CONVERSION_BASED_UNIT('INCH',#96)", 1, 0.0254},
               {"CONVERSION_BASED_UNIT('FOOT',#97)", 4, 0.3048}};
  static const char more[] =
      "#96=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.54),#98);\n"
      "#97=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#99);\n"
      "#98=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"
      "#99=(CONVERSION_BASED_UNIT('INCH',#96)LENGTH_UNIT()NAMED_UNIT(#95));\n#90=";
  for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
    char *step = replaced(
        *state, replaced(*state, step_curves, "SI_UNIT($,.METRE.)", units[i].step), "#90=", more);
    assert_near_named(end_of(&curves_of(*state, &lam_format_step, step).items[0].spline).x,
                      2 * units[i].size, 1e-15 * units[i].size, units[i].step);
    char *flag = lam_arena_printf(*state, "/1./%d/2HIN", units[i].iges);
    char *iges = replaced(*state, iges_curves(*state), "/1./1/2HIN", flag);
    if (units[i].iges >= 10) iges = replaced(*state, iges, "/1/.1/ ", "/1/.1/");
    assert_near_named(end_of(&curves_of(*state, &lam_format_iges, iges).items[2].spline).x,
                      2 * units[i].size, 1e-15 * units[i].size, flag);
  }
}

/* ---- bad files ---- */

static void check_refused(void **state, const lam_format *format, const char *text,
                          const bad_case *cases, size_t n) {
  for (size_t i = 0; i < n; i++) {
    char *bad = replaced(*state, text, cases[i].old, cases[i].by);
    lam_curve_list list;
    const char *message = "it is read";
    try_curves(*state, format, bad, strlen(bad), &list, &message);
    assert_string_equal(message, cases[i].message);
  }
}

static void bad_curves_are_refused_with_a_reason(void **state) {
  static const bad_case step[] = {
      {"(4,4)", "(4,3)", "24: curve #24: its multiplicities do not fit its points"},
      {"(0.,3.)", "(3.,0.)", "24: curve #24: it has knots that decrease"},
      {"'',3,(", "'',4,(", "24: curve #24: its multiplicities do not fit its points"},
      {"'',3,(", "'',.5,(", "24: curve #24: its degree is not a whole number from 1 on"},
      {"#13,2.)", "#13,-2.)", "19: curve #16: its radius is not a positive number"},
      {"#14=CIRCLE('',#13", "#14=CIRCLE('',#12",
       "19: curve #16: its position is not an AXIS2_PLACEMENT_3D"},
      {"#3,#4,#7", "#3,#1,#7", "12: curve #8: it does not end at VERTEX_POINTs"},
      {"(PARAMETER_VALUE(1.))", "()", "29: curve #31: it is not trimmed at two ends"},
      {"(#20,#21,#2)", "(#20)", "31: curve #40: a polyline of fewer than two points"},
      {"#15=SURFACE_CURVE('',#14", "#15=SURFACE_CURVE('',#15",
       "19: curve #16: curves within curves without end"},
  };
  static const bad_case iges[] = {
      {"126/1/1/0/0/1/0/0./0./3./3.", "126/9/1/0/0/1/0/0./0./3./3.",
       "10: entity 126 at D7: parameters are missing"},
      {"126/1/1/0/0/1/0/0./0./3./3.", "126/1/1/0/0/1/0/0./0./3./2.",
       "10: entity 126 at D7: it has knots that decrease"},
      {"100/3./0./0./1.", "100/3./0./0./0.", "8: entity 100 at D5: its radius is 0"},
      {"110/0./0./0./1./0./2.$", "110/0./0./0./1./0.$   ",
       "6: entity 110 at D3: parameters are missing"},
      {"110/0./0./0./1./0./2.$", "110/0./0./0./1./0./x.$", "6: entity 110: \"x.\" is not a number"},
  };
  static const char json[] =
      "{\"unit\": \"m\", \"curves\": [{\"degree\": 1, \"count\": 2, \"knots\": [0, 0, 1, 1],\n"
      "\"points\": [[0, 0, 0], [0, 1, 0]]}]}";
  static const bad_case bad_json[] = {
      {"\"degree\": 1", "\"degree\": 0", "0: curves[0].degree: expected a whole number from 1 on"},
      {"\"count\": 2", "\"count\": 1", "0: curves[0].count: expected a whole number from 2 on"},
      {"[0, 0, 1, 1]", "[0, 1, 1]", "0: curves[0].knots: expected count + degree + 1 numbers"},
      {"[0, 0, 1, 1]", "[0, 1, 0, 1]", "0: curves[0] has knots that decrease"},
      {"[0, 1, 0]", "[0, 1]", "0: curves[0].points: expected three numbers for each"},
      {"\"curves\"", "\"lines\"", "0: has no curves; expected a map with unit and curves"},
  };
  check_refused(state, &lam_format_step, step_curves, step, sizeof step / sizeof *step);
  check_refused(state, &lam_format_iges, iges_curves(*state), iges, sizeof iges / sizeof *iges);
  assert_string_equal(curves_of(*state, &lam_format_surface, json).items[0].name, "curves[0]");
  check_refused(state, &lam_format_surface, json, bad_json, sizeof bad_json / sizeof *bad_json);
  lam_curve_list list;
  const char *message, none[] = STEP_BEGIN
                       "#1=PARABOLA('',#2,2.);\n#3=EDGE_CURVE('',#4,#4,#1,.T.);\n"
                       "#4=VERTEX_POINT('',#5);\n#5=CARTESIAN_POINT('',(0.,0.,0.));\n" STEP_END;
  assert_false(try_curves(*state, &lam_format_step, none, sizeof none - 1, &list, &message));
  assert_string_equal(message, "0: has no curve but PARABOLA; expected B-splines, lines or arcs");
}

/* Cut anywhere, the files are refused with one message or, when only blanks are missing, read. */
static void files_may_end_anywhere(void **state) {
  const char *texts[2] = {step_curves, iges_curves(*state)};
  for (int f = 0; f < 2; f++)
    for (size_t size = 0, length = strlen(texts[f]); size + 2 < length; size += f ? 1 : 3) {
      lam_arena_mark mark = lam_arena_mark_get(*state);
      char *bytes = lam_arena_alloc(*state, size, 1); /* so that a step too far is found */
      memcpy(bytes, texts[f], size);
      lam_curve_list list;
      const char *message;
      if (try_curves(*state, formats[f].reads, bytes, size, &list, &message) && size + 90 < length)
        fail_msg("%s: %zu of %zu bytes are read", formats[f].reads->name, size, length);
      lam_arena_release(*state, mark);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(curves_come_back),
      TEST(a_model_without_curves_has_none),
      TEST(sides_of_a_face_are_curves),
      TEST(step_curves_of_others_are_read),
      TEST(iges_curves_of_others_are_read),
      TEST(parts_are_the_curve),
      TEST(units_are_honored),
      TEST(bad_curves_are_refused_with_a_reason),
      TEST(files_may_end_anywhere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
