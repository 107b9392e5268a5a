/* The constraint `jacobi`: strips between geodesics whose width changes linearly. Listed in
 * constraints.c; net/kinds/geodesic_parallel_net.c adds it. */
#include "con/edge_sums.h"

/* Jacobi's equation w'' + K w = 0 for the width w of a strip between two geodesics, with K = 0
 * (thesis 3.3.3, eq. 3.5):
 *   r = |w_(k-1)| - 2 |w_k| + |w_(k+1)|   (length),  w_k the edges across the strip
 * The Jacobian is in edge_sums.c. The geodesics have to be divided evenly (equal-edges). An element
 * is an edge w_k with a face on both sides, and the edges opposite to it in these. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_family_params *given = params;
  const lam_net *net = scope->net;
  lam_edge_list list = lam_edge_list_new(scope->problem->arena, 3, net->edge_count);
  for (int e = 0; e < net->edge_count; e++) {
    const lam_edge *edge = &net->edges[e];
    int before[2], after[2];
    if (edge->family == given->family || edge->face[1] < 0) continue;
    lam_opposite_edge(net, edge->face[0], edge, before);
    lam_opposite_edge(net, edge->face[1], edge, after);
    lam_edge_list_push(&list, (int[6]){before[0], before[1], edge->vertex[0], edge->vertex[1],
                                       after[0], after[1]});
  }

  static const double second_difference[3] = {1, -2, 1};
  lam_edge_sum_add(scope, "jacobi", weight, &list, second_difference);
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(lam_family_params, "geodesics", family, "0", 0, 1,
                    "Family whose lines bound the strips: 0, along u, or 1, along v."),
    {0}};

const lam_constraint_kind lam_con_jacobi = {
    {"jacobi", "Straight width of strips",
     "The width of every strip between two geodesics changes linearly along it, so that the "
     "Gaussian curvature is 0: together with geodesic-parallel and evenly divided geodesics the "
     "surface is nearly developable.",
     "|w(k-1)| - 2 |w(k)| + |w(k+1)| = 0", "thesis 3.3.3, eq. 3.4 and 3.5", keys,
     sizeof(lam_family_params)},
    add};
