/* Surfaces of least area: four ways from the same start to within a millionth of the least area.
 * Called by bench.c. */
#include "bench/bench.h"
#include "surf/area/least_area.h"

#include <math.h>
#include <stdio.h>

enum { spans = 8, most_steps = 400, repeats = 3 };

/* The methods of lam_least_area_method from the refined start, and Newton's method on ever finer
 * splines. */
static const char *const methods[] = {"Newton", "I-functional", "L-BFGS", "coarse to fine"};
enum { coarse_to_fine = 3, method_count = 4 };

/* A boundary of four cubics: x, y, z and weight of its points, and the least area over it, m^2. */
typedef struct boundary {
  const char *name;
  double least, points[12][4];
} boundary;

/* Examples 1, 3 and 4 of Wu & Wang; the least areas are extrapolated from splines with up to 32 x
 * 32 spans. */
/* clang-format off */
static const boundary boundaries[] = {
    {"example 1", 12.83575753,
     {{-1, 2, 1, 2},    {-1, 0, 2.72, 1},    {-1, 0, -2.72, 1},    {-1, -2, -1, 2},
      {-0.5, 2, -2, 1}, {-0.5, -2, 2, 1},
      {0.5, 2, -2, 1},  {0.5, -2, 2, 1},
      {1, 2, 1, 2},     {1, 0, 2.72, 1},     {1, 0, -2.72, 1},     {1, -2, -1, 2}}},
    {"example 3", 2.834509634,
     {{-1, 1, 0, 1},    {-1, 1, -2, 1. / 3}, {1, 1, -2, 1. / 3},   {1, 1, 0, 1},
      {0.75, 1, 0, 0.2}, {-0.75, 1, 0, 0.2},
      {0.5, -1, 0, 0.2}, {-0.5, -1, 0, 0.2},
      {-0.5, -1, 0, 1}, {-0.5, -1, -1, 1. / 3}, {0.5, -1, -1, 1. / 3}, {0.5, -1, 0, 1}}},
    {"example 4", 8.258297188,
     {{-1, 1, 0, 1},    {-1, 1, -2, 1. / 3}, {1, 1, -2, 1. / 3},   {1, 1, 0, 1},
      {-3, 1, 0, 1. / 3}, {3, 1, 0, 1. / 3},
      {-3, -1, 0, 1. / 3}, {3, -1, 0, 1. / 3},
      {-1, -1, 0, 1},   {-1, -1, -2, 1. / 3}, {1, -1, -2, 1. / 3}, {1, -1, 0, 1}}},
};
/* clang-format on */

/* The bicubic Bezier surface with the boundary points, row by row; inner points are at the origin,
 * with weight 1. */
static lam_spline_surface surface_between(lam_arena *arena, const double given[12][4]) {
  static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, 16);
  double *weights = LAM_NEW(arena, double, 16);

  for (int k = 0, from = 0; k < 16; k++) {
    bool inner = k / 4 % 3 && k % 4 % 3;
    points[k] = inner ? lam_v3(0, 0, 0) : lam_v3(given[from][0], given[from][1], given[from][2]);
    weights[k] = inner ? 1 : given[from][3];
    from += !inner;
  }

  return (lam_spline_surface){NULL, {3, 3}, {4, 4}, {knots, knots}, points, weights};
}

/* A row of the table, or an object. least: m^2; the excess over it is measured by another
 * quadrature than was minimized with. */
static void show(lam_bench *bench, const char *name, const char *method,
                 const lam_least_area_result *result, double least, double seconds) {
  double excess = lam_surface_area(bench->arena, &result->surface, 8) / least - 1;
  if (bench->json)
    json_array_append_new(
        bench->json, json_pack("{s:s, s:s, s:s, s:i, s:b, s:f, s:f}", "section", "surfaces",
                               "boundary", name, "method", method, "iterations", result->iterations,
                               "reached", result->converged, "excess", excess, "total", seconds));
  else
    fprintf(bench->out, "%-10s  %-15s %6d steps  %8.3f s  excess %.1e%s\n", name, method,
            result->iterations, seconds, excess, result->converged ? "" : "  (not reached)");
}

/* Runs a method several times and shows its last result with the time of the fastest run. All but
 * the last one stop a millionth above the least area; that one stops by itself. */
static void run(lam_bench *bench, const boundary *b, int method) {
  lam_spline_surface coarse = surface_between(bench->arena, b->points);
  coarse = lam_least_area_dirichlet(bench->arena, &coarse);
  lam_spline_surface start = lam_spline_surface_refine(bench->arena, &coarse, spans);

  lam_least_area_options options = lam_least_area_defaults();
  options.most = most_steps;
  options.enough = method < coarse_to_fine ? b->least * (1 + 1e-6) : 0;
  if (method < coarse_to_fine) options.method = (lam_least_area_method)method;

  lam_least_area_result result = {0};
  double fastest = INFINITY;
  for (int k = 0; k < repeats; k++) {
    double since = lam_bench_clock();
    result = method < coarse_to_fine ? lam_least_area_minimize(bench->arena, &start, &options)
                                     : lam_least_area_solve(bench->arena, &coarse, spans, &options);
    fastest = fmin(fastest, lam_bench_clock() - since);
  }
  show(bench, b->name, methods[method], &result, b->least, fastest);
}

/* Every boundary by every method; the memory of a run is released before the next one. */
bool lam_bench_surfaces(lam_bench *bench) {
  if (!bench->json)
    fprintf(bench->out,
            "\nleast area on %d x %d spans, to 1e-6 above the least area, from the same start\n",
            spans, spans);

  for (size_t b = 0; b < sizeof boundaries / sizeof *boundaries; b++)
    for (int m = 0; m < method_count; m++) {
      lam_arena_mark mark = lam_arena_mark_get(bench->arena);
      run(bench, &boundaries[b], m);
      lam_arena_release(bench->arena, mark);
    }
  return true;
}
