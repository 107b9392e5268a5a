/* Molding surfaces and isogonal molding nets: what their names promise, from positions alone. */
#include "mesh/offset.h"
#include "net/optimize.h"
#include "net_fixture.h"

static lam_surface surface_of(net_fixture *f, const char *keys) {
  const lam_row_head *head = lam_registry_find(&lam_surfaces, "molding");
  lam_row row = {.head = head, .params = net_params(f, head->keys, head->params_size, keys)};
  return lam_surface_make(f->arena, &row, &f->errors);
}

/* ---- the surface ---- */

/* Profiles are congruent and lie in planes square to the trajectory: distances within a profile do
 * not depend on u, and the paths of all points are parallel. */
static void profiles_are_congruent(void **state) {
  net_fixture *f = *state;
  lam_surface s = surface_of(f, "{}");
  net_no_errors(f, "molding");
  for (int i = 0; i <= 20; i++) {
    lam_jet low, high;
    for (int j = 0; j < 5; j++) {
      double u = i / 20., v = .2 * j, w = .2 * j + .17;
      lam_vec3 first = lam_sub(lam_surface_point(&s, LAM_CHART_PRINCIPAL, 0, 0, w),
                               lam_surface_point(&s, LAM_CHART_PRINCIPAL, 0, 0, v));
      lam_surface_eval(&s, u, v, &low);
      lam_surface_eval(&s, u, w, &high);
      lam_vec3 d = lam_sub(high.x, low.x);
      assert_near(lam_length(d), lam_length(first), 1e-13);
      assert_near(d.z, first.z, 1e-13);
      assert_near(lam_dot(d, lam_unit(low.u)), 0, 1e-13);
      assert_near(lam_length(lam_cross(lam_unit(low.u), lam_unit(high.u))), 0, 1e-13);
      /* the path is level and square to the profile: F = M = 0 */
      lam_curvature c = lam_jet_curvature(&low);
      assert_near(c.F, 0, 1e-12);
      assert_near(c.M, 0, 1e-12);
    }
  }
}

/* The profile's own curvature is a principal curvature: a Bezier half-circle-like arch on a
 * straight trajectory is a cylinder. */
static void a_straight_trajectory_gives_a_cylinder(void **state) {
  net_fixture *f = *state;
  lam_surface s = surface_of(f, "{trajectory: [0, 0, 500, 0, 900, 0], unit: cm}");
  net_no_errors(f, "molding");
  for (int i = 0; i <= 10; i++)
    for (int j = 0; j <= 10; j++) {
      lam_jet jet;
      lam_surface_eval(&s, .1 * i, .1 * j, &jet);
      assert_near(lam_jet_curvature(&jet).K, 0, 1e-12);
      assert_near(jet.u.y, 0, 1e-15);
    }
  assert_near(lam_surface_point(&s, LAM_CHART_NATURAL, 0, 1, 0).x, 9, 1e-14);
  assert_near(lam_surface_point(&s, LAM_CHART_NATURAL, 0, 1, 0).y, -.02, 1e-15);
}

static void wrong_curves_are_refused(void **state) {
  net_fixture *f = *state;
  static const char *const rows[][2] = {
      {"{trajectory: [0, 0, 1]}", "3 numbers"},
      {"{profile: [0, 0]}", "2 numbers"},
      {"{trajectory: [0, 0, 0, 0, 1, 1]}", "points 1 and 2 are the same"},
      {"{profile: [-9, 0, -9, 3, 9, 3, 9, 0]}", "of the trajectory, whose radius"},
      {"{trajectory: [0, 0, 1, 0, 0, 0]}", "of the trajectory, whose radius"},
      {"{profile: [0, 0, 1, 0, 0, 0]}", "stands still"},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    surface_of(f, rows[i][0]);
    if (f->errors.count != 1 || !strstr(f->errors.first->text, rows[i][1]))
      fail_msg("%s: %d errors, %s", rows[i][0], f->errors.count,
               f->errors.count ? f->errors.first->text : "");
  }
}

/* From principal lines, a circular and a conical net are near. */
static void nets_on_a_molding_surface(void **state) {
  net_fixture *f = *state;
  static const char *const kinds[] = {"circular", "conical"};
  for (int i = 0; i < 2; i++) {
    lam_mesh mesh = net_sampled(f, "molding", "{}", LAM_CHART_PRINCIPAL, 24, 12, 0);
    lam_net net = net_built(f, &mesh);
    const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, kinds[i]);
    lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, "{grid: [24, 12]}");
    lam_net_job job = {.kind = kind, .common = common};
    lam_net_result result;
    assert_true(lam_net_optimize(f->arena, &job, &net, &f->errors, &result));
    if (!result.converged) fail_msg("%s: %s", kinds[i], result.reason);
  }
}

/* ---- the net ---- */

typedef struct molding {
  lam_net net;
  int n, m;
} molding;

static molding net_of(net_fixture *f, int n, int m, const char *keys) {
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, "isogonal-molding");
  void *params = net_params(f, kind->head.keys, kind->head.params_size, keys);
  lam_mesh mesh;
  molding result = {.n = n, .m = m};
  const int grid[2] = {n, m};
  kind->start(f->arena, params, grid, (lam_location){0}, &f->errors, &mesh);
  net_no_errors(f, keys);
  result.net = net_built(f, &mesh);
  return result;
}

static double worst(net_fixture *f, const molding *s, const char *name) {
  return lam_net_measure_one(f->arena, &s->net, s->net.mesh.vertices, name).max;
}

static const char even[] = "{turn: 120 deg, edges: [1 m, 2 m, 1.5 m]}";
static const char s_shaped[] = "{turn: [60 deg, -60 deg], edges: [1 m]}";
static const char uneven[] = "{turn: [60 deg, 70 deg], edges: [1 m]}";

/* Planar and conical whatever the turns; circular with one turn of one sign. */
static void planar_conical_circular(void **state) {
  net_fixture *f = *state;
  static const char *const rows[] = {even, s_shaped, uneven};
  for (int i = 0; i < 3; i++) {
    molding s = net_of(f, 12, 8, rows[i]);
    assert_below(worst(f, &s, "face_planarity"), 1e-14);
    assert_below(worst(f, &s, "conicality"), 1e-9);
    double circularity = worst(f, &s, "circularity");
    if (i == 0) assert_below(circularity, 1e-13);
    if (i == 1) assert_below(.01, circularity);
    if (i == 2) assert_true(circularity > 1e-3 && circularity < .02);
  }
}

/* Lengths of the six connections among a vertex and its neighbors decide about the shape of a node;
 * along the trajectory nodes are congruent up to the lengths of its edges: the angles among the
 * four edges agree. Across it they differ. */
static void node_angles(const molding *s, int i, int j, double angles[6]) {
  const lam_star *star = &s->net.stars[s->net.star_of_vertex[i * (s->m + 1) + j]];
  const lam_vec3 *x = s->net.mesh.vertices;
  for (int a = 0, count = 0; a < 4; a++)
    for (int b = a + 1; b < 4; b++)
      angles[count++] = lam_angle(lam_sub(x[star->neighbor[a]], x[star->center]),
                                  lam_sub(x[star->neighbor[b]], x[star->center]));
}

static void nodes_are_congruent_along_the_trajectory(void **state) {
  net_fixture *f = *state;
  molding s = net_of(f, 12, 8, even);
  double across = 0;
  for (int j = 1; j < s.m; j++)
    for (int i = 1; i < s.n; i++) {
      double first[6], here[6], beside[6];
      node_angles(&s, 1, j, first);
      node_angles(&s, i, j, here);
      for (int k = 0; k < 6; k++) assert_near(here[k], first[k], 1e-13);
      if (j == 1) continue;
      node_angles(&s, 1, 1, beside);
      for (int k = 0; k < 6; k++) across = fmax(across, fabs(beside[k] - here[k]));
    }
  assert_below(.1, across);
}

/* Faces are isosceles trapezoids whose parallel sides follow the trajectory; the trajectory has the
 * lengths asked for, and turns by 120 / 12 degrees at every vertex. */
static void faces_are_isosceles_trapezoids(void **state) {
  net_fixture *f = *state;
  molding s = net_of(f, 12, 4, even); /* as many points as the default profile lists: its corners */
  const lam_vec3 *x = s.net.mesh.vertices;
  assert_near(lam_distance(x[0], lam_v3(0, -2 / cos(5 * net_pi / 180), 0)), 0, 1e-14);
  assert_near(lam_distance(x[2], lam_v3(0, 0, 2.4)), 0, 1e-14);
  for (int i = 0; i < s.n; i++) {
    for (int j = 0; j < s.m; j++) {
      lam_vec3 a = x[i * 5 + j], b = x[i * 5 + 5 + j], c = x[i * 5 + 6 + j], d = x[i * 5 + 1 + j];
      assert_near(lam_distance(b, c), lam_distance(a, d), 1e-13);
      assert_near(lam_length(lam_cross(lam_unit(lam_sub(b, a)), lam_unit(lam_sub(c, d)))), 0,
                  1e-13);
    }
    lam_vec3 edge = lam_sub(x[i * 5 + 7], x[i * 5 + 2]); /* a = 0: the trajectory itself */
    double at = 2. * i / 11, length = at < 1 ? 1 + at : 2 - .5 * (at - 1);
    assert_near(lam_length(edge), length, 1e-13);
    assert_near(atan2(edge.y, edge.x), (5 + 10 * i) * net_pi / 180, 1e-13);
  }
}

/* Both kinds of offsets at once (thesis 3.5.4). */
static void offsets_of_both_kinds(void **state) {
  net_fixture *f = *state;
  molding s = net_of(f, 12, 8, even);
  const lam_vec3 *x = s.net.mesh.vertices;
  lam_vec3 *directions = LAM_NEW(f->arena, lam_vec3, s.net.mesh.vertex_count);
  assert_below(lam_net_mirrored_normals(f->arena, &s.net, x, directions), 1e-12);
  for (int e = 0; e < s.net.edge_count; e++)
    assert_below(lam_net_edge_twist(&s.net, x, directions, e), 1e-12);
  assert_below(lam_net_cone_axes(f->arena, &s.net, x, directions), 1e-13);
  for (int e = 0; e < s.net.edge_count; e++) {
    const int *v = s.net.edges[e].vertex;
    if (!s.net.boundary[v[0]] && !s.net.boundary[v[1]])
      assert_below(lam_net_edge_twist(&s.net, x, directions, e), 1e-11);
  }
}

/* Through the solver: nothing is left to do. */
static void nothing_to_solve(void **state) {
  net_fixture *f = *state;
  static const char *const rows[] = {even, s_shaped, uneven};
  for (int i = 0; i < 3; i++) {
    molding s = net_of(f, 12, 8, rows[i]);
    const lam_net_kind *kind =
        (const lam_net_kind *)lam_registry_find(&lam_nets, "isogonal-molding");
    lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common, "{grid: [12, 8]}");
    lam_net_job job = {.kind = kind,
                       .params = net_params(f, kind->head.keys, kind->head.params_size, rows[i]),
                       .common = common};
    lam_net_result result;
    assert_true(lam_net_optimize(f->arena, &job, &s.net, &f->errors, &result));
    assert_true(result.converged);
    assert_int_equal(result.solution.iterations, 0);
  }
}

static void wrong_nets_are_refused(void **state) {
  net_fixture *f = *state;
  static const char *const rows[][2] = {
      {"{turn: [10 deg, 10 deg, 10 deg, 10 deg, 10 deg]}", "5 sections for 12 cells"},
      {"{turn: 1200 deg}", "100 deg at every vertex"},
      {"{turn: []}", "0 sections"},
      {"{edges: []}", "none given"},
      {"{edges: [1 m, -1 m]}", "length 2 is -1"},
      {"{profile: [1 m, 1 m, 1 m]}", "3 numbers"},
      {"{profile: [1 m, 1 m, 1 m, 1 m]}", "points 1 and 2 are the same"},
      {"{turn: 170 deg, edges: [0.1 m]}", "turns around a center"},
  };
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, "isogonal-molding");
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    f->errors = (lam_errors){.arena = f->arena};
    void *params = net_params(f, kind->head.keys, kind->head.params_size, rows[i][0]);
    lam_mesh mesh;
    bool made =
        kind->start(f->arena, params, (int[2]){12, 8}, (lam_location){0}, &f->errors, &mesh);
    if (made || f->errors.count < 1 || !strstr(f->errors.first->text, rows[i][1]))
      fail_msg("%s: %s", rows[i][0], f->errors.count ? f->errors.first->text : "accepted");
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(profiles_are_congruent),
      NET_TEST(a_straight_trajectory_gives_a_cylinder),
      NET_TEST(wrong_curves_are_refused),
      NET_TEST(nets_on_a_molding_surface),
      NET_TEST(planar_conical_circular),
      NET_TEST(nodes_are_congruent_along_the_trajectory),
      NET_TEST(faces_are_isosceles_trapezoids),
      NET_TEST(offsets_of_both_kinds),
      NET_TEST(nothing_to_solve),
      NET_TEST(wrong_nets_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
