/* Delaunay's surfaces of revolution of constant mean curvature, unduloid and nodoid: two lines
 * in surfaces.c.
 *
 * In isothermic parameters, u the angle and dv = ds / r along the meridian: a meridian of slope
 * angle psi with (r sin psi)' = 2 h r r' has a first integral, and extremes r = 1 (the bulge)
 * and r = |n| (the neck); n > 0 is the unduloid, n < 0 the nodoid.
 *   h = 1 / (1 + n),  r sin psi = h (r^2 + n),  (dr/dv)^2 = h^2 (1 - r^2)(r^2 - n^2)
 *   =>  r = dn(h v | m), m = 1 - n^2,
 *   dz/dv = r sin psi  =>  z = epsilon(h v) + h n v,  epsilon = integral of dn^2.
 * The normal points outward at the bulge, so H = -h there and everywhere. v = 0 is the bulge;
 * the period is 2K/h. Diagonals of these coordinates are lines of equal normal curvature H
 * (Eells, The surfaces of Delaunay, 1987). */
#include "core/numbers.h"
#include "surf/elliptic.h"
#include "surf/surface_kind.h"

/* The parameters of a row: |n|. */
typedef struct lam_delaunay_keys {
  double neck;
} lam_delaunay_keys;

/* What evaluation needs: n with its sign, h, and the elliptic functions of m. */
typedef struct lam_delaunay {
  double n, h;
  lam_elliptic elliptic;
} lam_delaunay;

/* The surface of a signed n; 1 - m = n^2. */
static const void *make(lam_arena *arena, double n) {
  lam_delaunay *s = LAM_NEW(arena, lam_delaunay, 1);
  *s = (lam_delaunay){n, 1 / (1 + n), lam_elliptic_make(n * n)};
  return s;
}

/* n > 0. */
static const void *prepare_unduloid(lam_arena *arena, const void *params, lam_location location,
                                    lam_errors *errors) {
  (void)location;
  (void)errors;
  return make(arena, ((const lam_delaunay_keys *)params)->neck);
}

/* n < 0. */
static const void *prepare_nodoid(lam_arena *arena, const void *params, lam_location location,
                                  lam_errors *errors) {
  (void)location;
  (void)errors;
  return make(arena, -((const lam_delaunay_keys *)params)->neck);
}

/* dn' = -m sn cn, and r'' = h^2 r (1 + n^2 - 2 r^2) from the square of r' above. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_delaunay *s = data;
  lam_jacobi j = lam_jacobi_eval(&s->elliptic, s->h * v);
  double r = j.dn, hh = s->h * s->h, nn = s->n * s->n, dr = -s->h * (1 - nn) * j.sn * j.cn;
  lam_jet_revolve((lam_meridian){.r = r,
                                 .dr = dr,
                                 .ddr = hh * r * (1 + nn - 2 * r * r),
                                 .z = j.epsilon + s->h * s->n * v,
                                 .dz = s->h * (r * r + s->n),
                                 .ddz = 2 * s->h * r * dr},
                  u, jet);
}

/* One wave, from neck to neck. Its diagonals reach almost all the way around at most: a net
 * of them would lie on itself otherwise. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  const lam_delaunay *s = data;
  double half = s->elliptic.quarter / s->h;
  lam_domain rings = {{0, 2 * LAM_PI}, {-half, half}, {true, false}};
  double reach = fmin(half, .95 * LAM_PI) / 2;
  lam_domain diagonals = {{-reach, reach}, {-reach, reach}, {false, false}};
  return chart != LAM_CHART_ASYMPTOTIC &&
         lam_domain_give(chart == LAM_CHART_DIAGONAL ? diagonals : rings, p, q, closed);
}

/* The natural parameters are the principal ones. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  (void)data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_DIAGONAL) lam_diagonal(p, q, u, v);
}

/* The only key, with another default and upper limit for each of the two. */
#define NECK(ratio, most)                                                                          \
  LAM_NUMBER_KEY(lam_delaunay_keys, "neck", neck, ratio, 0.01, (most),                             \
                 "Smallest radius divided by the largest.")
static const lam_key unduloid_keys[] = {NECK("0.4", 1), {0}};
static const lam_key nodoid_keys[] = {NECK("0.3", 0.9), {0}};

const lam_surface_kind lam_surface_unduloid = {
    .head = {.name = "unduloid",
             .title = "Unduloid",
             .doc = "A tube of constant mean curvature with bulges and necks, between a cylinder "
                    "(neck 1) and a string of spheres (neck near 0): the shape of an evenly "
                    "inflated bellows. Cut lengthwise it makes a vault of waves. The parameter "
                    "lines are curvature lines with square meshes; their diagonals all have the "
                    "same normal curvature, so strips along them unroll to arcs of one radius. "
                    "Largest radius 1. One wave is the default domain; v may run over several.",
             .equation =
                 "r = dn(h v), z = E(am(h v)) + h n v, h = 1/(1+n), n = neck, m = 1 - n^2; |H| = h",
             .source = "Eells, The surfaces of Delaunay, 1987",
             .keys = unduloid_keys,
             .params_size = sizeof(lam_delaunay_keys)},
    .prepare = prepare_unduloid,
    .eval = eval,
    .domain = domain,
    .locate = locate};

const lam_surface_kind lam_surface_nodoid = {
    .head =
        {.name = "nodoid",
         .title = "Nodoid",
         .doc = "A surface of revolution of constant mean curvature whose meridian runs in loops. "
                "One loop without its inner part is a ring-shaped bulge that swings back at the "
                "rims: a flared canopy with square meshes along the curvature lines and diagonals "
                "of one normal curvature. Largest radius 1. One loop is the default domain; "
                "several cut through each other.",
         .equation =
             "r = dn(h v), z = E(am(h v)) + h n v, h = 1/(1+n), n = -neck, m = 1 - n^2; |H| = h",
         .source = "Eells, The surfaces of Delaunay, 1987",
         .keys = nodoid_keys,
         .params_size = sizeof(lam_delaunay_keys)},
    .prepare = prepare_nodoid,
    .eval = eval,
    .domain = domain,
    .locate = locate};
