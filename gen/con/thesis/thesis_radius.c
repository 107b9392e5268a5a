/* Stars on spheres of one radius in the form of the thesis, with centers as unknowns, and the angle
 * of their tangents: for net/kinds/cmc_net.c. */
#include "con/kernel.h"
#include "con/thesis/thesis.h"

#include <math.h>

/* A star on a sphere (thesis 3.2.3), unknowns v_0..v_4, m, and r when it is unknown:
 *   r_k = (v_k - m)^2 - r^2  (length^2);  p[0] = r when it is given
 *   by v_k: 2 (v_k - m), by m the opposite, by r: -2 r */
static void equal_sphere(int n, const double *x, const double *p, double *r, double *J) {
  bool common = n == 19;
  double radius = common ? x[18] : p[0];
  lam_vec3 m = lam_local(x, 5);
  for (int i = 0; J && i < 5 * n; i++) J[i] = 0;

  for (int k = 0; k < 5; k++) {
    lam_vec3 d = lam_sub(lam_local(x, k), m);
    r[k] = lam_dot(d, d) - radius * radius;
    if (!J) continue;
    lam_add_to(J + k * n, k, lam_scale(d, 2));
    lam_add_to(J + k * n, 5, lam_scale(d, -2));
    if (common) J[k * n + 18] = -2 * radius;
  }
}

/* ---- rules for products of vectors, in three rows of a Jacobian with n columns ---- */

/* Adds sign times the rows g to the columns of the k-th vector. */
static void add_cross(int n, int k, lam_vec3 g[3], double sign, double *J) {
  for (int row = 0; row < 3; row++) lam_add_to(J + row * n, k, lam_scale(g[row], sign));
}

/* Rows of the matrix [a]x: d(a x b)/db. */
static void cross_rows(lam_vec3 a, lam_vec3 rows[3]) {
  rows[0] = lam_v3(0, -a.z, a.y);
  rows[1] = lam_v3(a.z, 0, -a.x);
  rows[2] = lam_v3(-a.y, a.x, 0);
}

static void put(double *r, lam_vec3 v) { r[0] = v.x, r[1] = v.y, r[2] = v.z; }

/* The derivative of r = ... - x_k by the vector x_k. */
static void subtract_node(int n, int k, double *J) {
  for (int c = 0; c < 3; c++) J[c * n + 3 * k + c] -= 1;
}

/* Normal of the circle's plane (thesis def. 9), unknowns v, v1, v3, B:
 *   r = E1 x E3 - B  (length^2),  E_k = v_k - v
 *   by E3: [E1]x, by E1: -[E3]x, by B: -I */
static void circle_plane(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 v = lam_local(x, 0), E1 = lam_sub(lam_local(x, 1), v), E3 = lam_sub(lam_local(x, 2), v),
           g[3];
  put(r, lam_sub(lam_cross(E1, E3), lam_local(x, 3)));
  if (!J) return;

  for (int i = 0; i < 3 * n; i++) J[i] = 0;
  cross_rows(E1, g);
  add_cross(n, 2, g, 1, J);
  add_cross(n, 0, g, -1, J);
  cross_rows(E3, g);
  add_cross(n, 1, g, -1, J);
  add_cross(n, 0, g, 1, J);
  subtract_node(n, 3, J);
}

/* Tangent (thesis def. 9), unknowns v, m, B, T:
 *   r = B x N - T  (length^3),  N = v - m
 *   by N: [B]x, by B: -[N]x, by T: -I */
static void sphere_tangent(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 N = lam_sub(lam_local(x, 0), lam_local(x, 1)), B = lam_local(x, 2), g[3];
  put(r, lam_sub(lam_cross(B, N), lam_local(x, 3)));
  if (!J) return;

  for (int i = 0; i < 3 * n; i++) J[i] = 0;
  cross_rows(B, g);
  add_cross(n, 0, g, 1, J);
  add_cross(n, 1, g, -1, J);
  cross_rows(N, g);
  add_cross(n, 2, g, -1, J);
  subtract_node(n, 3, J);
}

/* ---- blocks ---- */

/* Mean of 2 N.E / E^2 over the edges of the stars: the curvature that the net has, in 1 / solver
 * unit. */
static double mean_curvature(const lam_problem *problem, int stars, const int *star,
                             const lam_vec3 *normals) {
  double sum = 0;
  for (int s = 0; s < stars; s++)
    for (int k = 1; k < 5; k++) {
      lam_vec3 E =
          lam_sub(lam_local(problem->x, star[5 * s + k]), lam_local(problem->x, star[5 * s]));
      sum += 2 * lam_dot(normals[star[5 * s]], E) / lam_dot(E, E);
    }
  return sum / (4 * stars);
}

/* Makes the nodes B and T of the polyline from vertex ends[1] over v to ends[0], on the sphere of
 * node m, and writes the nodes of its circle_plane and sphere_tangent (4 each). Returns node T. */
static int tangent_node(lam_problem *problem, int v, const int ends[2], int m, int *plane,
                        int *line) {
  lam_vec3 at = lam_local(problem->x, v), center = lam_local(problem->x + problem->offset[m], 0);
  lam_vec3 B = lam_cross(lam_sub(lam_local(problem->x, ends[0]), at),
                         lam_sub(lam_local(problem->x, ends[1]), at));
  int normal = lam_thesis_vector_node(problem, B);
  int tangent = lam_thesis_vector_node(problem, lam_cross(B, lam_sub(at, center)));
  plane[0] = v, plane[1] = ends[0], plane[2] = ends[1], plane[3] = normal;
  line[0] = v, line[1] = m, line[2] = normal, line[3] = tangent;
  return tangent;
}

/* Two tangents per star, along u and along v, and their angle (radians). */
static void add_tangents(lam_scope *scope, int stars, const int *star, const int *centers,
                         double angle) {
  lam_problem *problem = scope->problem;
  int *planes = LAM_NEW(problem->arena, int, 8 * stars),
      *lines = LAM_NEW(problem->arena, int, 8 * stars),
      *tangents = LAM_NEW(problem->arena, int, 2 * stars);
  for (int i = 0; i < 2 * stars; i++) {
    const int *s = star + i / 2 * 5, ends[2] = {s[1 + (i & 1)], s[3 + (i & 1)]};
    tangents[i] = tangent_node(problem, s[0], ends, centers[i / 2], planes + 4 * i, lines + 4 * i);
  }

  lam_block block = {.name = "circle-plane", .kernel = circle_plane, .rows = 3, .weight = 1};
  block.count = 2 * stars;
  block.arity = 4;
  block.nodes = planes;
  lam_problem_add(problem, block);

  block.name = "tangent";
  block.kernel = sphere_tangent;
  block.nodes = lines;
  lam_problem_add(problem, block);
  lam_thesis_crossing(scope, stars, lam_thesis_units(scope, 2 * stars, tangents), angle);
}

/* Makes a node per star for the center of its sphere, which starts at the signed distance `radius`
 * from the star's vertex along the normal. */
static int *make_centers(lam_problem *problem, int stars, const int *star, double radius,
                         const lam_vec3 *x, const lam_vec3 *normals) {
  int *centers = LAM_NEW(problem->arena, int, stars);
  for (int s = 0; s < stars; s++) {
    int v = star[5 * s];
    centers[s] = lam_thesis_vector_node(problem, lam_along(x[v], radius, normals[v]));
  }
  return centers;
}

/* The equations hold r^2 alone: the sign of the radius chooses the side on which the centers
 * start. */
void lam_thesis_equal_spheres(lam_scope *scope, double radius, double angle) {
  lam_problem *problem = scope->problem;
  lam_vec3 *x, *normals;
  lam_thesis_normals(scope, &x, &normals);
  const int *star;
  int stars = lam_scope_stars(scope, false, &star), arity = radius == 0 ? 7 : 6, common = -1;
  double start = radius == 0 ? 1 / mean_curvature(problem, stars, star, normals) : radius;
  if (radius == 0) common = lam_problem_node(problem, 1, &start);
  const int *centers = make_centers(problem, stars, star, start, x, normals);

  int *nodes = LAM_NEW(problem->arena, int, arity *stars);
  double *radii = LAM_NEW(problem->arena, double, stars);
  for (int s = 0; s < stars; s++) {
    int *to = nodes + arity * s;
    for (int k = 0; k < 5; k++) to[k] = star[5 * s + k];
    to[5] = centers[s];
    if (common >= 0) to[6] = common;
    radii[s] = radius;
  }

  lam_block block = {.name = "spherical-star", .kernel = equal_sphere, .rows = 5, .weight = 1};
  block.count = stars;
  block.arity = arity;
  block.nodes = nodes;
  block.param_count = 1;
  block.params = radii;
  lam_problem_add(problem, block);
  if (!isnan(angle)) add_tangents(scope, stars, star, centers, angle);
}
