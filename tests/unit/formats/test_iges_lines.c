/* IGES, column by column as it is written, and what is read of entities of other programs: units,
 * transformations within transformations, polylines, boundaries. Sections and entities by IGES 5.3;
 * numbers by hand. */
#include "files_fixture.h"
#include "tests/unit/text_fixture.h"

/* ---- writing ---- */

static const double straight[] = {0, 0, 1, 1}, twice[] = {0, 0, 2, 2}, three[] = {0, 0, 0, 1, 1, 1};
static const lam_vec3 points[6] = {{0, 0, 0},       {0, 1e-3, 0}, {1e-3, 0, 0},
                                   {1e-3, 1e-3, 0}, {2e-3, 0, 0}, {2e-3, 1e-3, 4e-3}};
static const double weights[6] = {1, 2, 3, 4, 5, 6};

/* A line of 80 columns: 72 of data, the letter of the section, 7 for its number. */
static const char *line_of(lam_arena *arena, const char *text, char section, int number) {
  for (const char *at = text; *at; at = strchr(at, '\n') + 1)
    if (at[72] == section && atoi(at + 73) == number) return lam_arena_printf(arena, "%.80s", at);
  fail_msg("no line %c%d", section, number);
  return NULL;
}

static void assert_line(lam_arena *arena, const char *text, char section, int number,
                        const char *data) {
  char expected[96];
  snprintf(expected, sizeof expected, "%-72s%c%7d", data, section, number);
  assert_string_equal(line_of(arena, text, section, number), expected);
}

/* A surface of 3 x 2 points, degrees 2 and 1, rational: entity 128 with K = 2, 1, M = 2, 1, open,
 * rational, not periodic; knots, then weights and points in millimeters with u running fastest, and
 * the domain. Its four sides as 126: v = 0, u = 1, v = 1, u = 0. */
static const char *const surface_lines[] = {
    "128,2,1,2,1,0,0,0,0,0,0.0,0.0,0.0,1.0,1.0,1.0,0.0,0.0,2.0,2.0,         1",
    "1.0,3.0,5.0,2.0,4.0,6.0,0.0,0.0,0.0,1.0,0.0,0.0,2.0,0.0,0.0,0.0,       1",
    "1.0,0.0,1.0,1.0,0.0,2.0,1.0,4.0,0.0,1.0,0.0,2.0;                       1",
    "126,2,2,0,0,0,0,0.0,0.0,0.0,1.0,1.0,1.0,1.0,3.0,5.0,0.0,0.0,0.0,       3",
    "1.0,0.0,0.0,2.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0;                           3",
    "126,1,1,0,0,0,0,0.0,0.0,2.0,2.0,5.0,6.0,2.0,0.0,0.0,2.0,1.0,4.0,       5",
    "0.0,2.0,0.0,0.0,0.0;                                                   5",
    "126,2,2,0,0,0,0,0.0,0.0,0.0,1.0,1.0,1.0,2.0,4.0,6.0,0.0,1.0,0.0,       7",
    "1.0,1.0,0.0,2.0,1.0,4.0,0.0,1.0,0.0,0.0,0.0;                           7",
    "126,1,1,0,0,0,0,0.0,0.0,2.0,2.0,1.0,2.0,0.0,0.0,0.0,0.0,1.0,0.0,       9",
    "0.0,2.0,0.0,0.0,0.0;                                                   9",
    /* a closed polynomial curve of family 1: its weights are 1 */
    "126,2,1,0,1,1,0,0.0,0.0,0.5,1.0,1.0,1.0,1.0,1.0,0.0,0.0,0.0,0.0,      11",
    "1.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0;                              11",
};

static void lines_have_their_columns(void **state) {
  static const double bent[] = {0, 0, .5, 1, 1};
  static const lam_vec3 loop[3] = {{0, 0, 0}, {0, 1e-3, 0}, {0, 0, 0}};
  lam_spline_surface s = {"roof", {2, 1}, {3, 2}, {three, twice}, points, weights};
  lam_named_curve curves[3] = {{"B07", 1, {1, 3, bent, loop, NULL}},
                               {"A01", 0, {1, 2, straight, points, NULL}},
                               {"a long name", -1, {1, 2, straight, points, NULL}}};
  lam_model model = {.name = "roof",
                     .version = "0",
                     .surface_count = 1,
                     .surfaces = &s,
                     .curve_count = 3,
                     .curves = curves};
  assert_string_equal(text_path(*state, &lam_format_iges, &model, 0), "roof.igs");
  const char *text = text_of(*state, &lam_format_iges, &model, 0);
  assert_line(*state, text, 'S', 1, "smooth surfaces and curves of a design, in millimeters");
  assert_line(*state, text, 'G', 1,
              "1H,,1H;,4Hroof,8Hroof.igs,7Hlamella,1H0,32,38,6,308,15,4Hroof,1.0,2,2HMM");
  assert_line(*state, text, 'G', 2,
              ",1,0.01,15H20000101.000000,1.0E-5,1.0E5,,,11,0,15H20000101.000000;");
  for (int i = 0; i < 13; i++) assert_line(*state, text, 'P', i + 1, surface_lines[i]);

  /* type, first parameter line, level; type, number of parameter lines, label */
  assert_line(*state, text, 'D', 1,
              "     128       1       0       1       0       0       0       000000000");
  assert_line(*state, text, 'D', 2,
              "     128       0       0       3       0                 SURFACE       0");
  assert_line(*state, text, 'D', 5,
              "     126       6       0       1       0       0       0       000000000");
  assert_line(*state, text, 'D', 6,
              "     126       0       0       2       0                    SIDE       0");
  assert_line(*state, text, 'D', 11,
              "     126      12       0       1       2       0       0       000000000");
  assert_line(*state, text, 'D', 12,
              "     126       0       0       2       0                     B07       0");
  assert_line(*state, text, 'D', 13,
              "     126      14       0       1       1       0       0       000000000");
  assert_line(*state, text, 'D', 15,
              "     126      16       0       1       3       0       0       000000000");
  assert_line(*state, text, 'D', 16,
              "     126       0       0       2       0                a long n       0");
  assert_line(*state, text, 'T', 1, "S      1G      2D     16P     17");
}

/* A tube that closes up in u says so, and its last side is the first; the same in v. */
static void closed_surfaces_say_so(void **state) {
  static const double ring[] = {0, 0, 1, 2, 2};
  static const lam_vec3 by_u[6] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0},
                                   {1, 0, 1}, {0, 0, 0}, {0, 0, 1}},
                        by_v[6] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0},
                                   {0, 0, 1}, {1, 0, 1}, {0, 0, 1}};
  lam_spline_surface s[2] = {{"u", {1, 1}, {3, 2}, {ring, straight}, by_u, NULL},
                             {"v", {1, 1}, {2, 3}, {straight, ring}, by_v, NULL}};
  static const char *const heads[2] = {"128,2,1,1,1,1,0,1,0,0,", "128,1,2,1,1,0,1,1,0,0,"};
  for (int i = 0; i < 2; i++) {
    lam_model model = {.name = "t", .version = "0", .surface_count = 1, .surfaces = &s[i]};
    const char *text = text_of(*state, &lam_format_iges, &model, 0);
    assert_holds(text, heads[i]);
    assert_holds(text, "126,2,1,0,1,1,0,");       /* a side that is a ring is closed */
    assert_holds(text, "SIDE       0D      8\n"); /* three sides, not four */
    assert_lacks(text, "D      9\n");
  }
}

/* ---- reading ---- */

/* An entity: type, matrix, status, form, parameters (one line). */
typedef struct entity {
  int type, matrix, status, form;
  const char *parameters;
} entity;

/* A file of these entities; entity i stands at directory line 2 i + 1. unit: the unit flag. */
static const char *file_of(lam_arena *arena, int unit, const entity *e, int count) {
  lam_text text = {.arena = arena};
  add_line(&text, "", 'S', 1);
  add_line(&text, lam_arena_printf(arena, "1H,,1H;,,5Ha,b;c,,,32,38,6,308,15,,1.0,%d,;", unit), 'G',
           1);
  for (int i = 0; i < count; i++) {
    add_line(&text,
             lam_arena_printf(arena, "%8d%8d%8d%8d%8d%8d%8d%8d%08d", e[i].type, i + 1, 0, 0, 0, 0,
                              e[i].matrix, 0, e[i].status),
             'D', 2 * i + 1);
    add_line(&text, lam_arena_printf(arena, "%8d%8d%8d%8d%8d", e[i].type, 0, 0, 1, e[i].form), 'D',
             2 * i + 2);
  }
  for (int i = 0; i < count; i++) add_line(&text, e[i].parameters, 'P', i + 1);
  add_line(&text, "", 'T', 1);
  return text.data;
}

static const char *read_curves(lam_arena *arena, const char *text, lam_curve_list *list) {
  lam_errors errors = {.arena = arena};
  if (lam_format_iges.read_curves(arena, text, strlen(text), (lam_location){.file = "x"}, &errors,
                                  list))
    return NULL;
  assert_int_equal(errors.count, 1);
  return errors.first->text;
}

static lam_curve_list curves_of(lam_arena *arena, int unit, const entity *e, int count) {
  lam_curve_list list;
  const char *message = read_curves(arena, file_of(arena, unit, e, count), &list);
  if (message) fail_msg("%s", message);
  return list;
}

static void assert_point(lam_vec3 x, double a, double b, double c, const char *what) {
  if (!(lam_distance(x, lam_v3(a, b, c)) <= 1e-14))
    fail_msg("%s: (%.17g, %.17g, %.17g), expected (%g, %g, %g)", what, x.x, x.y, x.z, a, b, c);
}

/* Unit flags: IGES 5.3, 2.2.4.3.14; an inch is 25.4 mm, a mile 1609.344 m. */
static void unit_flags_are_known(void **state) {
  static const double sizes[12] = {
      [1] = .0254, [2] = 1e-3,    [4] = .3048, [5] = 1609.344, [6] = 1,
      [7] = 1000,  [8] = 2.54e-5, [9] = 1e-6,  [10] = .01,     [11] = 2.54e-8};
  static const entity line = {110, 0, 0, 0, "110,1.,0.,0.,0.,2.,0.;"};
  for (int flag = -1; flag <= 12; flag++) {
    lam_curve_list list;
    const char *message = read_curves(*state, file_of(*state, flag, &line, 1), &list);
    double size = flag >= 0 && flag < 12 ? sizes[flag] : 0;
    if (size > 0 && message) fail_msg("flag %d: %s", flag, message);
    if (size > 0) assert_near(list.items[0].spline.points[1].y, 2 * size, 1e-15 * size);
    if (size == 0)
      assert_string_equal(message ? message : "it is read",
                          "the unit of length is unknown; expected a flag of 1, 2 or 4 to 11");
  }
}

/* The line goes through D1 (a quarter turn about z, then 10 along x), which goes through D3 (a
 * quarter turn about x, then 5 along z): (1, 2, 3) -> (8, 1, 3) -> (8, -3, 6), and the origin ->
 * (10, 0, 0) -> (10, 0, 5). */
static void transformations_are_nested(void **state) {
  static const entity e[3] = {{124, 3, 0, 0, "124,0,-1,0,10,1,0,0,0,0,0,1,0;"},
                              {124, 0, 0, 0, "124,1,0,0,0,0,0,-1,0,0,1,0,5;"},
                              {110, 1, 0, 0, "110,0,0,0,1,2,3;"}};
  lam_curve_list list = curves_of(*state, 6, e, 3);
  assert_int_equal(list.count, 1);
  assert_point(list.items[0].spline.points[0], 10, 0, 5, "origin");
  assert_point(list.items[0].spline.points[1], 8, -3, 6, "point");
}

/* A transformation that points to itself, to no entity, to a line within an entry or to another
 * type; one whose numbers are missing. */
static void bad_transformations_are_refused(void **state) {
  static const struct {
    entity matrix;
    int pointer;
    const char *message;
  } cases[] = {
      {{124, 1, 0, 0, "124,1,0,0,0,0,1,0,0,0,0,1,0;"},
       1,
       "entity 124 at D1: it names a transformation that is none"},
      {{124, 0, 0, 0, "124,1,0,0,0,0,1,0,0,0,0,1,0;"},
       5,
       "entity 110 at D3: it names a transformation that is none"},
      {{124, 0, 0, 0, "124,1,0,0,0,0,1,0,0,0,0,1,0;"},
       2,
       "entity 110 at D3: it names a transformation that is none"},
      {{116, 0, 0, 0, "116,1,0,0,0;"},
       1,
       "entity 110 at D3: it names a transformation that is none"},
      {{124, 0, 0, 0, "124,1,0,0,0;"}, 1, "entity 124 at D1: parameters are missing"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const entity e[2] = {cases[i].matrix, {110, cases[i].pointer, 0, 0, "110,0,0,0,1,2,3;"}};
    lam_curve_list list;
    const char *message = read_curves(*state, file_of(*state, 6, e, 2), &list);
    assert_string_equal(message ? message : "it is read", cases[i].message);
  }
}

/* Data of form 1 (pairs at one z), 2 (triples) and 3 (with a vector behind), as polylines 11, 12
 * and 13; other forms are sections or axes. */
static void polylines_have_three_forms(void **state) {
  static const double knots[5] = {0, 0, 1, 2, 2};
  static const entity e[5] = {{106, 0, 0, 10, "106,1,2,9.,0,0,1,1;"},
                              {106, 0, 0, 11, "106,1,3,7.,1,2,3,4,5,6;"},
                              {106, 0, 0, 12, "106,2,3,1,2,7,3,4,7,5,6,7;"},
                              {106, 0, 0, 13, "106,3,3,1,2,7,9,9,9,3,4,7,9,9,9,5,6,7,9,9,9;"},
                              {106, 0, 0, 14, "106,1,2,9.,0,0,1,1;"}};
  lam_curve_list list = curves_of(*state, 6, e, 5);
  assert_int_equal(list.count, 3);
  for (int i = 0; i < 3; i++) {
    const lam_spline_curve *c = &list.items[i].spline;
    assert_int_equal(c->count, 3);
    assert_int_equal(c->degree, 1);
    for (int k = 0; k < 3; k++) assert_point(c->points[k], 1 + 2 * k, 2 + 2 * k, 7, "corner");
    for (int k = 0; k < 5; k++) assert_near(c->knots[k], knots[k], 0);
  }
}

/* Half a circle around (1, 2) at z = 3, from (3, 2) to (-1, 2); one that ends where it starts is
 * full; a rational curve keeps its weights, one of equal weights is polynomial. */
static void arcs_and_weights_are_read(void **state) {
  static const entity e[4] = {{100, 0, 0, 0, "100,3.,1.,2.,3.,2.,-1.,2.;"},
                              {100, 0, 0, 0, "100,3.,1.,2.,3.,2.,3.,2.;"},
                              {126, 0, 0, 0, "126,1,1,0,0,0,0,0,0,1,1,2.,3.,0,0,0,1,0,0,0.,1.;"},
                              {126, 0, 0, 0, "126,1,1,0,0,0,0,0,0,1,1,2.,2.,0,0,0,1,0,0,-9.,9.;"}};
  lam_curve_list list = curves_of(*state, 6, e, 4);
  assert_int_equal(list.count, 4);
  const lam_spline_curve *half = &list.items[0].spline;
  static const double corners[5][2] = {{3, 2}, {3, 4}, {1, 4}, {-1, 4}, {-1, 2}};
  assert_int_equal(half->count, 5);
  for (int k = 0; k < 5; k++)
    assert_point(half->points[k], corners[k][0], corners[k][1], 3, "half");
  assert_int_equal(list.items[1].spline.count, 9);
  assert_non_null(list.items[2].spline.weights);
  assert_near(list.items[2].spline.weights[1], 3, 0);
  assert_null(list.items[3].spline.weights);
  assert_string_equal(list.items[3].name, "D7");
}

/* A surface that is long and narrow, in few letters: no more is asked for than its points. */
static void narrow_surfaces_come_back(void **state) {
  enum { n = 60 };
  double knots[n + 2];
  lam_vec3 x[2 * n];
  for (int i = 0; i < n + 2; i++) knots[i] = i == 0 ? 0 : i > n ? n - 1 : i - 1;
  for (int i = 0; i < 2 * n; i++) x[i] = lam_v3(i / 2 * 1e-3, i % 2 * 1e-3, 0);
  lam_spline_surface s = {"s", {1, 1}, {n, 2}, {knots, straight}, x, NULL};
  lam_model model = {.name = "t", .version = "0", .surface_count = 1, .surfaces = &s};
  lam_spline_list list =
      read_back(*state, &lam_format_iges, written(*state, &lam_format_iges, &model));
  assert_int_equal(list.items[0].count[0], n);
  for (int i = 0; i < 2 * n; i++)
    assert_near(lam_distance(list.items[0].points[i], x[i]), 0, 1e-15);
}

/* Curves in the parameters of a surface are none in space: those of 142 (with the constituents of a
 * composite curve, 102), of 141, and those whose use flag is 5. */
static void plane_curves_are_left_out(void **state) {
  static const entity e[9] = {
      {110, 0, 0, 0, "110,0,0,0,1,0,0;"},  {110, 0, 0, 0, "110,0,0,0,2,0,0;"},
      {102, 0, 0, 0, "102,2,1,3;"},        {110, 0, 0, 0, "110,0,0,0,4,0,0;"},
      {142, 0, 0, 0, "142,1,99,5,7,2;"},   {110, 0, 0, 0, "110,0,0,0,6,0,0;"},
      {110, 0, 0, 0, "110,0,0,0,7,0,0;"},  {141, 0, 0, 0, "141,1,2,99,1,11,1,1,13;"},
      {110, 0, 500, 0, "110,0,0,0,9,0,0;"}};
  lam_curve_list list = curves_of(*state, 6, e, 9);
  assert_int_equal(list.count, 2);
  assert_point(list.items[0].spline.points[1], 4, 0, 0, "the curve in space of 142");
  assert_point(list.items[1].spline.points[1], 6, 0, 0, "the curve in space of 141");
}

/* Numbers that no spline has: points less one, degrees and flags out of range or not whole, lists
 * that end early. One message each. */
static void bad_numbers_are_refused(void **state) {
#define RANGE "a number of points, degree or flag is out of range"
  static const struct {
    const char *parameters, *message;
  } cases[] = {
      {"126,0,1,0,0,1,0,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", RANGE},
      {"126,1.5,1,0,0,1,0,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", "a whole number expected"},
      {"126,1,0,0,0,1,0,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", RANGE},
      {"126,1,1001,0,0,1,0,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", RANGE},
      {"126,1,1,0,0,2,0,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", RANGE},
      {"126,1,1,0,0,1,-1,0,0,1,1,1,1,0,0,0,1,0,0,0,1;", RANGE},
      {"126,1,1,0,0,1,0,0,0,1,1,1,1,0,0,0,1,0,0;", "parameters are missing"},
      {"126,1,1,0,0,1,0,0,0,1,1,1,0,0,0,0,1,0,0,0,1;", "it has a weight that is not positive"},
      {"126,1,1,0,0,1,0,0,0,1,1,0,0,0,0,0,1,0,0,0,1;", "it has a weight that is not positive"},
      {"126,1;", "parameters are missing"},
      {"128,1,1;", "parameters are missing"},
      {"128,1,1,1,1,,,1,,,0,0,1,1,0,0,1,1,0,0,0,0,,,,2,,,,2,,2,2,,0,1,0,1;",
       "it has a weight that is not positive"},
      {"128,0,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1;", RANGE},
      {"128,1,0,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1;", RANGE},
      {"128,1,1,0,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1;", RANGE},
      {"128,1,1,1,1001,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1;", RANGE},
      {"128,1,1,1,1,0,0,1,0,2,0,0,1,1,0,0,1,1,1,1,1,1;", RANGE},
      {"128,1,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1;", "parameters are missing"},
      {"128,1,1,1,1,0,0,1,0,0,0,0,1;", "parameters are missing"},
      {"128,1,1,1,1,,,1,,,0,0,1,1,0,1,0,1,1,1,1,1,,,,2,,,,2,,2,2,,0,1,0,1;",
       "it has knots that decrease"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    int type = atoi(cases[i].parameters);
    const entity e = {type, 0, 0, 0, cases[i].parameters};
    const char *text = file_of(*state, 6, &e, 1), *message;
    lam_spline_list surfaces;
    lam_curve_list curves;
    if (type == 126)
      message = read_curves(*state, text, &curves);
    else
      try_read(*state, &lam_format_iges, text, strlen(text), &surfaces, &message);
    const char *behind = message ? strstr(message, " at D1: ") : NULL;
    if (!behind || strcmp(behind + 8, cases[i].message) != 0)
      fail_msg("%s: %s", cases[i].parameters, message ? message : "it is read");
  }
}

/* ---- trimmed faces ---- */

#define SQUARE                                                                                     \
  { 128, 0, 0, 0, "128,1,1,1,1,,,1,,,0,0,1,1,0,0,1,1,1,1,1,1,,,,2,,,,2,,2,2,,0,1,0,1;" }

/* The note about the surface of these entities. */
static const char *note_of(lam_arena *arena, const entity *e, int count) {
  lam_spline_list list;
  const char *message, *text = file_of(arena, 6, e, count);
  if (!try_read(arena, &lam_format_iges, text, strlen(text), &list, &message))
    fail_msg("%s", message);
  return list.notes[0] ? list.notes[0] : "";
}

/* The square of side 2 with boundaries: x = 2 is a side, x = 1 is not. Trimmed (144) by an outer or
 * an inner one, through a composite curve; bounded (143, 141). Placed by entity 408. */
static void boundaries_inside_trim(void **state) {
  static const struct {
    double outer, inner;
    bool trimmed;
  } cases[] = {{2, 2, false}, {1, 2, true}, {2, 1, true}};
  for (int i = 0; i < 3; i++)
    for (int bounded = 0; bounded < 2; bounded++) {
      const entity e[8] = {
          SQUARE,
          {110, 0, 0, 0,
           lam_arena_printf(*state, "110,%g,0,0,%g,2,0;", cases[i].outer, cases[i].outer)},
          {110, 0, 0, 0,
           lam_arena_printf(*state, "110,%g,2,0,%g,0,0;", cases[i].inner, cases[i].inner)},
          {102, 0, 0, 0, "102,1,5;"},
          {142, 0, 0, 0, "142,1,1,0,3,2;"},
          {142, 0, 0, 0, "142,1,1,0,7,2;"},
          {141, 0, 0, 0, "141,1,2,1,2,3,1,0,7,2,0;"},
          {bounded ? 143 : 144, 0, 0, 0, bounded ? "143,1,1,1,13;" : "144,1,1,1,9,11;"}};
      const char *note = note_of(*state, e, 8);
      if ((strstr(note, "trimmed") != NULL) != cases[i].trimmed)
        fail_msg("case %d, %s: note \"%s\"", i, bounded ? "bounded" : "trimmed", note);
    }
  static const entity placed[2] = {SQUARE, {408, 0, 0, 0, "408,1,0,0,0,1.;"}};
  assert_holds(note_of(*state, placed, 2), "assembly");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEXT_TEST(lines_have_their_columns),
      TEXT_TEST(closed_surfaces_say_so),
      TEXT_TEST(unit_flags_are_known),
      TEXT_TEST(transformations_are_nested),
      TEXT_TEST(bad_transformations_are_refused),
      TEXT_TEST(polylines_have_three_forms),
      TEXT_TEST(arcs_and_weights_are_read),
      TEXT_TEST(narrow_surfaces_come_back),
      TEXT_TEST(plane_curves_are_left_out),
      TEXT_TEST(bad_numbers_are_refused),
      TEXT_TEST(boundaries_inside_trim),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
