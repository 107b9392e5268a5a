/* What remains of the Gaussian curvature, measured on the finished surface by evaluated jets and
 * not by the rule that was minimized with. Called by developable.c for the report, by minimax.c
 * for the bound of the corners, by the benchmark and by the tests. */
#include "core/numeric/quadrature.h"
#include "surf/developable/developable.h"
#include "surf/spline/spline_surface.h"

typedef struct meter {
  const lam_nurbs *nurbs;
  const lam_spline_surface *shape;
} meter;

/* The start of the domain in direction d. */
static double domain_low(const lam_spline_surface *s, int d) { return s->knots[d][s->degree[d]]; }

/* The length of the domain in direction d. */
static double domain_length(const lam_spline_surface *s, int d) {
  return s->knots[d][s->count[d]] - s->knots[d][s->degree[d]];
}

/* ||K||_2, over the parameters scaled to the unit square, and the area, by `points` Gauss points
 * per span and direction. */
static void integrate(lam_arena *arena, const meter *m, int points, lam_developable_measures *out) {
  const lam_spline_surface *s = m->shape;
  double *t = LAM_NEW(arena, double, points), *w = LAM_NEW(arena, double, points), sum = 0;
  double unit = domain_length(s, 0) * domain_length(s, 1);
  lam_gauss_rule(points, t, w);

  for (int a = s->degree[0]; a < s->count[0]; a++)
    for (int b = s->degree[1]; b < s->count[1]; b++) {
      double u = s->knots[0][a], v = s->knots[1][b], du = s->knots[0][a + 1] - u,
             dv = s->knots[1][b + 1] - v;
      for (int g = 0; du * dv > 0 && g < points * points; g++) {
        lam_jet jet;
        lam_nurbs_eval(m->nurbs, u + du * t[g / points], v + dv * t[g % points], &jet);
        double K = lam_jet_curvature(&jet).K, weight = du * dv * w[g / points] * w[g % points];
        sum += weight * K * K / unit;
        out->area += weight * lam_length(lam_cross(jet.u, jet.v));
      }
    }

  out->l2 = sqrt(sum);
}

/* Largest and mean |K|, and the ratio of least to greatest |x_u x x_v|, on (grid + 1)^2 points
 * of the domain, the edges included. */
static void scan(const meter *m, int grid, lam_developable_measures *out) {
  double least = INFINITY, most = 0, sum = 0;

  for (int i = 0; i <= grid; i++)
    for (int j = 0; j <= grid; j++) {
      lam_jet jet;
      lam_nurbs_eval(m->nurbs, domain_low(m->shape, 0) + domain_length(m->shape, 0) * i / grid,
                     domain_low(m->shape, 1) + domain_length(m->shape, 1) * j / grid, &jet);

      double K = fabs(lam_jet_curvature(&jet).K), stretch = lam_length(lam_cross(jet.u, jet.v));
      out->max = fmax(out->max, K);
      sum += K;
      least = fmin(least, stretch);
      most = fmax(most, stretch);
    }

  out->mean = sum / ((grid + 1.) * (grid + 1.));
  out->least_ratio = most > 0 ? least / most : 0;
}

/* The largest -L N / (E G - F^2) of the four corners, 1/m^2: |K| there is at least as large,
 * whatever M is. */
static double corner_bound_of(const meter *m) {
  double bound = 0;
  for (int k = 0; k < 4; k++) {
    lam_jet jet;
    lam_nurbs_eval(m->nurbs, domain_low(m->shape, 0) + (k & 1 ? domain_length(m->shape, 0) : 0),
                   domain_low(m->shape, 1) + (k & 2 ? domain_length(m->shape, 1) : 0), &jet);

    lam_curvature c = lam_jet_curvature(&jet);
    bound = fmax(bound, -c.L * c.N / (c.E * c.G - c.F * c.F));
  }
  return bound;
}

/* K at the corners by evaluated jets. */
double lam_developable_bound(lam_arena *arena, const lam_spline_surface *surface) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  meter m = {lam_nurbs_make(arena, surface), surface};
  double bound = corner_bound_of(&m);
  lam_arena_release(arena, mark);
  return bound;
}

/* Integrals by Gauss's rule, extremes on a grid, the bound from the corners. */
lam_developable_measures lam_developable_measure(lam_arena *arena,
                                                 const lam_spline_surface *surface, int points,
                                                 int grid) {
  lam_developable_measures out = {0};
  lam_arena_mark mark = lam_arena_mark_get(arena);
  meter m = {lam_nurbs_make(arena, surface), surface};
  integrate(arena, &m, points, &out);
  scan(&m, grid, &out);
  out.corner_bound = corner_bound_of(&m);
  lam_arena_release(arena, mark);
  return out;
}
