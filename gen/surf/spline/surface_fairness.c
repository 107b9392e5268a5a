/* How fair a spline surface is, from curvatures at quadrature nodes and along parameter lines.
 * Called by surface_fairing.c; part of the surface kernel. */
#include "surf/spline/surface_fairness.h"
#include "core/numeric/quadrature.h"
#include "surf/spline/spline_edit.h"
#include "surf/surface.h"

/* Nodes of Gauss' rule per direction of a patch. */
enum { RULE = 6 };

/* Forms and curvatures at (u,v). */
static lam_curvature curvature_at(const lam_spline_surface *s, double u, double v) {
  lam_jet jet = lam_spline_surface_jet(s, u, v);
  return lam_jet_curvature(&jet);
}

/* Adds what one quadrature node says. |grad H|^2 = (G H_u^2 - 2 F H_u H_v + E H_v^2) / 
 * (EG - F^2), with H_u and H_v by central differences; size: of the patch in the parameters. */
static void add_node(const lam_spline_surface *s, double u, double v, const double size[2],
                     double weight, lam_surface_fairness *f) {
  lam_curvature c = curvature_at(s, u, v);
  double h[] = {1e-4 * size[0], 1e-4 * size[1]}, det = c.E * c.G - c.F * c.F;
  double hu = (curvature_at(s, u + h[0], v).H - curvature_at(s, u - h[0], v).H) / (2 * h[0]);
  double hv = (curvature_at(s, u, v + h[1]).H - curvature_at(s, u, v - h[1]).H) / (2 * h[1]);

  double area = weight * size[0] * size[1] * sqrt(det);
  f->bending += (c.k1 * c.k1 + c.k2 * c.k2) * area;
  f->curvature_change += (c.G * hu * hu - 2 * c.F * hu * hv + c.E * hv * hv) / det * area;
}

/* The integrals over one patch of the knots. */
static void add_patch(const lam_spline_surface *s, const double low[2], const double size[2],
                      lam_surface_fairness *f) {
  double nodes[RULE], weights[RULE];
  lam_gauss_rule(RULE, nodes, weights);
  for (int i = 0; i < RULE * RULE; i++)
    add_node(s, low[0] + size[0] * nodes[i / RULE], low[1] + size[1] * nodes[i % RULE], size,
             weights[i / RULE] * weights[i % RULE], f);
}

/* Along the line at `across`, direction d: changes of sign of the normal curvature (what is
 * below 1e-9 of the largest one has none), and jumps of H at the breaks. */
static void follow(lam_arena *arena, const lam_spline_surface *s, int d, double across, int count,
                   const double *breaks, int samples, lam_surface_fairness *f) {
  int total = (count - 1) * samples;
  double *bends = LAM_NEW(arena, double, total), most = 0, before = 0;

  /* Normal curvatures in the middles of the parts of every span. */
  for (int i = 0; i < total; i++) {
    int part = i / samples;
    double t = breaks[part] + (i % samples + 0.5) / samples * (breaks[part + 1] - breaks[part]);
    lam_curvature c = curvature_at(s, d ? across : t, d ? t : across);
    bends[i] = d ? c.N / c.G : c.L / c.E;
    most = fmax(most, fabs(bends[i]));
  }

  for (int i = 0; i < total; i++) {
    if (fabs(bends[i]) <= 1e-9 * most) continue;
    f->inflections += bends[i] * before < 0;
    before = bends[i];
  }

  for (int k = 1; k + 1 < count; k++) {
    double low = nextafter(breaks[k], -INFINITY);
    double jump = curvature_at(s, d ? across : breaks[k], d ? breaks[k] : across).H -
                  curvature_at(s, d ? across : low, d ? low : across).H;
    f->curvature_jump = fmax(f->curvature_jump, fabs(jump));
  }
}

/* The distinct knots of the domain; sets count. */
static double *breaks_of(lam_arena *arena, const lam_spline_surface *s, int d, int *count) {
  double *breaks = LAM_NEW(arena, double, s->count[d] + 1);
  *count = 0;
  for (int i = s->degree[d]; i <= s->count[d]; i++)
    if (*count == 0 || s->knots[d][i] > breaks[*count - 1]) breaks[(*count)++] = s->knots[d][i];
  return breaks;
}

/* Integrals patch by patch, then lines in the middle of every span of both directions. */
lam_surface_fairness lam_spline_surface_fairness(lam_arena *arena, const lam_spline_surface *s,
                                                 int samples) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_surface_fairness f = {0};
  int count[2];
  const double *breaks[2] = {breaks_of(arena, s, 0, &count[0]), breaks_of(arena, s, 1, &count[1])};

  for (int i = 0; i + 1 < count[0]; i++)
    for (int j = 0; j + 1 < count[1]; j++) {
      const double low[] = {breaks[0][i], breaks[1][j]};
      const double size[] = {breaks[0][i + 1] - low[0], breaks[1][j + 1] - low[1]};
      add_patch(s, low, size, &f);
    }

  for (int d = 0; d < 2; d++)
    for (int i = 0; i + 1 < count[1 - d]; i++)
      follow(arena, s, d, (breaks[1 - d][i] + breaks[1 - d][i + 1]) / 2, count[d], breaks[d],
             samples, &f);

  lam_arena_release(arena, mark);
  return f;
}
