/* Nearly developable surfaces: Newton's method against the two algorithms of Li & Deng, on four
 * general curves (the defaults of the surface kind, figs. 3 and 4) and on a cone, with the same
 * quadrature and exact gradients. Called by bench.c. */
#include "bench/bench.h"
#include "curve/bspline/basis.h"
#include "surf/developable/developable.h"
#include "surf/spline/coons_patch.h"

#include <stdio.h>

/* Four cubic curves that a surface is made between. */
typedef struct boundary_case {
  const char *name;
  lam_vec3 net[4][4]; /* control points of the sides; the four inner ones are not looked at */
} boundary_case;

/* clang-format off */
static const boundary_case cases[] = {
    {"four general curves",
     {{{0, 0, 0},   {-.15, 1, .2}, {.1, 2, .1},  {0, 3, .25}},
      {{1, -.2, .55}, {0, 0, 0},   {0, 0, 0},    {1, 3.15, .95}},
      {{2, .1, .75}, {0, 0, 0},    {0, 0, 0},    {2, 2.9, .8}},
      {{3, 0, .3},  {3.1, 1, -.05}, {3.2, 2, .05}, {3, 3, .05}}}},
    {"a cone",
     {{{0.4, 0.96, 1.04},
       {0.389333333333, 1.211733333333, 1.268266666667},
       {0.355466666667, 1.515733333333, 1.552266666667},
       {0.2912, 1.8816, 1.904}},
      {{0.750666666667, 0.778933333333, 1.007733333333},
       {0, 0, 0},
       {0, 0, 0},
       {1.094666666667, 1.605333333333, 1.753866666667}},
      {{1.0552, 0.493833333333, 1.084833333333},
       {0, 0, 0},
       {0, 0, 0},
       {1.715733333333, 1.090133333333, 1.890666666667}},
      {{1.296, 0.0837, 1.2987},
       {1.5682, 0.175233333333, 1.576233333333},
       {1.868266666667, 0.289533333333, 1.889333333333},
       {2.185, 0.42, 2.225}}}},
};
/* clang-format on */

/* The bilinear Coons surface of the case, where all methods start: boundary curves with v = 0, u =
 * 0, v = 1 and u = 1. knots: of a cubic Bezier curve, kept by pointer. */
static lam_spline_surface coons(lam_arena *arena, const boundary_case *c, const double *knots) {
  lam_vec3 *curve[4];
  for (int i = 0; i < 4; i++) curve[i] = LAM_NEW(arena, lam_vec3, 4);
  for (int k = 0; k < 4; k++) {
    curve[0][k] = c->net[k][0];
    curve[1][k] = c->net[0][k];
    curve[2][k] = c->net[k][3];
    curve[3][k] = c->net[3][k];
  }

  lam_sides sides = {0};
  for (int i = 0; i < LAM_SIDES; i++)
    sides.side[i] = (lam_spline_curve){3, 4, knots, curve[i], NULL};
  return lam_coons_surface(arena, &sides, LAM_COONS_BILINEAR);
}

/* A row of the table, or an object. seconds: of the fastest run; norm: of the Gaussian
 * curvature. */
static void show(lam_bench *bench, const char *name, const char *method,
                 const lam_developable_result *r, double seconds, double norm) {
  if (bench->json)
    json_array_append_new(bench->json,
                          json_pack("{ssssss sisi sfsfsb}", "section", "developable", "case", name,
                                    "method", method, "iterations", r->iterations, "evaluations",
                                    r->evaluations, "seconds", seconds, "norm", norm, "converged",
                                    r->converged));
  else
    fprintf(bench->out, "%-26s %-24s %5d %6d %9.2f  %.10g%s\n", name, method, r->iterations,
            r->evaluations, seconds * 1e3, norm, r->converged ? "" : "  not converged");
}

/* One method on one case, with points x points Gauss points. Results are measured with many more
 * than they were computed with. */
static void run(lam_bench *bench, const boundary_case *c, lam_developable_method method, int points,
                const char *name) {
  enum { repeats = 5 };
  double knots[8], least = INFINITY;
  lam_developable_result result = {0};
  lam_spline_surface surface = {0};
  lam_knots_clamped(3, 4, knots);

  for (int k = 0; k < repeats; k++) {
    surface = coons(bench->arena, c, knots);
    lam_developable_options options = {.method = method, .power = 2, .points = points};
    double since = lam_bench_clock();
    result = lam_developable_solve(bench->arena, &surface, options);
    least = fmin(least, lam_bench_clock() - since);
  }

  double norm = lam_developable_measure(bench->arena, &surface, 40, 200).l2;
  show(bench, c->name, name, &result, least, norm);
}

/* Newton's method with two quadratures, to see what the coarser one costs. */
void lam_bench_developable(lam_bench *bench) {
  if (!bench->json)
    fprintf(bench->out,
            "\nnearly developable surfaces   method                   steps  tried        ms  "
            "||K|| (40 x 40 Gauss points)\n");

  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    run(bench, &cases[i], LAM_DEVELOPABLE_NEWTON, 32, "newton, 32 x 32");
    run(bench, &cases[i], LAM_DEVELOPABLE_NEWTON, 16, "newton, 16 x 16");
    run(bench, &cases[i], LAM_DEVELOPABLE_TRUST_REGION, 16, "trust-region, 16 x 16");
    run(bench, &cases[i], LAM_DEVELOPABLE_QUASI_NEWTON, 16, "quasi-newton, 16 x 16");
  }
}
