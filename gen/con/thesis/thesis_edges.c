/* Half-edges with unit vectors and lengths as unknowns (thesis 3.7.1), which thesis_angle.c builds
 * on, and geodesic parallel coordinates with them, for net/kinds/geodesic_parallel_net.c. */
#include "con/kernel.h"
#include "con/thesis/thesis.h"

/* Half-edge of thesis 3.7.1, unknowns v_i, v_j, (e, w):
 *   r_0..2 = v_j - v_i - w e  (length),  r_3 = (v_j - v_i)^2 - w^2  (length^2)
 * Both together make e a unit vector. By v_j: I and 2 (v_j - v_i), by v_i the opposite, by e: -w I,
 * by w: -e and -2 w. */
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

/* Valences are small: the ring is searched. */
int lam_half_edge_find(const lam_half_edges *edges, int from, int to) {
  int at = edges->net->ring_start[from];
  while (edges->net->ring[at] != to) at++;
  return at;
}

/* Makes a node (e, w) per entry of net->ring, in that order, and writes the nodes of the elements:
 * vertex, neighbor, half-edge. */
static void make_half_edges(lam_problem *problem, const lam_net *net, int *nodes) {
  for (int v = 0; v < net->mesh.vertex_count; v++)
    for (int k = net->ring_start[v]; k < net->ring_start[v + 1]; k++) {
      lam_vec3 E = lam_sub(lam_local(problem->x, net->ring[k]), lam_local(problem->x, v)),
               e = lam_unit(E);
      nodes[3 * k] = v;
      nodes[3 * k + 1] = net->ring[k];
      nodes[3 * k + 2] = lam_problem_node(problem, 4, (double[]){e.x, e.y, e.z, lam_length(E)});
    }
}

/* The nodes follow one another in the order of the rings. */
lam_half_edges lam_half_edges_add(lam_scope *scope) {
  const lam_net *net = scope->net;
  lam_problem *problem = scope->problem;
  int count = net->ring_start[net->mesh.vertex_count],
      *nodes = LAM_NEW(problem->arena, int, 3 * count);
  lam_half_edges edges = {net, problem->node_count, LAM_NEW(problem->arena, int, count)};
  make_half_edges(problem, net, nodes);

  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      const int *v = net->edges[e].vertex;
      edges.family[lam_half_edge_find(&edges, v[k], v[1 - k])] = net->edges[e].family;
    }

  lam_block block = {.name = "half-edge", .kernel = half_edge, .rows = 4, .weight = 1, .arity = 3};
  block.count = count;
  block.nodes = nodes;
  lam_problem_add(problem, block);
  return edges;
}

/* ---- geodesic parallel coordinates ---- */

/* One u-edge between two v-edges of a star (thesis 3.7.2), each (e, w):
 *   r = e_u . (e_v - e_-v)  (dimensionless)
 *   dr/de_u = e_v - e_-v, dr/de_v = e_u, dr/de_-v = -e_u */
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

/* Writes the nodes of the element at vertex v whose u-edge goes to the neighbor u, and its v-edges
 * to the neighbors left and right. */
static void put_element(const lam_half_edges *edges, int v, int u, int left, int right, int *to) {
  to[0] = edges->first + lam_half_edge_find(edges, v, u);
  to[1] = edges->first + lam_half_edge_find(edges, v, left);
  to[2] = edges->first + lam_half_edge_find(edges, v, right);
}

/* Two elements per star, and with border one per half star whose inner edge is a geodesic. */
void lam_thesis_geodesic_parallel(lam_scope *scope, int family, bool border) {
  lam_half_edges edges = lam_half_edges_add(scope);
  const int *star, *half;
  int stars = lam_scope_stars(scope, false, &star),
      halves = border ? lam_scope_half_stars(scope, &half) : 0, count = 0;
  int *nodes = LAM_NEW(scope->problem->arena, int, 3 * (2 * stars + halves));
  int u = 1 + (family & 1), v = 2 - (family & 1); /* where +u and +v of the geodesics stand */
  for (int s = 0; s < stars; s++, star += 5)
    for (int side = 0; side < 2; side++, count++)
      put_element(&edges, star[0], star[u + 2 * side], star[v], star[v + 2], nodes + 3 * count);

  for (int s = 0; s < halves; s++, half += 4) {
    if (edges.family[lam_half_edge_find(&edges, half[0], half[2])] != family) continue;
    put_element(&edges, half[0], half[2], half[1], half[3], nodes + 3 * count);
    count++;
  }

  lam_block block = {.name = "geodesic-parallel", .kernel = geodesic_parallel, .rows = 1};
  block.weight = 1;
  block.count = count;
  block.arity = 3;
  block.nodes = nodes;
  lam_problem_add(scope->problem, block);
}
