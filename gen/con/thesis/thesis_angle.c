#include "con/kernel.h"
#include "con/thesis/thesis.h"

#include <math.h>

/* r = U1 . U2 - cos(angle), unknowns (U1, a1), (U2, a2);  p[0] = cos(angle) */
static void crossing(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = x[0] * x[4] + x[1] * x[5] + x[2] * x[6] - p[0];
  if (!J) return;
  for (int i = 0; i < n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c] = x[4 + c];
    J[4 + c] = x[c];
  }
}

/* Rows 0..2: D - a T and row 3: T^2 - 1, where T = x[at..at+2] and a = x[at+3]. The caller adds
 * dD/dx. */
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

/* Bisector tangent, unknowns (e1, w1), (e3, w3), (T, a):  r = e1 - e3 - a T,  T^2 - 1 */
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

/* Unit vector along T, unknowns T, (U, a):  r = U - a T,  U^2 - 1 */
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

void lam_thesis_crossing(lam_scope *scope, int count, const int *tangents, double angle) {
  double *cosines = LAM_NEW(scope->problem->arena, double, count);
  for (int i = 0; i < count; i++) cosines[i] = cos(angle);
  lam_problem_add(scope->problem, (lam_block){.name = "angle",
                                              .kernel = crossing,
                                              .rows = 1,
                                              .weight = 1,
                                              .count = count,
                                              .arity = 2,
                                              .nodes = tangents,
                                              .param_count = 1,
                                              .params = cosines});
}

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
  lam_problem_add(problem, (lam_block){.name = "unit-tangent",
                                       .kernel = unit_along,
                                       .rows = 4,
                                       .weight = 1,
                                       .count = count,
                                       .arity = 2,
                                       .nodes = nodes});
  return units;
}

void lam_thesis_angle(lam_scope *scope, double angle, bool border) {
  lam_half_edges edges = lam_half_edges_add(scope);
  lam_problem *problem = scope->problem;
  const int *star;
  int stars = lam_scope_stars(scope, border, &star);
  int *nodes = LAM_NEW(problem->arena, int, 6 * stars),
      *tangents = LAM_NEW(problem->arena, int, 2 * stars);
  for (int i = 0; i < 2 * stars; i++) {
    const int *s = star + i / 2 * 5;
    int a = edges.first + lam_half_edge_find(&edges, s[0], s[1 + (i & 1)]);
    int b = edges.first + lam_half_edge_find(&edges, s[0], s[3 + (i & 1)]);
    lam_vec3 D = lam_sub(lam_local(problem->x + problem->offset[a], 0),
                         lam_local(problem->x + problem->offset[b], 0));
    lam_vec3 T = lam_unit(D);
    tangents[i] = lam_problem_node(problem, 4, (double[]){T.x, T.y, T.z, lam_length(D)});
    nodes[3 * i] = a;
    nodes[3 * i + 1] = b;
    nodes[3 * i + 2] = tangents[i];
  }
  lam_problem_add(problem, (lam_block){.name = "tangent",
                                       .kernel = bisector,
                                       .rows = 4,
                                       .weight = 1,
                                       .count = 2 * stars,
                                       .arity = 3,
                                       .nodes = nodes});
  lam_thesis_crossing(scope, stars, tangents, angle);
}
