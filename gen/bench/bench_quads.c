/* Surfaces whose sides are asymptotic curves: from corner data to the control net. Called by
 * bench.c. */
#include "bench/bench.h"
#include "surf/asymptotic/asymptotic_quad.h"

#include <math.h>
#include <stdio.h>

enum { repeats = 20 };

/* A roof on four corners that are not in one plane; every side bends into it. Polynomial and
 * rational boundaries exist. */
static const lam_quad_corners roof = {
    .corner = {{0, 0, 0}, {4, 0.2, 1.2}, {-0.3, 3.2, 1}, {4.1, 3.6, -0.2}},
    .tangent = {{{4.025, -0.88, 1.135}, {3.965, 1.45, 0.94}},
                {{-0.98, 3.125, 0.93}, {0.535, 3.25, 0.87}},
                {{4.22, 1.765, -0.995}, {4.33, -0.525, -1.05}},
                {{1.015, 3.4, -1.24}, {-0.63, 3.29, -1.315}}},
    .curvature = {{0.0872, 0.1346}, {0.0882, 0.1715}, {0.1975, 0.067}, {0.157, 0.0948}},
    .side = {{1, 1}, {1, 1}, {1, 1}, {1, 1}},
    .weight = {1, 1, 1, 1}};

/* Makes the patch several times; *fastest: seconds of the fastest run. False with errors. */
static bool make_patch(lam_bench *bench, lam_quad_form form, lam_asymptotic_patch *patch,
                       double *fastest) {
  *fastest = INFINITY;
  for (int k = 0; k < repeats; k++) {
    double since = lam_bench_clock();
    if (!lam_asymptotic_patch_make(bench->arena, &roof, form, (lam_location){0}, bench->errors,
                                   patch))
      return false;
    *fastest = fmin(*fastest, lam_bench_clock() - since);
  }
  return true;
}

/* A row of the table, or an object. ratio: the greatest |normal curvature| / curvature of a
 * side. */
static void show(lam_bench *bench, const char *name, const lam_asymptotic_patch *patch,
                 double seconds, double ratio) {
  if (bench->json)
    json_array_append_new(bench->json, json_pack("{s:s, s:s, s:f, s:f, s:f}", "section",
                                                 "asymptotic", "form", name, "residual", ratio,
                                                 "energy", patch->energy, "total", seconds));
  else
    fprintf(bench->out, "asymptotic patch, %-6s %2d x %2d points %8.2f ms  %.1e\n", name,
            patch->surface.count[0], patch->surface.count[1], seconds * 1e3, ratio);
}

/* The memory of a form is released before the next one. */
bool lam_bench_quads(lam_bench *bench) {
  static const lam_quad_form forms[] = {LAM_QUAD_BI7, LAM_QUAD_BI11, LAM_QUAD_BI13};
  if (!bench->json)
    fprintf(bench->out, "\nasymptotic patch, from corner data to control points: "
                        "|normal curvature| of the sides over their curvature\n");

  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
    lam_arena_mark mark = lam_arena_mark_get(bench->arena);
    lam_asymptotic_patch patch;
    double fastest, ratio, sine;
    if (!make_patch(bench, forms[i], &patch, &fastest)) return false;

    lam_asymptotic_residuals(bench->arena, &patch.surface, (const bool[4]){false}, 50, &ratio,
                             &sine);
    show(bench, lam_quad_form_names[forms[i]], &patch, fastest, ratio);
    lam_arena_release(bench->arena, mark);
  }
  return true;
}
