#include "con/kernel.h"
#include "con/thesis/thesis.h"

/* Square of a vertex, unknowns v, w:  r = (v - o)^2 - w;  p = o, an origin near the net (rounding)
 */
static void square(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = -x[3];
  for (int c = 0; c < 3; c++) r[0] += (x[c] - p[c]) * (x[c] - p[c]);
  if (!J) return;
  for (int c = 0; c < n; c++) J[c] = c < 3 ? 2 * (x[c] - p[c]) : -1;
}

/* A star on one sphere or plane (thesis eq. 3.3), unknowns v_0..v_4, w_0..w_4, (a, b, e):
 *   r_k = a w_k + b . (v_k - o) + e,  r_5 = b^2 - 4 a e - 1;  p = o */
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

/* Nodes w_v = (v - o)^2 of all vertices; the first is returned. */
static int add_squares(lam_scope *scope, lam_vec3 o) {
  lam_problem *problem = scope->problem;
  int n = problem->vertex_count, first = problem->node_count,
      *nodes = LAM_NEW(problem->arena, int, 2 * n);
  double *params = LAM_NEW(problem->arena, double, 3 * n);
  for (int v = 0; v < n; v++) {
    lam_vec3 d = lam_sub(lam_local(problem->x, v), o);
    nodes[2 * v] = v;
    nodes[2 * v + 1] = lam_problem_node(problem, 1, (double[]){lam_dot(d, d)});
    for (int c = 0; c < 3; c++) params[3 * v + c] = c == 0 ? o.x : c == 1 ? o.y : o.z;
  }
  lam_problem_add(problem, (lam_block){.name = "square",
                                       .kernel = square,
                                       .rows = 1,
                                       .weight = 1,
                                       .count = n,
                                       .arity = 2,
                                       .nodes = nodes,
                                       .param_count = 3,
                                       .params = params});
  return first;
}

/* The sphere through v with normal N that fits the star best: a (v - o)^2 + b . (v - o) + e has the
 * gradient N at v. */
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

void lam_thesis_spherical_stars(lam_scope *scope) {
  lam_problem *problem = scope->problem;
  lam_arena *arena = problem->arena;
  int n = problem->vertex_count;
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, n), *normals = LAM_NEW(arena, lam_vec3, n), o = {0, 0, 0};
  lam_problem_positions(problem, x);
  lam_net_normals(scope->net, x, normals);
  for (int v = 0; v < n; v++) o = lam_along(o, 1. / n, x[v]);
  int squares = add_squares(scope, o);
  const int *star;
  int count = lam_scope_stars(scope, false, &star), *nodes = LAM_NEW(arena, int, 11 * count);
  double *params = LAM_NEW(arena, double, 3 * count);
  for (int s = 0; s < count; s++, star += 5) {
    for (int k = 0; k < 5; k++) {
      nodes[11 * s + k] = star[k];
      nodes[11 * s + 5 + k] = squares + star[k];
    }
    nodes[11 * s + 10] = sphere_node(problem, star, normals[star[0]], o);
    for (int c = 0; c < 3; c++) params[3 * s + c] = c == 0 ? o.x : c == 1 ? o.y : o.z;
  }
  lam_problem_add(problem, (lam_block){.name = "spherical-star",
                                       .kernel = sphere,
                                       .rows = 6,
                                       .weight = 1,
                                       .count = count,
                                       .arity = 11,
                                       .nodes = nodes,
                                       .param_count = 3,
                                       .params = params});
}

/* Square of an edge, unknowns v, v_k, l:  r = (v_k - v)^2 - l */
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
 *   r = E1 l3 - E3 l1 - t,  E_k = v_k - v,  l_k = E_k^2 */
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

void lam_thesis_circle_angle(lam_scope *scope, double angle) {
  lam_problem *problem = scope->problem;
  lam_arena *arena = problem->arena;
  const int *star;
  int stars = lam_scope_stars(scope, false, &star);
  int *squares = LAM_NEW(arena, int, 12 * stars), *lines = LAM_NEW(arena, int, 12 * stars),
      *tangents = LAM_NEW(arena, int, 2 * stars);
  for (int i = 0; i < 2 * stars; i++) {
    const int *s = star + i / 2 * 5, side[2] = {s[1 + (i & 1)], s[3 + (i & 1)]};
    lam_vec3 E[2];
    double l[2];
    int node[2];
    for (int k = 0; k < 2; k++) {
      E[k] = lam_sub(lam_local(problem->x, side[k]), lam_local(problem->x, s[0]));
      l[k] = lam_dot(E[k], E[k]);
      node[k] = lam_problem_node(problem, 1, &l[k]);
      int *to = squares + 6 * i + 3 * k;
      to[0] = s[0], to[1] = side[k], to[2] = node[k];
    }
    tangents[i] = lam_thesis_vector_node(problem, lam_along(lam_scale(E[0], l[1]), -l[0], E[1]));
    const int line[6] = {s[0], side[0], side[1], node[0], node[1], tangents[i]};
    for (int k = 0; k < 6; k++) lines[6 * i + k] = line[k];
  }
  lam_problem_add(problem, (lam_block){.name = "edge-square",
                                       .kernel = edge_square,
                                       .rows = 1,
                                       .weight = 1,
                                       .count = 4 * stars,
                                       .arity = 3,
                                       .nodes = squares});
  lam_problem_add(problem, (lam_block){.name = "tangent",
                                       .kernel = circle_tangent,
                                       .rows = 3,
                                       .weight = 1,
                                       .count = 2 * stars,
                                       .arity = 6,
                                       .nodes = lines});
  lam_thesis_crossing(scope, stars, lam_thesis_units(scope, 2 * stars, tangents), angle);
}
