/* Normal equations and their factorization, against plain dense arithmetic. */
#include "solve/guided.h"
#include "solve_fixture.h"

/* A common sphere of vertices: nodes (vertex, sphere = center and radius); r = (|v - c|^2 / R^2 -
 * 1) / 2. */
static void on_sphere(int n, const double *x, const double *p, double *r, double *J) {
  double R = x[6], d[3] = {x[0] - x[3], x[1] - x[4], x[2] - x[5]},
         s = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  (void)p;
  r[0] = .5 * (s / (R * R) - 1);
  if (!J) return;
  for (int c = 0; c < 3; c++) {
    J[c] = d[c] / (R * R);
    J[3 + c] = -J[c];
  }
  J[n - 1] = -s / (R * R * R);
}

/* The same with the nodes in the other order: the larger node of another size first. */
static void sphere_first(int n, const double *x, const double *p, double *r, double *J) {
  double y[7] = {x[4], x[5], x[6], x[0], x[1], x[2], x[3]}, K[7];
  on_sphere(n, y, p, r, J ? K : NULL);
  for (int c = 0; J && c < 7; c++) J[c] = K[(c + 3) % 7];
}

/* Two scalars, in any order of their indices: r = (a - p b, a + b - 1). */
static void two_numbers(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = x[0] - p[0] * x[1];
  r[1] = x[0] + x[1] - 1;
  if (!J) return;
  J[0] = 1, J[1] = -p[0];
  J[n] = 1, J[n + 1] = 1;
}

/* Nodes v, w, v, s with v listed twice and s of five unknowns: r = v_x w_y + v_z^2 - s_0 s_4. */
static void twice(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  r[0] = x[0] * x[4] + x[8] * x[8] - x[9] * x[13];
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = 0;
  J[0] = x[4], J[4] = x[0], J[8] = 2 * x[8], J[9] = -x[13], J[13] = -x[9];
}

/* A grid with planar stars, edges, fairness, closeness and the kernels above on extra nodes of 4,
 * 1, 1 and 5 unknowns.
 */
static lam_problem *mixed_problem(net_fixture *f, const lam_net *net) {
  static const double sphere[4] = {1, 2, 9, 8}, a[1] = {.3}, b[1] = {.9}, five[5] = {1, 2, 3, 4, 5};
  static const double slope[2] = {2, -3};
  lam_arena *arena = f->arena;
  lam_problem *problem = lam_problem_new(arena, net->mesh.vertex_count, net->mesh.vertices);
  int ball = lam_problem_node(problem, 4, sphere), first = lam_problem_node(problem, 1, a);
  int second = lam_problem_node(problem, 1, b), other = lam_problem_node(problem, 5, five);
  lam_scope scope = {.problem = problem, .net = net, .unit = 1, .errors = &f->errors};
  lam_con_planar_star.add(&scope, NULL, 3, (lam_location){0});
  lam_con_fairness.add(&scope, NULL, .7, (lam_location){0});
  lam_con_closeness.add(&scope, NULL, .2, (lam_location){0});
  lam_edge_length_add(&scope, "soft edges", LAM_SOFT, 1.5, (lam_edge_length_params){1.1, false});
  int count = net->mesh.vertex_count, *pairs = LAM_NEW(arena, int, 2 * count),
      *reversed = LAM_NEW(arena, int, 2 * count);
  for (int v = 0; v < count; v++) {
    pairs[2 * v] = reversed[2 * v + 1] = v;
    pairs[2 * v + 1] = reversed[2 * v] = ball;
  }
  lam_problem_add(problem, (lam_block){.name = "sphere",
                                       .kernel = on_sphere,
                                       .rows = 1,
                                       .weight = 2,
                                       .count = count,
                                       .arity = 2,
                                       .nodes = pairs});
  lam_problem_add(problem, (lam_block){.name = "sphere first",
                                       .kernel = sphere_first,
                                       .rows = 1,
                                       .weight = .6,
                                       .count = count,
                                       .arity = 2,
                                       .nodes = reversed});
  int *scalars = LAM_NEW(arena, int, 4), *doubled = LAM_NEW(arena, int, 8);
  memcpy(scalars, (int[4]){second, first, first, second}, 4 * sizeof(int));
  memcpy(doubled, (int[8]){7, 3, 7, other, 2, 11, 2, other}, 8 * sizeof(int));
  lam_problem_add(problem, (lam_block){.name = "numbers",
                                       .kernel = two_numbers,
                                       .rows = 2,
                                       .weight = 1,
                                       .count = 2,
                                       .arity = 2,
                                       .nodes = scalars,
                                       .param_count = 1,
                                       .params = (double *)slope});
  lam_problem_add(problem, (lam_block){.name = "twice",
                                       .kernel = twice,
                                       .rows = 1,
                                       .role = LAM_SOFT,
                                       .weight = 1,
                                       .count = 2,
                                       .arity = 4,
                                       .nodes = doubled});
  lam_problem_add(
      problem, (lam_block){.name = "nothing", .kernel = twice, .rows = 1, .count = 0, .arity = 4});
  return problem;
}

static lam_net bumpy_net(net_fixture *f) {
  lam_mesh mesh = net_grid(f->arena, 5, 4, net_saddle);
  lam_mesh_perturb(&mesh, .2, 5);
  return net_built(f, &mesh);
}

static void sparse_equals_dense(void **state) {
  net_fixture *f = *state;
  lam_net net = bumpy_net(f);
  lam_problem *problem = mixed_problem(f, &net);
  assert_int_equal(problem->block_count, 8);
  static const lam_weights weights[] = {{1, 1, 1}, {1, .5, .01}, {1, 0, 0}, {0, 0, 1}, {0, 2, 0}};
  for (size_t i = 0; i < sizeof weights / sizeof *weights; i++) {
    assert_system(f->arena, problem, problem->x, weights[i]);
    double *elsewhere = LAM_NEW(f->arena, double, problem->offset[problem->node_count]);
    for (int k = 0; k < problem->offset[problem->node_count]; k++)
      elsewhere[k] = problem->x[k] + .3 * net_random(f);
    assert_system(f->arena, problem, elsewhere, weights[i]);
  }
}

static void fixed_nodes_have_no_columns(void **state) {
  net_fixture *f = *state;
  lam_net net = bumpy_net(f);
  for (int trial = 0; trial < 12; trial++) {
    lam_problem *problem = mixed_problem(f, &net);
    int free_unknowns = 0;
    for (int v = 0; v < problem->node_count; v++) {
      problem->fixed[v] = net_random(f) > (trial - 4) / 8.;
      if (!problem->fixed[v]) free_unknowns += problem->size[v];
    }
    assert_system(f->arena, problem, problem->x, (lam_weights){1, 1, .3});
    lam_system *system = lam_system_new(f->arena, problem);
    assert_int_equal(lam_system_size(system), free_unknowns);
  }
}

/* Columns ascend with the diagonal first, the order is a permutation, unknowns are those of the
 * free nodes in order. */
static void the_pattern_is_well_formed(void **state) {
  net_fixture *f = *state;
  lam_net net = bumpy_net(f);
  lam_problem *problem = mixed_problem(f, &net);
  problem->fixed[0] = problem->fixed[6] = true;
  lam_system *system = lam_system_new(f->arena, problem);
  int n = lam_system_size(system);
  const int *start = lam_system_columns(system), *row = lam_system_rows(system),
            *order = lam_system_order(system);
  const int *unknown = lam_system_unknowns(system);
  int *seen = LAM_NEW(f->arena, int, n), column = 0;
  assert_int_equal(start[0], 0);
  for (int c = 0; c < n; c++) {
    assert_int_equal(row[start[c]], c);
    for (int k = start[c] + 1; k < start[c + 1]; k++)
      assert_true(row[k] > row[k - 1] && row[k] < n);
    seen[order[c]]++;
  }
  for (int c = 0; c < n; c++) assert_int_equal(seen[c], 1);
  for (int v = 0; v < problem->node_count; v++)
    for (int c = 0; !problem->fixed[v] && c < problem->size[v]; c++)
      assert_int_equal(unknown[column++], problem->offset[v] + c);
  assert_int_equal(column, n);
}

/* The worst block is named; a residual without derivatives is the same; damping changes the
 * diagonal alone. */
static void residuals_and_damping(void **state) {
  net_fixture *f = *state;
  lam_net net = bumpy_net(f);
  lam_problem *problem = mixed_problem(f, &net);
  lam_system *system = lam_system_new(f->arena, problem);
  int n = lam_system_size(system), entries = lam_system_columns(system)[n];
  double *values = LAM_NEW(f->arena, double, entries), *gradient = LAM_NEW(f->arena, double, n);
  double *damped = LAM_NEW(f->arena, double, entries);
  lam_weights weights = {1, 1, 1};
  lam_residual full = lam_system_assemble(system, problem->x, weights, values, gradient);
  lam_residual alone = lam_system_residual(system, problem->x, weights);
  assert_memory_equal(&full, &alone, sizeof full);
  assert_string_equal(
      full.worst, "numbers"); /* .9 + 3 * .3 = 1.8 and .3 + 3 * .9 = 3: larger than all others */
  assert_near(full.max, 3, 1e-15);
  memcpy(damped, values, sizeof(double) * (size_t)entries);
  lam_system_damp(system, .25, damped);
  for (int c = 0; c < n; c++)
    for (int k = lam_system_columns(system)[c]; k < lam_system_columns(system)[c + 1]; k++)
      assert_near(damped[k], values[k] + (k == lam_system_columns(system)[c] ? .25 : 0), 0);
}

/* Gaussian elimination with column pivots. */
static void eliminate(int n, double *A, double *b) {
  for (int c = 0; c < n; c++) {
    int pivot = c;
    for (int r = c + 1; r < n; r++)
      if (fabs(A[r * n + c]) > fabs(A[pivot * n + c])) pivot = r;
    for (int k = 0; k < n; k++) {
      double swap = A[c * n + k];
      A[c * n + k] = A[pivot * n + k];
      A[pivot * n + k] = swap;
    }
    double swap = b[c];
    b[c] = b[pivot];
    b[pivot] = swap;
    for (int r = c + 1; r < n; r++) {
      double factor = A[r * n + c] / A[c * n + c];
      for (int k = c; k < n; k++) A[r * n + k] -= factor * A[c * n + k];
      b[r] -= factor * b[c];
    }
  }
  for (int c = n - 1; c >= 0; c--) {
    for (int k = c + 1; k < n; k++) b[c] -= A[c * n + k] * b[k];
    b[c] /= A[c * n + c];
  }
}

static void solving_equals_elimination(void **state) {
  net_fixture *f = *state;
  lam_net net = bumpy_net(f);
  lam_problem *problem = mixed_problem(f, &net);
  problem->fixed[3] = true;
  lam_system *system = lam_system_new(f->arena, problem);
  int n = lam_system_size(system), entries = lam_system_columns(system)[n];
  double *values = LAM_NEW(f->arena, double, entries), *gradient = LAM_NEW(f->arena, double, n);
  double *x = LAM_NEW(f->arena, double, n);
  lam_factor *factor = lam_factor_analyze(f->arena, n, lam_system_columns(system),
                                          lam_system_rows(system), lam_system_order(system));
  for (int round = 0; round < 3; round++) {
    lam_system_assemble(system, problem->x, (lam_weights){1, 1, 1. / (1 + round)}, values,
                        gradient);
    lam_system_damp(system, .1, values);
    double *dense = dense_values(f->arena, system, values), *b = LAM_NEW(f->arena, double, n);
    memcpy(b, gradient, sizeof(double) * (size_t)n);
    eliminate(n, dense, b);
    assert_true(lam_factor_refactor(factor, values));
    lam_factor_solve(factor, gradient, x);
    for (int i = 0; i < n; i++) assert_near(x[i], b[i], 1e-10 * (1 + fabs(b[i])));
    lam_factor_solve(factor, gradient, gradient); /* in place */
    assert_memory_equal(gradient, x, sizeof(double) * (size_t)n);
  }
  lam_factor_stats stats = lam_factor_get_stats(factor);
  assert_int_equal(stats.factorized, 3);
  assert_int_equal(stats.solved, 6);
  assert_true(stats.flops > 0 && stats.entries >= n);
}

/* A chain of n unknowns with diagonal d and neighbors -1: definite for d > 2, indefinite for d < 2
 * cos(pi / (n + 1)). Small ones are factorized column by column, large dense ones in blocks: both
 * must notice. */
static bool chain_is_definite(net_fixture *f, int n, int band, double d) {
  int *start = LAM_NEW(f->arena, int, n + 1), *row = LAM_NEW(f->arena, int, n *(band + 1)),
      *order = LAM_NEW(f->arena, int, n);
  double *values = LAM_NEW(f->arena, double, n *(band + 1)), *b = LAM_NEW(f->arena, double, n);
  int k = 0;
  for (int c = 0; c < n; c++) {
    order[c] = c;
    b[c] = 1;
    for (int r = c; r <= c + band && r < n; r++, k++) {
      row[k] = r;
      values[k] = r == c ? d * band : -1;
    }
    start[c + 1] = k;
  }
  lam_factor *factor = lam_factor_analyze(f->arena, n, start, row, order);
  bool definite = lam_factor_refactor(factor, values);
  for (int c = 0; c < n; c++)
    values[start[c]] = 2 * band + 1; /* afterwards a definite one works again */
  if (!lam_factor_refactor(factor, values))
    fail_msg("a definite matrix of %d unknowns is refused", n);
  lam_factor_solve(factor, b, b);
  double sum = (2 * band + 1) * b[0];
  for (int r = 1; r <= band; r++) sum -= b[r];
  assert_near(sum, 1, 1e-12);
  return definite;
}

static void not_positive_definite_is_reported(void **state) {
  net_fixture *f = *state;
  static const int sizes[][2] = {{2, 1}, {12, 1}, {40, 3}, {400, 120}, {600, 300}};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    int n = sizes[i][0], band = sizes[i][1];
    assert_true(chain_is_definite(f, n, band, 2.01));
    if (chain_is_definite(f, n, band, -1))
      fail_msg("n = %d, band %d: a negative diagonal is accepted", n, band);
    if (chain_is_definite(f, n, band, .3))
      fail_msg("n = %d, band %d: an indefinite matrix is accepted", n, band);
    if (chain_is_definite(f, n, band, 0))
      fail_msg("n = %d, band %d: a zero diagonal is accepted", n, band);
  }
}

static void nodes_grow_and_keep_their_values(void **state) {
  net_fixture *f = *state;
  lam_vec3 points[3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  lam_problem *problem = lam_problem_new(f->arena, 3, points);
  problem->fixed[1] = true;
  double start[8];
  for (int i = 0; i < 200; i++) {
    for (int c = 0; c < 8; c++) start[c] = 100 * i + c;
    assert_int_equal(lam_problem_node(problem, 1 + i % 8, start), 3 + i);
  }
  assert_memory_equal(problem->x, points, sizeof points);
  assert_true(problem->fixed[1] && !problem->fixed[0] && !problem->fixed[202]);
  for (int i = 0; i < 200; i++) {
    assert_int_equal(problem->offset[4 + i] - problem->offset[3 + i], 1 + i % 8);
    for (int c = 0; c <= i % 8; c++)
      assert_near(problem->x[problem->offset[3 + i] + c], 100 * i + c, 0);
  }
  lam_vec3 back[3];
  lam_problem_positions(problem, back);
  assert_memory_equal(back, points, sizeof points);
}

/* Twelve fixed points of the sphere about (1, 2, 3) with radius 2: the sphere is found. */
static void a_common_sphere_is_found(void **state) {
  net_fixture *f = *state;
  lam_vec3 points[12];
  int nodes[24];
  for (int i = 0; i < 12; i++) {
    lam_vec3 d = lam_unit(lam_v3(net_random(f), net_random(f), net_random(f)));
    points[i] = lam_along(lam_v3(1, 2, 3), 2, d);
  }
  lam_problem *problem = lam_problem_new(f->arena, 12, points);
  int ball = lam_problem_node(problem, 4, (double[4]){.7, 2.3, 2.6, 2.5});
  for (int i = 0; i < 12; i++) {
    problem->fixed[i] = true;
    nodes[2 * i] = i, nodes[2 * i + 1] = ball;
  }
  lam_problem_add(problem, (lam_block){.name = "sphere",
                                       .kernel = on_sphere,
                                       .rows = 1,
                                       .weight = 1,
                                       .count = 12,
                                       .arity = 2,
                                       .nodes = nodes});
  lam_schedule schedule = lam_schedule_default();
  lam_solution s = lam_guided_solve(problem, &schedule, NULL);
  if (!s.converged) fail_msg("%s", s.reason);
  const double *x = problem->x + problem->offset[ball];
  static const double expected[4] = {1, 2, 3, 2};
  for (int c = 0; c < 4; c++) assert_near(x[c], expected[c], 1e-11);
  assert_int_equal(s.unknowns, 4);
  assert_int_equal(s.residuals, 12);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(sparse_equals_dense),
      NET_TEST(fixed_nodes_have_no_columns),
      NET_TEST(the_pattern_is_well_formed),
      NET_TEST(residuals_and_damping),
      NET_TEST(solving_equals_elimination),
      NET_TEST(not_positive_definite_is_reported),
      NET_TEST(nodes_grow_and_keep_their_values),
      NET_TEST(a_common_sphere_is_found),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
