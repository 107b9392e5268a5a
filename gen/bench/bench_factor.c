#include "bench/bench.h"
#include "solve/assemble.h"

#include <stdio.h>
#include <stdlib.h>

enum { repeats = 15 };

typedef struct spread {
  double least, median; /* milliseconds */
} spread;

static int compare_double(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static spread spread_of(double *seconds) {
  qsort(seconds, repeats, sizeof(double), compare_double);
  return (spread){seconds[0] * 1e3, seconds[repeats / 2] * 1e3};
}

typedef struct comparison {
  spread iteration, factor, alone; /* alone: factorize and solve */
  double ratio;                    /* median of the pairs' */
  lam_factor_stats stats;
} comparison;

/* An iteration, then CHOLMOD's part of it alone on the same matrix; pairs see the same noise of the
 * machine. */
static comparison compare(lam_arena *arena, const lam_net_job *job, const lam_net *net) {
  double unit = lam_net_mean_edge(net, net->mesh.vertices), times[4][repeats];
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    x[v] = lam_scale(net->mesh.vertices[v], 1 / unit);
  lam_errors errors = {.arena = arena};
  lam_problem *problem = lam_problem_new(arena, net->mesh.vertex_count, x);
  lam_scope scope = {.problem = problem, .net = net, .unit = unit, .errors = &errors};
  job->kind->constrain(&scope, job->params, job->location);
  lam_system *system = lam_system_new(arena, problem);
  int n = lam_system_size(system);
  const int *columns = lam_system_columns(system);
  lam_factor *L =
      lam_factor_analyze(arena, n, columns, lam_system_rows(system), lam_system_order(system));
  double *values = LAM_NEW(arena, double, columns[n]), *gradient = LAM_NEW(arena, double, n),
         *step = LAM_NEW(arena, double, n);
  for (int i = 0; i < repeats; i++) {
    double t = lam_bench_clock();
    lam_system_assemble(system, problem->x, (lam_weights){1, 1, 0}, values, gradient);
    lam_system_damp(system, 1e-6, values);
    lam_factor_refactor(L, values);
    lam_factor_solve(L, gradient, step);
    lam_system_residual(system, problem->x, (lam_weights){1, 1, 0});
    times[0][i] = lam_bench_clock() - t;
    t = lam_bench_clock();
    lam_factor_refactor(L, values);
    times[1][i] = lam_bench_clock() - t;
    lam_factor_solve(L, gradient, step);
    times[2][i] = lam_bench_clock() - t;
    times[3][i] = times[0][i] / times[2][i];
  }
  comparison c = {.stats = lam_factor_get_stats(L)};
  c.iteration = spread_of(times[0]);
  c.factor = spread_of(times[1]);
  c.alone = spread_of(times[2]);
  c.ratio = spread_of(times[3]).median * 1e-3;
  return c;
}

static bool factor_of_iteration(lam_bench *bench) {
  static const lam_bench_case what = {.kind = "asymptotic",
                                      .keys = "orthogonal: yes",
                                      .solver = "{}",
                                      .surface = "{kind: enneper, u: [-0.8, 0.8], v: [-0.8, 0.8]}",
                                      .grid = {68, 69},
                                      .noise = .05};
  lam_net_job job;
  lam_net net;
  if (!lam_bench_net(bench, &what, &job, &net)) return false;
  comparison c = compare(bench->arena, &job, &net);
  if (bench->json) {
    json_array_append_new(
        bench->json, json_pack("{s:s, s:s, s:i, s:f, s:f, s:f, s:f, s:f}", "section", "factor",
                               "net", what.kind, "vertices", net.mesh.vertex_count, "iteration_ms",
                               c.iteration.least, "factor_ms", c.factor.least, "cholmod_ms",
                               c.alone.least, "ratio", c.ratio, "flops", c.stats.flops));
    return true;
  }
  fprintf(bench->out,
          "asymptotic net with right angles, %d vertices, %d times, median (least)\n"
          "  one iteration %.1f (%.1f) ms; CHOLMOD on the same matrix: factorize %.1f (%.1f), with "
          "solve %.1f (%.1f); "
          "%.2f Gflop, %.1f M entries\n"
          "  one iteration / CHOLMOD factorize + solve: %.2f (median of %d pairs)\n",
          net.mesh.vertex_count, repeats, c.iteration.median, c.iteration.least, c.factor.median,
          c.factor.least, c.alone.median, c.alone.least, c.stats.flops * 1e-9,
          c.stats.entries * 1e-6, c.ratio, repeats);
  return true;
}

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
