/* The pseudosphere x = (cos u / cosh v, sin u / cosh v, v - tanh v), v > 0: K = -1. One line in
 * surfaces.c. E = 1/cosh^2 v, G = tanh^2 v, II ~ du^2 - dv^2: the asymptotic lines are
 * u +- v = const. In u = p - q, v = p + q all of them have unit speed, E + G = 1: a Chebyshev
 * net. */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The meridian is the tractrix r = 1 / cosh v, z = v - tanh v. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  (void)data;
  double r = 1 / cosh(v), t = tanh(v);
  lam_jet_revolve((lam_meridian){.r = r,
                                 .dr = -r * t,
                                 .ddr = r * (t * t - r * r),
                                 .z = v - t,
                                 .dz = t * t,
                                 .ddz = 2 * t * r * r},
                  u, jet);
}

/* Away from the rim v = 0, where the surface is singular. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  static const lam_domain domains[LAM_CHART_COUNT] = {
      [LAM_CHART_NATURAL] = {{0, 2 * LAM_PI}, {0.3, 2.5}, {true, false}},
      [LAM_CHART_ASYMPTOTIC] = {{0.15, 1.25}, {0.15, 1.25}, {false, false}},
      [LAM_CHART_PRINCIPAL] = {{0, 2 * LAM_PI}, {0.3, 2.5}, {true, false}}};
  return chart != LAM_CHART_DIAGONAL && lam_domain_give(domains[chart], p, q, closed);
}

/* Asymptotic lines are the diagonals; the principal chart is the natural one. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_ASYMPTOTIC) lam_diagonal(p, q, u, v);
}

const lam_surface_kind lam_surface_pseudosphere = {
    .head = {.name = "pseudosphere",
             .title = "Pseudosphere",
             .doc = "The trumpet of constant Gaussian curvature -1, turned from a tractrix. Its "
                    "asymptotic lines form a net of equal edges, so a grid of equal rods or a "
                    "loose fabric can be laid on it. The rim v = 0 is a sharp edge where the "
                    "asymptotic lines of both families touch: stay at v > 0.1 or so. Far out the "
                    "trumpet is as thin as 2 exp(-v).",
             .equation = "x = (cos u / cosh v, sin u / cosh v, v - tanh v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 3-3"},
    .eval = eval,
    .domain = domain,
    .locate = locate};
