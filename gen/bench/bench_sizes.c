/* Every net of the table of starts, growing: how the time of a step grows with the number of
 * vertices. Called by bench.c. */
#include "bench/bench.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Vertices of the nets, about. */
static const int sizes[] = {441, 1681, 4761, 40401};
enum { size_count = sizeof sizes / sizeof *sizes };

/* Cells of a grid with about so many vertices: multiples of four, which coarser nets divide. */
static void grid_of(int vertices, double aspect, int grid[2]) {
  double n = sqrt(vertices * aspect);
  grid[0] = 4 * (int)lround((n - 1) / 4);
  grid[1] = 4 * (int)lround((vertices / n - 1) / 4);
}

/* A row of the table. growth: the exponent of the time of a step in the number of vertices, between
 * this net and the smaller one before it (NULL: none). */
static void print_row(const lam_bench *bench, const lam_bench_case *what, const lam_bench_result *r,
                      const lam_bench_result *smaller) {
  char growth[16] = "";
  if (smaller)
    snprintf(growth, sizeof growth, "%.2f",
             log(r->step / smaller->step) / log((double)r->vertices / smaller->vertices));

  char memory[16] = "-";
  if (isfinite(r->memory)) snprintf(memory, sizeof memory, "%.0f", r->memory / 1048576);

  fprintf(bench->out,
          "  %-18s %8d %9d %5d %5d %9.2f %8.2f %8.2f %7.2f %9.1f %7s %6s %7.3f %9.1e  %s\n",
          what->kind, r->vertices, r->unknowns, r->iterations, r->factorizations, r->step * 1e3,
          r->assembly * 1e3, r->factor * 1e3, r->solve * 1e3, r->total * 1e3, memory, growth,
          r->shortest_edge, r->measure, r->converged ? "" : r->reason);
  fflush(bench->out);
}

/* Solves one kind of net on ever finer grids. False with errors. */
static bool run_start(lam_bench *bench, const lam_bench_start *start) {
  lam_bench_result before;
  for (int i = 0; i < size_count && sizes[i] <= bench->most; i++) {
    lam_bench_case what = {.kind = start->kind,
                           .keys = start->keys,
                           .solver = "{tolerance: 1e-8}",
                           .surface = start->surface,
                           .noise = start->noise,
                           .measure = start->measure,
                           .repeats = sizes[i] < 10000 ? 3 : 1};
    grid_of(sizes[i], start->aspect, what.grid);

    lam_bench_result result;
    if (!lam_bench_run_case(bench, &what, &result)) return false;

    if (bench->json)
      json_array_append_new(bench->json, lam_bench_json("sizes", &what, &result));
    else
      print_row(bench, &what, &result, i ? &before : NULL);
    before = result;
  }
  return true;
}

/* The start of a kind of net, or NULL. */
static const lam_bench_start *start_of(const char *kind) {
  for (int i = 0; i < lam_bench_start_count; i++)
    if (strcmp(lam_bench_starts[i].kind, kind) == 0) return &lam_bench_starts[i];
  return NULL;
}

/* What the columns mean. */
static void print_head(const lam_bench *bench) {
  fprintf(bench->out,
          "every net, to a residual of 1e-8; its: also those on coarser nets; tried: steps with "
          "those that were rejected; processor time, the least of three runs (one above 10,000 "
          "vertices)\n"
          "  %-18s %8s %9s %5s %5s %9s %8s %8s %7s %9s %7s %6s %7s %9s\n",
          "net", "vertices", "unknowns", "its", "tried", "ms/step", "assemble", "factor", "solve",
          "in all", "MB peak", "growth", "s. edge", "measure");
}

/* In the order of the registry. Kinds that the table forgets are named at the end. */
bool lam_bench_sizes(lam_bench *bench) {
  if (!bench->json) print_head(bench);

  bool done = true;
  const char *without = "";
  for (int i = 0; done && i < lam_nets.count; i++) {
    const char *kind = lam_nets.rows[i]->name;
    if (bench->only && strcmp(bench->only, kind) != 0) continue;

    const lam_bench_start *start = start_of(kind);
    if (start)
      done = run_start(bench, start);
    else
      without = lam_arena_printf(bench->arena, "%s%s%s", without, *without ? ", " : "", kind);
  }

  if (!bench->json && *without) fprintf(bench->out, "  no start in the table for: %s\n", without);
  return done;
}
