/* The sphere x = radius (cos v cos u, cos v sin u, sin v), one line in surfaces.c: longitude
 * and latitude. Every line on it is a curvature line; the principal chart is the isothermic
 * one, Mercator's: v = atan(sinh q). */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The parameters of a row, and the data. */
typedef struct lam_sphere {
  double radius;
} lam_sphere;

/* The meridian is a circle. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  double c = ((const lam_sphere *)data)->radius * cos(v),
         s = ((const lam_sphere *)data)->radius * sin(v);
  lam_jet_revolve((lam_meridian){.r = c, .dr = -s, .ddr = -c, .z = s, .dz = c, .ddz = -s}, u, jet);
}

/* To 1.2 radians of latitude, north and south. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  bool known = chart == LAM_CHART_NATURAL || chart == LAM_CHART_PRINCIPAL;
  double top = chart == LAM_CHART_PRINCIPAL ? asinh(tan(1.2)) : 1.2;
  return known &&
         lam_domain_give((lam_domain){{0, 2 * LAM_PI}, {-top, top}, {true, false}}, p, q, closed);
}

/* Mercator's chart is the principal one. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)data;
  (void)sector;
  *u = p;
  *v = chart == LAM_CHART_PRINCIPAL ? atan(sinh(q)) : q;
}

static const lam_key keys[] = {
    LAM_NUMBER_KEY(lam_sphere, "radius", radius, "1", 1e-3, 1e6, "Radius."), {0}};

const lam_surface_kind lam_surface_sphere = {
    .head = {.name = "sphere",
             .title = "Sphere",
             .doc = "Longitude u and latitude v, in radians. The dome of domes; also a good test, "
                    "because all curvatures are known. Meshes shrink towards the poles, where the "
                    "parameters are singular: the default domain ends at 69 degrees. It has no "
                    "asymptotic lines, as its curvature is positive.",
             .equation = "x = radius (cos v cos u, cos v sin u, sin v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 2-2",
             .keys = keys,
             .params_size = sizeof(lam_sphere)},
    .eval = eval,
    .domain = domain,
    .locate = locate};
