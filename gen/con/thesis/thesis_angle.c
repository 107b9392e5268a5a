/* The angle of the bisector tangents in the form of the thesis, for asymptotic and isogonal nets
 * (net/kinds); and the blocks of unit tangents and their crossing that thesis_sphere.c and
 * thesis_radius.c share. */
#include "con/kernel.h"
#include "con/thesis/thesis.h"

#include <math.h>

/* r = U1 . U2 - cos(angle)  (dimensionless), unknowns (U1, a1), (U2, a2);  p[0] = cos(angle)
 *   dr/dU1 = U2, dr/dU2 = U1 */
static void crossing(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = x[0] * x[4] + x[1] * x[5] + x[2] * x[6] - p[0];
  if (!J) return;
  for (int i = 0; i < n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c] = x[4 + c];
    J[4 + c] = x[c];
  }
}

/* Rows 0..2: D - a T and row 3: T^2 - 1, where T = x[at..at+2] and a = x[at+3]. Derivatives by T
 * and a: -a I and -T, and 2 T in row 3. The caller adds dD/dx. */
static void scaled_unit(int n, const double *x, int at, const double D[3], double *r, double *J) {
  r[3] = -1;
  for (int c = 0; c < 3; c++) {
    r[c] = D[c] - x[at + 3] * x[at + c];
    r[3] += x[at + c] * x[at + c];
  }
  if (!J) return;

  for (int i = 0; i < 4 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c * n + at + c] = -x[at + 3];
    J[c * n + at + 3] = -x[at + c];
    J[3 * n + at + c] = 2 * x[at + c];
  }
}

/* Bisector tangent (thesis eq. 3.2), unknowns (e1, w1), (e3, w3), (T, a):
 *   r = e1 - e3 - a T,  T^2 - 1  (dimensionless), D = e1 - e3 for scaled_unit */
static void bisector(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  double D[3];
  for (int c = 0; c < 3; c++) D[c] = x[c] - x[4 + c];
  scaled_unit(n, x, 8, D, r, J);
  for (int c = 0; J && c < 3; c++) {
    J[c * n + c] = 1;
    J[c * n + 4 + c] = -1;
  }
}

/* Unit vector along T, unknowns T, (U, a):
 *   r = U - a T,  U^2 - 1  (dimensionless)
 *   dr/dU = I, dr/dT = -a I, dr/da = -T, and 2 U by U in the last row */
static void unit_along(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  const double *T = x, *U = x + 3, a = x[6];
  r[3] = -1;
  for (int c = 0; c < 3; c++) {
    r[c] = U[c] - a * T[c];
    r[3] += U[c] * U[c];
  }
  if (!J) return;

  for (int i = 0; i < 4 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c * n + c] = -a;
    J[c * n + 3 + c] = 1;
    J[c * n + 6] = -T[c];
    J[3 * n + 3 + c] = 2 * U[c];
  }
}

/* ---- blocks ---- */

/* One element per pair of tangents. */
void lam_thesis_crossing(lam_scope *scope, int count, const int *tangents, double angle) {
  double *cosines = LAM_NEW(scope->problem->arena, double, count);
  for (int i = 0; i < count; i++) cosines[i] = cos(angle);

  lam_block block = {.name = "angle", .kernel = crossing, .rows = 1, .weight = 1, .arity = 2};
  block.count = count;
  block.nodes = tangents;
  block.param_count = 1;
  block.params = cosines;
  lam_problem_add(scope->problem, block);
}

/* U starts at unit(T), and a at 1 / |T|. */
int *lam_thesis_units(lam_scope *scope, int count, const int *tangents) {
  lam_problem *problem = scope->problem;
  int *nodes = LAM_NEW(problem->arena, int, 2 * count),
      *units = LAM_NEW(problem->arena, int, count);
  for (int i = 0; i < count; i++) {
    lam_vec3 T = lam_local(problem->x + problem->offset[tangents[i]], 0), U = lam_unit(T);
    nodes[2 * i] = tangents[i];
    nodes[2 * i + 1] = units[i] =
        lam_problem_node(problem, 4, (double[]){U.x, U.y, U.z, 1 / lam_length(T)});
  }

  lam_block block = {.name = "unit-tangent", .kernel = unit_along, .rows = 4, .weight = 1};
  block.count = count;
  block.arity = 2;
  block.nodes = nodes;
  lam_problem_add(problem, block);
  return units;
}

/* The node (T, a) of a tangent at its start, from the nodes of the half-edges to both sides. */
static int tangent_node(lam_problem *problem, int ahead, int back) {
  lam_vec3 D = lam_sub(lam_local(problem->x + problem->offset[ahead], 0),
                       lam_local(problem->x + problem->offset[back], 0));
  lam_vec3 T = lam_unit(D);
  return lam_problem_node(problem, 4, (double[]){T.x, T.y, T.z, lam_length(D)});
}

/* Two tangents per star: along u and along v. */
void lam_thesis_angle(lam_scope *scope, double angle, bool border) {
  lam_half_edges edges = lam_half_edges_add(scope);
  lam_problem *problem = scope->problem;
  const int *star;
  int stars = lam_scope_stars(scope, border, &star);
  int *nodes = LAM_NEW(problem->arena, int, 6 * stars),
      *tangents = LAM_NEW(problem->arena, int, 2 * stars);
  for (int i = 0; i < 2 * stars; i++) {
    const int *s = star + i / 2 * 5;
    int ahead = edges.first + lam_half_edge_find(&edges, s[0], s[1 + (i & 1)]);
    int back = edges.first + lam_half_edge_find(&edges, s[0], s[3 + (i & 1)]);
    tangents[i] = tangent_node(problem, ahead, back);
    nodes[3 * i] = ahead;
    nodes[3 * i + 1] = back;
    nodes[3 * i + 2] = tangents[i];
  }

  lam_block block = {.name = "tangent", .kernel = bisector, .rows = 4, .weight = 1, .arity = 3};
  block.count = 2 * stars;
  block.nodes = nodes;
  lam_problem_add(problem, block);
  lam_thesis_crossing(scope, stars, tangents, angle);
}
