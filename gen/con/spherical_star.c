/* The constraint `spherical-star`: every vertex on a sphere with its neighbors. Listed in
 * constraints.c; S-nets and CMC nets (net/kinds) add it. */
#include "con/circle.h"
#include "con/constraint.h"

/* Spherical vertex star (S-net, thesis 3.2.3, def. 8 and 10). E_k = v_k - v, circle tangents a of
 * (E1, E3), b of (E2, E4), N = unit(a x b): the only sphere (or plane) that touches both circles at
 * v has the normal N there. It passes through v_k when its curvature is
 *   kappa_k = 2 N.E_k / |E_k|^2   (1/length; positive: the center lies on the side of N)
 * N.a = 0 gives kappa_1 = kappa_3, N.b = 0 gives kappa_2 = kappa_4, so two curvatures describe the
 * star:
 *   own      r = kappa_1 - kappa_2               every star has a sphere of its own
 *   given    r = kappa_1 - k, kappa_2 - k        k = p[0]; k = 0: the planar star of an asymptotic
 *                                                net
 *   common   r = kappa_1 - k, kappa_2 - k        k = x[15], one unknown for all
 * Jacobian of kappa_i = N.c, c = 2 E_i / |E_i|^2: with M = a x b and g = (c - N (N.c)) / |M|, by a:
 * b x g, by b: g x a, and by E_i in c: (2 N - 2 kappa_i E_i) / |E_i|^2. */

/* kappa_1 and kappa_2 of a star, and their derivatives by the four E_k (NULL: not wanted). */
static void curvatures(const double *x, double kappa[2], lam_vec3 dE[2][4]) {
  lam_vec3 v = lam_local(x, 0), E[4];
  for (int k = 0; k < 4; k++) E[k] = lam_sub(lam_local(x, k + 1), v);
  lam_vec3 a = lam_circle_tangent(E[0], E[2]), b = lam_circle_tangent(E[1], E[3]),
           M = lam_cross(a, b);
  double size = lam_length(M);
  lam_vec3 N = lam_scale(M, 1 / size);

  for (int i = 0; i < 2; i++) {
    double q = lam_dot(E[i], E[i]);
    lam_vec3 c = lam_scale(E[i], 2 / q);
    kappa[i] = lam_dot(N, c);
    if (!dE) continue;

    lam_vec3 g = lam_scale(lam_along(c, -kappa[i], N), 1 / size);
    for (int k = 0; k < 4; k++) dE[i][k] = lam_v3(0, 0, 0);
    lam_circle_pullback(E[0], E[2], lam_cross(b, g), &dE[i][0], &dE[i][2]);
    lam_circle_pullback(E[1], E[3], lam_cross(g, a), &dE[i][1], &dE[i][3]);
    dE[i][i] = lam_along(dE[i][i], 2 / q, lam_along(N, -kappa[i], E[i]));
  }
}

/* r = kappa_1 - kappa_2  (1/length) */
static void own_sphere(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  double kappa[2];
  lam_vec3 dE[2][4];
  curvatures(x, kappa, J ? dE : NULL);
  r[0] = kappa[0] - kappa[1];
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = 0;
  for (int k = 0; k < 4; k++) dE[0][k] = lam_sub(dE[0][k], dE[1][k]);
  lam_star_row(J, 4, dE[0]);
}

/* r_i = kappa_i - k  (1/length);  p[0] = k */
static void given_sphere(int n, const double *x, const double *p, double *r, double *J) {
  double kappa[2];
  lam_vec3 dE[2][4];
  curvatures(x, kappa, J ? dE : NULL);
  for (int i = 0; i < 2; i++) {
    r[i] = kappa[i] - p[0];
    if (!J) continue;
    for (int c = 0; c < n; c++) J[i * n + c] = 0;
    lam_star_row(J + i * n, 4, dE[i]);
  }
}

/* The same with k as the unknown x[15]: dr_i/dk = -1. */
static void common_sphere(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  given_sphere(n, x, x + 15, r, J);
  if (!J) return;
  for (int i = 0; i < 2; i++) J[i * n + 15] = -1;
}

/* ---- on the border ---- */

/* Border vertex with its border edges E1, E3 and its inner edge E2 between them: the sphere through
 * the four vertices has the center w / (2 d) from v,
 *   d = E1 . (E2 x E3),  w = |E1|^2 E2 x E3 + |E2|^2 E3 x E1 + |E3|^2 E1 x E2,
 * and the curvature
 *   kappa = 2 d / |w|   (1/length; signed as above; 0 when the edges lie in a plane)
 * By E_i, with j, k next in turn and u = unit(w):
 *   dd = E_j x E_k,  d|w| = 2 (u . (E_j x E_k)) E_i + |E_j|^2 u x E_k + |E_k|^2 E_j x u
 * Every vertex lies on a sphere with its neighbors here, so there is nothing to ask for without a
 * curvature that is given or common. */
static double border_curvature(const double *x, lam_vec3 dE[3]) {
  lam_vec3 v = lam_local(x, 0), E[3], square[3], w = {0, 0, 0};
  double q[3];
  for (int i = 0; i < 3; i++) {
    E[i] = lam_sub(lam_local(x, i + 1), v);
    q[i] = lam_dot(E[i], E[i]);
  }
  for (int i = 0; i < 3; i++) {
    square[i] = lam_cross(E[(i + 1) % 3], E[(i + 2) % 3]);
    w = lam_along(w, q[i], square[i]);
  }

  double size = lam_length(w), kappa = 2 * lam_dot(E[0], square[0]) / size;
  lam_vec3 u = lam_scale(w, 1 / size);
  for (int i = 0; i < 3 && dE; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    lam_vec3 dw = lam_scale(E[i], 2 * lam_dot(u, square[i]));
    dw = lam_along(lam_along(dw, q[j], lam_cross(u, E[k])), q[k], lam_cross(E[j], u));
    dE[i] = lam_scale(lam_along(lam_scale(square[i], 2), -kappa, dw), 1 / size);
  }
  return kappa;
}

/* r = kappa - k  (1/length);  p[0] = k */
static void given_border(int n, const double *x, const double *p, double *r, double *J) {
  lam_vec3 dE[3];
  r[0] = border_curvature(x, J ? dE : NULL) - p[0];
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = 0;
  lam_star_row(J, 3, dE);
}

/* The same with k as the unknown x[12]: dr/dk = -1. */
static void common_border(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  given_border(n, x, x + 12, r, J);
  if (J) J[12] = -1;
}

/* ---- blocks ---- */

/* The mean curvature of all stars where the vertices are now, in 1 / solver unit. */
static double mean_at_start(const lam_problem *problem, const int *stars, int count) {
  double sum = 0;
  for (int i = 0; i < count; i++) {
    double x[15], kappa[2];
    for (int k = 0; k < 5; k++)
      for (int c = 0; c < 3; c++) x[3 * k + c] = problem->x[3 * stars[5 * i + k] + c];
    curvatures(x, kappa, NULL);
    sum += (kappa[0] + kappa[1]) / 2;
  }
  return sum / count;
}

/* The elements of `arity` nodes with one more each. */
static const int *with_node(lam_scope *scope, const int *elements, int arity, int count, int node) {
  int *nodes = LAM_NEW(scope->problem->arena, int, (arity + 1) * count);
  for (int i = 0; i < count; i++) {
    for (int k = 0; k < arity; k++) nodes[(arity + 1) * i + k] = elements[arity * i + k];
    nodes[(arity + 1) * i + arity] = node;
  }
  return nodes;
}

/* Whether a sphere of that radius (meters) has chords as long as the mean edge; adds an error when
 * not. */
static bool radius_fits(const lam_scope *scope, double radius, lam_location location) {
  if (fabs(radius) >= scope->unit / 2) return true;
  lam_error_add(scope->errors, location, "radius",
                "given %g m; expected at least half the mean edge, %g m: no sphere that is smaller "
                "has such a chord",
                radius, scope->unit / 2);
  return false;
}

/* Gives a block of spheres the radius in meters as its parameter. */
static void give_radius(const lam_scope *scope, double radius, lam_block *block) {
  block->param_count = 1;
  block->params = LAM_NEW(scope->problem->arena, double, block->count);
  for (int i = 0; i < block->count; i++) block->params[i] = scope->unit / radius;
}

/* Border vertices with the curvature that the inner stars have: given, or in a common node. */
static void add_border(lam_scope *scope, double radius, int common, double weight) {
  lam_block block = {.name = "spherical-star", .rows = 1, .weight = weight, .arity = 4};
  block.count = lam_scope_half_stars(scope, &block.nodes);
  if (radius != 0) {
    block.kernel = given_border;
    give_radius(scope, radius, &block);
  } else {
    block.kernel = common_border;
    block.nodes = with_node(scope, block.nodes, 4, block.count, common);
    block.arity = 5;
  }
  lam_problem_add(scope->problem, block);
}

/* The kernel is chosen by what is known of the radius. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  const lam_spherical_star_params *given = params;
  bool common = given->radius == 0 && given->spheres == LAM_SPHERES_COMMON;
  int node = -1;
  lam_block block = {.name = "spherical-star", .rows = 2, .weight = weight, .arity = 5};
  block.count = lam_scope_stars(scope, given->border, &block.nodes);
  if (block.count == 0) return;

  if (given->radius != 0) {
    if (!radius_fits(scope, given->radius, location)) return;
    block.kernel = given_sphere;
    give_radius(scope, given->radius, &block);
  } else if (common) {
    double start = mean_at_start(scope->problem, block.nodes, block.count);
    node = lam_problem_node(scope->problem, 1, &start);
    block.kernel = common_sphere;
    block.nodes = with_node(scope, block.nodes, 5, block.count, node);
    block.arity = 6;
  } else {
    block.kernel = own_sphere;
    block.rows = 1;
  }

  lam_problem_add(scope->problem, block);
  if (given->border && (common || given->radius != 0))
    add_border(scope, given->radius, node, weight);
}

static const char *const sphere_choices[] = {"own", "common", NULL};

static const lam_key keys[] = {
    LAM_LENGTH_KEY(lam_spherical_star_params, "radius", radius, "0", -1e12, 1e12,
                   "Radius of every sphere; negative when the centers lie behind the surface, seen "
                   "from the tip of its normal (a dome with normals outwards). 0: it is found."),
    LAM_CHOICE_KEY(lam_spherical_star_params, "spheres", spheres, "own", sphere_choices,
                   "When the radius is found. own: every star has a sphere of its own; common: all "
                   "have the same, unknown radius."),
    LAM_FLAG_KEY(lam_spherical_star_params, "border", border, "no",
                 "Vertices of the border take part, where the radius is given or common: with "
                 "their three neighbors, and reentrant corners, which have four edges."),
    {0}};

const lam_constraint_kind lam_con_spherical_star = {
    {"spherical-star", "Spherical vertex stars",
     "Every regular vertex lies on one sphere with its four neighbors: both polylines have the "
     "same normal curvature there, and the principal directions halve the angles between them. "
     "With one radius for all, strips normal to the surface unroll to arcs of that radius. A very "
     "large radius is nearly an asymptotic net.",
     "2 N.E1 / |E1|^2 = 2 N.E2 / |E2|^2 (= 1 / radius), N = unit(t1 x t2), t1 = unit(E1 |E3|^2 - "
     "E3 |E1|^2)",
     "thesis 3.2.3, def. 8 and 10, th. 4 and 5", keys, sizeof(lam_spherical_star_params)},
    add};
