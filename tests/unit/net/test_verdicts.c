/* What a net's verdict promises: converged means that the measure of its kind shows it somewhere,
 * and that the net neither turns over nor lies on itself. */
#include "net/optimize.h"
#include "net_fixture.h"

static lam_net_result solve(net_fixture *f, const lam_mesh *mesh, const char *kind_name,
                            const char *keys) {
  lam_net net = net_built(f, mesh);
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, kind_name);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, keys);
  common->from.file = "mesh.obj";
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, "{}"),
                     .common = common};
  lam_net_result result;
  assert_true(lam_net_optimize(f->arena, &job, &net, &f->errors, &result));
  net_no_errors(f, kind_name);
  return result;
}

static void assert_fails(const lam_net_result *result, const char *word) {
  assert_false(result->converged);
  if (strncmp(result->reason, word, strlen(word)) != 0)
    fail_msg("%s, expected %s", result->reason, word);
}

/* ---- proof ---- */

/* n x n quads of a saddle, each with four vertices of its own: no inner vertex anywhere. */
static lam_mesh soup(net_fixture *f, int n) {
  static const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  lam_mesh mesh = {4 * n * n, LAM_NEW(f->arena, lam_vec3, 4 * n * n), n * n,
                   (int(*)[4])lam_arena_alloc(f->arena, (size_t)(n * n), sizeof *mesh.faces)};
  for (int q = 0; q < n * n; q++)
    for (int k = 0; k < 4; k++) {
      mesh.faces[q][k] = 4 * q + k;
      mesh.vertices[4 * q + k] = net_saddle(q / n + corner[k][0], q % n + corner[k][1]);
    }
  return mesh;
}

/* Every kind names the measure that proves it, and measures it. Only `free` demands nothing. */
static void every_kind_names_its_proof(void **state) {
  (void)state;
  for (int i = 0; i < lam_nets.count; i++) {
    const lam_net_kind *kind = (const lam_net_kind *)lam_nets.rows[i];
    bool listed = false;
    for (int m = 0; kind->proof && kind->measures[m]; m++)
      listed |= strcmp(kind->measures[m], kind->proof) == 0;
    if (listed == (strcmp(kind->head.name, "free") == 0)) fail_msg("%s", kind->head.name);
  }
}

/* In a soup no star exists, so that all kinds that are defined at stars have nothing to solve. */
static void a_soup_is_nothing_to_solve(void **state) {
  net_fixture *f = *state;
  static const char *const kinds[] = {"asymptotic", "conical", "dog",   "geodesic",
                                      "s-net",      "cmc",     "k-net", "voss"};
  lam_mesh mesh = soup(f, 4);
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
    lam_net_result result = solve(f, &mesh, kinds[i], "{}");
    assert_fails(&result, "nothing to solve: ");
    assert_non_null(result.unproven);
  }

  /* Quads alone can be plane; a net without demands is what it is; one whose demand applies nowhere
   * is not. */
  assert_true(solve(f, &mesh, "planar-quads", "{}").converged);
  assert_true(solve(f, &mesh, "free", "{}").converged);
  lam_net_result result = solve(f, &mesh, "free", "{constraints: [planar-star]}");
  assert_fails(&result, "nothing to solve: the constraints apply nowhere");
}

/* ---- folds and overlaps ---- */

/* A flat ring of radius 2 to 4 in cells of 20 degrees, that rises by a thousandth per cell. */
static lam_vec3 turn(double i, double j) {
  double a = i * net_pi / 9;
  return lam_v3((2 + j) * cos(a), (2 + j) * sin(a), .001 * i);
}

/* 27 cells are one and a half turns: 9 x 2 faces lie under 9 x 2 others. 17 cells are less than one
 * turn. */
static void a_net_that_lies_on_itself(void **state) {
  net_fixture *f = *state;
  for (int k = 0; k < 2; k++) {
    lam_mesh mesh = net_grid(f->arena, k ? 28 : 18, 3, turn);
    lam_net net = net_built(f, &mesh);
    double over = lam_net_measure_one(f->arena, &net, mesh.vertices, "overlaps").max;
    assert_near(over, k ? 36 : 0, 0);

    lam_net_result result = solve(f, &mesh, "free", "{}");
    if (k) assert_fails(&result, "lies on itself: 36 faces");
    if (!k) assert_true(result.converged);
  }
}

/* The same turn, rising by one per cell: the layers are 18 apart. Two strips at right angles pass
 * through each other without lying on each other. */
static lam_vec3 stairs(double i, double j) {
  lam_vec3 x = turn(i, j);
  return lam_v3(x.x, x.y, i);
}
/* Along x at height .1, up and back, then down through the start of itself. */
static lam_vec3 loop(double i, double j) {
  if (i <= 4) return lam_v3(i, j, .1);
  if (i <= 7) return lam_v3(4, j, i - 3.9);
  if (i <= 9.5) return lam_v3(11 - i, j, 3.1);
  return lam_v3(1.5, j, 13 - i);
}

static void layers_and_passages_are_no_overlap(void **state) {
  net_fixture *f = *state;
  lam_mesh meshes[2] = {net_grid(f->arena, 28, 3, stairs), net_grid(f->arena, 16, 3, loop)};
  for (int k = 0; k < 2; k++) {
    lam_net net = net_built(f, &meshes[k]);
    assert_near(lam_net_measure_one(f->arena, &net, meshes[k].vertices, "overlaps").max, 0, 0);
  }
}

/* A strip that was folded at its start is folded in the end: three of its faces' edges turn by more
 * than 120 degrees. */
static lam_vec3 folded(double i, double j) {
  return i > 2 ? lam_v3(4 - i, j, .6 * (i - 2)) : lam_v3(i, j, 0);
}

static void a_fold_of_the_start_is_a_failure(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 5, 4, folded);
  lam_net_result result = solve(f, &mesh, "free", "{}");
  assert_fails(&result, "folded: faces turn over at 3 edges");
}

/* The usual ranges of every surface, in every chart that it has by formula, are no net that lies on
 * itself or turns over: the widest waves of the unduloid too. */
static void usual_ranges_lie_once(void **state) {
  net_fixture *f = *state;
  static const char *const keyed[][2] = {{"unduloid", "{neck: 0.17647}"},
                                         {"unduloid", "{neck: 1}"},
                                         {"nodoid", "{neck: 0.9}"},
                                         {"unduloid", "{}"},
                                         {"nodoid", "{}"},
                                         {"enneper", "{}"},
                                         {"enneper", "{order: 3}"},
                                         {"catenoid", "{}"},
                                         {"helicoid", "{}"},
                                         {"pseudosphere", "{}"},
                                         {"scherk", "{}"},
                                         {"torus", "{}"},
                                         {"sphere", "{}"},
                                         {"ellipsoid", "{}"},
                                         {"constant-ratio", "{}"},
                                         {"hyperbolic-paraboloid", "{}"}};
  for (size_t i = 0; i < sizeof keyed / sizeof *keyed; i++)
    for (int chart = 0; chart < LAM_CHART_COUNT; chart++) {
      double range[2][2];
      bool closed[2];
      const lam_row_head *head = lam_registry_find(&lam_surfaces, keyed[i][0]);
      if (!head) fail_msg("%s", keyed[i][0]);
      lam_row row = {.head = head,
                     .params = net_params(f, head->keys, head->params_size, keyed[i][1])};
      lam_surface made = lam_surface_make(f->arena, &row, &f->errors);
      if (!made.kind->domain(made.data, chart, range[0], range[1], closed)) continue;

      lam_mesh mesh = net_sampled(f, keyed[i][0], keyed[i][1], chart, 16, 16, 0);
      lam_net net = net_built(f, &mesh);
      for (int k = 0; k < 2; k++) {
        const char *name = k ? "foldovers" : "overlaps";
        double found = lam_net_measure_one(f->arena, &net, mesh.vertices, name).max;
        if (found > 0)
          fail_msg("%s %s, chart %d: %g %s", keyed[i][0], keyed[i][1], chart, found, name);
      }
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(every_kind_names_its_proof),       NET_TEST(a_soup_is_nothing_to_solve),
      NET_TEST(a_net_that_lies_on_itself),        NET_TEST(layers_and_passages_are_no_overlap),
      NET_TEST(a_fold_of_the_start_is_a_failure), NET_TEST(usual_ranges_lie_once),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
