/* The ellipsoid x = (a cos v cos u, b cos v sin u, c sin v) with half axes a, b, c; one line in
 * surfaces.c.
 *
 * Principal chart: Jacobi's ellipsoidal coordinates. With the half axes in falling order,
 * A >= B >= C, and P = A^2 - B^2, Q = B^2 - C^2, S = A^2 - C^2, the lines of w = p and b = q
 * are curvature lines:
 *   X / A = cos w sqrt((P sin^2 b + S cos^2 b) / S),  Y / B = cos b sin w,
 *   Z / C = sin b sqrt((S sin^2 w + Q cos^2 w) / S).
 * The umbilics are b = +-pi/2, w = 0 and pi (Jacobi 1839; Karney, Jacobi's coordinates of an
 * ellipsoid). */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The parameters of a row. */
typedef struct lam_ellipsoid_keys {
  double axes[3];
} lam_ellipsoid_keys;

/* What evaluation needs. */
typedef struct lam_ellipsoid {
  double axes[3];
  int order[3]; /* order[0] is the direction of the longest axis */
  double turn;  /* -1 when order is an odd permutation, else 1: keeps the orientation */
  double p, q;  /* P / S and Q / S; 1 on a sphere, where any two orthogonal families will do */
} lam_ellipsoid;

/* Sorts the axes and finds P / S and Q / S. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_ellipsoid_keys *keys = params;
  lam_ellipsoid *s = LAM_NEW(arena, lam_ellipsoid, 1);
  (void)location;
  (void)errors;
  *s = (lam_ellipsoid){{keys->axes[0], keys->axes[1], keys->axes[2]}, {0, 1, 2}, 1, 0, 1};

  for (int pass = 0; pass < 2; pass++)
    for (int i = 0; i < 2 - pass; i++)
      if (s->axes[s->order[i]] < s->axes[s->order[i + 1]]) {
        int swap = s->order[i];
        s->order[i] = s->order[i + 1];
        s->order[i + 1] = swap;
        s->turn = -s->turn;
      }

  double a = s->axes[s->order[0]], b = s->axes[s->order[1]], c = s->axes[s->order[2]],
         span = (a - c) * (a + c);
  if (span > 0) {
    s->p = (a - b) * (a + b) / span;
    s->q = (b - c) * (b + c) / span;
  }
  return s;
}

/* The sphere, stretched. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const double *axes = ((const lam_ellipsoid *)data)->axes;
  lam_vec3 *fields[] = {&jet->x, &jet->u, &jet->v, &jet->uu, &jet->uv, &jet->vv};
  double c = cos(v), s = sin(v);
  lam_jet_revolve((lam_meridian){.r = c, .dr = -s, .ddr = -c, .z = s, .dz = c, .ddz = -s}, u, jet);

  for (int i = 0; i < 6; i++) {
    fields[i]->x *= axes[0];
    fields[i]->y *= axes[1];
    fields[i]->z *= axes[2];
  }
}

/* Both charts are closed in u and end before the poles or umbilics. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  bool known = chart == LAM_CHART_NATURAL || chart == LAM_CHART_PRINCIPAL;
  return known &&
         lam_domain_give((lam_domain){{0, 2 * LAM_PI}, {-1.2, 1.2}, {true, false}}, p, q, closed);
}

/* The unit vector (X / A, Y / B, Z / C) in the order of the axes, then its longitude and
 * latitude. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  const lam_ellipsoid *s = data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_NATURAL) return;

  double cw = cos(p), sw = s->turn * sin(p), cb = cos(q), sb = sin(q), x[3];
  x[s->order[0]] = cw * sqrt(s->p * sb * sb + cb * cb);
  x[s->order[1]] = cb * sw;
  x[s->order[2]] = sb * sqrt(sw * sw + s->q * cw * cw);

  *u = atan2(x[1], x[0]);
  *v = atan2(x[2], hypot(x[0], x[1]));
}

static const lam_key keys[] = {LAM_NUMBER_KEY(lam_ellipsoid_keys, "axes", axes, "[3, 2, 1]", 1e-3,
                                              1e6, "Half axes along x, y and z."),
                               {0}};

const lam_surface_kind lam_surface_ellipsoid = {
    .head = {.name = "ellipsoid",
             .title = "Ellipsoid",
             .doc = "A closed convex surface with three half axes, and the standard shape for nets "
                    "of flat panels on a dome. Its own parameters are longitude u and latitude v "
                    "of the stretched sphere. The principal chart follows the curvature lines; "
                    "they run around four umbilics, on the ellipse of the longest and the shortest "
                    "axis, between which the lines of q = +-pi/2 fold onto each other: the default "
                    "domain ends at 1.2. It has no asymptotic lines.",
             .equation = "x = (a cos v cos u, b cos v sin u, c sin v)",
             .source = "Jacobi 1839; Karney, Jacobi's coordinates of an ellipsoid",
             .keys = keys,
             .params_size = sizeof(lam_ellipsoid_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = locate};
