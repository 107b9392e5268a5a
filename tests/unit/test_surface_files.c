/* Reading and writing spline surfaces: STEP, IGES, surface.json, OBJ. What OpenCASCADE reads is in tests/cli/step.t. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "formats/format.h"
#include "surf/spline_surface.h"
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const lam_format lam_format_surface, lam_format_step, lam_format_iges, lam_format_surface_obj;
static const lam_format *const readable[] = {&lam_format_surface, &lam_format_step, &lam_format_iges};
enum { readable_count = 3 };

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

static void assert_near(double value, double expected, double tolerance, const char *what) {
  if (!(fabs(value - expected) <= tolerance))
    fail_msg("%s: %.17g, expected %.17g +- %.1e", what, value, expected, tolerance);
}

/* ---- surfaces ---- */

/* Numbers of many digits, of all sizes, from a fixed sequence. */
static double next_number(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 9007199254740992.0;
}

static lam_spline_surface some_surface(lam_arena *arena, int p, int q, int n, int m, bool rational, bool clamped) {
  lam_spline_surface s = {.name = "surface", .degree = {p, q}, .count = {n, m}};
  uint64_t state = (uint64_t)(1000 * p + 100 * q + 10 * n + m);
  for (int d = 0; d < 2; d++) {
    int total = s.count[d] + s.degree[d] + 1;
    double *knots = LAM_NEW(arena, double, total), t = -0.3;
    for (int i = 0; i < total; i++) {
      bool inside = i > s.degree[d] && i <= s.count[d];
      if (!clamped || inside) t += i == s.degree[d] + 2 ? 0 : next_number(&state); /* one inner knot stands twice */
      knots[i] = t;
    }
    s.knots[d] = knots;
  }
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, n * m);
  double *weights = LAM_NEW(arena, double, n *m);
  for (int i = 0; i < n * m; i++) {
    double x = next_number(&state), y = next_number(&state), z = next_number(&state);
    points[i] = lam_v3(12 * x - 3, 1e-5 * y, 4e4 * z);
    weights[i] = 0.2 + next_number(&state);
  }
  s.points = points;
  s.weights = rational ? weights : NULL;
  return s;
}

static lam_model model_of(const lam_spline_surface *surfaces, int count) {
  return (lam_model){
      .name = "it-s", .title = "Peter's \\ t\u00e9nt", .version = "0", .surface_count = count, .surfaces = surfaces};
}

static lam_text written(lam_arena *arena, const lam_format *format, const lam_model *model) {
  lam_text text = {.arena = arena};
  assert_int_equal(format->count(model), 1);
  assert_int_equal(format->write(model, 0, &text), LAM_OK);
  return text;
}

static bool try_read(lam_arena *arena, const lam_format *format, const char *bytes, size_t size, lam_spline_list *list,
                     const char **message) {
  lam_errors errors = {.arena = arena};
  bool good = format->read_surfaces(arena, bytes, size, (lam_place){.file = "x"}, &errors, list);
  assert_int_equal(errors.count, good ? 0 : 1); /* one message */
  *message = good ? NULL : lam_arena_printf(arena, "%d: %s", errors.first->place.line, errors.first->text);
  return good;
}

static lam_spline_list read_back(lam_arena *arena, const lam_format *format, lam_text text) {
  lam_spline_list list;
  const char *message;
  if (!try_read(arena, format, text.data, text.length, &list, &message)) fail_msg("%s: %s", format->name, message);
  return list;
}

static void assert_same_surface(const lam_spline_surface *a, const lam_spline_surface *b, const char *what) {
  for (int d = 0; d < 2; d++) {
    assert_int_equal(a->degree[d], b->degree[d]);
    assert_int_equal(a->count[d], b->count[d]);
    for (int i = 0; i < a->count[d] + a->degree[d] + 1; i++) assert_true(a->knots[d][i] == b->knots[d][i]);
  }
  assert_int_equal(a->weights != NULL, b->weights != NULL);
  for (int i = 0; i < a->count[0] * a->count[1]; i++) {
    const lam_vec3 *x = &a->points[i], *y = &b->points[i];
    assert_near(x->x, y->x, 1e-15 * fabs(y->x), what);
    assert_near(x->y, y->y, 1e-15 * fabs(y->y), what);
    assert_near(x->z, y->z, 1e-15 * fabs(y->z), what);
    if (a->weights) assert_true(a->weights[i] == b->weights[i]);
  }
}

/* The largest distance of points at the same parameters, relative to the size. */
static double difference(lam_arena *arena, const lam_spline_surface *a, const lam_spline_surface *b) {
  const lam_nurbs *x = lam_nurbs_make(arena, a), *y = lam_nurbs_make(arena, b);
  double p[2], q[2], p2[2], q2[2], worst = 0, size = 0;
  bool closed[2];
  lam_nurbs_domain(x, LAM_CHART_NATURAL, p, q, closed);
  lam_nurbs_domain(y, LAM_CHART_NATURAL, p2, q2, closed);
  assert_true(p[0] == p2[0] && p[1] == p2[1] && q[0] == q2[0] && q[1] == q2[1]);
  for (int i = 0; i <= 20; i++)
    for (int j = 0; j <= 20; j++) {
      double u = p[0] + (p[1] - p[0]) * i / 20, v = q[0] + (q[1] - q[0]) * j / 20;
      lam_jet jx, jy;
      lam_nurbs_eval(x, u, v, &jx);
      lam_nurbs_eval(y, u, v, &jy);
      worst = fmax(worst, lam_distance(jx.x, jy.x));
      size = fmax(size, lam_length(jx.x));
    }
  return worst / size;
}

/* ---- there and back ---- */

/* Knots and weights come back as the same doubles, points to the last digit (millimeters stand between). */
static void surfaces_come_back(void **state) {
  static const int shapes[][4] = {{3, 3, 7, 6}, {1, 2, 2, 3}, {5, 1, 9, 4}, {2, 4, 40, 5}};
  for (int f = 0; f < readable_count; f++)
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
      for (int rational = 0; rational < 2; rational++) {
        const int *k = shapes[i];
        lam_spline_surface s = some_surface(*state, k[0], k[1], k[2], k[3], rational, true);
        lam_model model = model_of(&s, 1);
        lam_spline_list list = read_back(*state, readable[f], written(*state, readable[f], &model));
        assert_int_equal(list.count, 1);
        assert_same_surface(&list.items[0], &s, readable[f]->name);
      }
}

static void several_surfaces_keep_their_order(void **state) {
  lam_spline_surface s[3] = {some_surface(*state, 3, 3, 7, 6, true, true),
                             some_surface(*state, 2, 1, 4, 2, false, true),
                             some_surface(*state, 1, 1, 2, 2, true, true)};
  lam_model model = model_of(s, 3);
  for (int f = 0; f < readable_count; f++) {
    lam_spline_list list = read_back(*state, readable[f], written(*state, readable[f], &model));
    assert_int_equal(list.count, 3);
    for (int i = 0; i < 3; i++) assert_same_surface(&list.items[i], &s[i], readable[f]->name);
  }
}

/* Other programs expect clamped knots: the same surface, over the same domain. */
static void unclamped_knots_are_clamped(void **state) {
  for (int rational = 0; rational < 2; rational++) {
    lam_spline_surface s = some_surface(*state, 3, 2, 8, 6, rational, false);
    lam_spline_surface clamped = lam_spline_clamped(*state, &s);
    for (int d = 0; d < 2; d++)
      for (int i = 0; i <= s.degree[d]; i++) {
        assert_true(clamped.knots[d][i] == s.knots[d][s.degree[d]]);
        assert_true(clamped.knots[d][clamped.count[d] + i] == s.knots[d][s.count[d]]);
      }
    assert_null(lam_spline_problem(&clamped));
    assert_near(difference(*state, &clamped, &s), 0, 1e-14, "clamped");
    lam_model model = model_of(&s, 1);
    for (int f = 0; f < readable_count; f++) {
      lam_spline_list list = read_back(*state, readable[f], written(*state, readable[f], &model));
      assert_near(difference(*state, &list.items[0], &s), 0, 1e-14, readable[f]->name);
    }
  }
}

/* A decimal comma does not get in. */
static void locales_do_not_matter(void **state) {
  lam_spline_surface s = some_surface(*state, 2, 2, 5, 5, true, true);
  lam_model model = model_of(&s, 1);
  const char *before = lam_arena_copy(*state, setlocale(LC_ALL, NULL));
  if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8")) skip();
  for (int f = 0; f < readable_count; f++) {
    lam_spline_list list = read_back(*state, readable[f], written(*state, readable[f], &model));
    assert_same_surface(&list.items[0], &s, readable[f]->name);
  }
  setlocale(LC_ALL, before);
}

/* ---- structure of what is written ---- */

/* Every real has a point and an upper-case E; no line is wider than IGES allows; every reference leads somewhere. */
static void step_is_well_formed(void **state) {
  lam_spline_surface s = some_surface(*state, 3, 3, 7, 6, true, true);
  lam_model model = model_of(&s, 1);
  lam_text text = written(*state, &lam_format_step, &model);
  assert_non_null(strstr(text.data, "PRODUCT('it-s','Peter''s \\\\ t\\X2\\00E9\\X0\\nt',"));
  const char *data = strstr(text.data, "\nDATA;\n");
  assert_non_null(data);
  bool quoted = false;
  for (const char *c = data; *c; c++) {
    if (*c == '\'') quoted = !quoted;
    if (!quoted && *c == 'e' && c[-1] >= '0' && c[-1] <= '9') fail_msg("a lower-case e at %.20s", c - 8);
    if (!quoted && *c == 'E' && c[-1] >= '0' && c[-1] <= '9') {
      const char *digit = c - 1;
      while (*digit >= '0' && *digit <= '9') digit--;
      if (*digit != '.') fail_msg("a mantissa without a point at %.20s", digit);
    }
    if (!quoted && *c == '#' && c[-1] != '\n') {
      char entity[32];
      snprintf(entity, sizeof entity, "\n#%.*s=", (int)strspn(c + 1, "0123456789"), c + 1);
      if (!strstr(data, entity)) fail_msg("nothing at%s", entity);
    }
  }
}

static void iges_has_eighty_columns(void **state) {
  lam_spline_surface s = some_surface(*state, 3, 3, 7, 6, true, true);
  lam_model model = model_of(&s, 1);
  lam_text text = written(*state, &lam_format_iges, &model);
  int counts[128] = {0}, numbers[4];
  const char *last = "";
  for (const char *at = text.data; *at; at = strchr(at, '\n') + 1) {
    assert_int_equal(strchr(at, '\n') - at, 80);
    char digits[8] = {0};
    memcpy(digits, at + 73, 7);
    assert_int_equal(atoi(digits), ++counts[(unsigned char)at[72]]); /* numbered from 1 in each section */
    last = at;
  }
  assert_int_equal(sscanf(last, "S%7dG%7dD%7dP%7d", &numbers[0], &numbers[1], &numbers[2], &numbers[3]), 4);
  for (int i = 0; i < 4; i++) assert_int_equal(numbers[i], counts[(unsigned char)"SGDP"[i]]);
  assert_int_equal(counts['D'], 2 * 5); /* a surface and its four sides */
  assert_int_equal(counts['T'], 1);
}

static int occurrences(const char *text, const char *word) {
  int n = 0;
  for (const char *at = text; (at = strstr(at, word)); at += strlen(word)) n++;
  return n;
}

/* A side that is a point has no edge; two sides that are one curve are one edge, passed twice; corners in one place are
 * one vertex. Ring: a square or a bent line of five points; top: the same ring, or a point. */
static void sides_become_edges(void **state) {
  static const lam_vec3 square[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 1e-16, 0}};
  static const lam_vec3 line[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {2, 0, 0}};
  static const double knots[] = {0, 0, 1, 2, 3, 4, 4}, up[] = {0, 0, 1, 1};
  static const struct {
    const lam_vec3 *ring;
    bool apex;
    int edges, passed, vertices;
  } cases[] = {{line, false, 4, 4, 4}, {line, true, 3, 3, 3}, {square, false, 3, 4, 2}, {square, true, 2, 3, 2}};
  for (int i = 0; i < 4; i++) {
    lam_vec3 points[10];
    for (int k = 0; k < 5; k++) {
      points[2 * k] = cases[i].ring[k];
      points[2 * k + 1] = lam_add(lam_scale(cases[i].ring[k], cases[i].apex ? 0 : 1), lam_v3(0, 0, 1));
    }
    lam_spline_surface s = {"roof", {1, 1}, {5, 2}, {knots, up}, points, NULL};
    lam_model model = model_of(&s, 1);
    const char *step = written(*state, &lam_format_step, &model).data;
    assert_int_equal(occurrences(step, "=EDGE_CURVE("), cases[i].edges);
    assert_int_equal(occurrences(step, "=B_SPLINE_CURVE_WITH_KNOTS("), cases[i].edges);
    assert_int_equal(occurrences(step, "=ORIENTED_EDGE("), cases[i].passed);
    assert_int_equal(occurrences(step, "=VERTEX_POINT("), cases[i].vertices);
    assert_int_equal(occurrences(written(*state, &lam_format_iges, &model).data, "\n126,"), cases[i].edges);
  }
}

/* The control points in OBJ, with u running fastest, and one statement of each kind. */
static void obj_lists_u_fastest(void **state) {
  static const double knots_u[] = {0, 0, 0, 1, 1, 1}, knots_v[] = {0, 0, 2, 2}, weights[] = {1, 2, 3, 4, 5, 6};
  static const lam_vec3 points[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 1e-9}};
  lam_spline_surface s = {"roof", {2, 1}, {3, 2}, {knots_u, knots_v}, points, weights};
  lam_model model = model_of(&s, 1);
  assert_string_equal(written(*state, &lam_format_surface_obj, &model).data,
                      "# it-s: smooth surfaces, meters\n"
                      "v 0.0 0.0 0.0 1.0\nv 1.0 0.0 0.0 3.0\nv 2.0 0.0 0.0 5.0\n"
                      "v 0.0 1.0 0.0 2.0\nv 1.0 1.0 0.0 4.0\nv 2.0 1.0 1.0E-9 6.0\n"
                      "g roof\ncstype rat bspline\ndeg 2 1\nsurf 0.0 1.0 0.0 2.0 1 2 3 4 5 6\n"
                      "parm u 0.0 0.0 0.0 1.0 1.0 1.0\nparm v 0.0 0.0 2.0 2.0\nend\n");
}

static void a_model_without_splines_gives_no_file(void **state) {
  (void)state;
  lam_model model = model_of(NULL, 0);
  for (int f = 0; f < readable_count; f++) assert_int_equal(readable[f]->count(&model), 0);
  assert_int_equal(lam_format_surface_obj.count(&model), 0);
}

/* ---- what other programs write ---- */

/* The text with the first `old` replaced. */
static char *replaced(lam_arena *arena, const char *text, const char *old, const char *by) {
  const char *at = strstr(text, old);
  assert_non_null(at);
  return lam_arena_printf(arena, "%.*s%s%s", (int)(at - text), text, by, at + strlen(old));
}

/* A bilinear patch, written as OpenCASCADE and others do: lower-case words, comments, lines broken anywhere, an inch.
 */
static const char step_inch[] =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n"
    "#10=CARTESIAN_POINT('a;b''c',(0.,0.,0.));\n#11 = CARTESIAN_POINT ( '', ( 0., 1.,\n 0. ) ) ;\n"
    "#12=CARTESIAN_POINT($,(1.,0.,0.)); /* #12=( */ #13=CARTESIAN_POINT('',(1.,1.,2.5E-1));\n"
    "#20=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#10,#11),(#12,#13)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),"
    "(-1.,3.),.UNSPECIFIED.);\n"
    "#30=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#31,#34))"
    "REPRESENTATION_CONTEXT('',''));\n"
    "#31=(CONVERSION_BASED_UNIT('INCH',#32)LENGTH_UNIT()NAMED_UNIT(#35));\n"
    "#32=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#33);\n"
    "#33=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#34=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
    "#35=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
    "ENDSEC;\nEND-ISO-10303-21;\n";

static void step_of_others_is_read(void **state) {
  lam_text text = {.arena = *state};
  lam_text_add(&text, step_inch);
  lam_spline_list list = read_back(*state, &lam_format_step, text);
  assert_int_equal(list.count, 1);
  const lam_spline_surface *s = &list.items[0];
  assert_near(s->points[3].x, 0.0254, 1e-17, "an inch");
  assert_near(s->points[3].z, 0.00635, 1e-17, "a quarter of an inch");
  assert_near(s->points[1].y, 0.0254, 1e-17, "v runs fastest");
  assert_true(s->knots[1][0] == -1 && s->knots[1][3] == 3 && s->weights == NULL);
}

/* Knots that are not listed: one of each form along a row of points, of degree 2 and along v of degree 1. The surface
 * begins at the first point unless its knots are uniform; then it begins in the middle of the first two. */
static void step_without_knots_is_read(void **state) {
  static const struct {
    const char *surface;
    double knots[8], start;
  } cases[] = {
      {"BEZIER_SURFACE('',2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)", {0, 0, 0, 1, 1, 2, 2, 2}, 0},
      {"(B_SPLINE_SURFACE(2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)QUASI_UNIFORM_SURFACE()RATIONAL_B_SPLINE_SURFACE(((1.,1.),"
       "(2.,2.),(1.,1.),(1.,1.),(1.,1.))))",
       {0, 0, 0, 1, 2, 3, 3, 3},
       0},
      {"UNIFORM_SURFACE('',2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)", {-2, -1, 0, 1, 2, 3, 4, 5}, 0.0127},
  };
  for (int i = 0; i < 3; i++) {
    lam_text surface = {.arena = *state}, text = {.arena = *state};
    lam_text_add(&surface,
                 replaced(*state, cases[i].surface, "%s", "((#10,#11),(#12,#13),(#10,#11),(#12,#13),(#10,#11))"));
    const char *from = strstr(step_inch, "B_SPLINE_SURFACE_WITH_KNOTS"), *to = strstr(from, ";\n");
    lam_text_bytes(&text, step_inch, (size_t)(from - step_inch));
    lam_text_add(&text, surface.data);
    lam_text_add(&text, to);
    const lam_spline_surface *s = &read_back(*state, &lam_format_step, text).items[0];
    int knots = s->count[0] + s->degree[0] + 1;
    assert_int_equal(knots, 8);
    for (int k = 0; k < knots; k++) assert_true(s->knots[0][k] == cases[i].knots[k]);
    assert_int_equal(s->weights != NULL, i == 1);
    lam_jet jet;
    lam_nurbs_eval(lam_nurbs_make(*state, s), s->knots[0][2], s->knots[1][1], &jet);
    assert_near(jet.x.x, cases[i].start, 1e-16, "start");
  }
}

/* A line of an IGES file, filled up to its section and number. */
static void add_line(lam_text *text, const char *data, char section, int number) {
  lam_text_printf(text, "%-72s%c%7d\r\n", data, section, number);
}

/* Entity 128 in inches with other delimiters, exponents as in Fortran, left-out flags, moved by entity 124: a turn by
 * 90 degrees about z, then 10 inches along x. */
static lam_text iges_of_others(lam_arena *arena) {
  lam_text text = {.arena = arena};
  add_line(&text, "a comment", 'S', 1);
  add_line(&text, "1H//1H$/3Ha/b/4Ha.ig/1Hx/1Hy/32/38/6/38/15/1Hz/1./1/2HIN/1/.1/", 'G', 1);
  add_line(&text, "15H20000101.000000/1.D-3/10.$", 'G', 2);
  add_line(&text, "     124       1       0       0       0       0       0       000000000", 'D', 1);
  add_line(&text, "     124       0       0       1       0", 'D', 2);
  add_line(&text, "     128       2       0       0       0       0       1       000000000", 'D', 3);
  add_line(&text, "     128       0       0       3       0", 'D', 4);
  add_line(&text, "124/0./-1./0./10./1./0./0./0./0./0./1./0.$                            1", 'P', 1);
  add_line(&text, "128/1/1/1/1///1///0.D0/0./1./1./0./0./2./2./                          3", 'P', 2);
  add_line(&text, "1./1./1./1./0./0./0./ 1.0D+0 /0./0./0./1d0/0./                        3", 'P', 3);
  add_line(&text, "1./1./.5/0./1./0./2.$                                                 3", 'P', 4);
  add_line(&text, "S      1G      2D      4P      4", 'T', 1);
  return text;
}

static void iges_of_others_is_read(void **state) {
  lam_spline_list list = read_back(*state, &lam_format_iges, iges_of_others(*state));
  assert_int_equal(list.count, 1);
  const lam_spline_surface *s = &list.items[0];
  assert_null(s->weights);
  assert_near(lam_distance(s->points[0], lam_v3(0.254, 0, 0)), 0, 1e-16, "(0, 0)");
  assert_near(lam_distance(s->points[1], lam_v3(0.2286, 0, 0)), 0, 1e-16, "(0, 1)");
  assert_near(lam_distance(s->points[2], lam_v3(0.254, 0.0254, 0)), 0, 1e-16, "(1, 0)");
  assert_near(lam_distance(s->points[3], lam_v3(0.2286, 0.0254, 0.0127)), 0, 1e-16, "(1, 1)");
}

/* ---- bad files ---- */

typedef struct bad_case {
  const char *old, *by, *message;
} bad_case;

static void check_refused(void **state, const lam_format *format, const char *text, const bad_case *cases, size_t n) {
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
#define CHECK_REFUSED(format, text, cases) check_refused(state, format, text, cases, sizeof(cases) / sizeof *(cases))

static void bad_step_is_refused_with_a_reason(void **state) {
  static const bad_case cases[] = {
      {"ISO-10303-21;", "solid x;", "0: is not a STEP file: it does not begin with ISO-10303-21"},
      {"END-ISO-10303-21;", "", "19: is cut off: END-ISO-10303-21 expected"},
      {"(2,2),(2,2)", "(2,2),(2,1)", "10: surface #20: its multiplicities do not fit its points"},
      {"(2,2),(2,2)", "(2,2),(2,9999999999)", "10: surface #20: its multiplicities do not fit its points"},
      {"(0.,1.)", "(1.,0.)", "10: surface #20: it has knots that decrease"},
      {"(0.,1.)", "(0.)", "10: surface #20: expected as many knots as multiplicities"},
      {"'',1,1,", "'',0,1,", "10: surface #20: its degree is not a whole number from 1 on"},
      {"'',1,1,", "'',1.5,1,", "10: surface #20: its degree is not a whole number from 1 on"},
      {"(#12,#13)", "(#12)", "10: surface #20: its control points are not rows of equal length"},
      {"(#12,#13)", "(#12,#99)", "10: surface #20: a control point is not a CARTESIAN_POINT of three numbers"},
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
      {"B_SPLINE_SURFACE_WITH_KNOTS", "CURVE", "0: has no surface; expected at least one B-spline surface"},
  };
  CHECK_REFUSED(&lam_format_step, step_inch, cases);
}

static void bad_iges_is_refused_with_a_reason(void **state) {
  static const bad_case cases[] = {
      {"a comment", "x", "0: is not an IGES file: column 73 names no section"},
      {"S      1G      2D      4P      4", "S\n", "12: a line of 80 columns expected"},
      {"/1./1/2HIN", "/2./1/2HIN", "2: the scale of the model is not 1: such files are not read"},
      {"/1./1/2HIN", "/1./3/2HIN", "2: the unit of length is unknown; expected a flag of 1, 2 or 4 to 11"},
      {"     128       2 ", "     128       9 ",
       "6: entity 128 at D3: its directory entry points outside the parameter section"},
      {"     128       2 ", "     128       1 ", "6: entity 128 at D3: its parameters belong to another entity"},
      {"       1       000000000D      3", "       3       000000000D      3",
       "6: entity 128 at D3: it names a transformation that is none"},
      {"128/1/1/1/1/", "128/9/9/1/1/", "6: entity 128 at D3: parameters are missing"},
      {"128/1/1/1/1/", "128/1/1/0/1/", "6: entity 128 at D3: a number of points, degree or flag is out of range"},
      {"128/1/1/1/1/", "128/1/1/2/1/", "6: entity 128 at D3: it has too few points for its degree"},
      {"1.0D+0 ", "1.0F+0 ", "6: entity 128: \"1.0F+0\" is not a number"},
      {"1./1./1./1./0.", "1./1./1./-1/0.", "6: entity 128 at D3: it has a weight that is not positive"},
      {"     128       2 ", "     114       2 ",
       "0: has no B-spline surface (entity 128); expected surfaces saved as NURBS"},
  };
  CHECK_REFUSED(&lam_format_iges, iges_of_others(*state).data, cases);
}

static void bad_json_is_refused_with_a_reason(void **state) {
  static const char good[] = "{\"unit\": \"cm\", \"surfaces\": [{\"degree\": [1, 1], \"count\": [2, 2],\n"
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
      {"\"knots_u\"", "\"weights\": [1, 1, 1, 0], \"knots_u\"", "0: surfaces[0] has a weight that is not positive"},
      {"\"surfaces\"", "\"surface\"", "0: has no surfaces; expected a map with unit and surfaces"},
  };
  lam_text text = {.arena = *state};
  lam_text_add(&text, good);
  lam_spline_list list = read_back(*state, &lam_format_surface, text);
  assert_near(list.items[0].points[3].z, 0.01, 1e-17, "a centimeter");
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

/* What the evaluation cannot take is refused with the key's name, and so is a surface that nobody read. */
static void surfaces_of_files_are_checked(void **state) {
  static const lam_vec3 points[60] = {{0}};
  static double high[60], torn[] = {0, 0, 0.5, 0.5, 1, 1};
  for (int i = 30; i < 60; i++) high[i] = 1;
  const struct {
    lam_spline_surface surface;
    const char *message;
  } cases[] = {
      {{NULL, {29, 1}, {30, 2}, {high, torn}, points, NULL}, "the surface has degree 29; expected at most 24"},
      {{NULL, {1, 1}, {2, 4}, {(const double[]){0, 0, 1, 1}, torn}, points, NULL},
       "the knots of the surface in v must not repeat an inner knot more often than the degree"},
  };
  const lam_row_head *head = lam_registry_find(&lam_surfaces, "file");
  for (int i = -1; i < 2; i++) {
    lam_errors errors = {.arena = *state};
    lam_surface_source source = {"x.step", 1, i < 0 ? NULL : &cases[i].surface};
    lam_row row = {.head = head, .params = &source};
    assert_null(lam_surface_make(*state, &row, &errors).kind);
    assert_string_equal(errors.first->key, "file");
    assert_string_equal(errors.first->text,
                        i < 0 ? "x.step cannot be read: this caller loads no files" : cases[i].message);
  }
}

static void endings_lead_to_the_reader(void **state) {
  (void)state;
  assert_ptr_equal(lam_format_for("a/b.step"), &lam_format_step);
  assert_ptr_equal(lam_format_for("b.STP"), &lam_format_step);
  assert_ptr_equal(lam_format_for("b.iges"), &lam_format_iges);
  assert_ptr_equal(lam_format_for("b.igs"), &lam_format_iges);
  assert_ptr_equal(lam_format_for("surface.json"), &lam_format_surface);
  assert_null(lam_format_for("b.ste"));
  assert_null(lam_format_for("b."));
  assert_null(lam_format_for("step"));
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(surfaces_come_back),
      TEST(several_surfaces_keep_their_order),
      TEST(unclamped_knots_are_clamped),
      TEST(locales_do_not_matter),
      TEST(step_is_well_formed),
      TEST(iges_has_eighty_columns),
      TEST(sides_become_edges),
      TEST(obj_lists_u_fastest),
      TEST(a_model_without_splines_gives_no_file),
      TEST(step_of_others_is_read),
      TEST(step_without_knots_is_read),
      TEST(iges_of_others_is_read),
      TEST(bad_step_is_refused_with_a_reason),
      TEST(bad_iges_is_refused_with_a_reason),
      TEST(bad_json_is_refused_with_a_reason),
      TEST(files_may_end_anywhere),
      TEST(surfaces_of_files_are_checked),
      TEST(endings_lead_to_the_reader),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
