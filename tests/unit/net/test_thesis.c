/* The thesis' own form of the nets (auxiliary unknowns, at most quadratic) and its solver (full
 * steps, constant epsilon). */
#include "con/thesis/thesis.h"
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "net/optimize.h"
#include "solve_fixture.h"

enum { most_unknowns = 64, most_rows = 16 };

/* ---- kernels ---- */

typedef struct form {
  const char *name;
  void (*add)(lam_scope *scope);
} form;

static void add_stars(lam_scope *s) { lam_thesis_planar_stars(s, true); }
static void add_faces(lam_scope *s) { lam_thesis_planar_faces(s); }
static void add_angle(lam_scope *s) { lam_thesis_angle(s, 1.1, true); }
static void add_parallel(lam_scope *s) { lam_thesis_geodesic_parallel(s, 0, true); }
static void add_across(lam_scope *s) { lam_thesis_geodesic_parallel(s, 1, true); }
static void add_spheres(lam_scope *s) { lam_thesis_spherical_stars(s); }
static void add_circle_angle(lam_scope *s) { lam_thesis_circle_angle(s, .9); }
static void add_radius(lam_scope *s) { lam_thesis_equal_spheres(s, 4, 1.2); }
static void add_one_radius(lam_scope *s) { lam_thesis_equal_spheres(s, 0, NAN); }

static const form forms[] = {{"planar stars", add_stars},
                             {"planar faces", add_faces},
                             {"angle", add_angle},
                             {"geodesic parallel", add_parallel},
                             {"geodesic parallel", add_across},
                             {"spherical stars", add_spheres},
                             {"circle angle", add_circle_angle},
                             {"equal spheres", add_radius},
                             {"one radius", add_one_radius}};
enum { form_count = sizeof forms / sizeof *forms };

static lam_vec3 dome(double i, double j) {
  double x = i - 2, y = j - 2.5;
  return lam_v3(i, j, -.08 * x * x - .11 * y * y + .02 * x * y);
}

static lam_problem *problem_on(net_fixture *f, const lam_mesh *mesh, const form *kind,
                               lam_net *net) {
  *net = net_built(f, mesh);
  lam_problem *problem = lam_problem_new(f->arena, mesh->vertex_count, net->mesh.vertices);
  lam_scope scope = {.problem = problem, .net = net, .unit = 1, .errors = &f->errors};
  kind->add(&scope);
  net_no_errors(f, kind->name);
  return problem;
}

static lam_problem *any_problem(net_fixture *f, int which, bool irregular, lam_net *net) {
  lam_mesh mesh = irregular ? net_round_cube(f) : net_grid(f->arena, 5, 6, dome);
  return problem_on(f, &mesh, &forms[which], net);
}

static int random_element(net_fixture *f, const lam_problem *problem, const lam_block *block,
                          int element, double *x) {
  int at[most_unknowns], n = element_unknowns(problem, block, element, at);
  assert_true(n <= most_unknowns && block->rows <= most_rows);
  for (int i = 0; i < n; i++) x[i] = problem->x[at[i]] + .4 * net_random(f);
  return n;
}

static void at(const lam_block *block, int element, int n, const double *x, const double *d,
               double t, double *r) {
  double y[most_unknowns];
  for (int i = 0; i < n; i++) y[i] = x[i] + t * d[i];
  block->kernel(n, y, element_params(block, element), r, NULL);
}

/* Along any line the residual of a quadratic equation has no third difference, and its slope at the
 * middle is exactly the central difference: both hold to rounding, not only for small steps. */
static void check_element(net_fixture *f, const lam_problem *problem, const lam_block *block,
                          int element) {
  double x[most_unknowns], d[most_unknowns], r[4][most_rows], J[most_rows * most_unknowns],
      size = 0;
  int n = random_element(f, problem, block, element, x);
  for (int i = 0; i < n; i++) d[i] = net_random(f);
  for (int i = 0; i < block->rows * n; i++) J[i] = 1e30; /* a kernel writes every entry */
  for (int k = 0; k < 4; k++) at(block, element, n, x, d, k - 1.5, r[k]);
  for (int k = 0; k < block->rows; k++) {
    for (int i = 0; i < 4; i++) size = fmax(size, fabs(r[i][k]));
    double third = r[3][k] - 3 * r[2][k] + 3 * r[1][k] - r[0][k];
    if (!(fabs(third) <= 1e-13 * (10 + size)))
      fail_msg("%s, row %d: third difference %.3g, expected 0 of a quadratic equation", block->name,
               k, third);
  }
  block->kernel(n, x, element_params(block, element), r[0], J);
  for (int i = 0; i < n; i++) {
    for (int c = 0; c < n; c++) d[c] = c == i;
    at(block, element, n, x, d, .5, r[2]);
    at(block, element, n, x, d, -.5, r[1]);
    for (int k = 0; k < block->rows; k++)
      if (!(fabs(J[k * n + i] - (r[2][k] - r[1][k])) <= 1e-12 * (1 + size)))
        fail_msg("%s, dr%d/dx%d is %.15g, by differences %.15g", block->name, k, i, J[k * n + i],
                 r[2][k] - r[1][k]);
  }
}

static void test_equations_are_quadratic_with_exact_jacobians(void **state) {
  net_fixture *f = *state;
  for (int i = 0; i < 2 * form_count; i++) {
    lam_net net;
    lam_problem *problem = any_problem(f, i / 2, i & 1, &net);
    assert_true(problem->block_count > 0);
    for (int b = 0; b < problem->block_count; b++)
      for (int e = 0; e < problem->blocks[b].count; e += 1 + problem->blocks[b].count / 7)
        check_element(f, problem, &problem->blocks[b], e);
  }
}

/* Auxiliary unknowns start with their own equations satisfied; what is left is the net's. */
static void test_auxiliary_unknowns_start_consistent(void **state) {
  net_fixture *f = *state;
  static const char *const defining[] = {"half-edge", "square",       "edge-square",
                                         "tangent",   "unit-tangent", "circle-plane"};
  int seen = 0;
  for (int i = 0; i < form_count; i++) {
    lam_net net;
    lam_problem *problem = any_problem(f, i, false, &net);
    for (int b = 0; b < problem->block_count; b++) {
      const lam_block *block = &problem->blocks[b];
      bool own = false;
      for (size_t k = 0; k < sizeof defining / sizeof *defining; k++)
        own |= strcmp(defining[k], block->name) == 0;
      seen += own;
      for (int e = 0; own && e < block->count; e++) {
        int places[most_unknowns], n = element_unknowns(problem, block, e, places);
        double x[most_unknowns], r[most_rows];
        for (int k = 0; k < n; k++) x[k] = problem->x[places[k]];
        block->kernel(n, x, element_params(block, e), r, NULL);
        for (int k = 0; k < block->rows; k++) assert_near(r[k], 0, 1e-13);
      }
    }
  }
  assert_int_equal(seen, 11);
}

static void test_systems_of_mixed_nodes_are_the_dense_ones(void **state) {
  net_fixture *f = *state;
  for (int i = 0; i < form_count; i++) {
    lam_mesh mesh = net_grid(f->arena, 3, 4, dome);
    lam_net net;
    lam_problem *problem = problem_on(f, &mesh, &forms[i], &net);
    for (int k = 0; k < problem->offset[problem->node_count]; k++)
      problem->x[k] += .1 * net_random(f);
    assert_system(f->arena, problem, problem->x, (lam_weights){1, 1, 1});
  }
}

/* Thesis table 3.2: the column var is 3 |V| + 8 |E|. The row of figure 4.13 (391 vertices, 17 x 23)
 * has |E| = 742 instead. */
static void test_unknowns_are_those_of_table_3_2(void **state) {
  net_fixture *f = *state;
  static const struct {
    int m, n, vertices, unknowns;
  } rows[] = {{21, 21, 441, 8043},
              {31, 37, 1147, 21249},
              {11, 17, 187, 3329},
              {11, 30, 330, 5942},
              {27, 54, 1458, 27054},
              {41, 117, 4797, 89879},
              {17, 23, 391, 3 * 391 + 8 * 742}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
    lam_mesh mesh = net_grid(f->arena, rows[i].m, rows[i].n, dome);
    lam_net net;
    lam_problem *problem = problem_on(f, &mesh, &forms[3], &net);
    assert_int_equal(mesh.vertex_count, rows[i].vertices);
    assert_int_equal(problem->offset[problem->node_count], rows[i].unknowns);
    assert_int_equal(3 * mesh.vertex_count + 8 * net.edge_count, rows[i].unknowns);
    assert_int_equal(problem->blocks[0].rows * problem->blocks[0].count, 8 * net.edge_count);
    /* two equations per edge of the inner u-lines, end half-stars among them: 2 (m - 1) (n - 2) */
    assert_int_equal(problem->blocks[1].rows * problem->blocks[1].count,
                     2 * (rows[i].m - 1) * (rows[i].n - 2));
  }
}

/* ---- nets ---- */

static double angle_at(const lam_net *net, int v, int a, int b) {
  const lam_vec3 *x = net->mesh.vertices;
  return lam_angle(lam_sub(x[a], x[v]), lam_sub(x[b], x[v])) * LAM_DEGREES_PER_RADIAN;
}

/* Largest difference of the angles on both sides of a u-edge, in degrees. */
static double geodesic_parallel_error(const lam_net *net) {
  double worst = 0;
  for (int s = 0; s < net->star_count; s++) {
    int v = net->stars[s].center;
    const int *k = net->stars[s].neighbor;
    worst = fmax(worst, fabs(angle_at(net, v, k[0], k[1]) - angle_at(net, v, k[0], k[3])));
    worst = fmax(worst, fabs(angle_at(net, v, k[2], k[1]) - angle_at(net, v, k[2], k[3])));
  }
  return worst;
}

/* Standard deviation over mean of the u-edges between neighboring v-lines, in the middle of the
 * net: zigzags show. */
static double strip_variation(const lam_net *net, int n) {
  double worst = 0;
  const lam_vec3 *x = net->mesh.vertices;
  for (int i = 0; i + 1 < n; i++) {
    double sum = 0, squares = 0;
    for (int j = 0; j < n; j++) {
      double l = lam_distance(x[i * n + j], x[(i + 1) * n + j]);
      sum += l, squares += l * l;
    }
    worst = fmax(worst, sqrt(fmax(squares / n - sum / n * sum / n, 0)) / (sum / n));
  }
  return worst;
}

/* Radius of the sphere through v and three of its neighbors, and the distance of the fourth from
 * that sphere. Where the star is nearly flat the radius is up to 1e9 edges: |E - c| - |c| would
 * lose seven digits to it, so the difference of squares is divided by the sum, whose rounding is
 * that of E. */
static double star_radius(const lam_net *net, int s, double *off) {
  const lam_vec3 *x = net->mesh.vertices;
  const lam_star *star = &net->stars[s];
  lam_vec3 v = x[star->center], E[4];
  for (int k = 0; k < 4; k++) E[k] = lam_sub(x[star->neighbor[k]], v);
  lam_vec3 p = lam_cross(E[1], E[2]), q = lam_cross(E[2], E[0]), r = lam_cross(E[0], E[1]);
  lam_vec3 c = lam_scale(p, lam_dot(E[0], E[0]));
  c = lam_along(lam_along(c, lam_dot(E[1], E[1]), q), lam_dot(E[2], E[2]), r);
  c = lam_scale(c, 1 / (2 * lam_dot(E[0], p)));
  *off = fabs(lam_dot(E[3], E[3]) - 2 * lam_dot(E[3], c)) / (lam_distance(E[3], c) + lam_length(c));
  return lam_length(c);
}

/* A net that exists in the thesis' form only, with a scale: lengths of the solver are relative to
 * the mean edge. */
typedef struct outcome {
  lam_net net;
  lam_net_result result;
  double unit; /* mean edge at the start */
} outcome;

static double radius_of_case; /* mean edges; 0: unknown */
static void constrain_parallel(lam_scope *s, const void *p, lam_location at_) {
  (void)p, (void)at_, add_parallel(s);
}
static void constrain_spheres(lam_scope *s, const void *p, lam_location at_) {
  (void)p, (void)at_, add_spheres(s);
}
static void constrain_cmc(lam_scope *s, const void *p, lam_location at_) {
  (void)p, (void)at_;
  lam_thesis_equal_spheres(s, radius_of_case, net_pi / 2);
}

static outcome solve(net_fixture *f, const char *mesh_name, const lam_net_kind *kind,
                     const char *params, const char *solver, const char *more) {
  lam_mesh mesh =
      net_obj(f->arena, lam_arena_printf(f->arena, "tests/cases/nets/%s_init.obj", mesh_name));
  outcome o = {.net = net_built(f, &mesh)};
  o.unit = lam_net_mean_edge(&o.net, mesh.vertices);
  lam_net_common *common = net_params(f, lam_net_common_keys, sizeof *common,
                                      lam_arena_printf(f->arena, "{solver: %s%s}", solver, more));
  common->from.file = mesh_name;
  lam_net_job job = {.kind = kind,
                     .params = net_params(f, kind->head.keys, kind->head.params_size, params),
                     .common = common};
  assert_true(lam_net_optimize(f->arena, &job, &o.net, &f->errors, &o.result));
  net_no_errors(f, mesh_name);
  if (!o.result.converged)
    fail_msg("%s, solver %s: %s, residual %g (%s)", mesh_name, solver, o.result.reason,
             o.result.solution.residual, o.result.solution.worst);
  assert_int_equal(o.result.degenerate != NULL, false);
  return o;
}

static const char *const no_measures[] = {NULL};
static lam_net_kind own_kind(void (*constrain)(lam_scope *, const void *, lam_location),
                             double fairness) {
  return (lam_net_kind){.head = {.name = "own"},
                        .schedule = {.fairness = fairness,
                                     .decay = .5,
                                     .floor = 1e-3,
                                     .tolerance = 1e-11,
                                     .max_iterations = 100},
                        .constrain_thesis = constrain,
                        .measures = no_measures};
}

static double measured(net_fixture *f, const outcome *o, const char *name) {
  return lam_net_measure_one(f->arena, &o->net, o->net.mesh.vertices, name).max;
}

/* The bump of 15 x 15 vertices. Reference solution: vertices only, 3 steps, angles to 4e-11 deg,
 * u-edges of a strip vary by .0045; without the equations at the ends of the u-lines .17. Auxiliary
 * unknowns: 4 steps. */
static void test_geodesic_parallel_coordinates(void **state) {
  net_fixture *f = *state;
  lam_net_kind kind = own_kind(constrain_parallel, 0);
  static const char *const solvers[] = {"thesis", "{method: thesis, epsilon: 1e-5}"};
  for (int i = 0; i < 2; i++) {
    outcome o = solve(f, "bump", &kind, "{}", solvers[i], "");
    assert_int_equal(o.result.solution.unknowns, 3 * 225 + 8 * 420);
    assert_true(o.result.solution.iterations <= 6);
    assert_below(geodesic_parallel_error(&o.net), 1e-8);
    assert_below(strip_variation(&o.net, 15), .05);
    assert_below(measured(f, &o, "foldovers"), 0);
  }
}

/* Reference solution of the Enneper patch, auxiliary unknowns: 2 steps, planar to 8e-15, angles
 * within 8e-13 deg, shortest edge .6908 of the mean edge. The border takes part here as well. */
static void test_asymptotic_net_with_right_angles(void **state) {
  net_fixture *f = *state;
  outcome o =
      solve(f, "10_anet_enneper", (const lam_net_kind *)lam_registry_find(&lam_nets, "asymptotic"),
            "{orthogonal: yes, border: no}", "{method: thesis, epsilon: 1e-5}", "");
  /* normals of 15 x 15 stars, two half-edges of 4 unknowns on 544 edges, two tangents of 4 at every
   * star */
  assert_int_equal(o.result.solution.unknowns, 3 * 289 + 3 * 225 + 8 * 544 + 8 * 225);
  assert_true(o.result.solution.iterations <= 3);
  assert_below(measured(f, &o, "star_planarity"), 1e-12);
  assert_below(measured(f, &o, "angle_deviation"), 1e-9);
  assert_near(measured(f, &o, "shortest_edge"), .691, .003);
  assert_below(o.result.drift, .005);
}

/* Reference solution of the bump, auxiliary normals: 4 steps, planarity 5e-13, shortest edge .935.
 */
static void test_planar_quads(void **state) {
  net_fixture *f = *state;
  outcome o = solve(f, "bump", (const lam_net_kind *)lam_registry_find(&lam_nets, "planar-quads"),
                    "{}", "{method: thesis, fairness: 0, epsilon: 1e-5}", "");
  assert_int_equal(o.result.solution.unknowns, 3 * 225 + 3 * 196);
  assert_true(o.result.solution.iterations <= 6);
  assert_below(measured(f, &o, "face_planarity"), 1e-10);
  assert_near(measured(f, &o, "shortest_edge"), .935, .05);
  /* fairness of the kind, but no more than .01 of positions, and gone in the end */
  outcome faired =
      solve(f, "bump", (const lam_net_kind *)lam_registry_find(&lam_nets, "planar-quads"), "{}",
            "thesis", "");
  assert_below(measured(f, &faired, "face_planarity"), 1e-9);
}

/* Unduloid of mean curvature 1/2 in a unit of .1975708 (mean edge 1): spheres of radius 2 exactly.
 * Reference solution in this form: 3 steps with epsilon 1e-6, r = 2 within 4e-13; with 1e-3 it
 * stops at a residual of 9e-7 after 60. */
static void test_constant_mean_curvature(void **state) {
  net_fixture *f = *state;
  static const double scale = 0.1975708073255066;
  for (int unknown = 0; unknown < 2; unknown++) {
    radius_of_case = unknown ? 0 : 2 / scale;
    lam_net_kind kind = own_kind(constrain_cmc, 0);
    outcome o = solve(f, "05_cmc_unduloid", &kind, "{}", "{method: thesis, epsilon: 1e-5}", "");
    /* m, B1, B2, T1, T2, (U1, a1), (U2, a2) at every star with four faces */
    assert_int_equal(o.net.star_count, 464);
    assert_int_equal(o.result.solution.unknowns, 3 * 528 + 23 * 464 + unknown);
    assert_true(o.result.solution.iterations <= 5);
    double least = INFINITY, most = 0, worst = 0, off;
    for (int s = 0; s < o.net.star_count; s++) {
      double r = star_radius(&o.net, s, &off) * scale;
      least = fmin(least, r), most = fmax(most, r), worst = fmax(worst, off);
    }
    assert_near(least, unknown ? most : 2, 1e-9);
    assert_near(most, 2, unknown ? .05 : 1e-9);
    assert_below(worst, 1e-10);
  }
}

/* Every star on a sphere of its own. Reference solutions reach 1e-8 in 8 steps in every form. */
static void test_spherical_stars(void **state) {
  net_fixture *f = *state;
  lam_net_kind kind = own_kind(constrain_spheres, .02);
  outcome o = solve(f, "08_snet_principal_symmetric", &kind, "{}",
                    "{method: thesis, epsilon: 1e-5, tolerance: 1e-10}", "");
  double worst = 0, off;
  for (int s = 0; s < o.net.star_count; s++) {
    star_radius(&o.net, s, &off);
    worst = fmax(worst, off / o.unit);
  }
  assert_below(worst, 1e-7);
  assert_true(o.result.solution.iterations <= 12);
  assert_below(measured(f, &o, "foldovers"), 0);
}

/* ---- solver ---- */

static void test_a_net_without_such_a_form_says_so(void **state) {
  net_fixture *f = *state;
  const lam_net_kind *kind = (const lam_net_kind *)lam_registry_find(&lam_nets, "free");
  const lam_net_common *common =
      net_params(f, lam_net_common_keys, sizeof(lam_net_common), "{solver: thesis}");
  assert_false(lam_net_method_check(kind, common, (lam_location){0}, &f->errors));
  assert_int_equal(f->errors.count, 1);
  assert_string_equal(f->errors.first->key, "net.solver");
  assert_non_null(strstr(f->errors.first->text, "free has no form with auxiliary unknowns"));
  assert_non_null(strstr(f->errors.first->text, "asymptotic, planar-quads"));

  kind = (const lam_net_kind *)lam_registry_find(&lam_nets, "asymptotic");
  assert_true(lam_net_method_check(kind, common, (lam_location){0}, &f->errors));
}

/* Variants of geodesic parallel coordinates that are not written in half-edges are refused, not
 * solved without them. */
static void test_keys_without_such_a_form_are_refused(void **state) {
  net_fixture *f = *state;
  static const char *const keys[] = {"{developable: one-line}", "{widths: equal}",
                                     "{isometric: yes}"};
  const lam_net_kind *kind =
      (const lam_net_kind *)lam_registry_find(&lam_nets, "geodesic-parallel");
  for (int i = 0; i < 3; i++) {
    lam_mesh mesh = net_grid(f->arena, 5, 6, dome);
    lam_net net = net_built(f, &mesh);
    lam_errors errors = {.arena = f->arena};
    lam_net_job job = {
        .kind = kind,
        .params = net_params(f, kind->head.keys, kind->head.params_size, keys[i]),
        .common = net_params(f, lam_net_common_keys, sizeof(lam_net_common), "{solver: thesis}")};
    lam_net_result result;
    assert_false(lam_net_optimize(f->arena, &job, &net, &errors, &result));
    assert_int_equal(errors.count, 1);
    assert_non_null(strstr(errors.first->text, "developable, widths or isometric"));
  }
}

static void line_and_parabola(int n, const double *x, const double *p, double *r, double *J) {
  (void)n, (void)p;
  r[0] = x[1] - x[0] * x[0];
  if (J) J[0] = -2 * x[0], J[1] = 1, J[2] = 0;
}

/* One step of min (phi + phi' d)^2 + eps^2 d^2 with phi = y - x^2 at (1, 0, 0): d = -phi J' / (J J'
 * + eps^2) with J = (-2, 1, 0), phi = -1. */
static void test_steps_are_full_and_damped_by_epsilon(void **state) {
  net_fixture *f = *state;
  static const int node = 0;
  double epsilon = .5, s = 1 / (5 + epsilon * epsilon);
  lam_vec3 start = {1, 0, 0}, x;
  lam_problem *problem = lam_problem_new(f->arena, 1, &start);
  lam_problem_add(problem, (lam_block){.name = "parabola",
                                       .kernel = line_and_parabola,
                                       .rows = 1,
                                       .weight = 1,
                                       .count = 1,
                                       .arity = 1,
                                       .nodes = &node});
  lam_schedule schedule = lam_schedule_default();
  schedule.max_iterations = 1;
  lam_solution solution = lam_gauss_newton_solve(problem, &schedule, epsilon, NULL);
  lam_problem_positions(problem, &x);
  assert_near(x.x, 1 - 2 * s, 1e-15);
  assert_near(x.y, s, 1e-15);
  assert_near(x.z, 0, 0);
  assert_int_equal(solution.iterations, 1);
  assert_false(solution.converged);
  assert_near(solution.history[0], 1, 0);
  assert_near(solution.residual, fabs(x.y - x.x * x.x), 1e-15); /* not the linearized one */
  /* a constant epsilon: the residual falls by the same factor in every step, eps^2 / (J J' + eps^2)
   * near the solution
   */
  schedule.max_iterations = 40;
  solution = lam_gauss_newton_solve(problem, &schedule, epsilon, NULL);
  assert_true(solution.converged);
  lam_problem_positions(problem, &x);
  double slope = 4 * x.x * x.x + 1, factor = epsilon * epsilon / (slope + epsilon * epsilon);
  int last = solution.history_count - 3;
  assert_near(solution.history[last] / solution.history[last - 1], factor, 1e-3);
}

static void test_wrong_methods_are_named(void **state) {
  net_fixture *f = *state;
  lam_net_common common;
  const char *text = "{solver: {method: theses}}";
  lam_keys_parse(f->arena, lam_net_common_keys, text, strlen(text), NULL, &f->errors, &common);
  assert_int_equal(f->errors.count, 1);
  assert_non_null(strstr(f->errors.first->text, "theses"));
  assert_non_null(strstr(f->errors.first->text, "lamella, thesis"));
}

int main(void) {
  const struct CMUnitTest tests[] = {NET_TEST(test_equations_are_quadratic_with_exact_jacobians),
                                     NET_TEST(test_auxiliary_unknowns_start_consistent),
                                     NET_TEST(test_systems_of_mixed_nodes_are_the_dense_ones),
                                     NET_TEST(test_unknowns_are_those_of_table_3_2),
                                     NET_TEST(test_geodesic_parallel_coordinates),
                                     NET_TEST(test_asymptotic_net_with_right_angles),
                                     NET_TEST(test_planar_quads),
                                     NET_TEST(test_constant_mean_curvature),
                                     NET_TEST(test_spherical_stars),
                                     NET_TEST(test_a_net_without_such_a_form_says_so),
                                     NET_TEST(test_keys_without_such_a_form_are_refused),
                                     NET_TEST(test_steps_are_full_and_damped_by_epsilon),
                                     NET_TEST(test_wrong_methods_are_named)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
