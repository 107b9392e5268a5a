/* The catenoid x = (cosh v cos u, cosh v sin u, v), one line in surfaces.c. E = G = cosh^2 v:
 * isothermic. With the outward normal II = -du^2 + dv^2, so the asymptotic lines are
 * u +- v = const, and they are the diagonals of the curvature lines. */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The meridian r = cosh v, z = v. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  (void)data;
  double c = cosh(v), s = sinh(v);
  lam_jet_revolve((lam_meridian){.r = c, .dr = s, .ddr = c, .z = v, .dz = 1}, u, jet);
}

/* Rings, or the square of their diagonals that reaches about as far. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  lam_domain rings = {{0, 2 * LAM_PI}, {-1.3, 1.3}, {true, false}},
             diagonals = {{-0.7, 0.7}, {-0.7, 0.7}, {false, false}};
  bool diagonal = chart == LAM_CHART_ASYMPTOTIC || chart == LAM_CHART_DIAGONAL;
  return lam_domain_give(diagonal ? diagonals : rings, p, q, closed);
}

/* The principal chart is the natural one; asymptotic lines are its diagonals. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_ASYMPTOTIC || chart == LAM_CHART_DIAGONAL) lam_diagonal(p, q, u, v);
}

const lam_surface_kind lam_surface_catenoid = {
    .head = {.name = "catenoid",
             .title = "Catenoid",
             .doc = "The minimal surface of revolution: the shape of a soap film between two "
                    "rings, and a good waist for a tower or a funnel column. The curvature lines "
                    "are the rings and the hanging-chain meridians; the asymptotic lines are their "
                    "diagonals and cross at right angles everywhere. Radius 1 at the waist. A film "
                    "between rings only exists when their distance is below 1.325 ring radii (|v| "
                    "< 1.2); a gridshell may go further.",
             .equation = "x = (cosh v cos u, cosh v sin u, v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 3-5"},
    .eval = eval,
    .domain = domain,
    .locate = locate};
