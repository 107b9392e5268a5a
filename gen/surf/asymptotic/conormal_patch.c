/* A patch over four asymptotic curves with their conormals nu. Called by skin_patches.c.
 *
 * With m the mean direction of nu along an edge, and a, b, m right-handed, orthogonal and of
 * length 1, the tangents across the edge are
 *
 *   T = x nu x a + y nu x b,   that is   T.b = x nu.m,  T.a = -y nu.m
 *
 * in the tangent planes of both patches along it. x and y have degree 5, T has degree 9 as the
 * patch. At the ends T is the derivative of the crossing curve, and T' = w the mixed derivative:
 *
 *   x1 = x0 + (w.b - x0 nu'.m) / (5 nu.m),   y1 = y0 - (w.a + y0 nu'.m) / (5 nu.m)
 *
 * Both curves at a corner have the same w: w.nu = -r_v.nu_u = -r_u.nu_v is given, its part in
 * the tangent plane is free. These two numbers per corner and the two middle coefficients of x
 * and y along every edge, 24 in all, minimize the thin-plate energy (thesis, eq. 2.8) together
 * with the inner points of the control net. */
#include "core/numeric/dense.h"
#include "surf/asymptotic/conormal.h"

#include <string.h>

enum {
  SIDE = LAM_CONORMAL_SURFACE + 1,
  TOTAL = SIDE * SIDE,
  CROSS = LAM_CONORMAL_SURFACE - LAM_CONORMAL_DEGREE + 1, /* coefficients of x and of y */
  MIDDLE = CROSS - 4,                                     /* those that the ends do not fix */
  FREE = 8 + 8 * MIDDLE, /* numbers: two per corner, then those of x and y of every edge */
  SAMPLES = 17,          /* points of an edge where folds are looked for */
};

struct lam_conormal_plate {
  double stiffness[TOTAL][TOTAL]; /* half the gradient of the energy by the outer two rings, with
                                     inner points of least energy */
  double lift[TOTAL][TOTAL];      /* all points, by those of the outer two rings */
};

/* Whether point k of the net is in neither of the outer two rings. */
static bool is_inner(int k) {
  return k / SIDE > 1 && k / SIDE < SIDE - 2 && k % SIDE > 1 && k % SIDE < SIDE - 2;
}

/* Column k is the net whose points in the outer two rings are 0 but for point k. */
const lam_conormal_plate *lam_conormal_plate_make(lam_arena *arena) {
  lam_conormal_plate *out = LAM_NEW(arena, lam_conormal_plate, 1);
  lam_thin_plate plate;
  int count, degree = LAM_CONORMAL_SURFACE;
  const double *knots = lam_knots_repeat(arena, degree, 0, NULL, 1, &count);
  lam_thin_plate_make(arena, (int[2]){degree, degree}, (int[2]){SIDE, SIDE},
                      (const double *const[2]){knots, knots}, &plate);

  for (int k = 0; k < TOTAL; k++) {
    double net[TOTAL] = {0}, pull[TOTAL];
    if (is_inner(k)) continue;

    net[k] = 1;
    lam_thin_plate_fill(arena, &plate, net);
    lam_thin_plate_apply(arena, &plate, net, pull);
    for (int i = 0; i < TOTAL; i++) {
      out->lift[i][k] = net[i];
      out->stiffness[i][k] = is_inner(i) ? 0 : pull[i];
    }
  }
  return out;
}

/* The number in the net of point k along a side, in ring 0 (on the edge) or 1. */
static int ring_index(int side, int ring, int k) {
  int across = side < 2 ? ring : SIDE - 1 - ring;
  return side % 2 ? across * SIDE + k : k * SIDE + across;
}

/* ---- along an edge ---- */

/* What the tangents across an edge are made of, and their coefficients. */
typedef struct across {
  lam_vec3 a, b, m;
  const lam_vec3 *conormals;
  double x[CROSS], y[CROSS];
} across;

/* The frame of an edge, with all coefficients 0. */
static across across_start(const lam_conormal_edge *edge) {
  across out = {.conormals = edge->conormals};
  for (int k = 0; k < LAM_CONORMAL_POINTS; k++)
    out.m = lam_add(out.m, lam_unit(edge->conormals[k]));
  out.m = lam_unit(out.m);

  lam_vec3 chord = lam_sub(edge->points[LAM_CONORMAL_CURVE], edge->points[0]);
  out.a = lam_unit(lam_along(chord, -lam_dot(chord, out.m), out.m));
  out.b = lam_cross(out.m, out.a);
  return out;
}

/* nu.m and nu'.m at an end. */
static void end_values(const across *c, int end, double *value, double *slope) {
  const lam_vec3 *nu = c->conormals + (end ? LAM_CONORMAL_DEGREE - 1 : 0);
  *value = lam_dot(nu[end], c->m);
  *slope = LAM_CONORMAL_DEGREE * lam_dot(lam_sub(nu[1], nu[0]), c->m);
}

/* Sets the first coefficients from an end by T there. */
static void set_tangent(across *c, int end, lam_vec3 tangent) {
  double value, slope;
  end_values(c, end, &value, &slope);
  c->x[end ? CROSS - 1 : 0] = lam_dot(tangent, c->b) / value;
  c->y[end ? CROSS - 1 : 0] = -lam_dot(tangent, c->a) / value;
}

/* Sets the second coefficients from an end by T' = w, after set_tangent. Without it the change
 * that a part of w makes. */
static void set_twist(across *c, int end, lam_vec3 w) {
  double value, slope, step = (end ? -1.0 : 1.0) / (CROSS - 1);
  int at = end ? CROSS - 1 : 0, next = end ? CROSS - 2 : 1;

  end_values(c, end, &value, &slope);
  c->x[next] = c->x[at] + step * (lam_dot(w, c->b) - c->x[at] * slope) / value;
  c->y[next] = c->y[at] - step * (lam_dot(w, c->a) + c->y[at] * slope) / value;
}

/* The binomial coefficient. */
static double choose(int n, int k) { return k ? choose(n, k - 1) * (n - k + 1) / k : 1; }

/* Adds T / 9, negative along r3 and r4, to the second ring of a net. T is the product of the
 * Bernstein polynomials of nu and of (x a + y b). */
static void add_tangents(const across *c, int side, lam_vec3 net[TOTAL]) {
  lam_vec3 t[SIDE] = {{0, 0, 0}};
  for (int j = 0; j < LAM_CONORMAL_POINTS; j++)
    for (int i = 0; i < CROSS; i++) {
      lam_vec3 axis = lam_along(lam_scale(c->a, c->x[i]), c->y[i], c->b);
      double factor = choose(CROSS - 1, i) * choose(LAM_CONORMAL_DEGREE, j) /
                      choose(LAM_CONORMAL_SURFACE, i + j);
      t[i + j] = lam_along(t[i + j], factor, lam_cross(c->conormals[j], axis));
    }

  int skip = side % 2 ? 2 : 1; /* the points in the corners of the ring belong to r1 and r3 */
  for (int k = skip; k < SIDE - skip; k++) {
    lam_vec3 *point = &net[ring_index(side, 1, k)];
    *point = lam_along(*point, (side < 2 ? 1.0 : -1.0) / LAM_CONORMAL_SURFACE, t[k]);
  }
}

/* The Bernstein polynomial number k of a degree at t. */
static double bernstein(int degree, int k, double t) {
  return choose(degree, k) * pow(t, k) * pow(1 - t, degree - k);
}

/* Whether T changes to the other side of its curve, where the surface folds over: r' x T = nu
 * times a function of one sign otherwise. */
static bool folds(const lam_conormal_edge *edge, const across *c) {
  double last = 0;
  for (int g = 0; g < SAMPLES; g++) {
    double t = (double)g / (SAMPLES - 1), x = 0, y = 0;
    lam_vec3 nu = {0, 0, 0}, along = {0, 0, 0};
    for (int k = 0; k < CROSS; k++) {
      x += bernstein(CROSS - 1, k, t) * c->x[k];
      y += bernstein(CROSS - 1, k, t) * c->y[k];
    }

    for (int k = 0; k < LAM_CONORMAL_POINTS; k++)
      nu = lam_along(nu, bernstein(LAM_CONORMAL_DEGREE, k, t), edge->conormals[k]);
    for (int k = 0; k < LAM_CONORMAL_CURVE; k++)
      along = lam_along(along, bernstein(LAM_CONORMAL_CURVE - 1, k, t),
                        lam_sub(edge->points[k + 1], edge->points[k]));

    lam_vec3 tangent = lam_cross(nu, lam_along(lam_scale(c->a, x), y, c->b));
    double side = lam_dot(lam_cross(along, tangent), nu);
    if (g && !(side * last > 0)) return true;
    last = side;
  }
  return false;
}

/* ---- the patch ---- */

/* r' at an end. */
static lam_vec3 end_tangent(const lam_conormal_edge *edge, int end) {
  const lam_vec3 *p = edge->points + (end ? LAM_CONORMAL_CURVE - 1 : 0);
  return lam_scale(lam_sub(p[1], p[0]), LAM_CONORMAL_CURVE);
}

typedef struct frame {
  across side[4];
  lam_vec3 tangent[4][2], twist[4]; /* at the corners: r_u, r_v; w */
} frame;

/* Hands w of a corner to the two sides that meet there. */
static void twist_corner(frame *f, int corner) {
  for (int k = 0; k < 2; k++) {
    lam_quad_end end = lam_quad_meeting[corner][k];
    set_twist(&f->side[end.curve], end.end, f->twist[corner]);
  }
}

/* The frame of a patch with all free numbers 0: w at a corner has its part along nu alone. */
static void frame_start(const lam_conormal_edge edges[4], frame *f) {
  for (int i = 0; i < 4; i++) f->side[i] = across_start(&edges[i]);
  for (int corner = 0; corner < 4; corner++) {
    const lam_quad_end *end = lam_quad_meeting[corner];
    lam_vec3 *tangent = f->tangent[corner];
    for (int k = 0; k < 2; k++) tangent[k] = end_tangent(&edges[end[k].curve], end[k].end);
    for (int k = 0; k < 2; k++) set_tangent(&f->side[end[k].curve], end[k].end, tangent[1 - k]);

    const lam_vec3 *nu = edges[end[0].curve].conormals + (end[0].end ? LAM_CONORMAL_DEGREE - 1 : 0);
    lam_vec3 normal = nu[end[0].end], slope = lam_scale(lam_sub(nu[1], nu[0]), LAM_CONORMAL_DEGREE);
    f->twist[corner] = lam_scale(normal, -lam_dot(tangent[1], slope) / lam_dot(normal, normal));
    twist_corner(f, corner);
  }
}

/* What each free number adds to the control net: first those of the twists, then those of x and
 * y in the middle of the edges. */
static void list_parts(const lam_conormal_edge edges[4], const frame *f,
                       lam_vec3 part[FREE][TOTAL]) {
  for (int k = 0; k < 16; k++) { /* corner and direction, curve */
    lam_quad_end end = lam_quad_meeting[k / 4][k % 2];
    int d = k / 2 % 2;
    across alone = across_start(&edges[end.curve]);
    set_twist(&alone, end.end, f->tangent[k / 4][d]);
    add_tangents(&alone, end.curve, part[2 * (k / 4) + d]);
  }

  for (int k = 0; k < 8 * MIDDLE; k++) {
    across alone = across_start(&edges[k % 4]);
    (k / 4 % 2 ? alone.y : alone.x)[2 + k / 8] = 1;
    add_tangents(&alone, k % 4, part[8 + k]);
  }
}

/* Sets the free numbers. */
static void frame_move(frame *f, const double z[FREE]) {
  for (int corner = 0; corner < 4; corner++) {
    for (int d = 0; d < 2; d++)
      f->twist[corner] = lam_along(f->twist[corner], z[2 * corner + d], f->tangent[corner][d]);
    twist_corner(f, corner);
  }
  for (int k = 0; k < 8 * MIDDLE; k++)
    (k / 4 % 2 ? f->side[k % 4].y : f->side[k % 4].x)[2 + k / 8] += z[8 + k];
}

/* The scalar product of two nets. */
static double product(const lam_vec3 *a, const lam_vec3 *b) {
  double sum = 0;
  for (int k = 0; k < TOTAL; k++) sum += lam_dot(a[k], b[k]);
  return sum;
}

/* out = matrix times net, coordinate by coordinate. */
static void apply(const double matrix[TOTAL][TOTAL], const lam_vec3 *net, lam_vec3 *out) {
  for (int i = 0; i < TOTAL; i++) out[i] = lam_v3(0, 0, 0);
  for (int k = 0; k < TOTAL; k++) {
    if (net[k].x == 0 && net[k].y == 0 && net[k].z == 0) continue;
    for (int i = 0; i < TOTAL; i++) out[i] = lam_along(out[i], matrix[i][k], net[k]);
  }
}

/* The outer ring, the curves in degree 9, and the same in the second one: the net with T = 0. */
static void set_rings(const lam_conormal_edge edges[4], lam_vec3 net[TOTAL]) {
  for (int i = 0; i < 4; i++) {
    lam_vec3 points[SIDE];
    memcpy(points, edges[i].points, sizeof edges[i].points);
    lam_bezier_elevate(LAM_CONORMAL_CURVE, LAM_CONORMAL_SURFACE, 3, &points[0].x);
    for (int k = 0; k < SIDE; k++) {
      net[ring_index(i, 0, k)] = points[k];
      if (k > i % 2 && k < SIDE - 1 - i % 2) net[ring_index(i, 1, k)] = points[k];
    }
  }
}

/* The energy is quadratic in the free numbers z: h z = -gradient at z = 0. */
bool lam_conormal_patch_make(const lam_conormal_plate *plate, const lam_conormal_edge edges[4],
                             lam_vec3 *points, double *energy) {
  frame f;
  lam_vec3 part[FREE][TOTAL] = {{{0, 0, 0}}}, net[TOTAL], pull[TOTAL];
  double h[FREE * FREE], z[FREE];

  frame_start(edges, &f);
  list_parts(edges, &f, part);
  set_rings(edges, net);
  for (int i = 0; i < 4; i++) add_tangents(&f.side[i], i, net);

  apply(plate->stiffness, net, pull);
  for (int k = 0; k < FREE; k++) z[k] = -product(part[k], pull);
  for (int k = 0; k < FREE; k++) {
    apply(plate->stiffness, part[k], pull);
    for (int l = 0; l <= k; l++) h[k * FREE + l] = h[l * FREE + k] = product(part[l], pull);
  }

  if (!lam_cholesky_factor(FREE, h)) return false;
  lam_cholesky_solve(FREE, h, z);
  for (int k = 0; k < FREE; k++)
    for (int i = 0; i < TOTAL; i++) net[i] = lam_along(net[i], z[k], part[k][i]);

  apply(plate->stiffness, net, pull);
  *energy = product(net, pull);
  apply(plate->lift, net, points);

  frame_move(&f, z);
  for (int i = 0; i < 4; i++)
    if (folds(&edges[i], &f.side[i])) return false;
  return true;
}
