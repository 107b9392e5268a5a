/* From a design to a model: what each stage leaves there, in numbers known by hand. */
#include "design/describe.h"
#include "design/pipeline.h"
#include "net_fixture.h"
#include "surf/surface.h"

/* The design's model; NULL with messages in f->errors. net: what net.from.file was read as. */
static const lam_model *built(net_fixture *f, const char *yaml, const lam_mesh *net) {
  f->errors = (lam_errors){.arena = f->arena};
  lam_design_text text = {.path = "x.yaml", .bytes = yaml, .count = strlen(yaml)};
  lam_design *design = LAM_NEW(f->arena, lam_design, 1);
  lam_model *model = LAM_NEW(f->arena, lam_model, 1);
  lam_inputs inputs = {.net = net};
  if (!lam_design_parse(f->arena, &text, &f->errors, design)) return NULL;
  return lam_pipeline_run(f->arena, design, &inputs, NULL, &f->errors, model) ? model : NULL;
}

static const lam_model *made(net_fixture *f, const char *yaml, const lam_mesh *net) {
  const lam_model *model = built(f, yaml, net);
  if (!model) fail_msg("%s: %s", f->errors.first->key, f->errors.first->text);
  return model;
}

#define HEAD "lamella: 1\nname: x\n"
#define DOME HEAD "surface: {kind: monge, x2: -0.2, y2: -0.3, u: [-1, 1], v: [-1, 1], size: 4 m}\n"
#define FROM_FILE HEAD "net: {kind: free, from: {file: a.obj}"

/* ---- the net ---- */

/* Without a net a surface becomes 32 x 32 cells, which are not solved; with one, the cells of its
 * grid, halved, doubled or on diagonals: of 8 x 8 cells 24 inner vertices with i + j odd have faces
 * of diagonals. */
static void cells_of_the_net(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *net;
    int faces, stages;
  } rows[] = {{"", 32 * 32, 0},
              {"net: {kind: free, grid: [8, 6]}\n", 48, 1},
              {"net: {kind: free, grid: [8, 6], coarsen: 1}\n", 12, 1},
              {"net: {kind: free, grid: [8, 8], coarsen: 2}\n", 4, 1},
              {"net: {kind: free, grid: [8, 6], subdivide: 1}\n", 192, 1},
              {"net: {kind: free, grid: [2, 3], subdivide: 2}\n", 96, 1},
              {"net: {kind: free, grid: [8, 8], diagonalize: yes}\n", 24, 1}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    const lam_model *m = made(f, lam_arena_printf(f->arena, "%s%s", DOME, rows[i].net), NULL);
    assert_int_equal(m->net->face_count, rows[i].faces);
    assert_int_equal(m->report->stage_count, rows[i].stages);
    if (rows[i].stages) assert_string_equal(m->report->stages[0].name, "net: free");
  }
}

/* The net stands on the ground, with its lowest vertices at height 0. */
static void nets_stand_on_the_ground(void **state) {
  net_fixture *f = *state;
  const lam_model *m = made(f, DOME "net: {kind: free, grid: [4, 4]}\n", NULL);
  double low = INFINITY, high = -INFINITY;
  for (int v = 0; v < 25; v++) {
    low = fmin(low, m->net->vertices[v].z);
    high = fmax(high, m->net->vertices[v].z);
  }
  /* of size 4 m: the square of 2 is doubled, its middle (.2 + .3) * 2 above the corners */
  assert_near(low, 0, 1e-12);
  assert_near(high, 1, 1e-12);
  assert_int_equal(m->support_count, 4); /* the corners */
}

/* 5 x 3 vertices, of the heights 0 to 1; supports are those of the border that no neighbor is
 * below, up to a fiftieth of the height. */
static lam_mesh hills(net_fixture *f) {
  static const double z[15] = {0, .5, .5, .5, -.0, .4, .019, .3, .5, .021, .6, .5, 1, .7, .015};
  lam_mesh mesh = net_grid(f->arena, 5, 3, net_plane);
  for (int v = 0; v < 15; v++) mesh.vertices[v].z = z[v];
  return mesh;
}

static void supports_are_the_lowest_of_the_border(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = hills(f);
  const lam_model *m = made(f, FROM_FILE "}\n", &mesh);
  for (int v = 0; v < 15; v++)
    assert_near(lam_distance(m->net->vertices[v], mesh.vertices[v]), 0, 1e-12);
  static const int expected[3] = {0, 6, 14};
  assert_int_equal(m->support_count, 3); /* 4 lies inside, 9 is too high */
  for (int k = 0; k < 3; k++)
    assert_near(lam_distance(m->supports[k], mesh.vertices[expected[k]]), 0, 1e-12);
  assert_string_equal(m->picture.setting, "plaza");
  assert_int_equal(m->picture.width, 1600);
  assert_int_equal(m->picture.height, 900);
}

/* Lines stand in for axes of parts: A01 to A03 along u, B01 to B05 along v. */
static void lines_have_names(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = hills(f);
  const lam_model *m = made(f, FROM_FILE "}\n", &mesh);
  static const char *const names[] = {"A01", "A02", "A03", "B01", "B02", "B03", "B04", "B05"};
  assert_int_equal(m->polyline_count, 8);
  assert_int_equal(m->curve_count, 8);
  for (int i = 0; i < 8; i++) {
    assert_string_equal(m->curves[i].name, names[i]);
    assert_int_equal(m->curves[i].family, i >= 3);
  }
  assert_int_equal(made(f, DOME, NULL)->curve_count, 0); /* no net was asked for */
}

/* Noise of a tenth: no vertex moves by more than sqrt 3 tenths of the mean edge, some by half of
 * it; the same seed moves alike. */
static void noise_is_a_part_of_the_mean_edge(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 6, 6, net_plane);
  for (int v = 0; v < 36; v++) mesh.vertices[v] = lam_scale(mesh.vertices[v], 2); /* edges of 2 m */
  const lam_model *m[3] = {made(f, FROM_FILE ", noise: 0.1, seed: 1}\n", &mesh),
                           made(f, FROM_FILE ", noise: 0.1, seed: 1}\n", &mesh),
                           made(f, FROM_FILE ", noise: 0.1, seed: 2}\n", &mesh)};
  double most = 0, other = 0;
  for (int v = 0; v < 36; v++) {
    most = fmax(most, lam_distance(m[0]->net->vertices[v], mesh.vertices[v]));
    other = fmax(other, lam_distance(m[0]->net->vertices[v], m[2]->net->vertices[v]));
    assert_near(lam_distance(m[0]->net->vertices[v], m[1]->net->vertices[v]), 0, 0);
  }
  assert_below(most, .2 * sqrt(3));
  assert_below(.1, most);
  assert_below(.05, other);
}

/* ---- parts and sheets ---- */

/* Stages in the order in which they ran, sheets last. The share used of a sheet is 1 less what is
 * left; the report has the mean, and what is left of the emptiest. */
static void stages_and_sheets_of_a_report(void **state) {
  net_fixture *f = *state;
  const lam_model *m = made(
      f,
      DOME "net: {kind: free, grid: [3, 3]}\nparts: [{kind: lamella, height: 60 mm, thickness: "
           "1 mm}]\nsheets: {stock: [3 m, 0.4 m]}\nplots: [edge_length, spacing_u]\n",
      NULL);
  static const char *const stages[] = {"net: free", "lamellas", "clash", "sheets"};
  assert_int_equal(m->report->stage_count, 4);
  for (int i = 0; i < 4; i++) assert_string_equal(m->report->stages[i].name, stages[i]);

  double used = 0, least = 1;
  assert_true(m->sheet_count > 1);
  for (int i = 0; i < m->sheet_count; i++) {
    used += m->sheets[i].used;
    least = fmin(least, m->sheets[i].used);
  }
  const lam_stage *sheets = &m->report->stages[3];
  assert_int_equal(sheets->measure_count, 2);
  assert_string_equal(sheets->measures[0].name, "sheet_count");
  assert_near(sheets->measures[0].max, m->sheet_count, 0);
  assert_string_equal(sheets->measures[1].name, "sheet_used");
  assert_near(sheets->measures[1].min, least, 1e-14);
  assert_true(sheets->measures[1].max >= sheets->measures[1].mean && sheets->measures[1].max < 1);
  assert_near(sheets->measures[1].mean, used / m->sheet_count, 1e-14);
  assert_true(sheets->seconds >= 0 && sheets->seconds < 60);

  assert_int_equal(m->map_count, 2);
  assert_string_equal(m->maps[0].summary.name, "edge_length");
  assert_string_equal(m->maps[1].summary.name, "spacing_u");
  assert_int_equal(m->curve_count, m->part_count); /* axes, instead of the lines */
}

/* ---- surfaces ---- */

/* A spline surface is kept where the net stands: a bilinear one of 1 x 1, 4 m large and on the
 * ground. */
static void surfaces_stand_where_the_net_does(void **state) {
  net_fixture *f = *state;
  static const char yaml[] = HEAD
      "surface: {kind: bezier, count: [2, 2], size: 4 m, points: [0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1, "
      "2]}\nnet: {kind: free, grid: [2, 2]}\n";
  const lam_model *m = made(f, yaml, NULL);
  assert_int_equal(m->surface_count, 1);
  const lam_spline_surface *s = m->surfaces;
  assert_string_equal(s->name, "surface");
  static const int corners[4] = {0, 2, 6, 8};
  for (int k = 0; k < 4; k++)
    assert_near(lam_distance(s->points[k], m->net->vertices[corners[k]]), 0, 1e-12);
  assert_near(m->net->vertices[8].z - m->net->vertices[0].z, 4, 1e-12);
  assert_near(m->net->vertices[0].z, 0, 1e-12);
}

/* ---- mistakes ---- */

static void what_does_not_go_together_is_told(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *yaml, *key, *words;
  } rows[] = {
      {FROM_FILE "}\n", "net.from.file", "a.obj was not read by this caller"},
      {HEAD "net: {kind: free, from: {design: b}}\n", "net.from.design", "b was not read"},
      {HEAD "net: {kind: free}\n", "net", "a net without a surface"},
      {DOME "net: {kind: free, grid: [3, 3], coarsen: 3}\n", "net.coarsen", "a single face"},
      {DOME "net: {kind: free, grid: [1, 4], diagonalize: yes}\n", "net.diagonalize",
       "no inner vertex"},
      {DOME "net: {kind: free, from: {lines: natural, spacing: 1 m}}\n", "net.from.spacing",
       "given, but monge has a formula for its natural lines"},
      {DOME "net: {kind: free, from: {lines: natural, at: [0, 0]}}\n", "net.from.at",
       "given, but monge has a formula"},
      {HEAD "plots: [edge_length]\n", "plots", "there is no net to plot"},
      {DOME "plots: [flatness]\n", "plots", "flatness is one number for the whole net"},
      {HEAD "parts: [{kind: lamella, height: 60 mm, thickness: 1 mm}]\n", "parts",
       "parts without a net; expected net"},
      {DOME "texture: {motif: checker}\n", "texture", "there is no spline surface to print on"},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    assert_null(built(f, rows[i].yaml, NULL));
    const lam_error *e = f->errors.first;
    if (!e->key || strcmp(e->key, rows[i].key) != 0 || !strstr(e->text, rows[i].words))
      fail_msg("%s: %s, expected %s: %s", e->key, e->text, rows[i].key, rows[i].words);
  }
}

/* ---- words ---- */

static const char *quantity(net_fixture *f, double value, lam_key_unit unit) {
  lam_text text = {.arena = f->arena};
  lam_describe_quantity(&text, value, unit);
  return text.data;
}

/* From 1 m on in meters, from 0.1 mm on in millimeters, below in micrometers. */
static void quantities_are_shown_in_units_that_read_well(void **state) {
  net_fixture *f = *state;
  assert_string_equal(quantity(f, 12.5, LAM_UNIT_LENGTH), "12.5 m");
  assert_string_equal(quantity(f, 1, LAM_UNIT_LENGTH), "1 m");
  assert_string_equal(quantity(f, -.5, LAM_UNIT_LENGTH), "-500 mm");
  assert_string_equal(quantity(f, 1e-4, LAM_UNIT_LENGTH), "0.1 mm");
  assert_string_equal(quantity(f, 9e-5, LAM_UNIT_LENGTH), "90 um");
  assert_string_equal(quantity(f, 0, LAM_UNIT_LENGTH), "0");
  assert_string_equal(quantity(f, net_pi / 3, LAM_UNIT_ANGLE), "60 deg");
  assert_string_equal(quantity(f, 1. / 3, LAM_UNIT_NONE), "0.333333");
  assert_string_equal(quantity(f, 1e7, LAM_UNIT_NONE), "1e+07");
}

static const char *range(net_fixture *f, lam_key key, const char *unit) {
  const lam_unit_name *name = lam_unit_names;
  lam_text text = {.arena = f->arena};
  while (unit && strcmp(name->name, unit) != 0) name++;
  lam_describe_range(&text, &key, unit ? name : NULL);
  return text.data ? text.data : "";
}

/* Limits on one side or on both, in the unit that was given; none where the table has none. */
static void ranges_are_told(void **state) {
  net_fixture *f = *state;
  lam_key key = {.type = LAM_KEY_NUMBER, .unit = LAM_UNIT_LENGTH, .min = .02, .max = 2};
  assert_string_equal(range(f, key, NULL), "from 20 mm to 2 m");
  assert_string_equal(range(f, key, "cm"), "from 2 cm to 200 cm");
  key.max = 1e300;
  assert_string_equal(range(f, key, "mm"), "at least 20 mm");
  key.min = -1e300, key.max = 0;
  assert_string_equal(range(f, key, "m"), "at most 0");
  key.max = -1e300;
  assert_string_equal(range(f, key, NULL), "");
  key = (lam_key){.type = LAM_KEY_INTEGER, .min = 1, .max = 9};
  assert_string_equal(range(f, key, NULL), "from 1 to 9");
  key.type = LAM_KEY_TEXT;
  assert_string_equal(range(f, key, NULL), "");
  lam_key angle = {.type = LAM_KEY_NUMBER, .unit = LAM_UNIT_ANGLE, .min = 0, .max = net_pi / 2};
  assert_string_equal(range(f, angle, "deg"), "from 0 to 90 deg");
  assert_string_equal(range(f, angle, "rad"), "from 0 to 1.5708 rad");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(cells_of_the_net),
      NET_TEST(nets_stand_on_the_ground),
      NET_TEST(supports_are_the_lowest_of_the_border),
      NET_TEST(lines_have_names),
      NET_TEST(noise_is_a_part_of_the_mean_edge),
      NET_TEST(stages_and_sheets_of_a_report),
      NET_TEST(surfaces_stand_where_the_net_does),
      NET_TEST(what_does_not_go_together_is_told),
      NET_TEST(quantities_are_shown_in_units_that_read_well),
      NET_TEST(ranges_are_told),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
