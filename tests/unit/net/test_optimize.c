/* Solving under rough conditions: noise, handles, held boundaries, references, contradictions. */
#include "core/solid/triangles.h"
#include "net/optimize.h"
#include "net_fixture.h"

typedef struct outcome {
  lam_net net;
  lam_mesh start;
  lam_net_result result;
  lam_arena *arena;
} outcome;

typedef struct setup {
  const char *kind, *params, *keys;
  const lam_trimesh *reference;
  const lam_progress *progress;
} setup;

/* grid: cells along both families; 0: the mesh is no grid. */
static outcome solve(net_fixture *f, const lam_mesh *mesh, int grid, setup s) {
  outcome o = {.net = net_built(f, mesh), .start = *mesh, .arena = f->arena};
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, s.kind);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, s.keys);
  common->grid[0] = common->grid[1] = grid;
  if (!grid) common->from.file = "mesh.obj";
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, s.params),
                     .common = common,
                     .reference = s.reference,
                     .location = (lam_location){"test", 1, 1},
                     .progress = s.progress};
  if (!lam_net_optimize(f->arena, &job, &o.net, &f->errors, &o.result)) {
    assert_true(f->errors.count > 0);
    return o;
  }
  assert_int_equal(f->errors.count, 0);
  assert_non_null(o.result.reason);
  for (int v = 0; v < mesh->vertex_count; v++) {
    lam_vec3 x = o.net.mesh.vertices[v];
    assert_true(isfinite(x.x + x.y + x.z));
  }
  return o;
}

static double measure(const outcome *o, const char *name) {
  return lam_net_measure_one(o->arena, &o->net, o->net.mesh.vertices, name).max;
}

static void assert_converged(const outcome *o, const char *what) {
  if (!o->result.converged) fail_msg("%s: %s", what, o->result.reason);
}

static lam_mesh saddle(net_fixture *f, int cells) {
  return net_sampled(f, "enneper", "{}", LAM_CHART_ASYMPTOTIC, cells, cells, 0);
}

static const char right[] = "{orthogonal: yes}";

/* Noise of a tenth and a fifth of an edge, smoothed once: as many steps as from a bumpy start, no
 * folds, no slivers. */
static void noisy_starts_converge(void **state) {
  net_fixture *f = *state;
  for (int seed = 1; seed <= 8; seed++)
    for (int strength = 1; strength <= 2; strength++) {
      lam_mesh mesh = saddle(f, 16);
      lam_net net = net_built(f, &mesh);
      lam_mesh_perturb(&mesh, .1 * strength * lam_net_mean_edge(&net, mesh.vertices), seed);
      outcome o =
          solve(f, &mesh, 16, (setup){"asymptotic", right, "{solver: {smooth: yes}}", NULL, NULL});
      assert_converged(&o, "noise");
      assert_below(o.result.solution.iterations, 8);
      assert_below(measure(&o, "star_planarity"), 1e-12);
      assert_near(measure(&o, "foldovers"), 0, 0);
      assert_true(measure(&o, "shortest_edge") > .5); /* .63 without noise */
      for (int i = 0; i < o.result.measure_count; i++)
        if (strcmp(o.result.measures[i].name, "angle_deviation") == 0)
          assert_below(o.result.measures[i].max, 1e-9);
    }
}

/* Smoothing acts whatever the fairness of the net is about: the planar quads of an ellipsoid with
 * noise keep longer edges. */
static void smoothing_helps_planar_quads(void **state) {
  net_fixture *f = *state;
  double shortest[2];
  for (int smooth = 0; smooth < 2; smooth++) {
    lam_mesh mesh = net_sampled(f, "ellipsoid", "{}", LAM_CHART_PRINCIPAL, 16, 16, 0);
    lam_net net = net_built(f, &mesh);
    lam_mesh_perturb(&mesh, .1 * lam_net_mean_edge(&net, mesh.vertices), 1);
    outcome o =
        solve(f, &mesh, 16,
              (setup){"planar-quads", "{}", smooth ? "{solver: {smooth: yes}}" : "{}", NULL, NULL});
    assert_converged(&o, "planar quads");
    shortest[smooth] = measure(&o, "shortest_edge");
  }
  assert_true(shortest[1] > 1.5 * shortest[0]);
}

/* Handles that cannot be reached, constraints that contradict each other: a result with a
 * reason, never
 * NaN, within the limit of steps. */
static void contradictions_end_with_a_reason(void **state) {
  net_fixture *f = *state;
  static const char *const keys[] = {
      "{handles: [{vertex: [8, 8], to: [0 m, 0 m, 10 m]}], solver: {iterations: 60}}",
      "{handles: [{vertex: [8, 8], to: [0 m, 0 m, 100000 m]}], solver: {iterations: 60}}",
      "{handles: [{vertex: [8, 8], to: [0 m, 0 m, 1 m]}, {vertex: [8, 8], to: [0 m, 0 m, 2 m]}], "
      "solver: {iterations: "
      "60}}",
      "{constraints: [{kind: edge-length}], handles: [{vertex: [8, 8], to: [0 m, 0 m, 10 m]}], "
      "solver: {iterations: "
      "60}}",
      "{boundary: fixed, handles: [{vertex: [8, 8], to: [0 m, 0 m, 10 m], steps: 3}], solver: "
      "{iterations: 20}}",
      "{boundary: glide, handles: [{vertex: [8, 8], to: [0 m, 0 m, 10 m]}], solver: {iterations: "
      "60, fairness: 1}}",
      "{constraints: [{kind: angle, angle: 60 deg}], solver: {iterations: 60}}",
      "{constraints: [{kind: edge-length, length: 1 mm}], solver: {iterations: 60}}",
      "{boundary: fixed, constraints: [{kind: edge-length, length: 1000 m}], solver: {iterations: "
      "60}}",
  };
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    lam_mesh mesh = saddle(f, 16);
    outcome o = solve(f, &mesh, 16, (setup){"asymptotic", right, keys[i], NULL, NULL});
    if (o.result.converged) fail_msg("%s converged", keys[i]);
    assert_true(strlen(o.result.reason) > 10);
    assert_true(o.result.solution.worst != NULL);
    assert_below(o.result.solution.iterations, 60);
  }
}

static void handles_on_a_fixed_boundary_are_refused(void **state) {
  net_fixture *f = *state;
  f->errors = (lam_errors){.arena = f->arena};
  lam_mesh mesh = saddle(f, 4);
  solve(f, &mesh, 4,
        (setup){"asymptotic", right,
                "{boundary: fixed, handles: [{vertex: [0, 2], to: [0, 0, 0]}]}", NULL, NULL});
  assert_int_equal(f->errors.count, 1);
  assert_non_null(strstr(f->errors.first->text, "lies on the boundary, which is fixed"));
}

/* The handle ends where it has to be, in one step or in five, by grid position or index. */
static void handles_are_reached(void **state) {
  net_fixture *f = *state;
  static const char *const keys[] = {
      "{handles: [{vertex: [8, 8], to: [100 mm, 0 m, 300 mm]}]}",
      "{handles: [{vertex: [144, -1], to: [100 mm, 0 m, 300 mm]}]}",
      "{handles: [{vertex: [8, 8], to: [100 mm, 0 m, 300 mm], steps: 5}], solver: {fairness: 0.1}}",
      "{handles: [{vertex: [8, 8], to: [100 mm, 0 m, 300 mm]}], solver: {fairness: 0.1}}",
      "{constraints: [{kind: handle, vertex: [144, -1], to: [100 mm, 0 m, 300 mm]}]}",
  };
  lam_mesh mesh = saddle(f, 16);
  outcome first = {0};
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    outcome o = solve(f, &mesh, 16, (setup){"asymptotic", right, keys[i], NULL, NULL});
    assert_converged(&o, keys[i]);
    assert_near(lam_distance(o.net.mesh.vertices[8 * 17 + 8], lam_v3(.1, 0, .3)), 0, 1e-12);
    assert_below(measure(&o, "star_planarity"), 1e-12);
    if (i == 0) first = o;
    if (i == 1)
      assert_memory_equal(o.net.mesh.vertices, first.net.mesh.vertices, sizeof(lam_vec3) * 17 * 17);
    if (i == 2) assert_true(o.result.solution.iterations > first.result.solution.iterations);
  }
}

static void handles_that_are_not_there(void **state) {
  net_fixture *f = *state;
  static const char *const keys[] = {
      "{handles: [{vertex: [5, 0], to: [0, 0, 0]}]}",
      "{handles: [{vertex: [0, 5], to: [0, 0, 0]}]}",
      "{handles: [{vertex: [25, -1], to: [0, 0, 0]}]}",
      "{handles: [{vertex: [-1, -1], to: [0, 0, 0]}]}",
      "{handles: [{vertex: [-1, 3], to: [0, 0, 0]}]}",
  };
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    lam_mesh mesh = saddle(f, 4);
    solve(f, &mesh, 4, (setup){"asymptotic", right, keys[i], NULL, NULL});
    assert_int_equal(f->errors.count, 1);
    assert_non_null(strstr(f->errors.first->text, "does not exist"));
  }
}

/* Distance of x to the polyline through a boundary loop of the start. */
static double off_boundary(const outcome *o, lam_vec3 x) {
  double nearest = INFINITY;
  for (int l = 0; l < o->net.loop_count; l++)
    for (int i = 0; i < o->net.loops[l].count; i++) {
      const int *v = o->net.loops[l].vertices;
      lam_vec3 a = o->start.vertices[v[i]],
               d = lam_sub(o->start.vertices[v[(i + 1) % o->net.loops[l].count]], a);
      double t = lam_dot(lam_sub(x, a), d) / lam_dot(d, d);
      nearest = fmin(nearest, lam_distance(x, lam_along(a, fmin(fmax(t, 0), 1), d)));
    }
  return nearest;
}

/* fixed: every boundary vertex stays. glide: it stays on the boundary curve of the start, corners
 * stay, through several solves too. */
static void boundaries_are_held(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_obj(f->arena, "tests/cases/nets/16_anet_schwarzD_from_hypar_init.obj");
  lam_mesh bent = saddle(f, 12);
  static const struct {
    bool bent;
    const char *params, *keys;
    double tolerance;
  } rows[] = {
      {true, "{}", "{boundary: fixed, solver: {fairness: 0.1}}", 1e-14},
      {false, right, "{boundary: glide}", 1e-12},
      {false, right, "{boundary: glide, solver: {smooth: yes}}", 1e-12},
      {true, "{}",
       "{boundary: glide, handles: [{vertex: [84, -1], to: [0 m, 0 m, 50 mm], steps: 4}]}", 1e-12},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    outcome o = solve(f, rows[i].bent ? &bent : &mesh, 0,
                      (setup){"asymptotic", rows[i].params, rows[i].keys, NULL, NULL});
    assert_converged(&o, rows[i].keys);
    double moved = 0, unit = lam_net_mean_edge(&o.net, o.start.vertices);
    for (int v = 0; v < o.start.vertex_count; v++) {
      if (!o.net.boundary[v]) continue;
      double way = lam_distance(o.net.mesh.vertices[v], o.start.vertices[v]) / unit;
      if (o.net.ring_start[v + 1] - o.net.ring_start[v] == 2) assert_near(way, 0, 1e-14);
      moved = fmax(moved, way);
      assert_below(off_boundary(&o, o.net.mesh.vertices[v]) / unit, rows[i].tolerance);
    }
    if (i == 0)
      assert_near(moved, 0, 1e-14);
    else
      assert_true(moved > .01);
  }
}

static lam_vec3 lifted(double i, double j) { return lam_v3(i + 5.3, j + 4.4, .8); }

/* Nothing but a wish: a plane over a plane comes down on it straight, and is a plane as before. */
static void a_wish_alone_is_fulfilled(void **state) {
  net_fixture *f = *state;
  lam_mesh ground = net_grid(f->arena, 16, 16, net_plane), mesh = net_grid(f->arena, 5, 5, lifted);
  lam_trimesh reference = lam_mesh_triangles(f->arena, &ground);
  outcome o = solve(f, &mesh, 0, (setup){"free", "{}", "{}", &reference, NULL});
  assert_converged(&o, "a plane");
  for (int v = 0; v < 25; v++)
    assert_near(
        lam_distance(o.net.mesh.vertices[v], lam_v3(mesh.vertices[v].x, mesh.vertices[v].y, 0)), 0,
        1e-11);
}

/* Enneper's surface, in its own parameters over [-2, 2]^2, scaled and with its height changed by
 * bend x^2. */
static lam_trimesh reference_of(net_fixture *f, double scale, double bend) {
  lam_row row = {.head = lam_registry_find(&lam_surfaces, "enneper")};
  row.params = net_params(f, row.head->keys, row.head->params_size, "{}");
  lam_surface surface = lam_surface_make(f->arena, &row, &f->errors);
  lam_mesh mesh = lam_mesh_grid(f->arena, 61, 61, false, false);
  for (int i = 0; i < 61; i++)
    for (int j = 0; j < 61; j++) {
      lam_vec3 x =
          lam_surface_point(&surface, LAM_CHART_NATURAL, 0, (i - 30) / 15., (j - 30) / 15.);
      mesh.vertices[i * 61 + j] = lam_v3(scale * x.x, scale * x.y, scale * x.z + bend * x.x * x.x);
    }
  return lam_mesh_triangles(f->arena, &mesh);
}

static double farthest(const outcome *o, const lam_vec3 *positions, const lam_trimesh *reference) {
  lam_tree *tree = lam_tree_new(reference, NULL);
  double most = 0;
  for (int v = 0; v < o->net.mesh.vertex_count; v++) {
    lam_vec3 foot;
    int triangle;
    lam_tree_closest(tree, positions[v], &foot, &triangle);
    most = fmax(most, lam_distance(positions[v], foot));
  }
  lam_tree_free(tree);
  return most;
}

/* An asymptotic net near a mesh of triangles: on it when that is possible (a scaled minimal
 * surface, angles free); when it is not (right angles on a surface with H != 0), the constraints
 * hold exactly and the net stays as near as half the distance at the start. */
static void references_attract(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = saddle(f, 12);
  lam_trimesh scaled = reference_of(f, 1.02, 0), bent = reference_of(f, 1.02, .1);
  outcome o = solve(f, &mesh, 12, (setup){"asymptotic", "{}", "{}", &scaled, NULL});
  assert_converged(&o, "scaled");
  assert_true(farthest(&o, mesh.vertices, &scaled) > 5e-3);
  assert_below(farthest(&o, o.net.mesh.vertices, &scaled), 1e-12);
  assert_below(measure(&o, "star_planarity"), 1e-12);
  o = solve(f, &mesh, 12, (setup){"asymptotic", right, "{}", &bent, NULL});
  assert_converged(&o, "bent");
  assert_below(measure(&o, "star_planarity"), 1e-12);
  assert_near(measure(&o, "crossing_angle"), 90, 1e-9);
  assert_below(farthest(&o, o.net.mesh.vertices, &bent), .5 * farthest(&o, mesh.vertices, &bent));
}

static lam_vec3 twisted(double i, double j) { return lam_v3(i, j, i * j); }

/* A strip without inner vertices whose boundary is fixed: nothing can move, which is success only
 * if nothing has to. */
static void nothing_to_move(void **state) {
  net_fixture *f = *state;
  lam_mesh flat = net_grid(f->arena, 5, 2, net_plane), strip = net_grid(f->arena, 5, 2, twisted);
  outcome o = solve(f, &flat, 0, (setup){"planar-quads", "{}", "{boundary: fixed}", NULL, NULL});
  assert_converged(&o, "flat strip");
  o = solve(f, &strip, 0, (setup){"planar-quads", "{}", "{boundary: fixed}", NULL, NULL});
  assert_false(o.result.converged);
  assert_non_null(strstr(o.result.reason, "fixed"));
  assert_true(o.result.solution.residual > .1);
}

/* The middle of the monkey saddle has six neighbors: its star becomes planar, but it has no
 * crossing angle and is counted as left out. */
static void irregular_vertices_take_part(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_monkey(f, 6, 0);
  lam_mesh_perturb(&mesh, .01, 3);
  outcome o = solve(f, &mesh, 0, (setup){"asymptotic", right, "{}", NULL, NULL});
  assert_converged(&o, "monkey saddle");
  assert_int_equal(o.result.skipped, 1);
  assert_below(measure(&o, "star_planarity"), 1e-12);
  assert_near(measure(&o, "foldovers"), 0, 0);
  o = solve(f, &mesh, 0, (setup){"asymptotic", "{}", "{}", NULL, NULL});
  assert_int_equal(o.result.skipped, 0);
}

/* In millimeters or kilometers, the same steps and the same net; twice the same, the same bytes. */
static void solving_does_not_depend_on_the_unit(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = saddle(f, 8), large = saddle(f, 8);
  for (int v = 0; v < 81; v++) large.vertices[v] = lam_scale(large.vertices[v], 1024);
  setup s = {"asymptotic", right, "{solver: {fairness: 0.1}}", NULL, NULL};
  outcome a = solve(f, &mesh, 8, s), b = solve(f, &large, 8, s), again = solve(f, &mesh, 8, s);
  assert_converged(&a, "saddle");
  assert_int_equal(a.result.solution.iterations, b.result.solution.iterations);
  for (int v = 0; v < 81; v++)
    assert_near(lam_distance(lam_scale(a.net.mesh.vertices[v], 1024), b.net.mesh.vertices[v]), 0,
                1e-9);
  assert_memory_equal(a.net.mesh.vertices, again.net.mesh.vertices, sizeof(lam_vec3) * 81);
}

static void count_calls(void *context, const char *stage, double fraction, const char *detail) {
  assert_non_null(strstr(detail, "iteration"));
  assert_true(stage && fraction < 0); /* nobody knows how many are to come */
  ++*(int *)context;
}

static void limits_and_singular_starts(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = saddle(f, 8), point = net_grid(f->arena, 4, 4, net_plane);
  int calls = 0;
  lam_progress progress = {count_calls, &calls};
  outcome o = solve(f, &mesh, 8,
                    (setup){"asymptotic", right, "{solver: {iterations: 1}}", NULL, &progress});
  assert_false(o.result.converged);
  assert_int_equal(o.result.solution.iterations, 1);
  assert_int_equal(calls, 2);
  assert_non_null(strstr(o.result.reason, "limit"));
  point.vertices[5] = point.vertices[6]; /* an edge of length 0 */
  o = solve(f, &point, 0, (setup){"asymptotic", right, "{}", NULL, NULL});
  assert_false(o.result.converged);
  for (int v = 0; v < 16; v++) point.vertices[v] = lam_v3(1, 2, 3);
  solve(f, &point, 0, (setup){"asymptotic", right, "{}", NULL, NULL});
  assert_int_equal(f->errors.count, 1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(noisy_starts_converge),
      NET_TEST(smoothing_helps_planar_quads),
      NET_TEST(contradictions_end_with_a_reason),
      NET_TEST(handles_are_reached),
      NET_TEST(handles_that_are_not_there),
      NET_TEST(handles_on_a_fixed_boundary_are_refused),
      NET_TEST(boundaries_are_held),
      NET_TEST(a_wish_alone_is_fulfilled),
      NET_TEST(references_attract),
      NET_TEST(nothing_to_move),
      NET_TEST(irregular_vertices_take_part),
      NET_TEST(solving_does_not_depend_on_the_unit),
      NET_TEST(limits_and_singular_starts),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
