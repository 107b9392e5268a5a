/* Scherk's doubly periodic surface z = ln(cos u / cos v) over the square |u|, |v| < pi/2; one
 * line in surfaces.c.
 *
 * II ~ -du^2/cos^2 u + dv^2/cos^2 v, so with the inverse Gudermannians X = asinh(tan u),
 * Y = asinh(tan v) the asymptotic lines are X = a - b, Y = a + b. Along them
 *   E = 2 (1 - sin u sin v) = 2 cosh(2b) / (cosh X cosh Y),  G = 2 cosh(2a) / (cosh X cosh Y),
 * so d p = d a / sqrt(cosh 2a) (and q from b alike) makes them isothermic:
 *   sqrt(2) sinh a = sc(sqrt(2) p | m = 1/2),  sc = sn/cn.
 * The whole surface is the square |p|, |q| < K(1/2)/sqrt(2) = 1.31103. Curvature lines are the
 * diagonals. */
#include "surf/elliptic.h"
#include "surf/surface_kind.h"

/* The elliptic functions of m = 1/2; there are no parameters. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  (void)params;
  (void)location;
  (void)errors;
  lam_elliptic *elliptic = LAM_NEW(arena, lam_elliptic, 1);
  *elliptic = lam_elliptic_make(0.5);
  return elliptic;
}

/* d/du ln cos u = -tan u. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  (void)data;
  double a = tan(u), b = tan(v);
  jet->x = lam_v3(u, v, log(cos(u) / cos(v)));
  jet->u = lam_v3(1, 0, -a);
  jet->v = lam_v3(0, 1, b);
  jet->uu = lam_v3(0, 0, -1 - a * a);
  jet->uv = lam_v3(0, 0, 0);
  jet->vv = lam_v3(0, 0, 1 + b * b);
}

/* Away from the sides, where the surface rises without end. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  static const lam_domain domains[LAM_CHART_COUNT] = {
      [LAM_CHART_NATURAL] = {{-1.3, 1.3}, {-1.3, 1.3}, {false, false}},
      [LAM_CHART_ASYMPTOTIC] = {{-0.9, 0.9}, {-0.9, 0.9}, {false, false}},
      [LAM_CHART_PRINCIPAL] = {{-0.6, 0.6}, {-0.6, 0.6}, {false, false}}};
  return chart != LAM_CHART_DIAGONAL && lam_domain_give(domains[chart], p, q, closed);
}

/* a from p, or b from q. */
static double unscale(const lam_elliptic *elliptic, double p) {
  lam_jacobi j = lam_jacobi_eval(elliptic, M_SQRT2 * p);
  return asinh(M_SQRT1_2 * j.sn / j.cn);
}

/* From the diagonals to p, q, to a, b, to X, Y, to u, v. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_NATURAL) return;
  if (chart == LAM_CHART_PRINCIPAL) lam_diagonal(p, q, u, v);

  lam_diagonal(unscale(data, *u), unscale(data, *v), u, v);
  *u = atan(sinh(*u));
  *v = atan(sinh(*v));
}

const lam_surface_kind lam_surface_scherk = {
    .head = {.name = "scherk",
             .title = "Scherk's doubly periodic surface",
             .doc = "A minimal surface over a square whose four sides rise and fall without end, "
                    "like a chessboard of towers. The middle is a calm saddle with straight "
                    "diagonals, a good canopy on four supports. Its asymptotic lines are "
                    "orthogonal; here they are spaced so that the meshes are squares. The height "
                    "grows beyond all bounds towards u, v = pi/2: keep away from the sides.",
             .equation = "z = ln(cos u / cos v)",
             .source = "Dierkes et al., Minimal Surfaces, 3.5"},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = locate};
