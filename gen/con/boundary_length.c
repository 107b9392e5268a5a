#include "con/constraint.h"
#include "con/kernel.h"

/* Total length of one side of the boundary: r = sum |v_(k+1) - v_k| / L - 1  (dimensionless);  p[0]
 * = 1 / L */
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

/* Sides run between boundary corners (valence 2); a loop without corners is one side. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_net *net = scope->net;
  lam_arena *arena = scope->problem->arena;
  for (int l = 0; l < net->loop_count; l++) {
    const lam_polyline *loop = &net->loops[l];
    int n = loop->count, start = 0;
    for (int i = n - 1; i >= 0; i--)
      if (net->ring_start[loop->vertices[i] + 1] - net->ring_start[loop->vertices[i]] == 2)
        start = i;
    for (int from = 0; from < n;) {
      int to = from + 1;
      while (to < n && net->ring_start[loop->vertices[(start + to) % n] + 1] -
                               net->ring_start[loop->vertices[(start + to) % n]] !=
                           2)
        to++;
      int arity = to - from + 1, *nodes = LAM_NEW(arena, int, arity);
      double *params_of_side = LAM_NEW(arena, double, 1), length = 0;
      for (int i = 0; i < arity; i++) nodes[i] = loop->vertices[(start + from + i) % n];
      for (int i = 0; i + 1 < arity; i++)
        length += lam_distance(lam_local(scope->problem->x, nodes[i]),
                               lam_local(scope->problem->x, nodes[i + 1]));
      params_of_side[0] = 1 / length;
      lam_problem_add(scope->problem, (lam_block){.name = "boundary-length",
                                                  .kernel = path_length,
                                                  .rows = 1,
                                                  .weight = weight,
                                                  .count = 1,
                                                  .arity = arity,
                                                  .nodes = nodes,
                                                  .param_count = 1,
                                                  .params = params_of_side});
      from = to;
    }
  }
}

const lam_constraint_kind lam_con_boundary_length = {
    {"boundary-length", "Boundary length",
     "Every side of the boundary keeps its length at the start, while "
     "its vertices may move. Keeps a net from shrinking or growing "
     "when nothing else does.",
     "sum |v(k+1) - v(k)| / L - 1 = 0", "thesis 3.7", NULL, 0},
    add};
