/* Every constraint of the registry, tested because it is listed: its Jacobian against differences,
 * on many nets. */
#include "core/solid/triangles.h"
#include "solve_fixture.h"

enum { most_unknowns = 256, most_rows = 16, most_elements = 60, net_count = 6 };

static const char *const net_names[net_count] = {"open grid",  "torus",         "tube",
                                                 "round cube", "monkey saddle", "oculus"};

static lam_mesh mesh_of(net_fixture *f, int i) {
  switch (i) {
  case 0:
    return net_grid(f->arena, 5, 6, net_saddle);
  case 1:
    return net_torus(f->arena, 6, 5, 3, 1);
  case 2:
    return net_tube(f->arena, 6, 4);
  case 3:
    return net_round_cube(f);
  case 4:
    return net_monkey(f, 3, 0);
  default:
    return net_monkey(f, 3, 1);
  }
}

typedef struct subject {
  lam_net net;
  lam_problem *problem;
  lam_trimesh reference;
} subject;

/* A net with a mean edge of 1 and vertices displaced by up to a seventh of it, and a problem with
 * one constraint on it.
 */
static subject subject_of(net_fixture *f, int net, const lam_constraint_kind *kind,
                          const char *keys) {
  lam_mesh mesh = mesh_of(f, net);
  subject s = {.net = net_built(f, &mesh)};
  double unit = lam_net_mean_edge(&s.net, s.net.mesh.vertices);
  for (int v = 0; v < mesh.vertex_count; v++)
    s.net.mesh.vertices[v] = lam_scale(s.net.mesh.vertices[v], 1 / unit);
  s.reference = lam_mesh_triangles(f->arena, &s.net.mesh);
  lam_mesh_perturb(&s.net.mesh, 1. / 7, 1 + net);
  s.problem = lam_problem_new(f->arena, mesh.vertex_count, s.net.mesh.vertices);
  lam_tree *tree = lam_tree_new(&s.reference, NULL);
  lam_arena_defer(f->arena, lam_tree_free, tree);
  lam_trimesh *reference = LAM_NEW(f->arena, lam_trimesh, 1);
  *reference = s.reference;
  lam_scope scope = {.problem = s.problem,
                     .net = &s.net,
                     .unit = unit,
                     .reference = tree,
                     .reference_mesh = reference,
                     .errors = &f->errors};
  void *params = net_params(f, kind->head.keys, kind->head.params_size, keys);
  kind->add(&scope, params, 1, (lam_location){0});
  net_no_errors(f, kind->head.name);
  return s;
}

static void displace(net_fixture *f, lam_problem *problem, double by) {
  for (int i = 0; i < problem->offset[problem->node_count]; i++)
    problem->x[i] += by * net_random(f);
}

static void follow(const lam_problem *problem) {
  for (int b = 0; b < problem->block_count; b++) {
    lam_block *block = &problem->blocks[b];
    if (block->update) block->update(block, problem->x, problem->offset, block->context);
  }
}

/* dr/dx_i by central differences with steps h, 2h, 3h, extrapolated: the error is of order h^6. */
static void differences(const lam_block *block, int n, double *x, const double *p, int i,
                        double *slope) {
  static const double weight[] = {1.5, -.6, .1}, h = 2e-3;
  double right[most_rows], left[most_rows], at = x[i];
  for (int k = 0; k < block->rows; k++) slope[k] = 0;
  for (int step = 1; step <= 3; step++) {
    x[i] = at + step * h;
    block->kernel(n, x, p, right, NULL);
    x[i] = at - step * h;
    block->kernel(n, x, p, left, NULL);
    for (int k = 0; k < block->rows; k++)
      slope[k] += weight[step - 1] * (right[k] - left[k]) / (2 * step * h);
  }
  x[i] = at;
}

static void check_element(net_fixture *f, const subject *s, const lam_block *block, int element,
                          const char *where) {
  int at[most_unknowns], n = element_unknowns(s->problem, block, element, at);
  double x[most_unknowns], r[most_rows], same[most_rows], slope[most_rows],
      J[most_rows * most_unknowns];
  assert_true(n <= most_unknowns && block->rows <= most_rows);
  const double *p = element_params(block, element);
  for (int i = 0; i < n; i++) x[i] = s->problem->x[at[i]];
  for (int i = 0; i < block->rows * n; i++)
    J[i] = 1e30 * net_random(f); /* a kernel writes every entry */
  block->kernel(n, x, p, r, J);
  block->kernel(n, x, p, same, NULL);
  assert_memory_equal(r, same, sizeof(double) * (size_t)block->rows);
  double size[most_rows] = {0};
  for (int k = 0; k < block->rows; k++) {
    for (int i = 0; i < n; i++) size[k] = fmax(size[k], fabs(J[k * n + i]));
    assert_true(isfinite(r[k]) && size[k] > 1e-3 && size[k] < 1e3);
  }
  for (int i = 0; i < n; i++) {
    differences(block, n, x, p, i, slope);
    for (int k = 0; k < block->rows; k++)
      if (!(fabs(J[k * n + i] - slope[k]) <= 1e-7 * size[k]))
        fail_msg("%s on %s, element %d, dr%d/dx%d: %.15g, by differences %.15g", block->name, where,
                 element, k, i, J[k * n + i], slope[k]);
  }
}

/* A block that calls itself linear: the Jacobian is the same anywhere and for any parameters, and
 * r(x + d) = r(x) + J d. */
static void check_linear(net_fixture *f, const subject *s, const lam_block *block) {
  int at[most_unknowns], n = element_unknowns(s->problem, block, 0, at);
  double x[most_unknowns], d[most_unknowns], r[most_rows], moved[most_rows], params[64];
  double J[most_rows * most_unknowns], other[most_rows * most_unknowns];
  assert_true(block->param_count <= 64);
  for (int i = 0; i < n; i++) x[i] = s->problem->x[at[i]];
  block->kernel(n, x, element_params(block, 0), r, J);
  for (int i = 0; i < n; i++) x[i] += d[i] = 10 * net_random(f);
  block->kernel(n, x, element_params(block, 0), moved, other);
  assert_memory_equal(J, other, sizeof(double) * (size_t)(block->rows * n));
  for (int k = 0; k < block->rows; k++) {
    for (int i = 0; i < n; i++) r[k] += J[k * n + i] * d[i];
    assert_near(moved[k], r[k], 1e-12);
  }
  for (int i = 0; i < block->param_count; i++) params[i] = 10 * net_random(f);
  block->kernel(n, x, params, moved, other);
  assert_memory_equal(J, other, sizeof(double) * (size_t)(block->rows * n));
}

static int check_kind(net_fixture *f, const lam_constraint_kind *kind, const char *keys) {
  int blocks = 0;
  for (int net = 0; net < net_count; net++) {
    subject s = subject_of(f, net, kind, keys);
    blocks += s.problem->block_count;
    for (int trial = 0; trial < 2; trial++) {
      follow(s.problem);
      displace(f, s.problem, .1);
      for (int b = 0; b < s.problem->block_count; b++) {
        const lam_block *block = &s.problem->blocks[b];
        int stride = 1 + block->count / most_elements;
        for (int e = 0; e < block->count; e += stride)
          check_element(f, &s, block, e, net_names[net]);
        if (block->linear) check_linear(f, &s, block);
      }
    }
  }
  return blocks;
}

static void every_jacobian_is_the_derivative(void **state) {
  net_fixture *f = *state;
  for (int i = 0; i < lam_constraints.count; i++) {
    const lam_constraint_kind *kind = (const lam_constraint_kind *)lam_constraints.rows[i];
    if (check_kind(f, kind, "{}") == 0) fail_msg("%s adds nothing to any net", kind->head.name);
  }
}

static void jacobians_with_other_parameters(void **state) {
  net_fixture *f = *state;
  check_kind(f, &lam_con_angle, "{angle: 35 deg}");
  check_kind(f, &lam_con_angle, "{angle: 70 deg, tangents: circle}");
  check_kind(f, &lam_con_orthogonal, "{tangents: circle, border: yes}");
  check_kind(f, &lam_con_spherical_star, "{radius: 3 m}");
  check_kind(f, &lam_con_spherical_star, "{radius: -20 m}");
  check_kind(f, &lam_con_spherical_star, "{spheres: common}");
  check_kind(f, &lam_con_spherical_star, "{radius: -20 m, border: yes}");
  check_kind(f, &lam_con_spherical_star, "{spheres: common, border: yes}");
  check_kind(f, &lam_con_edge_length, "{length: 700 mm}");
  check_kind(f, &lam_con_edge_length, "{boundary: yes}");
  check_kind(f, &lam_con_fairness, "{of: displacements}");
  check_kind(f, &lam_con_geodesic_parallel, "{geodesics: 1, border: no}");
  check_kind(f, &lam_con_equal_angles, "{border: yes}");
  check_kind(f, &lam_con_equal_edges, "{family: 1, lines: middle}");
  check_kind(f, &lam_con_jacobi, "{geodesics: 1}");
  check_kind(f, &lam_con_strip_widths, "{widths: proportional}");
  check_kind(f, &lam_con_strip_widths, "{widths: constant, geodesics: 1}");
  check_kind(f, &lam_con_handle, "{vertex: [3, -1], to: [1 m, 2 m, 3 m]}");
}

/* Each constraint alone on every net: sparse and dense normal equations agree. The boundary of the
 * tube is a loop without corners: boundary-length lists its first vertex twice. */
static void every_constraint_assembles(void **state) {
  net_fixture *f = *state;
  bool repeated = false;
  for (int i = 0; i < lam_constraints.count; i++)
    for (int net = 0; net < net_count; net++) {
      const lam_constraint_kind *kind = (const lam_constraint_kind *)lam_constraints.rows[i];
      subject s = subject_of(f, net, kind, "{}");
      if (s.problem->block_count == 0) continue;
      follow(s.problem);
      displace(f, s.problem, .1);
      const lam_block *block = &s.problem->blocks[0];
      if (block->nodes[0] == block->nodes[block->arity - 1] && block->arity > 1) repeated = true;
      assert_system(f->arena, s.problem, s.problem->x, (lam_weights){1, 2, .5});
    }
  assert_true(repeated);
}

/* The number of elements, counted by hand. Grid 5 x 6: 12 inner vertices, 20 faces, 49 edges, 18 of
 * them on the boundary, 4 sides, triples 6 * 3 + 5 * 4 on 11 lines. Monkey saddle of 3 rings: 6
 * sectors of 9 faces, 1 + 6 * 12 vertices. */
static void elements_are_complete(void **state) {
  net_fixture *f = *state;
  static const struct {
    const lam_constraint_kind *kind;
    const char *keys;
    int net, elements, unknowns;
  } rows[] = {
      {&lam_con_planar_star, "{}", 0, 12, 15},
      {&lam_con_planar_face, "{}", 0, 20, 12},
      {&lam_con_orthogonal, "{}", 0, 12, 15},
      {&lam_con_edge_length, "{}", 0, 49, 6},
      {&lam_con_edge_length, "{boundary: yes}", 0, 18, 6},
      {&lam_con_edge_length, "{boundary: yes}", 1, 0, 6},
      {&lam_con_boundary_length, "{}", 0, 4, 15},
      {&lam_con_boundary_length, "{}", 2, 2, 21},
      {&lam_con_boundary_length, "{}", 1, 0, 0},
      {&lam_con_fairness, "{}", 0, 38, 9},
      {&lam_con_fairness, "{}", 1, 60, 9},
      {&lam_con_closeness, "{}", 0, 30, 3},
      {&lam_con_proximity, "{}", 0, 30, 3},
      {&lam_con_glide, "{}", 0, 14, 3},
      {&lam_con_glide, "{}", 2, 12, 3},
      {&lam_con_opposite_edges, "{}", 0, 20, 12},
      {&lam_con_spherical_star, "{}", 0, 12, 15},
      {&lam_con_spherical_star, "{radius: 9 m}", 3, 18, 15},
      {&lam_con_spherical_star, "{spheres: common}", 0, 12, 16},
      {&lam_con_spherical_star, "{border: yes}", 0, 12, 15},
      {&lam_con_spherical_star, "{radius: 9 m, border: yes}", 0, 12 + 14, 15},
      {&lam_con_spherical_star, "{spheres: common, border: yes}", 0, 12 + 14, 16},
      {&lam_con_planar_star, "{}", 3, 26, 15},
      {&lam_con_orthogonal, "{}", 3, 18, 15},
      {&lam_con_planar_face, "{}", 4, 54, 12},
      {&lam_con_planar_star, "{}", 4, 37, 15},
      {&lam_con_orthogonal, "{}", 4, 36, 15},
      {&lam_con_geodesic_parallel, "{}", 0, 12 + 8, 15},
      {&lam_con_geodesic_parallel, "{geodesics: 1}", 0, 12 + 6, 15},
      {&lam_con_geodesic_parallel, "{border: no}", 0, 12, 15},
      {&lam_con_geodesic_parallel, "{}", 2, 12, 15},
      {&lam_con_opposite_angles, "{}", 0, 12, 15},
      {&lam_con_equal_angles, "{border: yes}", 0, 12 + 14, 15},
      {&lam_con_equal_edges, "{}", 0, 18, 12},
      {&lam_con_equal_edges, "{family: 1}", 0, 20, 12},
      {&lam_con_equal_edges, "{lines: middle}", 0, 3, 12},
      {&lam_con_equal_edges, "{}", 2, 20, 12},
      {&lam_con_jacobi, "{}", 0, 15, 18},
      {&lam_con_jacobi, "{geodesics: 1}", 0, 16, 18},
      {&lam_con_jacobi, "{}", 2, 18, 18},
      {&lam_con_strip_widths, "{}", 0, 20, 12},
      {&lam_con_strip_widths, "{widths: proportional}", 0, 16, 24},
      {&lam_con_strip_widths, "{widths: constant}", 0, 20, 12},
  };
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    subject s = subject_of(f, rows[i].net, rows[i].kind, rows[i].keys);
    int elements = 0, at[most_unknowns];
    for (int b = 0; b < s.problem->block_count; b++) elements += s.problem->blocks[b].count;
    if (elements != rows[i].elements)
      fail_msg("%s %s on %s: %d elements, expected %d", rows[i].kind->head.name, rows[i].keys,
               net_names[rows[i].net], elements, rows[i].elements);
    if (elements)
      assert_int_equal(element_unknowns(s.problem, &s.problem->blocks[0], 0, at), rows[i].unknowns);
  }
}

/* At the start, what keeps the start is met: edge lengths, side lengths, closeness, gliding. */
static void constraints_that_keep_are_met_at_the_start(void **state) {
  net_fixture *f = *state;
  const lam_constraint_kind *kinds[] = {&lam_con_edge_length, &lam_con_boundary_length,
                                        &lam_con_closeness, &lam_con_glide};
  for (int net = 0; net < net_count; net++)
    for (int i = 0; i < 4; i++) {
      subject s = subject_of(f, net, kinds[i], "{}");
      follow(s.problem);
      dense_system d = dense_assemble(f->arena, s.problem, s.problem->x, (lam_weights){1, 1, 1});
      assert_near(d.energy, 0, 1e-28);
    }
  subject s = subject_of(f, 0, &lam_con_fairness, "{of: displacements}");
  assert_near(dense_assemble(f->arena, s.problem, s.problem->x, (lam_weights){1, 1, 1}).energy, 0,
              1e-28);
}

/* |n.(v - P)| with the foot point P is the distance to the reference: searched over all triangles'
 * points by the tree, and at most the distance of the nearest reference vertex. */
static void proximity_measures_the_distance(void **state) {
  net_fixture *f = *state;
  for (int net = 0; net < net_count; net++) {
    subject s = subject_of(f, net, &lam_con_proximity, "{}");
    follow(s.problem);
    const lam_block *block = &s.problem->blocks[0];
    lam_tree *tree = lam_tree_new(&s.reference, NULL);
    for (int e = 0; e < block->count; e++) {
      double r, nearest = INFINITY;
      lam_vec3 v = s.net.mesh.vertices[block->nodes[e]], foot;
      int triangle;
      block->kernel(3, &v.x, element_params(block, e), &r, NULL);
      lam_tree_closest(tree, v, &foot, &triangle);
      for (int k = 0; k < s.reference.vertex_count; k++)
        nearest = fmin(nearest, lam_distance(v, s.reference.vertices[k]));
      assert_near(fabs(r), lam_distance(v, foot), 1e-12);
      assert_below(fabs(r), nearest + 1e-12);
    }
    lam_tree_free(tree);
  }
}

static void proximity_needs_a_reference(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_problem *problem = lam_problem_new(f->arena, 9, mesh.vertices);
  lam_scope scope = {.problem = problem, .net = &net, .unit = 1, .errors = &f->errors};
  lam_con_proximity.add(&scope, NULL, 1, (lam_location){0});
  assert_int_equal(f->errors.count, 1);
  assert_int_equal(problem->block_count, 0);
  int ninth = 9;
  lam_handle_params far = {{1, &ninth}, {0, 0, 0}};
  lam_con_handle.add(&scope, &far, 1, (lam_location){0});
  assert_int_equal(f->errors.count, 2);
  assert_int_equal(problem->block_count, 0);
}

/* A boundary vertex moved along the tangent keeps its gliding residual 0; moved off the line by h,
 * the residual is h.
 */
static void gliding_is_free_along_the_boundary(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 5, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_problem *problem = lam_problem_new(f->arena, mesh.vertex_count, mesh.vertices);
  lam_scope scope = {.problem = problem, .net = &net, .unit = 1, .errors = &f->errors};
  lam_con_glide.add(&scope, NULL, 1, (lam_location){0});
  for (int v = 0; v < mesh.vertex_count; v++) {
    int valence = net.ring_start[v + 1] - net.ring_start[v];
    assert_int_equal(problem->fixed[v], net.boundary[v] && valence == 2);
  }
  problem->x[3 * 2 + 1] += 1.3; /* (0, 2) on the side x = 0, past the place of (0, 3) */
  follow(problem);
  assert_near(dense_assemble(f->arena, problem, problem->x, (lam_weights){1, 1, 1}).energy, 0,
              1e-28);
  problem->x[3 * 2 + 2] += .25;
  follow(problem);
  assert_near(dense_assemble(f->arena, problem, problem->x, (lam_weights){1, 1, 1}).max, .25,
              1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(every_jacobian_is_the_derivative),
      NET_TEST(jacobians_with_other_parameters),
      NET_TEST(every_constraint_assembles),
      NET_TEST(elements_are_complete),
      NET_TEST(constraints_that_keep_are_met_at_the_start),
      NET_TEST(proximity_measures_the_distance),
      NET_TEST(proximity_needs_a_reference),
      NET_TEST(gliding_is_free_along_the_boundary),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
