/* The constraint `boundary-length`: sides of the boundary keep their length at the start. Listed in
 * constraints.c; several kinds of nets (net/kinds) add it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Total length of one side of the boundary, a path of vertices v_0, v_1, ...:
 *   r = sum |v_(k+1) - v_k| / L - 1     (dimensionless);  p[0] = 1 / L
 *   dr/dv_(k+1) = E / (|E| L), dr/dv_k = -E / (|E| L) for every edge E = v_(k+1) - v_k
 * Thesis 3.7. */
static void path_length(int n, const double *x, const double *p, double *r, double *J) {
  int count = n / 3;
  r[0] = -1;
  for (int c = 0; J && c < n; c++) J[c] = 0;

  for (int k = 0; k + 1 < count; k++) {
    lam_vec3 E = lam_sub(lam_local(x, k + 1), lam_local(x, k));
    double length = lam_length(E);
    r[0] += length * p[0];
    if (!J) continue;
    lam_add_to(J, k + 1, lam_scale(E, p[0] / length));
    lam_add_to(J, k, lam_scale(E, -p[0] / length));
  }
}

/* Length of the path of count vertices at the start, in solver units. */
static double length_at_start(const lam_problem *problem, int count, const int *vertices) {
  double length = 0;
  for (int i = 0; i + 1 < count; i++)
    length +=
        lam_distance(lam_local(problem->x, vertices[i]), lam_local(problem->x, vertices[i + 1]));
  return length;
}

/* A block of one element: its arity is the side's number of vertices. A closed side comes back to
 * its first vertex. */
static void add_side(lam_scope *scope, const lam_polyline *side, double weight) {
  lam_arena *arena = scope->problem->arena;
  int arity = side->count + side->closed, *nodes = LAM_NEW(arena, int, arity);
  for (int i = 0; i < arity; i++) nodes[i] = side->vertices[i % side->count];

  lam_block block = {.name = "boundary-length", .kernel = path_length, .rows = 1, .count = 1};
  block.weight = weight;
  block.arity = arity;
  block.nodes = nodes;
  block.param_count = 1;
  block.params = LAM_NEW(arena, double, 1);
  block.params[0] = 1 / length_at_start(scope->problem, arity, nodes);
  lam_problem_add(scope->problem, block);
}

/* One block per side. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_polyline *sides;
  int count = lam_scope_sides(scope, &sides);
  for (int s = 0; s < count; s++) add_side(scope, &sides[s], weight);
}

const lam_constraint_kind lam_con_boundary_length = {
    {"boundary-length", "Boundary length",
     "Every side of the boundary keeps its length at the start, while its vertices may move. Keeps "
     "a net from shrinking or growing when nothing else does.",
     "sum |v(k+1) - v(k)| / L - 1 = 0", "thesis 3.7", NULL, 0},
    add};
