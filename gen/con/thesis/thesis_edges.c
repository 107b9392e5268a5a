#include "con/kernel.h"
#include "con/thesis/thesis.h"

/* Half-edge of thesis 3.7.1, unknowns v_i, v_j, e, w:
 *   r1..3 = v_j - v_i - w e  (length),  r4 = (v_j - v_i)^2 - w^2  (length^2)
 * Both together make e a unit vector. */
static void half_edge(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  const double *e = x + 6, w = x[9];
  r[3] = -w * w;
  for (int c = 0; c < 3; c++) {
    double d = x[3 + c] - x[c];
    r[c] = d - w * e[c];
    r[3] += d * d;
  }
  if (!J) return;
  for (int i = 0; i < 4 * n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c * n + c] = -1;
    J[c * n + 3 + c] = 1;
    J[c * n + 6 + c] = -w;
    J[c * n + 9] = -e[c];
    J[3 * n + 3 + c] = 2 * (x[3 + c] - x[c]);
    J[3 * n + c] = -J[3 * n + 3 + c];
  }
  J[3 * n + 9] = -2 * w;
}

int lam_half_edge_find(const lam_half_edges *edges, int from, int to) {
  int at = edges->net->ring_start[from];
  while (edges->net->ring[at] != to) at++;
  return at;
}

lam_half_edges lam_half_edges_add(lam_scope *scope) {
  const lam_net *net = scope->net;
  lam_problem *problem = scope->problem;
  int count = net->ring_start[net->mesh.vertex_count],
      *nodes = LAM_NEW(problem->arena, int, 3 * count);
  lam_half_edges edges = {net, problem->node_count, LAM_NEW(problem->arena, int, count)};
  for (int v = 0; v < net->mesh.vertex_count; v++)
    for (int k = net->ring_start[v]; k < net->ring_start[v + 1]; k++) {
      lam_vec3 E = lam_sub(lam_local(problem->x, net->ring[k]), lam_local(problem->x, v)),
               e = lam_unit(E);
      nodes[3 * k] = v;
      nodes[3 * k + 1] = net->ring[k];
      nodes[3 * k + 2] = lam_problem_node(problem, 4, (double[]){e.x, e.y, e.z, lam_length(E)});
    }
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++)
      edges.family[lam_half_edge_find(&edges, net->edges[e].vertex[k],
                                      net->edges[e].vertex[1 - k])] = net->edges[e].family;
  lam_problem_add(problem, (lam_block){.name = "half-edge",
                                       .kernel = half_edge,
                                       .rows = 4,
                                       .weight = 1,
                                       .count = count,
                                       .arity = 3,
                                       .nodes = nodes});
  return edges;
}

/* One u-edge between two v-edges of a star, each (e, w):  r = e_u . (e_v - e_-v) */
static void geodesic_parallel(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  r[0] = 0;
  for (int c = 0; c < 3; c++) r[0] += x[c] * (x[4 + c] - x[8 + c]);
  if (!J) return;
  for (int i = 0; i < n; i++) J[i] = 0;
  for (int c = 0; c < 3; c++) {
    J[c] = x[4 + c] - x[8 + c];
    J[4 + c] = x[c];
    J[8 + c] = -x[c];
  }
}

void lam_thesis_geodesic_parallel(lam_scope *scope, int family, bool border) {
  lam_half_edges edges = lam_half_edges_add(scope);
  const int *star, *half;
  int stars = lam_scope_stars(scope, false, &star),
      halves = border ? lam_scope_half_stars(scope, &half) : 0, count = 0;
  int *nodes = LAM_NEW(scope->problem->arena, int, 3 * (2 * stars + halves));
  for (int s = 0; s < stars; s++, star += 5)
    for (int side = 0; side < 2; side++, count++) {
      int u = 1 + (family & 1) + 2 * side, v = 2 - (family & 1);
      nodes[3 * count] = lam_half_edge_find(&edges, star[0], star[u]);
      nodes[3 * count + 1] = lam_half_edge_find(&edges, star[0], star[v]);
      nodes[3 * count + 2] = lam_half_edge_find(&edges, star[0], star[v + 2]);
    }
  for (int s = 0; s < halves; s++, half += 4) {
    int inner = lam_half_edge_find(&edges, half[0], half[2]);
    if (edges.family[inner] != family) continue;
    nodes[3 * count] = inner;
    nodes[3 * count + 1] = lam_half_edge_find(&edges, half[0], half[1]);
    nodes[3 * count + 2] = lam_half_edge_find(&edges, half[0], half[3]);
    count++;
  }
  for (int i = 0; i < 3 * count; i++) nodes[i] += edges.first;
  lam_problem_add(scope->problem, (lam_block){.name = "geodesic-parallel",
                                              .kernel = geodesic_parallel,
                                              .rows = 1,
                                              .weight = 1,
                                              .count = count,
                                              .arity = 3,
                                              .nodes = nodes});
}
