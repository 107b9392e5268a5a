/* What a STEP file says of how surfaces hang together, entity by entity: which way around vertices,
 * edges, loops and faces are passed; curves by family. CAD programs close a shell, or offset it to
 * one side, by these flags alone (ISO 10303-42). */
#include "tests/unit/text_fixture.h"

#include <stdio.h>
#include <stdlib.h>

extern const lam_format lam_format_step;

static const double straight[] = {0, 0, 1, 1}, bent[] = {0, 0, .5, 1, 1},
                    quadratic[] = {0, 0, 0, 1, 1, 1};

/* Points of the unit squares [0,1] x [0,1] and [1,2] x [0,1] in z = 0. The first looks up: u along
 * x, v along y. The second looks down: u along y, v along x. */
static const lam_vec3 up[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                      down[4] = {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 1, 0}};

/* Everything in front of the geometry: entities #1 to #15. */
#define PRODUCT(name, title)                                                                       \
  "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('smooth surfaces and curves, millimeters'),'2;1');\n" \
  "FILE_NAME('" name "','2000-01-01T00:00:00',(''),(''),'lamella 0','lamella','');\n"              \
  "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"                \
  "#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');\n"              \
  "#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);\n"    \
  "#3=PRODUCT_CONTEXT('',#1,'mechanical');\n#4=PRODUCT('" name "','" title "','',(#3));\n"         \
  "#5=PRODUCT_DEFINITION_FORMATION('','',#4);\n"                                                   \
  "#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"                                \
  "#7=PRODUCT_DEFINITION('design','',#5,#6);\n#8=PRODUCT_DEFINITION_SHAPE('','',#7);\n"            \
  "#9=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"                                     \
  "#10=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"                                    \
  "#11=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"                                 \
  "#12=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.0E-5),#9,'distance_accuracy_value','');\n"   \
  "#13=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#12))"             \
  "GLOBAL_UNIT_ASSIGNED_CONTEXT((#9,#10,#11))REPRESENTATION_CONTEXT('',''));\n"                    \
  "#14=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#15=AXIS2_PLACEMENT_3D('',#14,$,$);\n"

/* ---- two squares ---- */

/* Vertices by their height along (0.53, 0.64, 0.56): (0,0), (1,0), (0,1), (2,0), (1,1), (2,1), so
 * #26 to #31. Edges by their vertices, each on a curve of its own: #33 bottom and #35 left of the
 * first, #37 the bottom of the second (side 3, along v), #39 the common one (of the first: side 1,
 * up), #41 the top of the first (side 2, along u), #43 the right one and #45 the top of the second.
 *
 * The boundary of the first, counterclockwise seen from above: bottom, common, then top and left
 * backward. The second one's own boundary, counterclockwise seen from its normal (below): u = y
 * first: common upward (side 0), top rightward (side 1), then right and bottom backward. Both pass
 * the common edge upward, so the second is turned over: its bound and its face say .F. */
static const char two_squares[] = PRODUCT(
    "two",
    "two") "#16=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#17=CARTESIAN_POINT('',(0.0,1000.0,0.0));\n"
           "#18=CARTESIAN_POINT('',(1000.0,0.0,0.0));\n#19=CARTESIAN_POINT('',(1000.0,1000.0,0.0));"
           "\n"
           "#20=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#16,#17),(#18,#19)),.UNSPECIFIED.,.F.,.F.,.F.,"
           "(2,"
           "2),(2,2),(0.0,1.0),(0.0,1.0),.UNSPECIFIED.);\n#21=CARTESIAN_POINT('',(1000.0,0.0,0.0));"
           "\n"
           "#22=CARTESIAN_POINT('',(2000.0,0.0,0.0));\n#23=CARTESIAN_POINT('',(1000.0,1000.0,0.0));"
           "\n"
           "#24=CARTESIAN_POINT('',(2000.0,1000.0,0.0));\n"
           "#25=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#21,#22),(#23,#24)),.UNSPECIFIED.,.F.,.F.,.F.,"
           "(2,"
           "2),(2,2),(0.0,1.0),(0.0,1.0),.UNSPECIFIED.);\n#26=VERTEX_POINT('',#16);\n"
           "#27=VERTEX_POINT('',#18);\n#28=VERTEX_POINT('',#17);\n#29=VERTEX_POINT('',#22);\n"
           "#30=VERTEX_POINT('',#19);\n#31=VERTEX_POINT('',#24);\n"
           "#32=B_SPLINE_CURVE_WITH_KNOTS('',1,(#16,#18),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#33=EDGE_CURVE('',#26,#27,#32,.T.);\n"
           "#34=B_SPLINE_CURVE_WITH_KNOTS('',1,(#16,#17),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#35=EDGE_CURVE('',#26,#28,#34,.T.);\n"
           "#36=B_SPLINE_CURVE_WITH_KNOTS('',1,(#21,#22),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#37=EDGE_CURVE('',#27,#29,#36,.T.);\n"
           "#38=B_SPLINE_CURVE_WITH_KNOTS('',1,(#18,#19),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#39=EDGE_CURVE('',#27,#30,#38,.T.);\n"
           "#40=B_SPLINE_CURVE_WITH_KNOTS('',1,(#17,#19),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#41=EDGE_CURVE('',#28,#30,#40,.T.);\n"
           "#42=B_SPLINE_CURVE_WITH_KNOTS('',1,(#22,#24),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#43=EDGE_CURVE('',#29,#31,#42,.T.);\n"
           "#44=B_SPLINE_CURVE_WITH_KNOTS('',1,(#23,#24),.UNSPECIFIED.,.F.,.F.,(2,2),(0.0,1.0),"
           ".UNSPECIFIED.);\n#45=EDGE_CURVE('',#30,#31,#44,.T.);\n#46=ORIENTED_EDGE('',*,*,#33,.T.)"
           ";\n"
           "#47=ORIENTED_EDGE('',*,*,#39,.T.);\n#48=ORIENTED_EDGE('',*,*,#41,.F.);\n"
           "#49=ORIENTED_EDGE('',*,*,#35,.F.);\n#50=EDGE_LOOP('',(#46,#47,#48,#49));\n"
           "#51=FACE_OUTER_BOUND('',#50,.T.);\n#52=ADVANCED_FACE('up',(#51),#20,.T.);\n"
           "#53=ORIENTED_EDGE('',*,*,#39,.T.);\n#54=ORIENTED_EDGE('',*,*,#45,.T.);\n"
           "#55=ORIENTED_EDGE('',*,*,#43,.F.);\n#56=ORIENTED_EDGE('',*,*,#37,.F.);\n"
           "#57=EDGE_LOOP('',(#53,#54,#55,#56));\n#58=FACE_OUTER_BOUND('',#57,.F.);\n"
           "#59=ADVANCED_FACE('down',(#58),#25,.F.);\n#60=OPEN_SHELL('',(#52,#59));\n"
           "#61=SHELL_BASED_SURFACE_MODEL('',(#60));\n"
           "#62=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#15,#61),#13);\n"
           "#63=SHAPE_DEFINITION_REPRESENTATION(#8,#62);\nENDSEC;\nEND-ISO-10303-21;\n";

static void faces_that_share_an_edge_look_the_same_way(void **state) {
  lam_spline_surface surfaces[2] = {{"up", {1, 1}, {2, 2}, {straight, straight}, up, NULL},
                                    {"down", {1, 1}, {2, 2}, {straight, straight}, down, NULL}};
  lam_model model = {.name = "two", .version = "0", .surface_count = 2, .surfaces = surfaces};
  assert_string_equal(text_path(*state, &lam_format_step, &model, 0), "two.step");
  assert_lines("two squares", text_of(*state, &lam_format_step, &model, 0), two_squares);
}

/* ---- any shell ---- */

/* The numbers behind the entity with this number: at most `most` references. */
static int references(const char *text, int entity, int *numbers, int most) {
  char begin[32];
  snprintf(begin, sizeof begin, "\n#%d=", entity);
  const char *at = strstr(text, begin), *end = at ? strstr(at, ";\n") : NULL;
  if (!at) fail_msg("no entity #%d", entity);
  int n = 0;
  for (at += strlen(begin); at < end && n < most; at++)
    if (*at == '#') numbers[n++] = atoi(at + 1);
  return n;
}

/* The flag at the end of an entity: .T. or .F. */
static bool flag(const char *text, int entity) {
  char begin[32];
  snprintf(begin, sizeof begin, "\n#%d=", entity);
  const char *end = strstr(strstr(text, begin) + 1, ";\n");
  assert_true(end[-2] == '.' && (end[-3] == 'T' || end[-3] == 'F'));
  return end[-3] == 'T';
}

/* The point of a VERTEX_POINT, millimeters. */
static lam_vec3 vertex(const char *text, int entity) {
  int point;
  char begin[64];
  lam_vec3 x;
  assert_int_equal(references(text, entity, &point, 1), 1);
  snprintf(begin, sizeof begin, "\n#%d=CARTESIAN_POINT('',(", point);
  const char *at = strstr(text, begin);
  assert_non_null(at);
  assert_int_equal(sscanf(at + strlen(begin), "%lf,%lf,%lf", &x.x, &x.y, &x.z), 3);
  return x;
}

/* Twice the area that the bound of a face encloses, as a vector along the normal that the file
 * gives the face: the loop is passed as its edges say, or backward when its bound is not .T. Every
 * edge begins where the one before ends. */
static lam_vec3 face_area(const char *text, int face) {
  int bound, loop, oriented[8], edge, ends[2][2];
  references(text, face, &bound, 1);
  references(text, bound, &loop, 1);
  int n = references(text, loop, oriented, 8);
  lam_vec3 area = {0, 0, 0};

  int first = 0, last = 0;
  for (int i = 0; i < n; i++) {
    int numbers[2];
    references(text, oriented[i], &edge, 1);
    references(text, edge, numbers, 2);
    bool along = flag(text, oriented[i]);
    ends[1][0] = numbers[along ? 0 : 1], ends[1][1] = numbers[along ? 1 : 0];
    if (i && ends[1][0] != last) fail_msg("#%d begins at #%d, not #%d", edge, ends[1][0], last);
    if (!i) first = ends[1][0];
    last = ends[1][1];
    area = lam_add(area, lam_cross(vertex(text, ends[1][0]), vertex(text, ends[1][1])));
  }
  assert_int_equal(last, first);
  return lam_scale(area, flag(text, bound) ? 1 : -1);
}

/* The faces of a cube of 1 m around its center, each given in another way around: seen from
 * outside, or all from inside, every face has the area vector of its side; twice 1e6 mm^2. */
static void a_cube_looks_out_or_in(void **state) {
  static const int corners[6][4] = {{0, 2, 1, 3}, {4, 5, 6, 7}, {0, 1, 4, 5},
                                    {2, 3, 6, 7}, {0, 4, 2, 6}, {1, 3, 5, 7}};
  lam_vec3 points[6][4];
  lam_spline_surface s[6];
  for (int f = 0; f < 6; f++) {
    for (int k = 0; k < 4; k++) {
      int c = corners[f][k];
      points[f][k] = lam_v3((c & 1) - .5, (c >> 1 & 1) - .5, (c >> 2) - .5);
    }
    s[f] = (lam_spline_surface){"side", {1, 1}, {2, 2}, {straight, straight}, points[f], NULL};
  }
  lam_model model = {.name = "cube", .version = "0", .surface_count = 6, .surfaces = s};
  const char *text = text_of(*state, &lam_format_step, &model, 0), *at = text;
  assert_holds(text, "=CLOSED_SHELL('',(");

  double way = 0;
  for (int f = 0; f < 6; f++) {
    at = strstr(at + 1, "=ADVANCED_FACE(");
    assert_non_null(at);
    const char *number = at;
    while (*number != '#') number--;
    lam_vec3 area = face_area(text, atoi(number + 1));

    /* The normal that the file gives the face: its surface's, turned over by the flag. */
    lam_vec3 du = lam_sub(points[f][2], points[f][0]), dv = lam_sub(points[f][1], points[f][0]);
    lam_vec3 normal = lam_scale(lam_cross(du, dv), flag(text, atoi(number + 1)) ? 1 : -1);
    assert_near(lam_distance(area, lam_scale(normal, 2e6)), 0, 1e-6);

    lam_vec3 center = lam_scale(lam_add(points[f][0], points[f][3]), .5);
    double out = lam_dot(normal, center); /* +-1 x 0.5 */
    assert_near(fabs(out), .5, 1e-12);
    if (f == 0) way = out;
    assert_near(out, way, 1e-12);
  }
}

/* ---- curves ---- */

/* Families -1, 0 and 1, each on a layer and in a set; the rational one as a complex instance;
 * beside them no surface, so they are the shape of the product. A title is not the name. */
static const char three_curves[] = PRODUCT(
    "three",
    "\\X2\\00E9\\X0\\''\\\\") "#16=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#17=CARTESIAN_POINT('',(1.0,"
                              "2.0,3.0));\n"
                              "#18=B_SPLINE_CURVE_WITH_KNOTS('rim',1,(#16,#17),.UNSPECIFIED.,.F.,."
                              "F.,(2,2),(0.0,1.0),"
                              ".UNSPECIFIED.);\n"
                              "#19=PRESENTATION_LAYER_ASSIGNMENT('curves','',(#18));\n"
                              "#20=GEOMETRIC_CURVE_SET('curves',(#18));\n"
                              "#21=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#22=CARTESIAN_POINT('',(1.0,"
                              "2.0,3.0));\n"
                              "#23=CARTESIAN_POINT('',(4.0,5.0,6.0));\n"
                              "#24=B_SPLINE_CURVE_WITH_KNOTS('A01',1,(#21,#22,#23),.UNSPECIFIED.,."
                              "F.,.F.,(2,1,2),"
                              "(0.0,0.5,1.0),.UNSPECIFIED.);\n"
                              "#25=PRESENTATION_LAYER_ASSIGNMENT('family 0','',(#24));\n"
                              "#26=GEOMETRIC_CURVE_SET('family 0',(#24));\n"
                              "#27=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#28=CARTESIAN_POINT('',(1.0,"
                              "2.0,3.0));\n"
                              "#29=CARTESIAN_POINT('',(4.0,5.0,6.0));\n"
                              "#30=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#27,#28,#29),.UNSPECIFIED.,.F."
                              ",.F.)"
                              "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.0,1.0),.UNSPECIFIED.)CURVE()"
                              "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.0,0.5,2.0)"
                              ")"
                              "REPRESENTATION_ITEM('B01'));\n"
                              "#31=CARTESIAN_POINT('',(0.0,0.0,0.0));\n#32=CARTESIAN_POINT('',(1.0,"
                              "2.0,3.0));\n"
                              "#33=B_SPLINE_CURVE_WITH_KNOTS('B02',1,(#31,#32),.UNSPECIFIED.,.F.,."
                              "F.,(2,2),(0.0,1.0),"
                              ".UNSPECIFIED.);\n"
                              "#34=PRESENTATION_LAYER_ASSIGNMENT('family 1','',(#30,#33));\n"
                              "#35=GEOMETRIC_CURVE_SET('family 1',(#30,#33));\n"
                              "#36=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#15,#"
                              "20,#26,#35),#13);\n"
                              "#37=SHAPE_DEFINITION_REPRESENTATION(#8,#36);\nENDSEC;\nEND-ISO-"
                              "10303-21;\n";

static const lam_vec3 steps[3] = {{0, 0, 0}, {1e-3, 2e-3, 3e-3}, {4e-3, 5e-3, 6e-3}};
static const double weights[3] = {1, .5, 2};
static const lam_named_curve curves[4] = {{"A01", 0, {1, 3, bent, steps, NULL}},
                                          {"rim", -1, {1, 2, straight, steps, NULL}},
                                          {"B01", 1, {2, 3, quadratic, steps, weights}},
                                          {"B02", 1, {1, 2, straight, steps, NULL}}};

static void curves_are_sets_by_family(void **state) {
  lam_model model = {
      .name = "three", .title = "\u00e9'\\", .version = "0", .curve_count = 4, .curves = curves};
  assert_lines("curves", text_of(*state, &lam_format_step, &model, 0), three_curves);
}

/* Curves beside surfaces are another representation, related to that of the shells. The rational
 * surface is a complex instance. */
static void curves_stand_beside_surfaces(void **state) {
  static const double four[4] = {1, 2, 3, .25};
  lam_spline_surface s = {"up", {1, 1}, {2, 2}, {straight, straight}, up, four};
  lam_model model = {.name = "both",
                     .version = "0",
                     .surface_count = 1,
                     .surfaces = &s,
                     .curve_count = 1,
                     .curves = &curves[1]};
  const char *text = text_of(*state, &lam_format_step, &model, 0);
  assert_holds(text, "#20=(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#16,#17),(#18,#19)),"
                     ".UNSPECIFIED.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS((2,2),(2,2),(0.0,1.0),"
                     "(0.0,1.0),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()"
                     "RATIONAL_B_SPLINE_SURFACE(((1.0,2.0),(3.0,0.25)))REPRESENTATION_ITEM('')"
                     "SURFACE());\n");
  /* the right side, from (1, 0) to (1, 1), has the last two weights */
  assert_holds(text, "=(BOUNDED_CURVE()B_SPLINE_CURVE(1,(#18,#19),.UNSPECIFIED.,.F.,.F.)"
                     "B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.0,1.0),.UNSPECIFIED.)CURVE()"
                     "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((3.0,0.25))"
                     "REPRESENTATION_ITEM(''));\n");
  /* #21 to #24 vertices, #25 to #32 edges, #33 to #39 the face, #40 and #41 shells */
  assert_holds(text, "#42=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#15,#41),#13);\n");
  assert_holds(text, "#48=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#15,#47),#13);\n"
                     "#49=SHAPE_DEFINITION_REPRESENTATION(#8,#42);\n"
                     "#50=SHAPE_REPRESENTATION_RELATIONSHIP('','',#42,#48);\nENDSEC;\n");
}

/* Code points beyond ASCII by ISO 10303-21: two bytes of UTF-8 (U+00E9), three (U+20AC),
 * four (U+1F3D7); control characters are dropped. */
static void names_are_written_in_ascii(void **state) {
  lam_model model = {
      .name = "x\t\u00e9\u20ac\U0001F3D7~\x7f", .version = "0", .curve_count = 1, .curves = curves};
  assert_holds(text_of(*state, &lam_format_step, &model, 0),
               "FILE_NAME('x\\X2\\00E9\\X0\\\\X2\\20AC\\X0\\\\X4\\0001F3D7\\X0\\~',");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(faces_that_share_an_edge_look_the_same_way),
      TEXT_TEST(a_cube_looks_out_or_in),
      TEXT_TEST(curves_are_sets_by_family),
      TEXT_TEST(curves_stand_beside_surfaces),
      TEXT_TEST(names_are_written_in_ascii),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
