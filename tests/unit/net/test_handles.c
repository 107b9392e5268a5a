/* Handles: vertices by grid position, index or place, and whole sides carried onto curves. */
#include "mesh/net_sides.h"
#include "net/handles.h"
#include "net/optimize.h"
#include "net_fixture.h"

static lam_net_common *common_of(net_fixture *f, const char *keys) {
  return net_params(f, lam_net_common_keys, sizeof(lam_net_common), keys);
}

static lam_list resolved(net_fixture *f, const lam_net *net, lam_net_common *common) {
  return lam_handles_resolve(f->arena, common, net, net->mesh.vertices, (lam_location){0},
                             &f->errors);
}

static const lam_handle *handle(lam_list list, int i) { return (const lam_handle *)list.items + i; }
static lam_vec3 goal(lam_list list, int i) {
  const double *to = handle(list, i)->to;
  return lam_v3(to[0], to[1], to[2]);
}

/* A grid of 4 x 6 vertices: v0 are (i, 0), u1 (3, j), v1 (i, 5), u0 (0, j), in the direction of
 * growing i or j; grid positions count on refined nets too. */
static void sides_of_a_grid(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 6, net_plane);
  for (int fine = 0; fine < 2; fine++) {
    lam_net net = net_built(f, &mesh);
    int n = fine ? 7 : 4, m = fine ? 11 : 6;
    double h = fine ? .5 : 1;
    for (int side = 0; side < LAM_SIDE_COUNT; side++) {
      lam_polyline line;
      assert_true(lam_net_side(f->arena, &net, (lam_side)side, &line));
      bool along_v = side == LAM_SIDE_U0 || side == LAM_SIDE_U1;
      assert_int_equal(line.count, along_v ? m : n);
      assert_int_equal(line.family, along_v ? 1 : 0);
      for (int k = 0; k < line.count; k++) {
        lam_vec3 x = net.mesh.vertices[line.vertices[k]];
        lam_vec3 expected[] = {lam_v3(0, k * h, 0), lam_v3(3, k * h, 0), lam_v3(k * h, 0, 0),
                               lam_v3(k * h, 5, 0)};
        assert_near(lam_distance(x, expected[side]), 0, 1e-14);
      }
    }
    for (int i = -1; i <= n; i++)
      for (int j = -1; j <= m; j++) {
        int v = lam_net_grid_vertex(f->arena, &net, i, j);
        bool inside = i >= 0 && j >= 0 && i < n && j < m;
        assert_int_equal(v >= 0, inside);
        if (inside)
          assert_near(lam_distance(net.mesh.vertices[v], lam_v3(i * h, j * h, 0)), 0, 1e-14);
      }
    mesh = lam_net_four_point(f->arena, &net);
  }
}

/* A tube closed along u: v0 is the ring with vertex 0, v1 the other; no u0. A torus and the monkey
 * saddle (twelve corners) have no sides. */
static void sides_of_other_nets(void **state) {
  net_fixture *f = *state;
  lam_mesh tube = net_tube(f->arena, 8, 5), torus = net_torus(f->arena, 5, 6, 3, 1),
           monkey = net_monkey(f, 3, 0);
  lam_net net = net_built(f, &tube);
  lam_polyline line;
  for (int last = 0; last < 2; last++) {
    assert_true(lam_net_side(f->arena, &net, last ? LAM_SIDE_V1 : LAM_SIDE_V0, &line));
    assert_int_equal(line.count, 8);
    assert_true(line.closed);
    for (int k = 0; k < 8; k++) assert_int_equal(line.vertices[k] % 5, last ? 4 : 0);
  }
  assert_false(lam_net_side(f->arena, &net, LAM_SIDE_U0, &line));
  net = net_built(f, &torus);
  assert_false(lam_net_side(f->arena, &net, LAM_SIDE_V0, &line));
  net = net_built(f, &monkey);
  assert_false(lam_net_side(f->arena, &net, LAM_SIDE_V0, &line));
}

/* One vertex, named in four ways, moved in two. */
static void a_vertex_is_named_in_many_ways(void **state) {
  net_fixture *f = *state;
  static const char *const keys[] = {
      "{grid: [3, 5], handles: [{vertex: [2, 3], to: [1 m, 2 m, 3 m]}]}",
      "{grid: [3, 5], handles: [{vertex: 15, to: [1 m, 2 m, 3 m]}]}",
      "{grid: [3, 5], handles: [{vertex: [15], to: [1 m, 2 m, 3 m]}]}",
      "{grid: [3, 5], handles: [{at: [210 cm, 2.7 m, 40 cm], to: [1 m, 2 m, 3 m]}]}",
      "{grid: [3, 5], handles: [{vertex: [2, 3], by: [-1 m, -1 m, 3 m], steps: 4}]}",
  };
  lam_mesh mesh = net_grid(f->arena, 4, 6, net_plane);
  lam_net net = net_built(f, &mesh);
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    lam_net_common *common = common_of(f, keys[i]);
    lam_handles_check(common, (lam_location){0}, &f->errors);
    lam_list list = resolved(f, &net, common);
    net_no_errors(f, keys[i]);
    assert_int_equal(list.count, 1);
    assert_int_equal(handle(list, 0)->vertex[0], 15);
    assert_near(lam_distance(goal(list, 0), lam_v3(1, 2, 3)), 0, 1e-15);
    assert_int_equal(handle(list, 0)->steps, i == 4 ? 4 : 1);
  }
  /* closed around u: position [i, j] is index 5 i + j */
  lam_mesh tube = net_tube(f->arena, 8, 5);
  net = net_built(f, &tube);
  lam_list list = resolved(
      f, &net, common_of(f, "{grid: [8, 4], handles: [{vertex: [6, 3], by: [0, 0, 1 m]}]}"));
  net_no_errors(f, "tube");
  assert_int_equal(handle(list, 0)->vertex[0], 33);
}

/* A side of six vertices at distance 1 onto a polyline of lengths 3 and 4: shares k/5 of 7. Onto a
 * quadratic B-spline of three points, which is the Bezier curve (0, 0), (1, 1), (2, 0), y = x -
 * x^2/2: on the curve, at equal lengths. */
static void sides_go_to_curves(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 6, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_list list = resolved(
      f, &net,
      common_of(
          f,
          "{handles: [{side: u0, to: [0, 0, 0, 0, 3 m, 0, 0, 3 m, 4 m], degree: 1, steps: 3}]}"));
  net_no_errors(f, "polyline");
  assert_int_equal(list.count, 6);
  for (int k = 0; k < 6; k++) {
    double s = 7. * k / 5;
    assert_int_equal(handle(list, k)->vertex[0], k);
    assert_int_equal(handle(list, k)->steps, 3);
    assert_near(lam_distance(goal(list, k), lam_v3(0, fmin(s, 3), fmax(s - 3, 0))), 0, 1e-12);
  }
  list = resolved(f, &net,
                  common_of(f, "{handles: [{side: u1, to: [0, 0, 0, 1 m, 1 m, 0, 2 m, 0, 0]}]}"));
  net_no_errors(f, "spline");
  assert_int_equal(list.count, 6);
  double arc[6];
  for (int k = 0; k < 6; k++) {
    lam_vec3 x = goal(list, k);
    assert_int_equal(handle(list, k)->vertex[0], 18 + k);
    assert_near(x.y, x.x - x.x * x.x / 2, 1e-14);
    double t = 1 - x.x; /* length from the top: (t sqrt(1 + t^2) + asinh t) / 2 */
    arc[k] = -(t * sqrt(1 + t * t) + asinh(t)) / 2;
  }
  for (int k = 1; k < 6; k++) assert_near(arc[k] - arc[k - 1], (sqrt(2) + asinh(1)) / 5, 1e-6);
  list = resolved(f, &net, common_of(f, "{handles: [{side: v1, by: [0, 0, 2 m]}]}"));
  assert_int_equal(list.count, 4);
  for (int k = 0; k < 4; k++) assert_near(lam_distance(goal(list, k), lam_v3(k, 5, 2)), 0, 0);
}

static void wrong_handles_are_explained(void **state) {
  net_fixture *f = *state;
  static const struct {
    const char *keys, *why;
  } rows[] = {
      {"{handles: [{to: [0, 0, 0]}]}", "none of vertex, at and side"},
      {"{handles: [{steps: 2}]}", "none of vertex, at and side"},
      {"{handles: [{vertex: 3, at: [0, 0, 0], to: [0, 0, 0]}]}", "several of vertex, at and side"},
      {"{handles: [{vertex: 3}]}", "neither to nor by"},
      {"{handles: [{vertex: 3, to: [0, 0, 0], by: [0, 0, 0]}]}", "both to and by"},
      {"{handles: [{vertex: 3, to: [0, 0]}]}", "three numbers"},
      {"{handles: [{vertex: [1, 2, 3], to: [0, 0, 0]}]}", "more than two numbers"},
      {"{handles: [{side: u0, to: [0, 0, 0]}]}", "at least two points"},
      {"{handles: [{side: u0, to: [0, 0, 0, 1 m, 0, 0, 0]}]}", "at least two points"},
      {"{handles: [{vertex: 24, to: [0, 0, 0]}]}", "index from 0 to 23"},
      {"{handles: [{vertex: [4, 0], to: [0, 0, 0]}]}", "does not exist"},
      {"{boundary: fixed, handles: [{side: u0, by: [0, 0, 1 m]}]}", "which is fixed"},
  };
  lam_mesh mesh = net_grid(f->arena, 4, 6, net_plane);
  lam_net net = net_built(f, &mesh);
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_net_common *common = common_of(f, rows[i].keys);
    f->errors = (lam_errors){.arena = f->arena};
    lam_handles_check(common, (lam_location){0}, &f->errors);
    if (!f->errors.count) resolved(f, &net, common);
    assert_true(f->errors.count > 0);
    if (!strstr(f->errors.first->text, rows[i].why))
      fail_msg("\"%s\" does not say \"%s\"", f->errors.first->text, rows[i].why);
    f->errors = (lam_errors){.arena = f->arena};
  }
  lam_mesh tube = net_tube(f->arena, 8, 5), torus = net_torus(f->arena, 5, 6, 3, 1);
  net = net_built(f, &tube);
  resolved(f, &net, common_of(f, "{handles: [{side: v0, to: [0, 0, 0, 1 m, 0, 0]}]}"));
  assert_non_null(strstr(f->errors.first->text, "is closed"));
  f->errors = (lam_errors){.arena = f->arena};
  net = net_built(f, &torus);
  resolved(f, &net, common_of(f, "{handles: [{side: v0, by: [0, 0, 0]}]}"));
  assert_non_null(strstr(f->errors.first->text, "no side v0"));
}

static lam_vec3 bowl(double i, double j) { return lam_v3(i, j, (i * i + j * j) / 20); }

/* A net of planar quads follows one side that is bent onto an arch in three steps: the side ends on
 * the curve, and the faces are planar. */
static void a_net_follows_its_side(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 9, 9, bowl);
  lam_net net = net_built(f, &mesh);
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, "planar-quads");
  lam_net_common *common =
      common_of(f, "{handles: [{side: v0, to: [0, 0, 1 m, 4 m, 0, 0, 8 m, 0, 3 m], steps: 3}]}");
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, "{}"),
                     .common = common};
  lam_net_result result;
  assert_true(lam_net_optimize(f->arena, &job, &net, &f->errors, &result));
  net_no_errors(f, "planar quads");
  if (!result.converged) fail_msg("%s", result.reason);
  for (int i = 0; i < 9; i++) { /* the parabola with these control points: x = 8t */
    lam_vec3 x = net.mesh.vertices[9 * i];
    assert_near(x.y, 0, 1e-9);
    double t = x.x / 8;
    assert_near(x.z, (1 - t) * (1 - t) + 3 * t * t, 1e-9);
  }
  assert_below(lam_net_measure_one(f->arena, &net, net.mesh.vertices, "face_planarity").max, 1e-11);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(sides_of_a_grid),
      NET_TEST(sides_of_other_nets),
      NET_TEST(a_vertex_is_named_in_many_ways),
      NET_TEST(sides_go_to_curves),
      NET_TEST(wrong_handles_are_explained),
      NET_TEST(a_net_follows_its_side),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
