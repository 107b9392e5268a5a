/* Conditions that are linear in the lengths of a few edges: the common kernel of equal_edges.c,
 * jacobi.c and strip_widths.c. */
#include "con/edge_sums.h"
#include "con/kernel.h"

#include <string.h>

/* r = sum p[k] |b_k - a_k| (length); nodes a_0, b_0, a_1, b_1, ... A vertex may be listed twice.
 *   d|b - a| / db = (b - a) / |b - a|, and the opposite by a */
static void edge_sum(int n, const double *x, const double *p, double *r, double *J) {
  r[0] = 0;
  for (int c = 0; J && c < n; c++) J[c] = 0;

  for (int k = 0; 6 * k < n; k++) {
    lam_vec3 E = lam_sub(lam_local(x, 2 * k + 1), lam_local(x, 2 * k));
    double length = lam_length(E);
    r[0] += p[k] * length;
    if (!J) continue;
    lam_add_to(J, 2 * k + 1, lam_scale(E, p[k] / length));
    lam_add_to(J, 2 * k, lam_scale(E, -p[k] / length));
  }
}

lam_edge_list lam_edge_list_new(lam_arena *arena, int edges_each, int capacity) {
  return (lam_edge_list){edges_each, 0, LAM_NEW(arena, int, 2 * edges_each * capacity)};
}

void lam_edge_list_push(lam_edge_list *list, const int *vertices) {
  memcpy(list->nodes + 2 * list->edges_each * list->count++, vertices,
         sizeof(int) * 2 * (size_t)list->edges_each);
}

/* Every element has the same coefficients as its parameters. */
void lam_edge_sum_add(lam_scope *scope, const char *name, double weight, const lam_edge_list *list,
                      const double *coefficients) {
  int each = list->edges_each;
  double *params = LAM_NEW(scope->problem->arena, double, each * list->count);
  for (int i = 0; i < each * list->count; i++) params[i] = coefficients[i % each];

  lam_block block = {.name = name, .kernel = edge_sum, .rows = 1, .weight = weight};
  block.count = list->count;
  block.arity = 2 * each;
  block.nodes = list->nodes;
  block.param_count = each;
  block.params = params;
  lam_problem_add(scope->problem, block);
}

/* In a face a b c d the edge d c is opposite to a b, in the same direction. */
bool lam_opposite_edge(const lam_net *net, int f, const lam_edge *e, int opposite[2]) {
  const int *corner = net->mesh.faces[f];
  for (int k = 0; k < 4; k++) {
    int a = corner[k], b = corner[(k + 1) & 3], c = corner[(k + 2) & 3], d = corner[(k + 3) & 3];
    if (a == e->vertex[0] && b == e->vertex[1]) return opposite[0] = d, opposite[1] = c, true;
    if (b == e->vertex[0] && a == e->vertex[1]) return opposite[0] = c, opposite[1] = d, true;
  }
  return false;
}
