/* Surfaces joined into shells: what they share, which way around they lie, and what is written of
 * it as STEP; faces that are trimmed. The counts follow from Euler's formula or are counted by
 * hand. */
#include "core/numbers.h"
#include "files_fixture.h"
#include "formats/spline/shell.h"

static const double flat_knots[] = {0, 0, 1, 1};

/* The bilinear patch on four corners, counterclockwise from (0, 0). */
static lam_spline_surface patch(lam_arena *arena, lam_vec3 a, lam_vec3 b, lam_vec3 c, lam_vec3 d) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 4);
  points[0] = a, points[1] = d, points[2] = b, points[3] = c; /* (u,v): 00, 01, 10, 11 */
  return (lam_spline_surface){"patch", {1, 1}, {2, 2}, {flat_knots, flat_knots}, points, NULL};
}

/* The same patch with its corners moved on by `turns`, or passed the other way around. */
static lam_spline_surface turned(lam_arena *arena, const lam_spline_surface *s, int turns,
                                 bool over) {
  lam_vec3 x[4];
  for (int k = 0; k < 4; k++)
    x[k] = s->points[lam_shell_corner(s, ((over ? 4 - k : k) + turns) % 4)];
  return patch(arena, x[0], x[1], x[2], x[3]);
}

static lam_vec3 wave(int i, int j) { return lam_v3(1.1 * i, 0.9 * j, 0.2 * i * j - 0.1 * i * i); }

static int borders(const lam_shell *shell) {
  int n = 0;
  for (int e = 0; e < shell->edge_count; e++) n += shell->edges[e].uses == 1;
  return n;
}

/* Every edge inside is passed once each way when faces that are turned over are. */
static void assert_oriented(const lam_shell *shell, int count) {
  int *sum = calloc((size_t)shell->edge_count, sizeof *sum);
  for (int i = 0; i < 4 * count; i++)
    if (shell->uses[i].edge >= 0)
      sum[shell->uses[i].edge] +=
          (shell->uses[i].forward == (i % 4 < 2)) != shell->flipped[i / 4] ? 1 : -1;
  for (int e = 0; e < shell->edge_count; e++)
    assert_int_equal(abs(sum[e]), shell->edges[e].uses == 2 ? 0 : 1);
  free(sum);
}

/* n x m patches, each turned in another way, every third one over. */
static void a_grid_shares_its_edges(void **state) {
  enum { n = 5, m = 4 };
  lam_spline_surface s[n * m];
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      lam_spline_surface p =
          patch(*state, wave(i, j), wave(i + 1, j), wave(i + 1, j + 1), wave(i, j + 1));
      s[i * m + j] = turned(*state, &p, i + 2 * j, (i + j) % 3 == 2);
    }
  lam_shell shell = lam_shell_make(*state, n * m, s);
  assert_int_equal(shell.vertex_count, (n + 1) * (m + 1));
  assert_int_equal(shell.edge_count, n * (m + 1) + m * (n + 1));
  assert_int_equal(borders(&shell), 2 * (n + m));
  assert_int_equal(shell.part_count, 1);
  assert_int_equal(shell.border[0], 2 * (n + m));
  for (int i = 0; i < n * m; i++) assert_int_equal(shell.flipped[i], (i / m + i % m) % 3 == 2);
  assert_oriented(&shell, n * m);
}

static void a_cube_closes_up(void **state) {
  static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  lam_spline_surface s[8];
  for (int f = 0; f < 6; f++) {
    lam_vec3 x[4];
    for (int k = 0; k < 4; k++)
      x[k] = lam_v3(faces[f][k] & 1, faces[f][k] >> 1 & 1, faces[f][k] >> 2);
    s[f] = patch(*state, x[0], x[1], x[2], x[3]);
  }
  for (int f = 6; f < 8; f++) { /* two sheets of their own far away, above each other */
    double z = f;
    s[f] = patch(*state, lam_v3(9, 9, z), lam_v3(10, 9, z), lam_v3(10, 10, z), lam_v3(9, 10, z));
  }
  lam_shell shell = lam_shell_make(*state, 8, s);
  assert_int_equal(shell.vertex_count, 8 + 8);
  assert_int_equal(shell.edge_count, 12 + 8);
  assert_int_equal(shell.part_count, 3);
  assert_int_equal(shell.border[0], 0);
  assert_int_equal(shell.border[1], 4);
  assert_oriented(&shell, 8);
  lam_model model = model_of(s, 8);
  const char *step = written(*state, &lam_format_step, &model).data;
  assert_non_null(strstr(step, "CLOSED_SHELL("));
  assert_non_null(strstr(strstr(step, "OPEN_SHELL(") + 1, "OPEN_SHELL("));
}

/* A band with half a turn cannot be oriented: one of its edges is written twice. */
static void a_moebius_band_is_cut(void **state) {
  enum { n = 7 };
  lam_spline_surface s[n];
  lam_vec3 low[n + 1], high[n + 1];
  for (int i = 0; i <= n; i++) {
    double t = 2 * LAM_PI * i / n;
    lam_vec3 center = lam_v3(3 * cos(t), 3 * sin(t), 0);
    lam_vec3 across = lam_v3(cos(t / 2) * cos(t), cos(t / 2) * sin(t), sin(t / 2));
    low[i] = lam_sub(center, across), high[i] = lam_add(center, across);
  }
  for (int i = 0; i < n; i++) s[i] = patch(*state, low[i], low[i + 1], high[i + 1], high[i]);
  lam_shell shell = lam_shell_make(*state, n, s);
  assert_int_equal(shell.vertex_count, 2 * n);
  assert_int_equal(shell.edge_count, 3 * n + 1);
  assert_int_equal(shell.border[0], 2 * n + 2);
  assert_oriented(&shell, n);
}

/* Three sheets on one edge: two share it, the third has its own. */
static void no_edge_is_used_three_times(void **state) {
  lam_spline_surface s[3];
  for (int k = 0; k < 3; k++) {
    double t = 2 * k;
    lam_vec3 out = lam_v3(cos(t), sin(t), 0);
    s[k] = patch(*state, lam_v3(0, 0, 0), out, lam_add(out, lam_v3(0, 0, 1)), lam_v3(0, 0, 1));
  }
  lam_shell shell = lam_shell_make(*state, 3, s);
  assert_int_equal(shell.vertex_count, 8);
  assert_int_equal(shell.edge_count, 11);
  assert_int_equal(borders(&shell), 10);
  assert_oriented(&shell, 3);
}

/* Sides are one when their points are, whatever their degree and knots; sides between the same
 * corners that bulge by more than the tolerance are two. */
static void sides_are_compared_by_their_points(void **state) {
  static const double knots[] = {2, 2, 2, 5, 5, 5};
  static const struct {
    double bulge;
    int edges;
  } cases[] = {{0, 7}, {1e-10, 7}, {1e-7, 8}};
  for (int k = 0; k < 3; k++) {
    lam_spline_surface s[2] = {patch(*state, wave(0, 0), wave(1, 0), wave(1, 1), wave(0, 1))};
    lam_vec3 points[6] = {
        wave(1, 0),
        wave(2, 0),
        lam_add(lam_mix(wave(1, 0), wave(1, 1), 0.5), lam_v3(0, 0, cases[k].bulge)),
        lam_mix(wave(2, 0), wave(2, 1), 0.5),
        wave(1, 1),
        wave(2, 1)};
    s[1] = (lam_spline_surface){"quadratic", {2, 1}, {3, 2}, {knots, flat_knots}, points, NULL};
    lam_shell shell = lam_shell_make(*state, 2, s);
    assert_int_equal(shell.vertex_count, 6);
    assert_int_equal(shell.edge_count, cases[k].edges);
    assert_oriented(&shell, 2);
  }
}

/* ---- what of a file is not read ---- */

/* The square of side 2 as a face of STEP, with its four sides, or with a line across from the
 * middle of one side to the middle of the next, in units of meters. */
static const char square_face[] =
    "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(2.,0.,0.));\n#3=CARTESIAN_POINT('',"
    "(2.,2.,0.));\n"
    "#4=CARTESIAN_POINT('',(0.,2.,0.));\n#5=CARTESIAN_POINT('',(2.,1.,0.));\n#6=CARTESIAN_POINT('',"
    "(1.,2.,0.));\n"
    "#10=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#4),(#2,#3)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2)"
    ",(0.,1.),(0.,1.),"
    ".UNSPECIFIED.);\n"
    "#11=VERTEX_POINT('',#1);\n#12=VERTEX_POINT('',#2);\n#13=VERTEX_POINT('',#3);\n#14=VERTEX_"
    "POINT('',#4);\n"
    "#15=VERTEX_POINT('',#5);\n#16=VERTEX_POINT('',#6);\n#20=DIRECTION('',(1.,0.,0.));\n#21=VECTOR("
    "'',#20,1.);\n"
    "#22=LINE('',#1,#21);\n#23=EDGE_CURVE('',#11,#12,#22,.T.);\n#24=EDGE_CURVE('',#12,#15,#22,.T.);"
    "\n"
    "#25=EDGE_CURVE('',#15,#13,#22,.T.);\n#26=EDGE_CURVE('',#13,#14,#22,.T.);\n#27=EDGE_CURVE('',#"
    "14,#11,#22,.T.);\n"
    "#28=EDGE_CURVE('',#15,#16,#22,.T.);\n#29=EDGE_CURVE('',#16,#14,#22,.T.);\n"
    "#31=ORIENTED_EDGE('',*,*,#23,.T.);\n#32=ORIENTED_EDGE('',*,*,#24,.T.);\n#33=ORIENTED_EDGE('',*"
    ",*,#25,.T.);\n"
    "#34=ORIENTED_EDGE('',*,*,#26,.T.);\n#35=ORIENTED_EDGE('',*,*,#27,.T.);\n#36=ORIENTED_EDGE('',*"
    ",*,#28,.T.);\n"
    "#37=ORIENTED_EDGE('',*,*,#29,.T.);\n#40=EDGE_LOOP('',(#31,#32,#33,#34,#35));\n"
    "#41=FACE_OUTER_BOUND('',#40,.T.);\n#42=ADVANCED_FACE('',(#41),#10,.T.);\n"
    "#50=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#51))REPRESENTATION_"
    "CONTEXT('',''));\n"
    "#51=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\nENDSEC;\nEND-ISO-10303-21;\n";

static const char *note_of(lam_arena *arena, const lam_format *format, const char *text) {
  lam_text copy = {.arena = arena};
  lam_text_add(&copy, text);
  const char *note = read_back(arena, format, copy).notes[0];
  return note ? note : "";
}

static void trimmed_faces_of_step_are_noted(void **state) {
  static const char loop[] = "(#31,#32,#33,#34,#35)",
                    placed[] = "#60=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#1,#2);\n#50=";
  assert_string_equal(note_of(*state, &lam_format_step, square_face), "");
  assert_non_null(strstr(note_of(*state, &lam_format_step,
                                 replaced(*state, square_face, loop, "(#31,#32,#36,#37,#35)")),
                         "trimmed"));
  const char *note =
      note_of(*state, &lam_format_step, replaced(*state, square_face, "#50=", placed));
  assert_non_null(strstr(note, "assembly"));
  assert_null(strstr(note, "trimmed"));
}

/* The same square as entity 128, trimmed (144, 142) by the line from (from, 0) to (from, 2). */
static const char *trimmed_iges(lam_arena *arena, double from) {
  static const int types[] = {128, 110, 142, 144};
  lam_text text = {.arena = arena};
  add_line(&text, "", 'S', 1);
  add_line(&text, "1H,,1H;,,,,,32,38,6,308,15,,1.0,6,1HM;", 'G', 1);
  for (int i = 0; i < 4; i++) {
    add_line(&text,
             lam_arena_printf(arena, "%8d%8d%8d%8d%8d%8d%8d%8d%08d", types[i], i + 1, 0, 0, 0, 0, 0,
                              0, 0),
             'D', 2 * i + 1);
    add_line(&text, lam_arena_printf(arena, "%8d%8d%8d%8d%8d", types[i], 0, 0, 1, 0), 'D',
             2 * i + 2);
  }
  add_line(&text, "128,1,1,1,1,,,1,,,0,0,1,1,0,0,1,1,1,1,1,1,,,,2,,,,2,,2,2,,0,1,0,1;", 'P', 1);
  add_line(&text, lam_arena_printf(arena, "110,%g,0,0,%g,2,0;", from, from), 'P', 2);
  add_line(&text, "142,1,1,0,3,2;", 'P', 3);
  add_line(&text, "144,1,1,0,5;", 'P', 4);
  add_line(&text, "S      1G      1D      8P      4", 'T', 1);
  return text.data;
}

static void trimmed_faces_of_iges_are_noted(void **state) {
  assert_string_equal(note_of(*state, &lam_format_iges, trimmed_iges(*state, 2)), "");
  assert_non_null(strstr(note_of(*state, &lam_format_iges, trimmed_iges(*state, 1)), "trimmed"));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(a_grid_shares_its_edges),
      TEST(a_cube_closes_up),
      TEST(a_moebius_band_is_cut),
      TEST(no_edge_is_used_three_times),
      TEST(sides_are_compared_by_their_points),
      TEST(trimmed_faces_of_step_are_noted),
      TEST(trimmed_faces_of_iges_are_noted),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
