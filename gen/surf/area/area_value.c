/* The area and its first variation, by sums over one direction at a time. Called by the methods
 * of this folder in every step; area_variation.c adds the second variation.
 *
 * In homogeneous coordinates X = (w x, w) the surface is sum_ij f_i(u) g_j(v) X_ij. For every
 * node in v the rows A_i = sum_j g_j X_ij and B_i = sum_j g_j' X_ij are formed once, and every
 * node in u then needs f_i A_i, f_i' A_i and f_i B_i alone. The first variation goes the same
 * way back: with W = w(u, v) and the derivatives D, D_u, D_v of the density by x, x_u, x_v,
 *
 *   dA / dx_ij = w_ij sum (f_i g_j c + f_i' g_j D_u / W + f_i g_j' D_v / W)
 *   c          = (D - (W_u D_u + W_v D_v) / W) / W
 *
 * The area has D = 0, D_u = (G x_u - F x_v) / a, D_v = (E x_v - F x_u) / a; the volume,
 * integrated by parts, adds 2 H x_u x x_v to D. */
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* A homogeneous point. */
typedef struct row {
  double x[4]; /* w x, w y, w z, w */
} row;

/* Adds t times a homogeneous point. */
static inline void add_row(double t, const row *from, row *to) {
  for (int c = 0; c < 4; c++) to->x[c] += t * from->x[c];
}

/* The control points of a span times the functions g of a node in v: values A_i and derivatives
 * B_i. */
static void contract(const lam_area_form *form, const row *net, const double *g, row *a, row *b) {
  int p = form->rule[0].degree + 1, q = form->rule[1].degree + 1;
  for (int i = 0; i < p; i++) {
    a[i] = b[i] = (row){{0}};
    for (int j = 0; j < q; j++) {
      add_row(g[j], &net[i * q + j], &a[i]);
      add_row(g[q + j], &net[i * q + j], &b[i]);
    }
  }
}

/* The surface at a node. */
typedef struct node {
  double scale, wu, wv; /* 1 / W, W_u / W, W_v / W */
  lam_vec3 x, u, v;
} node;

/* The derivative of a rational point from that of its homogeneous one: (x W)' / W - x W' / W,
 * with scale = 1 / W and slope = W' / W. */
static inline lam_vec3 quotient(const row *r, double scale, lam_vec3 x, double slope) {
  return lam_v3(r->x[0] * scale - slope * x.x, r->x[1] * scale - slope * x.y,
                r->x[2] * scale - slope * x.z);
}

/* The surface at a node in u with the functions f, from the rows A_i and B_i of its node in v. */
static inline node visit(int p, const double *f, const row *a, const row *b) {
  row x = {{0}}, u = {{0}}, v = {{0}};
  for (int i = 0; i < p; i++) {
    add_row(f[i], &a[i], &x);
    add_row(f[p + i], &a[i], &u);
    add_row(f[i], &b[i], &v);
  }

  node at = {.scale = 1 / x.x[3]};
  at.wu = u.x[3] * at.scale;
  at.wv = v.x[3] * at.scale;
  at.x = lam_v3(x.x[0] * at.scale, x.x[1] * at.scale, x.x[2] * at.scale);
  at.u = quotient(&u, at.scale, at.x, at.wu);
  at.v = quotient(&v, at.scale, at.x, at.wv);
  return at;
}

/* What a node in u of weight w adds to the sums of a node in v: to[i] times g_j, across[i] times
 * g_j'. normal: x_u x x_v, a: its length. */
static inline void add_slopes(double curvature, const node *at, double w, double a, lam_vec3 normal,
                              int p, const double *f, lam_vec3 *to, lam_vec3 *across) {
  double E = lam_dot(at->u, at->u), F = lam_dot(at->u, at->v), G = lam_dot(at->v, at->v);

  /* A node without a tangent plane pulls like one that almost has none. */
  double least = 1e-14 * (E + G), scale = E + G > 0 ? w * at->scale / fmax(a, least) : 0;
  lam_vec3 fu = lam_along(lam_scale(at->u, scale * G), -scale * F, at->v),
           fv = lam_along(lam_scale(at->v, scale * E), -scale * F, at->u);
  lam_vec3 c = lam_scale(lam_along(lam_scale(fu, at->wu), at->wv, fv), -1);
  if (curvature != 0) c = lam_along(c, 2 * curvature * w * at->scale, normal);

  for (int i = 0; i < p; i++) {
    to[i] = lam_along(lam_along(to[i], f[i], c), f[p + i], fu);
    across[i] = lam_along(across[i], f[i], fv);
  }
}

/* Adds the sums of a node in v, with the functions g, to the gradient by the points of span (s,
 * t). */
static void spread(const lam_area_form *form, int s, int t, const double *g, const row *net,
                   const lam_vec3 *to, const lam_vec3 *across) {
  int q = form->rule[1].degree + 1;
  for (int k = 0; k < form->local; k++) {
    int point = lam_area_inner(form, s, t, k), i = k / q, j = k % q;
    if (point < 0) continue;
    lam_vec3 sum = lam_along(lam_scale(to[i], g[j]), g[q + j], across[i]);
    form->gradient[point] = lam_along(form->gradient[point], net[k].x[3], sum);
  }
}

/* The control points of span (s, t) in homogeneous coordinates, v fastest. */
static void fetch(const lam_area_form *form, const lam_vec3 *points, int s, int t, row *net) {
  int q = form->rule[1].degree + 1, columns = form->surface.count[1];
  int corner = form->rule[0].first[s] * columns + form->rule[1].first[t];
  for (int k = 0; k < form->local; k++) {
    int at = corner + k / q * columns + k % q;
    double w = form->surface.weights ? form->surface.weights[at] : 1;
    net[k] = (row){{w * points[at].x, w * points[at].y, w * points[at].z, w}};
  }
}

/* Area + 2 H volume, and with slope its gradient. */
static double integrate(const lam_area_form *form, const lam_vec3 *points, bool slope) {
  const lam_area_rule *ru = &form->rule[0], *rv = &form->rule[1];
  int p = ru->degree + 1, q = rv->degree + 1;
  double sum = 0, H = form->mean_curvature;
  row net[LAM_AREA_LOCAL], a[LAM_AREA_WIDTH], b[LAM_AREA_WIDTH];
  lam_vec3 to[LAM_AREA_WIDTH], across[LAM_AREA_WIDTH];
  if (slope)
    memset(form->gradient, 0, (size_t)(form->inner[0] * form->inner[1]) * sizeof *form->gradient);

  for (int s = 0; s < ru->spans; s++)
    for (int t = 0; t < rv->spans; t++) {
      fetch(form, points, s, t, net);
      for (int l = 0; l < rv->nodes; l++) {
        const double *g = rv->values + (t * rv->nodes + l) * 2 * q;
        contract(form, net, g, a, b);
        memset(to, 0, sizeof to);
        memset(across, 0, sizeof across);

        for (int k = 0; k < ru->nodes; k++) {
          const double *f = ru->values + (s * ru->nodes + k) * 2 * p;
          double w = ru->weights[s * ru->nodes + k] * rv->weights[t * rv->nodes + l];

          node at = visit(p, f, a, b);
          lam_vec3 normal = lam_cross(at.u, at.v);
          double density = lam_length(normal);
          sum += w * (H != 0 ? density + 2 * H / 3 * lam_dot(at.x, normal) : density);
          if (slope) add_slopes(H, &at, w, density, normal, p, f, to, across);
        }
        if (slope) spread(form, s, t, g, net, to, across);
      }
    }
  return isfinite(sum) ? sum : INFINITY;
}

double lam_area_value(const lam_area_form *form, const lam_vec3 *points) {
  return integrate(form, points, false);
}
double lam_area_slope(const lam_area_form *form, const lam_vec3 *points) {
  return integrate(form, points, true);
}
