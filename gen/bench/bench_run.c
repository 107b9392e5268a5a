/* Solving one case several times and keeping the least times, and memory where Linux tells. Called
 * by the sections that solve nets: bench_factor.c, bench_sizes.c, bench_thesis.c; the clock by
 * all. */
#include "bench/bench.h"
#include "core/solid/triangles.h"
#include "design/design.h"
#include "library/read_files.h"
#include "net/trace/start.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* ---- time and memory ---- */

double lam_bench_clock(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Largest resident set since the last reset, bytes, where Linux tells; NAN elsewhere. */
static double peak_memory(void) {
  char line[200];
  double kilobytes = NAN;
  FILE *status = fopen("/proc/self/status", "r");
  while (status && fgets(line, sizeof line, status))
    if (sscanf(line, "VmHWM: %lf", &kilobytes) == 1) break;
  if (status) fclose(status);
  return kilobytes * 1024;
}

/* What is free is given back first, so that it does not count. */
static void reset_peak_memory(void) {
  malloc_trim(0);
  FILE *file = fopen("/proc/self/clear_refs", "w");
  if (!file) return;
  fputs("5", file);
  fclose(file);
}

/* ---- the net of a case ---- */

/* The case as the text of a design, which has the defaults of every design. */
static const char *design_text(lam_arena *arena, const lam_bench_case *what) {
  const char *separator = *what->keys ? ", " : "";
  const char *head =
      lam_arena_printf(arena, "lamella: 1\nname: bench\ntitle: bench\n%s%s\n",
                       what->surface ? "surface: " : "", what->surface ? what->surface : "");

  /* The mesh is read from the folder, whatever the name here. */
  const char *from = what->surface
                         ? lam_arena_printf(arena, "grid: [%d, %d]", what->grid[0], what->grid[1])
                         : "from: {file: x.obj}";
  return lam_arena_printf(arena, "%snet: {kind: %s%s%s, %s, solver: %s}\n", head, what->kind,
                          separator, what->keys, from, what->solver);
}

/* The mesh that the net starts from: of the folder, or of lines on the surface. */
static bool start_mesh(lam_bench *bench, const lam_bench_case *what, const lam_design *design,
                       lam_mesh *mesh) {
  if (!what->surface)
    return lam_input_mesh(bench->arena,
                          lam_arena_printf(bench->arena, "%s/%s", bench->folder, what->mesh),
                          bench->errors, mesh);

  lam_surface surface = lam_surface_make(bench->arena, &design->surface, bench->errors);
  const lam_net_kind *kind = (const lam_net_kind *)design->net.head;
  const lam_net_common *common = design->net.common;
  return surface.kind &&
         lam_net_start(bench->arena, &surface, kind->chart, common->grid, 0, design->surface.common,
                       (lam_location){0}, bench->errors, mesh, NULL);
}

/* The same seed of the noise every time: runs are compared. */
bool lam_bench_net(lam_bench *bench, const lam_bench_case *what, lam_net_job *job, lam_net *net) {
  const char *text = design_text(bench->arena, what);
  lam_design_text source = {.bytes = text, .count = strlen(text), .path = "bench"};
  lam_design design;
  lam_mesh mesh;
  if (!lam_design_parse(bench->arena, &source, bench->errors, &design) ||
      !start_mesh(bench, what, &design, &mesh) ||
      !lam_net_build(bench->arena, &mesh, (lam_location){0}, bench->errors, net))
    return false;

  if (what->noise > 0)
    lam_mesh_perturb(&net->mesh, what->noise * lam_net_mean_edge(net, net->mesh.vertices), 1);

  *job = (lam_net_job){.kind = (const lam_net_kind *)design.net.head,
                       .params = design.net.params,
                       .common = design.net.common};
  return true;
}

/* ---- solving it ---- */

/* Times go to the result where they are less than those before. */
static void keep_times(const lam_solution *s, lam_bench_result *out) {
  double n = s->factorizations > 0 ? s->factorizations : 1;
  double step = (s->seconds_assembly + s->seconds_factor + s->seconds_solve) / n;
  if (s->seconds_total < out->total) {
    out->total = s->seconds_total;
    out->analysis = s->seconds_analysis;
  }
  if (step < out->step) {
    out->step = step;
    out->assembly = s->seconds_assembly / n;
    out->factor = s->seconds_factor / n;
    out->solve = s->seconds_solve / n;
  }
}

/* Everything else is the same in every run. */
static void keep_result(lam_arena *arena, const lam_bench_case *what, const lam_net *net,
                        const lam_net_result *r, lam_bench_result *out) {
  const lam_solution *s = &r->solution;
  keep_times(s, out);

  out->vertices = net->mesh.vertex_count;
  out->unknowns = s->unknowns;
  out->iterations = s->iterations;
  out->factorizations = s->factorizations;
  out->converged = r->converged;
  out->residual = s->residual;
  out->flops = s->factor.flops;
  out->entries = s->factor.entries;
  snprintf(out->reason, sizeof out->reason, "%s", r->reason);

  out->shortest_edge = lam_net_measure_one(arena, net, net->mesh.vertices, "shortest_edge").max;
  for (int i = 0; what->measure && i < r->measure_count; i++)
    if (strcmp(r->measures[i].name, what->measure) == 0) out->measure = r->measures[i].max;
}

/* From the text of the design to the solved net. False with errors. */
static bool run_once(lam_bench *bench, const lam_bench_case *what, lam_bench_result *result) {
  lam_net net;
  lam_net_job job;
  lam_net_result solved;
  if (!lam_bench_net(bench, what, &job, &net) ||
      !lam_net_optimize(bench->arena, &job, &net, bench->errors, &solved))
    return false;
  keep_result(bench->arena, what, &net, &solved, result);
  return true;
}

/* The memory of a run is released, so that every run begins alike. */
bool lam_bench_run_case(lam_bench *bench, const lam_bench_case *what, lam_bench_result *result) {
  *result = (lam_bench_result){.total = INFINITY, .step = INFINITY, .measure = NAN};
  bool done = true;

  reset_peak_memory();
  for (int i = 0; done && i < what->repeats; i++) {
    lam_arena_mark mark = lam_arena_mark_get(bench->arena);
    done = run_once(bench, what, result);
    if (done) lam_arena_release(bench->arena, mark); /* messages live in the arena */
  }
  result->memory = peak_memory();
  return done;
}

/* ---- results as JSON ---- */

/* null: unknown, or not a number. */
static json_t *number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

/* What identifies the case, what came of it, times, and the size of the work. */
json_t *lam_bench_json(const char *section, const lam_bench_case *what, const lam_bench_result *r) {
  json_t *out = json_object();
  json_object_set_new(out, "section", json_string(section));
  json_object_set_new(out, "net", json_string(what->kind));
  json_object_set_new(out, "keys", json_string(what->keys));
  json_object_set_new(out, "solver", json_string(what->solver));
  json_object_set_new(out, "start", json_string(what->surface ? what->surface : what->mesh));
  json_object_set_new(out, "noise", json_real(what->noise));

  json_object_set_new(out, "vertices", json_integer(r->vertices));
  json_object_set_new(out, "unknowns", json_integer(r->unknowns));
  json_object_set_new(out, "iterations", json_integer(r->iterations));
  json_object_set_new(out, "factorizations", json_integer(r->factorizations));
  json_object_set_new(out, "converged", json_boolean(r->converged));
  json_object_set_new(out, "reason", json_string(r->reason));
  json_object_set_new(out, "residual", number(r->residual));

  json_object_set_new(out, "analysis_ms", number(r->analysis * 1e3));
  json_object_set_new(out, "assembly_ms", number(r->assembly * 1e3));
  json_object_set_new(out, "factor_ms", number(r->factor * 1e3));
  json_object_set_new(out, "solve_ms", number(r->solve * 1e3));
  json_object_set_new(out, "step_ms", number(r->step * 1e3));
  json_object_set_new(out, "total_ms", number(r->total * 1e3));

  json_object_set_new(out, "peak_bytes", number(r->memory));
  json_object_set_new(out, "flops", number(r->flops));
  json_object_set_new(out, "factor_entries", number(r->entries));
  json_object_set_new(out, "shortest_edge", number(r->shortest_edge));
  if (what->measure) json_object_set_new(out, what->measure, number(r->measure));
  return out;
}
