/* Reading and writing spline surfaces: STEP, IGES, surface.json, OBJ. What OpenCASCADE reads is in
 * tests/cli/step.t. */
#include "files_fixture.h"
#include "formats/list/formats.h"
#include "formats/spline/curves.h"
#include "others_fixture.h"
#include "surf/spline/spline_surface.h"
#include <locale.h>

static const lam_format *const readable[] = {&lam_format_surface, &lam_format_step,
                                             &lam_format_iges};
enum { readable_count = 3 };

/* ---- surfaces ---- */

static void assert_same_surface(const lam_spline_surface *a, const lam_spline_surface *b,
                                const char *what) {
  for (int d = 0; d < 2; d++) {
    assert_int_equal(a->degree[d], b->degree[d]);
    assert_int_equal(a->count[d], b->count[d]);
    for (int i = 0; i < a->count[d] + a->degree[d] + 1; i++)
      assert_true(a->knots[d][i] == b->knots[d][i]);
  }
  assert_int_equal(a->weights != NULL, b->weights != NULL);
  for (int i = 0; i < a->count[0] * a->count[1]; i++) {
    const lam_vec3 *x = &a->points[i], *y = &b->points[i];
    assert_near_named(x->x, y->x, 1e-15 * fabs(y->x), what);
    assert_near_named(x->y, y->y, 1e-15 * fabs(y->y), what);
    assert_near_named(x->z, y->z, 1e-15 * fabs(y->z), what);
    if (a->weights) assert_true(a->weights[i] == b->weights[i]);
  }
}

/* The largest distance of points at the same parameters, relative to the size. */
static double difference(lam_arena *arena, const lam_spline_surface *a,
                         const lam_spline_surface *b) {
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

/* Knots and weights come back as the same doubles, points to the last digit (millimeters stand
 * between). */
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
    assert_near_named(difference(*state, &clamped, &s), 0, 1e-14, "clamped");
    lam_model model = model_of(&s, 1);
    for (int f = 0; f < readable_count; f++) {
      lam_spline_list list = read_back(*state, readable[f], written(*state, readable[f], &model));
      assert_near_named(difference(*state, &list.items[0], &s), 0, 1e-14, readable[f]->name);
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

/* Every real has a point and an upper-case E; no line is wider than IGES allows; every reference
 * leads somewhere. */
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
    if (!quoted && *c == 'e' && c[-1] >= '0' && c[-1] <= '9')
      fail_msg("a lower-case e at %.20s", c - 8);
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
    assert_int_equal(atoi(digits),
                     ++counts[(unsigned char)at[72]]); /* numbered from 1 in each section */
    last = at;
  }
  assert_int_equal(
      sscanf(last, "S%7dG%7dD%7dP%7d", &numbers[0], &numbers[1], &numbers[2], &numbers[3]), 4);
  for (int i = 0; i < 4; i++) assert_int_equal(numbers[i], counts[(unsigned char)"SGDP"[i]]);
  assert_int_equal(counts['D'], 2 * 5); /* a surface and its four sides */
  assert_int_equal(counts['T'], 1);
}

static int occurrences(const char *text, const char *word) {
  int n = 0;
  for (const char *at = text; (at = strstr(at, word)); at += strlen(word)) n++;
  return n;
}

/* A side that is a point has no edge; two sides that are one curve are one edge, passed twice;
 * corners in one place are one vertex. Ring: a square or a bent line of five points; top: the same
 * ring, or a point. */
static void sides_become_edges(void **state) {
  static const lam_vec3 square[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 1e-16, 0}};
  static const lam_vec3 line[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {2, 0, 0}};
  static const double knots[] = {0, 0, 1, 2, 3, 4, 4}, up[] = {0, 0, 1, 1};
  static const struct {
    const lam_vec3 *ring;
    bool apex;
    int edges, passed, vertices;
  } cases[] = {{line, false, 4, 4, 4},
               {line, true, 3, 3, 3},
               {square, false, 3, 4, 2},
               {square, true, 2, 3, 2}};
  for (int i = 0; i < 4; i++) {
    lam_vec3 points[10];
    for (int k = 0; k < 5; k++) {
      points[2 * k] = cases[i].ring[k];
      points[2 * k + 1] =
          lam_add(lam_scale(cases[i].ring[k], cases[i].apex ? 0 : 1), lam_v3(0, 0, 1));
    }
    lam_spline_surface s = {"roof", {1, 1}, {5, 2}, {knots, up}, points, NULL};
    lam_model model = model_of(&s, 1);
    const char *step = written(*state, &lam_format_step, &model).data;
    assert_int_equal(occurrences(step, "=EDGE_CURVE("), cases[i].edges);
    assert_int_equal(occurrences(step, "=B_SPLINE_CURVE_WITH_KNOTS("), cases[i].edges);
    assert_int_equal(occurrences(step, "=ORIENTED_EDGE("), cases[i].passed);
    assert_int_equal(occurrences(step, "=VERTEX_POINT("), cases[i].vertices);
    assert_int_equal(occurrences(written(*state, &lam_format_iges, &model).data, "\n126,"),
                     cases[i].edges);
  }
}

/* The control points in OBJ, with u running fastest, and one statement of each kind. */
static void obj_lists_u_fastest(void **state) {
  static const double knots_u[] = {0, 0, 0, 1, 1, 1}, knots_v[] = {0, 0, 2, 2},
                      weights[] = {1, 2, 3, 4, 5, 6};
  static const lam_vec3 points[] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                    {1, 1, 0}, {2, 0, 0}, {2, 1, 1e-9}};
  lam_spline_surface s = {"roof", {2, 1}, {3, 2}, {knots_u, knots_v}, points, weights};
  lam_model model = model_of(&s, 1);
  assert_string_equal(written(*state, &lam_format_surface_obj, &model).data,
                      "# it-s: smooth surfaces and curves, meters\n"
                      "v 0.0 0.0 0.0 1.0\nv 1.0 0.0 0.0 3.0\nv 2.0 0.0 0.0 5.0\n"
                      "v 0.0 1.0 0.0 2.0\nv 1.0 1.0 0.0 4.0\nv 2.0 1.0 1.0E-9 6.0\n"
                      "g roof\ncstype rat bspline\ndeg 2 1\nsurf 0.0 1.0 0.0 2.0 1 2 3 4 5 6\n"
                      "parm u 0.0 0.0 0.0 1.0 1.0 1.0\nparm v 0.0 0.0 2.0 2.0\nend\n");
}

/* Reads surfaces out of an OBJ text that lam_format_obj takes. */
static lam_spline_surface obj_surface(lam_arena *arena, const char *text, const char **note) {
  lam_text copy = {.arena = arena};
  lam_text_add(&copy, text);
  lam_spline_list list = read_back(arena, &lam_format_obj, copy);
  assert_int_equal(list.count, 1);
  *note = list.notes[0];
  return list.items[0];
}

/* What is written as surface.obj is read as the same numbers: lines are broken and joined, u runs
 * fastest. */
static void obj_comes_back(void **state) {
  const char *note;
  for (int rational = 0; rational < 2; rational++) {
    lam_spline_surface s = some_surface(*state, 3, 2, 7, 6, rational, true);
    lam_model model = model_of(&s, 1);
    lam_spline_surface back =
        obj_surface(*state, written(*state, &lam_format_surface_obj, &model).data, &note);
    assert_same_surface(&back, &s, "surface.obj");
    assert_null(note);
  }
}

/* Two Bezier pieces along u, of degree 2, and one along v, of degree 1, as the specification lists
 * them (the places where pieces meet): the third row of points is shared. References with slashes
 * and negative ones are other programs' habits. */
static const char obj_bezier[] =
    "mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 2 0 1 7\nv 3 0 0\nv 4 0 0\n"
    "v 0 1 0\nv 1 1 0\nv 2 1 1\nv 3 1 0\nv 4 1 0\no shell\ncstype bezier\ndeg 2 1\n"
    "surf 0 2 0 1 1/1/1 2//2 3 4 \\\n  5 -5 -4 \\\n-3 -2 -1\nparm u 0 1 2\nparm v 0 1\nend\n";

static void obj_of_others_is_read(void **state) {
  static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
  const char *note;
  lam_spline_surface s = obj_surface(*state, obj_bezier, &note);
  assert_null(note);
  assert_null(s.weights); /* a fourth number without rat is none */
  assert_int_equal(s.count[0], 5);
  assert_int_equal(s.count[1], 2);
  for (int i = 0; i < 8; i++) assert_true(s.knots[0][i] == knots[i]);
  assert_near_named(lam_distance(s.points[4], lam_v3(2, 0, 1)), 0, 0,
                    "the row where the pieces meet");
  assert_near_named(lam_distance(s.points[5], lam_v3(2, 1, 1)), 0, 0, "and its neighbor in v");
  obj_surface(*state, replaced(*state, obj_bezier, "surf 0 2", "surf 0 1.5"), &note);
  assert_non_null(note); /* half of a piece is cut off */
  obj_surface(*state, replaced(*state, obj_bezier, "parm v 0 1", "parm v 0 1\ntrim 0 1 1"), &note);
  assert_non_null(note);
}

static void bad_obj_is_refused_with_a_reason(void **state) {
  static const bad_case cases[] = {
      {"bezier", "cardinal", "13: cstype: expected bspline or bezier"},
      {"deg 2 1", "deg 2.5 1", "14: deg: expected whole numbers from 1 on"},
      {"deg 2 1", "", "15: no deg before the element"},
      {"deg 2 1", "deg 3 1",
       "15: the element has 10 points; expected 14, as its parameters and degree ask for"},
      {"v 1 0 0", "v 1 0", "3: v: fewer than three numbers given"},
      {"v 1 0 0", "v 1 0 x", "3: v: \"x\" is not a number"},
      {"-5 -4", "-50 -4", "16: \"-50\" given, the number of one of the 10 vertices expected"},
      {"5 -5", "0 -5", "16: \"0\" given, the number of one of the 10 vertices expected"},
      {"parm u 0 1 2", "parm w 0 1 2", "18: parm: expected u or v"},
      {"parm u 0 1 2", "parm u 0 2 1", "15: the element has knots that decrease"},
      {"parm v 0 1", "", "15: the element has too few parameters (parm) for its degree"},
      {"end", "", "15: this element is cut off: end expected"},
      {"surf 0 2 0 1 1", "l 1", "0: has no free-form surface (surf); expected at least one"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    char *bad = replaced(*state, obj_bezier, cases[i].old, cases[i].by);
    lam_spline_list list;
    const char *message = "it is read";
    try_read(*state, &lam_format_obj, bad, strlen(bad), &list, &message);
    assert_string_equal(message, cases[i].message);
  }
}

static void a_model_without_splines_gives_no_file(void **state) {
  (void)state;
  lam_model model = model_of(NULL, 0);
  for (int f = 0; f < readable_count; f++) assert_int_equal(readable[f]->count(&model), 0);
  assert_int_equal(lam_format_surface_obj.count(&model), 0);
}

/* ---- what other programs write ---- */

static void step_of_others_is_read(void **state) {
  lam_text text = {.arena = *state};
  lam_text_add(&text, step_inch);
  lam_spline_list list = read_back(*state, &lam_format_step, text);
  assert_int_equal(list.count, 1);
  const lam_spline_surface *s = &list.items[0];
  assert_near_named(s->points[3].x, 0.0254, 1e-17, "an inch");
  assert_near_named(s->points[3].z, 0.00635, 1e-17, "a quarter of an inch");
  assert_near_named(s->points[1].y, 0.0254, 1e-17, "v runs fastest");
  assert_true(s->knots[1][0] == -1 && s->knots[1][3] == 3 && s->weights == NULL);
}

/* Knots that are not listed: one of each form along a row of points, of degree 2 and along v of
 * degree 1. The surface begins at the first point unless its knots are uniform; then it begins in
 * the middle of the first two. */
static void step_without_knots_is_read(void **state) {
  static const struct {
    const char *surface;
    double knots[8], start;
  } cases[] = {
      {"BEZIER_SURFACE('',2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)", {0, 0, 0, 1, 1, 2, 2, 2}, 0},
      {"(B_SPLINE_SURFACE(2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)QUASI_UNIFORM_SURFACE()RATIONAL_B_"
       "SPLINE_SURFACE(((1.,1.),"
       "(2.,2.),(1.,1.),(1.,1.),(1.,1.))))",
       {0, 0, 0, 1, 2, 3, 3, 3},
       0},
      {"UNIFORM_SURFACE('',2,1,%s,.UNSPECIFIED.,.F.,.F.,.F.)", {-2, -1, 0, 1, 2, 3, 4, 5}, 0.0127},
  };
  for (int i = 0; i < 3; i++) {
    lam_text surface = {.arena = *state}, text = {.arena = *state};
    lam_text_add(&surface, replaced(*state, cases[i].surface, "%s",
                                    "((#10,#11),(#12,#13),(#10,#11),(#12,#13),(#10,#11))"));
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
    assert_near_named(jet.x.x, cases[i].start, 1e-16, "start");
  }
}

static void iges_of_others_is_read(void **state) {
  lam_spline_list list = read_back(*state, &lam_format_iges, iges_of_others(*state));
  assert_int_equal(list.count, 1);
  const lam_spline_surface *s = &list.items[0];
  assert_null(s->weights);
  assert_near_named(lam_distance(s->points[0], lam_v3(0.254, 0, 0)), 0, 1e-16, "(0, 0)");
  assert_near_named(lam_distance(s->points[1], lam_v3(0.2286, 0, 0)), 0, 1e-16, "(0, 1)");
  assert_near_named(lam_distance(s->points[2], lam_v3(0.254, 0.0254, 0)), 0, 1e-16, "(1, 0)");
  assert_near_named(lam_distance(s->points[3], lam_v3(0.2286, 0.0254, 0.0127)), 0, 1e-16, "(1, 1)");
}

/* What the evaluation cannot take is refused with the key's name, and so is a surface that nobody
 * read. */
static void surfaces_of_files_are_checked(void **state) {
  static const lam_vec3 points[60] = {{0}};
  static double high[60], torn[] = {0, 0, 0.5, 0.5, 1, 1};
  for (int i = 30; i < 60; i++) high[i] = 1;
  const struct {
    lam_spline_surface surface;
    const char *message;
  } cases[] = {
      {{NULL, {29, 1}, {30, 2}, {high, torn}, points, NULL},
       "the surface has degree 29; expected at most 24"},
      {{NULL, {1, 1}, {2, 4}, {(const double[]){0, 0, 1, 1}, torn}, points, NULL},
       "the knots of the surface in v must not repeat an inner knot more often than the degree"},
  };
  const lam_row_head *head = lam_registry_find(&lam_surfaces, "file");
  for (int i = -1; i < 2; i++) {
    lam_errors errors = {.arena = *state};
    lam_surface_source source = {"x.step", 1, i < 0 ? NULL : &cases[i].surface, NULL};
    lam_row row = {.head = head, .params = &source};
    assert_null(lam_surface_make(*state, &row, &errors).kind);
    assert_string_equal(errors.first->key, "file");
    assert_string_equal(errors.first->text,
                        i < 0 ? "x.step cannot be read: this caller loads no files"
                              : cases[i].message);
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
      TEST(obj_comes_back),
      TEST(obj_of_others_is_read),
      TEST(bad_obj_is_refused_with_a_reason),
      TEST(a_model_without_splines_gives_no_file),
      TEST(step_of_others_is_read),
      TEST(step_without_knots_is_read),
      TEST(iges_of_others_is_read),
      TEST(surfaces_of_files_are_checked),
      TEST(endings_lead_to_the_reader),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
