/* The constraint `edge-length`. Listed in constraints.c; net/kinds/geodesic_parallel_net.c adds it,
 * and K-nets, Chebyshev nets and the stiffness of net/optimize.c by lam_edge_length_add. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Length of an edge E = v1 - v0 (thesis 3.1, definition 3):
 *   r = (|E|^2 / L^2 - 1) / 2  (dimensionless; the half makes it a relative error);  p[0] = 1 / L^2
 *   dr/dv1 = E / L^2, dr/dv0 = -E / L^2 */
static void edge_length(int n, const double *x, const double *p, double *r, double *J) {
  (void)n;
  lam_vec3 E = lam_sub(lam_local(x, 1), lam_local(x, 0));
  r[0] = .5 * (lam_dot(E, E) * p[0] - 1);
  if (!J) return;
  for (int c = 0; c < 6; c++) J[c] = 0;
  lam_add_to(J, 1, lam_scale(E, p[0]));
  lam_add_to(J, 0, lam_scale(E, -p[0]));
}

/* The length that an edge has to have, in solver units. */
static double wanted_length(const lam_scope *scope, const lam_edge *edge, double given) {
  if (given > 0) return given / scope->unit;
  return lam_distance(lam_local(scope->problem->x, edge->vertex[0]),
                      lam_local(scope->problem->x, edge->vertex[1]));
}

/* All edges, or those of the boundary. */
void lam_edge_length_add(lam_scope *scope, const char *name, lam_role role, double weight,
                         lam_edge_length_params given) {
  const lam_net *net = scope->net;
  lam_arena *arena = scope->problem->arena;
  int count = 0, *nodes = LAM_NEW(arena, int, 2 * net->edge_count);
  double *params = LAM_NEW(arena, double, net->edge_count);
  for (int e = 0; e < net->edge_count; e++) {
    const lam_edge *edge = &net->edges[e];
    if (given.boundary_only && edge->face[1] >= 0) continue;
    double L = wanted_length(scope, edge, given.length);
    nodes[2 * count] = edge->vertex[0];
    nodes[2 * count + 1] = edge->vertex[1];
    params[count++] = 1 / (L * L);
  }

  lam_block block = {.name = name, .kernel = edge_length, .rows = 1, .role = role, .arity = 2};
  block.weight = weight;
  block.count = count;
  block.nodes = nodes;
  block.param_count = 1;
  block.params = params;
  lam_problem_add(scope->problem, block);
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  lam_edge_length_add(scope, "edge-length", LAM_HARD, weight,
                      *(const lam_edge_length_params *)params);
}

static const lam_key keys[] = {
    LAM_LENGTH_KEY(lam_edge_length_params, "length", length, "0", 0, 1e6,
                   "Length of every edge; 0 keeps each at its length at the start."),
    LAM_FLAG_KEY(lam_edge_length_params, "boundary", boundary_only, "no",
                 "Only edges of the boundary."),
    {0}};

const lam_constraint_kind lam_con_edge_length = {
    {"edge-length", "Edge lengths",
     "Edges of a given length, or each of its length at the start. With one length for all, the "
     "net is a Chebyshev net.",
     "(|v1 - v0|^2 / L^2 - 1) / 2 = 0", "thesis 3.1, definition 3", keys,
     sizeof(lam_edge_length_params)},
    add};
