/* The solver of lamella and that of the thesis side by side, on nets of the thesis' size. Called by
 * bench.c. */
#include "bench/bench.h"

#include <stdio.h>
#include <string.h>

/* Nets of table 3.2's largest row (117 x 41 vertices), solved by both methods one after the other
 * in the same minute. */
static const lam_bench_case cases[] = {
    {.kind = "geodesic-parallel",
     .keys = "geodesics: 1",
     .surface = "{kind: revolution, u: [0, 1], v: [0.1, 0.9]}",
     .grid = {40, 116},
     .noise = .05,
     .measure = "geodesic_error_v"},
    {.kind = "asymptotic",
     .keys = "orthogonal: yes",
     .surface = "{kind: enneper, u: [-0.8, 0.8], v: [-0.8, 0.8]}",
     .grid = {68, 69},
     .noise = .05,
     .measure = "star_planarity"},
    {.kind = "planar-quads",
     .keys = "",
     .mesh = "bench_wavy_69x70.obj",
     .measure = "face_planarity"},
};

/* The keys of the solvers, and what they are called in the table. */
static const char *const solvers[] = {
    "{tolerance: 1e-8}", "{method: thesis, tolerance: 1e-8, iterations: 30}",
    "{method: thesis, epsilon: 1e-5, tolerance: 1e-8, iterations: 30}"};
static const char *const names[] = {"lamella", "thesis, eps 1e-3", "thesis, eps 1e-5"};
enum { solver_count = sizeof solvers / sizeof *solvers };

/* What the columns mean. */
static void print_head(const lam_bench *bench) {
  fprintf(bench->out,
          "two methods: vertices as unknowns with damped steps, and auxiliary unknowns with full "
          "steps (thesis 3.7)\n"
          "  %-18s %-17s %8s %9s %5s %9s %6s %9s %8s %9s %9s %7s\n",
          "net", "method", "vertices", "unknowns", "its", "ms/step", "times", "in all", "Gflop",
          "residual", "measure", "s. edge");
}

/* A row of the table. ours: seconds of a step of the first solver. */
static void print_row(const lam_bench *bench, const char *net, const char *method,
                      const lam_bench_result *r, double ours) {
  fprintf(bench->out, "  %-18s %-17s %8d %9d %5d %9.2f %6.1f %9.1f %8.2f %9.1e %9.1e %7.3f  %s\n",
          net, method, r->vertices, r->unknowns, r->iterations, r->step * 1e3, r->step / ours,
          r->total * 1e3, r->flops * 1e-9, r->residual, r->measure, r->shortest_edge,
          r->converged ? "" : r->reason);
  fflush(bench->out);
}

/* One net by all solvers: the first one several times, the slow ones once. False with errors. */
static bool run_case(lam_bench *bench, const lam_bench_case *net) {
  double ours = 0;
  for (int k = 0; k < solver_count; k++) {
    lam_bench_case what = *net;
    what.solver = solvers[k];
    what.repeats = k == 0 ? 3 : 1;

    lam_bench_result result;
    if (!lam_bench_run_case(bench, &what, &result)) return false;

    if (k == 0) ours = result.step;
    if (bench->json)
      json_array_append_new(bench->json, lam_bench_json("thesis", &what, &result));
    else
      print_row(bench, what.kind, names[k], &result, ours);
  }
  return true;
}

/* Kinds that are not in the registry are left out. */
bool lam_bench_thesis(lam_bench *bench) {
  if (!bench->json) print_head(bench);

  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    if (!lam_registry_find(&lam_nets, cases[i].kind)) continue;
    if (bench->only && strcmp(bench->only, cases[i].kind) != 0) continue;
    if (!run_case(bench, &cases[i])) return false;
  }
  return true;
}
