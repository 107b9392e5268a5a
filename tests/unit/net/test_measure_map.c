/* Color maps of measures, names that are asked for, and where a net begins to be degenerate. */
#include "net_fixture.h"

#include "net/measures/layout.h"
#include "net/measures/measure_map.h"

/* ---- names ---- */

static const char *complaint(net_fixture *f, const char *name, bool mapped) {
  lam_errors errors = {.arena = f->arena};
  const lam_measure_kind *kind =
      lam_measure_named(name, mapped, (lam_location){.line = 7}, "plots[1]", &errors);
  assert_int_equal(errors.count, kind ? 0 : 1);
  if (kind) assert_string_equal(kind->name, name);
  if (kind) return NULL;
  assert_int_equal(errors.first->location.line, 7);
  assert_string_equal(errors.first->key, "plots[1]");
  return errors.first->text;
}

static void names_of_measures(void **state) {
  net_fixture *f = *state;
  assert_null(complaint(f, "turning_angle", true));
  assert_null(complaint(f, "edge_length", true));
  assert_null(complaint(f, "flatness", false));
  assert_string_equal(complaint(f, "flatness", true),
                      "flatness is one number for the whole net; expected a measure of vertices, "
                      "edges or faces");
  assert_string_equal(complaint(f, "turning_angel", true),
                      "given turning_angel; expected measures of `lamella list measures` (did you "
                      "mean turning_angle?)");
  assert_string_equal(complaint(f, "x", false),
                      "given x; expected measures of `lamella list measures`");

  const char *const items[] = {"edge_length", "flatness", "y"};
  const lam_list names = {.items = (void *)items, .count = 3};
  lam_errors errors = {.arena = f->arena};
  lam_measures_check(&names, true, (lam_location){0}, "plots", &errors);
  assert_int_equal(errors.count, 2);
}

/* Those that lay the net flat are slow, and left out unless they are named. */
static void which_measures_are_slow(void **state) {
  (void)state;
  int slow = 0;
  for (int i = 0; i < lam_measure_count; i++) {
    bool flat = strncmp(lam_measures[i]->name, "flattening_", 11) == 0;
    assert_int_equal(lam_measure_is_slow(lam_measures[i]), flat);
    slow += flat;
  }
  assert_int_equal(slow, 3);
  assert_null(lam_measure_find("nothing"));
  assert_null(lam_measure_scale(lam_measure_find("edge_length")));
  assert_string_equal(lam_measure_scale(lam_measure_find("parameter_stretch")), "stretch");
  assert_string_equal(lam_measure_scale(lam_measure_find("flattening_compression")), "stretch");
  assert_string_equal(lam_measure_scale(lam_measure_find("parameter_distortion")), "distortion");
}

/* ---- maps ---- */

/* 3 x 2 vertices: rows 1 apart, the second column 1, the third 3 further. */
static lam_vec3 uneven(double i, double j) { return lam_v3(i < 1 ? i : 1 + 3 * (i - 1), j, 0); }

static void maps_on_edges_faces_and_vertices(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 2, uneven);
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  lam_map map = lam_net_map(&in, lam_measure_find("edge_length"));
  assert_int_equal(map.on, LAM_MAP_EDGES);
  assert_int_equal(map.count, 7);
  for (int e = 0; e < 7; e++)
    assert_near(map.values[e],
                lam_distance(mesh.vertices[map.edges[e][0]], mesh.vertices[map.edges[e][1]]),
                1e-15);
  /* 1 apart three times across and twice along, 3 apart twice */
  assert_near(map.summary.min, 1, 1e-15);
  assert_near(map.summary.max, 3, 1e-15);
  assert_near(map.summary.mean, 11. / 7, 1e-15);
  assert_string_equal(map.summary.unit, "m");
  assert_string_equal(map.doc, "length of the edges");
  for (int v = 0; v < 6; v++) assert_near(map.normals[v].z, 1, 1e-15);
  assert_null(map.layout);

  map = lam_net_map(&in, lam_measure_find("edge_ratio"));
  assert_int_equal(map.on, LAM_MAP_FACES);
  assert_int_equal(map.count, 2);
  assert_near(map.values[0], 1, 1e-15);
  assert_near(map.values[1], 3, 1e-15);
  assert_null(map.edges);
  map = lam_net_map(&in, lam_measure_find("spacing_u"));
  assert_int_equal(map.on, LAM_MAP_VERTICES);
  assert_int_equal(map.count, 6);

  /* the rectangle: two cells of 2 x 1 */
  map = lam_net_map(&in, lam_measure_find("parameter_stretch"));
  for (int v = 0; v < 6; v++) {
    assert_near(map.layout[v].x, 2 * (v / 2), 1e-15);
    assert_near(map.layout[v].y, v % 2, 1e-15);
  }
}

/* Stretches 1 and 1.5, compressions 1/2 and 1 (cells of 2 over widths of 1 and 3): one range from
 * 1/2 to 1.5. The distortions 2 and 1.5 have a range of their own, the others none. */
static void maps_of_one_scale_share_their_range(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 2, uneven);
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  const char *const items[] = {"parameter_stretch", "edge_length", "parameter_compression",
                               "parameter_distortion"};
  const lam_list names = {.items = (void *)items, .count = 4};
  const lam_map *maps = lam_net_maps(&in, &names);
  static const double ranges[4][2] = {{.5, 1.5}, {0, 0}, {.5, 1.5}, {1.5, 2}};
  for (int i = 0; i < 4; i++) {
    assert_string_equal(maps[i].summary.name, items[i]);
    for (int k = 0; k < 2; k++) assert_near(maps[i].range[k], ranges[i][k], 1e-14);
  }

  /* all cells alike: one value, no range */
  mesh = net_grid(f->arena, 3, 2, net_plane);
  in.positions = mesh.vertices;
  maps = lam_net_maps(&in, &names);
  for (int k = 0; k < 2; k++) assert_near(maps[3].range[k], 0, 0);
}

/* ---- degenerate nets ---- */

/* What becomes of a net whose vertices are moved; NULL: nothing bad. */
static const char *moved(net_fixture *f, lam_vec3 (*start)(double i, double j),
                         lam_vec3 (*end)(double i, double j)) {
  lam_mesh before = net_grid(f->arena, 6, 6, start), after = net_grid(f->arena, 6, 6, end);
  lam_net net = net_built(f, &before);
  return lam_net_degenerate(f->arena, &net, before.vertices, after.vertices);
}

static void assert_starts(const char *text, const char *word) {
  if (!text || strncmp(text, word, strlen(word)) != 0)
    fail_msg("%s, expected %s", text ? text : "nothing", word);
}

static double factor;
static lam_vec3 wave(double i, double j) { return lam_v3(i, j, (int)(i + j) % 2 ? .1 : -.1); }
static lam_vec3 scaled(double i, double j) { return lam_scale(wave(i, j), factor); }
static lam_vec3 flatter(double i, double j) { return lam_v3(i, j, factor * wave(i, j).z); }
/* Five columns after the first are 1 apart; the first edge is `factor` long. */
static lam_vec3 pinched(double i, double j) {
  lam_vec3 x = wave(i, j);
  return i < .5 ? lam_v3(1 - factor, j, wave(1, j).z) : x;
}

/* Below a twentieth and from twenty times the size on; flat below a twentieth of the flatness
 * before. */
static void limits_of_size_and_flatness(void **state) {
  net_fixture *f = *state;
  factor = .0495, assert_starts(moved(f, wave, scaled), "shrunk");
  factor = .0505, assert_null(moved(f, wave, scaled));
  factor = 19.9, assert_null(moved(f, wave, scaled));
  factor = 20.1, assert_starts(moved(f, wave, scaled), "flown apart");
  factor = .049, assert_starts(moved(f, wave, flatter), "flattened");
  factor = .051, assert_null(moved(f, wave, flatter));
  factor = 0, assert_starts(moved(f, wave, flatter), "flattened");
  assert_null(moved(f, net_plane, net_plane));
}

/* Edges along u: 24 of sqrt(1.04) and 6 that are pinched, with 30 across of sqrt(1.04): the mean is
 * (54 sqrt(1.04) + 6 l) / 60, and the shortest is a fiftieth of it at l = .0184. */
static void limits_of_the_shortest_edge(void **state) {
  net_fixture *f = *state;
  factor = .018, assert_starts(moved(f, wave, pinched), "collapsed");
  factor = .019, assert_null(moved(f, wave, pinched));
  /* a net whose shortest edge was less than five times as long before has not collapsed */
  lam_mesh before, after;
  for (int k = 0; k < 2; k++) {
    factor = k ? .052 : .048, before = net_grid(f->arena, 6, 6, pinched);
    factor = .01, after = net_grid(f->arena, 6, 6, pinched);
    lam_net net = net_built(f, &before);
    const char *text = lam_net_degenerate(f->arena, &net, before.vertices, after.vertices);
    if (k) assert_starts(text, "collapsed");
    if (!k) assert_null(text);
  }
}

/* Faces bent by the angle about the line x = 2: above 120 degrees they count as folded. */
static lam_vec3 bent(double i, double j) {
  double a = factor * net_pi / 180, out = i > 2 ? i - 2 : 0;
  return lam_v3(fmin(i, 2) + out * cos(a), j, out * sin(a));
}

static void limit_of_a_fold(void **state) {
  net_fixture *f = *state;
  for (int k = 0; k < 2; k++) {
    factor = k ? 121 : 119;
    lam_mesh mesh = net_grid(f->arena, 6, 6, bent);
    lam_net net = net_built(f, &mesh);
    assert_near(lam_net_measure_one(f->arena, &net, mesh.vertices, "foldovers").max, k ? 5 : 0, 0);
  }
  assert_starts(moved(f, net_plane, bent), "folded");
  assert_starts(moved(f, bent, bent), "folded"); /* although it was so before */
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(names_of_measures),
      NET_TEST(which_measures_are_slow),
      NET_TEST(maps_on_edges_faces_and_vertices),
      NET_TEST(maps_of_one_scale_share_their_range),
      NET_TEST(limits_of_size_and_flatness),
      NET_TEST(limits_of_the_shortest_edge),
      NET_TEST(limit_of_a_fold),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
