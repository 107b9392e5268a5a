/* The helicoid x = (u cos v, u sin v, h v), h = +-1; one line in surfaces.c. Rulings (v =
 * const) and helices (u = const) are both asymptotic and cross at right angles: L = N = 0, F =
 * 0. With u = sinh p, v = q they become isothermic, E = G = cosh^2 p, and the curvature lines
 * are the diagonals. */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The parameters of a row, and the data: 0 right, 1 left. */
typedef struct lam_helicoid {
  int hand;
} lam_helicoid;

/* x_u is the unit vector of the ruling. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  double c = cos(v), s = sin(v), rise = ((const lam_helicoid *)data)->hand == 0 ? 1 : -1;
  jet->x = lam_v3(u * c, u * s, rise * v);
  jet->u = lam_v3(c, s, 0);
  jet->v = lam_v3(-u * s, u * c, rise);
  jet->uu = lam_v3(0, 0, 0);
  jet->uv = lam_v3(-s, c, 0);
  jet->vv = lam_v3(-u * c, -u * s, 0);
}

/* Half a turn; for the diagonals a square around the axis. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  static const lam_domain domains[LAM_CHART_COUNT] = {
      [LAM_CHART_NATURAL] = {{-1.5, 1.5}, {0, LAM_PI}, {false, false}},
      [LAM_CHART_ASYMPTOTIC] = {{-1.2, 1.2}, {0, LAM_PI}, {false, false}},
      [LAM_CHART_PRINCIPAL] = {{-0.7, 0.7}, {-0.7, 0.7}, {false, false}}};
  return chart != LAM_CHART_DIAGONAL && lam_domain_give(domains[chart], p, q, closed);
}

/* First from the diagonals to p, q, then u = sinh p. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_PRINCIPAL) lam_diagonal(p, q, u, v);
  if (chart != LAM_CHART_NATURAL) *u = sinh(*u);
}

static const char *const hands[] = {"right", "left", NULL};
static const lam_key keys[] = {
    LAM_CHOICE_KEY(lam_helicoid, "hand", hand, "right", hands,
                   "Sense of the screw: right rises counterclockwise seen from above."),
    {0}};

const lam_surface_kind lam_surface_helicoid = {
    .head = {.name = "helicoid",
             .title = "Helicoid",
             .doc = "The spiral stair of minimal surfaces: straight rulings turn about an axis "
                    "while they climb, by 2 pi for one turn. One family of asymptotic lines are "
                    "the rulings, truly straight lamellas that only twist; the other are helices. "
                    "Far from the axis the twist of the rulings fades and the helices become plain "
                    "stair strings. The axis itself is a ruling of the other family: v runs past "
                    "it without a singularity.",
             .equation = "x = (u cos v, u sin v, v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 2-5 and 3-5",
             .keys = keys,
             .params_size = sizeof(lam_helicoid)},
    .eval = eval,
    .domain = domain,
    .locate = locate};
