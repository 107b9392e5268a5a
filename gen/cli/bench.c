/* lamella bench [MESHES]: how fast the solver is, as ratios measured in one run. */
#include "cli/complain.h"
#include "cli/mesh_files.h"
#include "cli/run.h"
#include "cli/verbs.h"
#include "design/design.h"
#include "net/optimize.h"
#include "net/start.h"
#include "solve/assemble.h"
#include "surf/place.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char usage[] = "usage: lamella bench [FOLDER]\n"
                            "  FOLDER  has bench_wavy_69x70.obj and bench_torus_69x70.obj (default: tests/cases/nets)";

enum { repeats = 15 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare_double(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

typedef struct spread {
  double least, median;
} spread;

static spread spread_of(double *seconds, int count) {
  qsort(seconds, (size_t)count, sizeof(double), compare_double);
  return (spread){seconds[0] * 1e3, seconds[count / 2] * 1e3};
}

static void print_solution(const lam_net_result *r) {
  const lam_solution *s = &r->solution;
  double n = s->iterations > 0 ? s->iterations : 1;
  printf("  %s, %d iterations (%d factorizations), residual %.1e, %.0f ms in all\n", r->reason, s->iterations,
         s->factorizations, s->residual, s->seconds_total * 1e3);
  printf("  ms per iteration: assembly %.2f, factorize %.2f, solve %.2f, together %.2f\n",
         s->seconds_assembly / n * 1e3, s->seconds_factor / n * 1e3, s->seconds_solve / n * 1e3,
         (s->seconds_assembly + s->seconds_factor + s->seconds_solve) / n * 1e3);
  for (int i = 0; i < r->measure_count; i++)
    if (strstr("star_planarity face_planarity angle_deviation shortest_edge foldovers", r->measures[i].name))
      printf("  %-16s max %.3g %s\n", r->measures[i].name, r->measures[i].max, r->measures[i].unit);
}

/* The same matrix again, factorized and solved by CHOLMOD alone. */
static void compare_factor(lam_arena *arena, const lam_net_job *job, const lam_net *net) {
  double unit = lam_net_mean_edge(net, net->mesh.vertices), iteration[repeats], alone[repeats], factor[repeats],
         ratio[repeats];
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) x[v] = lam_scale(net->mesh.vertices[v], 1 / unit);
  lam_errors errors = {.arena = arena};
  lam_problem *problem = lam_problem_new(arena, net->mesh.vertex_count, x);
  lam_scope scope = {.problem = problem, .net = net, .unit = unit, .errors = &errors};
  job->kind->constrain(&scope, job->params, job->place);
  double t = now();
  lam_system *system = lam_system_new(arena, problem);
  int n = lam_system_size(system);
  const int *columns = lam_system_columns(system);
  lam_factor *L = lam_factor_analyze(arena, n, columns, lam_system_rows(system), lam_system_order(system));
  printf("  pattern and symbolic analysis, once: %.1f ms\n", (now() - t) * 1e3);
  double *values = LAM_NEW(arena, double, columns[n]), *gradient = LAM_NEW(arena, double, n),
         *step = LAM_NEW(arena, double, n);
  lam_weights weights = {1, 1, 0};
  for (int i = 0; i < repeats; i++) { /* an iteration, then CHOLMOD's part of it alone; pairs see the same noise */
    t = now();
    lam_system_assemble(system, problem->x, weights, values, gradient);
    lam_system_damp(system, 1e-6, values);
    lam_factor_refactor(L, values);
    lam_factor_solve(L, gradient, step);
    lam_system_residual(system, problem->x, weights);
    iteration[i] = now() - t;
    t = now();
    lam_factor_refactor(L, values);
    factor[i] = now() - t;
    lam_factor_solve(L, gradient, step);
    alone[i] = now() - t;
    ratio[i] = iteration[i] / alone[i] * 1e-3; /* spread_of gives thousandths */
  }
  lam_factor_stats stats = lam_factor_get_stats(L);
  spread whole = spread_of(iteration, repeats), cholmod = spread_of(alone, repeats),
         numeric = spread_of(factor, repeats), ratios = spread_of(ratio, repeats);
  printf("  again, %d times, median (least): one iteration %.1f (%.1f) ms; CHOLMOD on the same matrix: factorize %.1f "
         "(%.1f), "
         "with solve %.1f (%.1f); %.2f Gflop, %.1f M entries\n",
         repeats, whole.median, whole.least, numeric.median, numeric.least, cholmod.median, cholmod.least,
         stats.flops * 1e-9, stats.entries * 1e-6);
  printf("  one iteration / CHOLMOD factorize + solve: %.2f (median of %d pairs)\n", ratios.median, repeats);
}

static const char anet_design[] = "lamella: 1\nname: bench\ntitle: bench\n"
                                  "surface: {kind: enneper, u: [-0.8, 0.8], v: [-0.8, 0.8]}\n"
                                  "net: {kind: asymptotic, grid: [68, 69], orthogonal: yes}\n";
static const char planar_design[] = "lamella: 1\nname: bench\ntitle: bench\n"
                                    "net: {kind: planar-quads, from: {file: x.obj}, solver: {tolerance: 1e-6}}\n";

static bool parse(lam_arena *arena, const char *text, lam_errors *errors, lam_design *design) {
  return lam_design_parse(arena, text, strlen(text), "bench", NULL, 0, errors, design);
}

static bool run_job(lam_arena *arena, const lam_design *design, lam_net *net, lam_errors *errors, lam_net_job *job,
                    lam_net_result *result) {
  *job = (lam_net_job){(const lam_net_kind *)design->net.head, design->net.params, design->net.common, NULL, {0}, NULL};
  return lam_net_optimize(arena, job, net, errors, result);
}

static bool bench_anet(lam_arena *arena, lam_errors *errors) {
  lam_design design;
  lam_mesh mesh;
  lam_net net;
  lam_net_job job;
  lam_net_result result;
  if (!parse(arena, anet_design, errors, &design)) return false;
  const lam_net_common *common = design.net.common;
  lam_surface surface = lam_surface_make(arena, &design.surface, errors);
  if (!lam_net_start(arena, &surface, LAM_CHART_ASYMPTOTIC, common->grid, 0, design.surface.common, (lam_place){0},
                     errors, &mesh, NULL) ||
      !lam_net_build(arena, &mesh, (lam_place){0}, errors, &net))
    return false;
  lam_mesh_perturb(&net.mesh, .05 * lam_net_mean_edge(&net, net.mesh.vertices), 1);
  printf("A-net with right angles, 69 x 70 vertices, Enneper patch with noise of 0.05 edges\n");
  if (!run_job(arena, &design, &net, errors, &job, &result)) return false;
  print_solution(&result);
  compare_factor(arena, &job, &net);
  return true;
}

static bool bench_planar(lam_arena *arena, const char *folder, const char *name, lam_errors *errors) {
  lam_design design;
  lam_mesh mesh;
  lam_net net;
  lam_net_job job;
  lam_net_result result;
  const char *path = lam_arena_printf(arena, "%s/%s", folder, name);
  if (!parse(arena, planar_design, errors, &design) || !lam_input_mesh(arena, path, errors, &mesh) ||
      !lam_net_build(arena, &mesh, (lam_place){.file = path}, errors, &net))
    return false;
  printf("planar faces, %s, to 1e-6\n", name);
  if (!run_job(arena, &design, &net, errors, &job, &result)) return false;
  print_solution(&result);
  return true;
}

static int bench(lam_arena *arena, int argc, char **argv) {
  lam_errors errors = {.arena = arena};
  if (argc > 2 || (argc == 2 && argv[1][0] == '-')) {
    bool help = strcmp(argv[1], "--help") == 0;
    return help ? puts(usage) < 0 : lam_complain_plain(2, "bench: %s is not expected here\n%s", argv[1], usage);
  }
  const char *folder = argc > 1 ? argv[1] : "tests/cases/nets";
  printf("dense kernels: %s%s%s\n", lam_blas_kernel(), lam_blas_advice() ? "; " : "",
         lam_blas_advice() ? lam_blas_advice() : "");
  bool done = bench_anet(arena, &errors) && bench_planar(arena, folder, "bench_wavy_69x70.obj", &errors) &&
              bench_planar(arena, folder, "bench_torus_69x70.obj", &errors);
  return done ? 0 : lam_complain(&errors);
}

int lam_verb_bench(int argc, char **argv) { return lam_verb_run(bench, argc, argv); }
