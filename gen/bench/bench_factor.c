/* What an iteration costs beyond the factorization: a whole one against that part of it on the same
 * matrix; and nets on meshes that are hard to planarize. Called by bench.c, and by
 * tests/bench/second_opinion.c for its matrices. */
#include "bench/bench.h"

#include <stdio.h>
#include <stdlib.h>

enum { repeats = 15 };

/* ---- one iteration ---- */

/* Times of several runs. */
typedef struct spread {
  double least, median; /* milliseconds */
} spread;

static int compare_double(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* seconds: repeats of them, which are sorted. */
static spread spread_of(double *seconds) {
  qsort(seconds, repeats, sizeof(double), compare_double);
  return (spread){seconds[0] * 1e3, seconds[repeats / 2] * 1e3};
}

typedef struct comparison {
  spread iteration, factor, alone; /* alone: factorize and solve */
  double ratio;                    /* median of the pairs' */
  lam_factor_stats stats;
} comparison;

/* Positions are in mean edges, as the solver takes them. Hard constraints alone. */
static lam_bench_equations equations_of(lam_arena *arena, const lam_net_job *job,
                                        const lam_net *net) {
  double unit = lam_net_mean_edge(net, net->mesh.vertices);
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    x[v] = lam_scale(net->mesh.vertices[v], 1 / unit);

  lam_errors *errors = LAM_NEW(arena, lam_errors, 1);
  errors->arena = arena;
  lam_problem *problem = lam_problem_new(arena, net->mesh.vertex_count, x);
  lam_scope scope = {.problem = problem, .net = net, .unit = unit, .errors = errors};
  job->kind->constrain(&scope, job->params, job->location);

  lam_system *system = lam_system_new(arena, problem);
  int n = lam_system_size(system);
  const int *columns = lam_system_columns(system);
  return (lam_bench_equations){.problem = problem,
                     .system = system,
                     .factor = lam_factor_analyze(arena, n, columns, lam_system_rows(system),
                                                  lam_system_order(system)),
                     .values = LAM_NEW(arena, double, columns[n]),
                     .gradient = LAM_NEW(arena, double, n),
                     .step = LAM_NEW(arena, double, n)};
}

static const lam_weights hard_alone = {1, 1, 0};

void lam_bench_assemble(const lam_bench_equations *e) {
  lam_system_assemble(e->system, e->problem->x, hard_alone, e->values, e->gradient);
  lam_system_damp(e->system, 1e-6, e->values);
}

/* All that the solver does in one step: assemble, damp, factorize, solve, look at the residual. */
static void iterate(const lam_bench_equations *e) {
  lam_bench_assemble(e);
  lam_factor_refactor(e->factor, e->values);
  lam_factor_solve(e->factor, e->gradient, e->step);
  lam_system_residual(e->system, e->problem->x, hard_alone);
}

/* An iteration, then factorization and solution alone on the same matrix; pairs see the same noise
 * of the machine. */
static comparison compare(lam_bench_equations e) {
  double iteration[repeats], factor[repeats], alone[repeats], ratio[repeats];
  for (int i = 0; i < repeats; i++) {
    double since = lam_bench_clock();
    iterate(&e);
    iteration[i] = lam_bench_clock() - since;

    since = lam_bench_clock();
    lam_factor_refactor(e.factor, e.values);
    factor[i] = lam_bench_clock() - since;
    lam_factor_solve(e.factor, e.gradient, e.step);
    alone[i] = lam_bench_clock() - since;
    ratio[i] = iteration[i] / alone[i];
  }

  /* A ratio has no unit: the milliseconds of a spread are taken back. */
  return (comparison){.iteration = spread_of(iteration),
                      .factor = spread_of(factor),
                      .alone = spread_of(alone),
                      .ratio = spread_of(ratio).median * 1e-3,
                      .stats = lam_factor_get_stats(e.factor)};
}

/* The least times, and the ratio. The caller owns the object. */
static json_t *comparison_json(const char *net, int vertices, const comparison *c) {
  return json_pack("{s:s, s:s, s:i, s:f, s:f, s:f, s:f, s:f}", "section", "factor", "net", net,
                   "vertices", vertices, "iteration_ms", c->iteration.least, "factor_ms",
                   c->factor.least, "solved_ms", c->alone.least, "ratio", c->ratio, "flops",
                   c->stats.flops);
}

/* Medians, with the least times beside them. */
static void print_comparison(FILE *out, int vertices, const comparison *c) {
  fprintf(out,
          "asymptotic net with right angles, %d vertices, %d times, median (least)\n"
          "  one iteration %.1f (%.1f) ms; of it factorize %.1f (%.1f), with solve %.1f (%.1f); "
          "%.2f Gflop, %.1f M entries\n"
          "  one iteration / factorize and solve: %.2f (median of %d pairs)\n",
          vertices, repeats, c->iteration.median, c->iteration.least, c->factor.median,
          c->factor.least, c->alone.median, c->alone.least, c->stats.flops * 1e-9,
          c->stats.entries * 1e-6, c->ratio, repeats);
}

bool lam_bench_asymptotic(lam_bench *bench, int cells, lam_bench_equations *equations,
                          int *vertices) {
  lam_bench_case what = {.kind = "asymptotic",
                         .keys = "orthogonal: yes",
                         .solver = "{}",
                         .surface = "{kind: enneper, u: [-0.8, 0.8], v: [-0.8, 0.8]}",
                         .grid = {cells, cells + 1},
                         .noise = .05};
  lam_net_job job;
  lam_net net;
  if (!lam_bench_net(bench, &what, &job, &net)) return false;
  *equations = equations_of(bench->arena, &job, &net);
  *vertices = net.mesh.vertex_count;
  return true;
}

/* False with errors. */
static bool factor_of_iteration(lam_bench *bench) {
  lam_bench_equations equations;
  int vertices;
  if (!lam_bench_asymptotic(bench, 68, &equations, &vertices)) return false;

  comparison c = compare(equations);
  if (bench->json)
    json_array_append_new(bench->json, comparison_json("asymptotic", vertices, &c));
  else
    print_comparison(bench->out, vertices, &c);
  return true;
}

/* ---- hard meshes ---- */

/* Planar faces on a mesh of the folder, from where it is. False with errors. */
static bool hard_mesh(lam_bench *bench, const char *mesh) {
  lam_bench_case what = {.kind = "planar-quads",
                         .keys = "",
                         .solver = "{tolerance: 1e-6}",
                         .mesh = mesh,
                         .measure = "face_planarity",
                         .repeats = 3};
  lam_bench_result r;
  if (!lam_bench_run_case(bench, &what, &r)) return false;

  if (bench->json)
    json_array_append_new(bench->json, lam_bench_json("meshes", &what, &r));
  else
    fprintf(bench->out,
            "planar faces, %s, to 1e-6: %s, %d iterations of %.1f ms, %.0f ms in all; planarity "
            "%.1e, shortest edge %.3f\n",
            mesh, r.reason, r.iterations, r.step * 1e3, r.total * 1e3, r.measure, r.shortest_edge);
  return true;
}

bool lam_bench_factor(lam_bench *bench) {
  return factor_of_iteration(bench) && hard_mesh(bench, "bench_wavy_69x70.obj") &&
         hard_mesh(bench, "bench_torus_69x70.obj");
}
