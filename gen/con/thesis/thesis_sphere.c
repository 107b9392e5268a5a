/* Stars on spheres or planes of their own, and the angle of the tangents of def. 10, in the form of
 * the thesis: for S-nets and isogonal nets (net/kinds). */
#include "con/kernel.h"
#include "con/thesis/thesis.h"

/* ---- spheres (thesis eq. 3.3) ---- */

/* Square of a vertex, unknowns v, w:
 *   r = (v - o)^2 - w  (length^2),  dr/dv = 2 (v - o), dr/dw = -1
 * p = o, an origin near the net, so that the squares do not lose digits. */
static void square(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = -x[3];
  for (int c = 0; c < 3; c++) r[0] += (x[c] - p[c]) * (x[c] - p[c]);
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = c < 3 ? 2 * (x[c] - p[c]) : -1;
}

/* A star on one sphere or plane (thesis eq. 3.3), unknowns v_0..v_4, w_0..w_4, (a, b, e):
 *   r_k = a w_k + b . (v_k - o) + e  (length, k = 0..4),  r_5 = b^2 - 4 a e - 1;  p = o
 *   dr_k: b by v_k, a by w_k, and w_k, v_k - o, 1 by a, b, e;  dr_5: -4 e, 2 b, -4 a by a, b, e */
static void sphere(int n, const double *x, const double *p, double *r, double *J) {
  const double *w = x + 15, *b = x + 21;
  double a = x[20], e = x[24];
  for (int i = 0; J && i < 6 * n; i++) J[i] = 0;

  for (int k = 0; k < 5; k++) {
    double *row = J + k * n;
    r[k] = a * w[k] + e;
    for (int c = 0; c < 3; c++) r[k] += b[c] * (x[3 * k + c] - p[c]);
    if (!J) continue;
    for (int c = 0; c < 3; c++) {
      row[3 * k + c] = b[c];
      row[21 + c] = x[3 * k + c] - p[c];
    }
    row[15 + k] = a;
    row[20] = w[k];
    row[24] = 1;
  }

  r[5] = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] - 4 * a * e - 1;
  if (!J) return;
  for (int c = 0; c < 3; c++) J[5 * n + 21 + c] = 2 * b[c];
  J[5 * n + 20] = -4 * e;
  J[5 * n + 24] = -4 * a;
}

/* The origin o as the parameters of count elements. */
static double *origins(lam_arena *arena, int count, lam_vec3 o) {
  double *params = LAM_NEW(arena, double, 3 * count);
  for (int i = 0; i < count; i++) {
    params[3 * i] = o.x;
    params[3 * i + 1] = o.y;
    params[3 * i + 2] = o.z;
  }
  return params;
}

/* Nodes w_v = (v - o)^2 of all vertices, one after the other; the first is returned. */
static int add_squares(lam_scope *scope, lam_vec3 o) {
  lam_problem *problem = scope->problem;
  int n = problem->vertex_count, first = problem->node_count,
      *nodes = LAM_NEW(problem->arena, int, 2 * n);
  for (int v = 0; v < n; v++) {
    lam_vec3 d = lam_sub(lam_local(problem->x, v), o);
    nodes[2 * v] = v;
    nodes[2 * v + 1] = lam_problem_node(problem, 1, (double[]){lam_dot(d, d)});
  }

  lam_block block = {.name = "square", .kernel = square, .rows = 1, .weight = 1, .arity = 2};
  block.count = n;
  block.nodes = nodes;
  block.param_count = 3;
  block.params = origins(problem->arena, n, o);
  lam_problem_add(problem, block);
  return first;
}

/* The node (a, b, e) of a star at its start: the sphere a y^2 + b . y + e = 0, y = x - o, through
 * the star's vertex v with the gradient N there, so that b = N - 2 a (v - o). It passes through a
 * neighbor at the edge E when a = -N.E / E^2; a is the mean of these. */
static int sphere_node(lam_problem *problem, const int *star, lam_vec3 N, lam_vec3 o) {
  lam_vec3 v = lam_sub(lam_local(problem->x, star[0]), o);
  double a = 0;
  for (int k = 1; k < 5; k++) {
    lam_vec3 E = lam_sub(lam_local(problem->x, star[k]), lam_local(problem->x, star[0]));
    a -= lam_dot(N, E) / lam_dot(E, E) / 4;
  }
  lam_vec3 b = lam_along(N, -2 * a, v);
  return lam_problem_node(problem, 5,
                          (double[]){a, b.x, b.y, b.z, -a * lam_dot(v, v) - lam_dot(b, v)});
}

/* The origin is the mean of the vertices. */
void lam_thesis_spherical_stars(lam_scope *scope) {
  lam_problem *problem = scope->problem;
  int n = problem->vertex_count;
  lam_vec3 *x, *normals, o = {0, 0, 0};
  lam_thesis_normals(scope, &x, &normals);
  for (int v = 0; v < n; v++) o = lam_along(o, 1. / n, x[v]);
  int squares = add_squares(scope, o);

  const int *star;
  int count = lam_scope_stars(scope, false, &star),
      *nodes = LAM_NEW(problem->arena, int, 11 * count);
  for (int s = 0; s < count; s++, star += 5) {
    for (int k = 0; k < 5; k++) {
      nodes[11 * s + k] = star[k];
      nodes[11 * s + 5 + k] = squares + star[k];
    }
    nodes[11 * s + 10] = sphere_node(problem, star, normals[star[0]], o);
  }

  lam_block block = {.name = "spherical-star", .kernel = sphere, .rows = 6, .weight = 1};
  block.count = count;
  block.arity = 11;
  block.nodes = nodes;
  block.param_count = 3;
  block.params = origins(problem->arena, count, o);
  lam_problem_add(problem, block);
}

/* ---- tangents of circles (thesis def. 10) ---- */

/* Square of an edge, unknowns v, v_k, l:
 *   r = (v_k - v)^2 - l  (length^2),  2 (v_k - v) by v_k, the opposite by v, -1 by l */
static void edge_square(int n, const double *x, const double *p, double *r, double *J) {
  (void)n, (void)p;
  r[0] = -x[6];
  for (int c = 0; c < 3; c++) {
    double d = x[3 + c] - x[c];
    r[0] += d * d;
    if (!J) continue;
    J[3 + c] = 2 * d;
    J[c] = -2 * d;
  }
  if (J) J[6] = -1;
}

/* Tangent of the circle through three vertices (thesis def. 10), unknowns v, v1, v3, l1, l3, t:
 *   r = E1 l3 - E3 l1 - t  (length^3),  E_k = v_k - v,  l_k = E_k^2
 *   by v: (l1 - l3) I, by v1: l3 I, by v3: -l1 I, by l1: -E3, by l3: E1, by t: -I */
static void circle_tangent(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  double l1 = x[9], l3 = x[10];
  for (int i = 0; J && i < 3 * n; i++) J[i] = 0;

  for (int c = 0; c < 3; c++) {
    double E1 = x[3 + c] - x[c], E3 = x[6 + c] - x[c];
    r[c] = E1 * l3 - E3 * l1 - x[11 + c];
    if (!J) continue;
    double *row = J + c * n;
    row[c] = l1 - l3;
    row[3 + c] = l3;
    row[6 + c] = -l1;
    row[9] = -E3;
    row[10] = E1;
    row[11 + c] = -1;
  }
}

/* Makes the nodes l1, l3 and t of the polyline from vertex side[1] over v to side[0], and writes
 * the nodes of its two elements of edge_square (3 each) and of its circle_tangent (6). Returns node
 * t. */
static int tangent_node(lam_problem *problem, int v, const int side[2], int *squares, int *line) {
  lam_vec3 E[2];
  double l[2];
  int node[2];
  for (int k = 0; k < 2; k++) {
    E[k] = lam_sub(lam_local(problem->x, side[k]), lam_local(problem->x, v));
    l[k] = lam_dot(E[k], E[k]);
    node[k] = lam_problem_node(problem, 1, &l[k]);
    int *to = squares + 3 * k;
    to[0] = v, to[1] = side[k], to[2] = node[k];
  }

  lam_vec3 t = lam_along(lam_scale(E[0], l[1]), -l[0], E[1]);
  int tangent = lam_thesis_vector_node(problem, t);
  line[0] = v, line[1] = side[0], line[2] = side[1];
  line[3] = node[0], line[4] = node[1], line[5] = tangent;
  return tangent;
}

/* Two tangents per star, along u and along v. */
void lam_thesis_circle_angle(lam_scope *scope, double angle) {
  lam_problem *problem = scope->problem;
  lam_arena *arena = problem->arena;
  const int *star;
  int stars = lam_scope_stars(scope, false, &star);
  int *squares = LAM_NEW(arena, int, 12 * stars), *lines = LAM_NEW(arena, int, 12 * stars),
      *tangents = LAM_NEW(arena, int, 2 * stars);
  for (int i = 0; i < 2 * stars; i++) {
    const int *s = star + i / 2 * 5, side[2] = {s[1 + (i & 1)], s[3 + (i & 1)]};
    tangents[i] = tangent_node(problem, s[0], side, squares + 6 * i, lines + 6 * i);
  }

  lam_block block = {.name = "edge-square", .kernel = edge_square, .rows = 1, .weight = 1};
  block.count = 4 * stars;
  block.arity = 3;
  block.nodes = squares;
  lam_problem_add(problem, block);

  block = (lam_block){.name = "tangent", .kernel = circle_tangent, .rows = 3, .weight = 1};
  block.count = 2 * stars;
  block.arity = 6;
  block.nodes = lines;
  lam_problem_add(problem, block);
  lam_thesis_crossing(scope, stars, lam_thesis_units(scope, 2 * stars, tangents), angle);
}
