#include "con/star_cosines.h"

/* r = sum c_k <e_k, e_(k+1)>, cyclic, so dr/de_k = c_k e_(k+1) + c_(k-1) e_(k-1). */
void lam_star_cosines(int rows, const lam_cosines *cosines, int n, const double *x, double *r,
                      double *J) {
  lam_vec3 e[4];
  double length[4];
  lam_unit_edges(x, 4, e, length);
  for (int i = 0; i < rows; i++) {
    const signed char *c = cosines[i].c;
    r[i] = 0;
    for (int k = 0; k < 4; k++) r[i] += c[k] * lam_dot(e[k], e[(k + 1) & 3]);
    if (!J) continue;
    lam_vec3 de[4];
    for (int k = 0; k < 4; k++)
      de[k] = lam_along(lam_scale(e[(k + 1) & 3], c[k]), c[(k + 3) & 3], e[(k + 3) & 3]);
    lam_edges_row(J + i * n, 4, e, length, de);
  }
}

void lam_star_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        bool border, double weight) {
  lam_block block = {.name = name, .kernel = kernel, .rows = rows, .weight = weight, .arity = 5};
  block.count = lam_scope_stars(scope, border, &block.nodes);
  lam_problem_add(scope->problem, block);
}

/* Nodes: center, border, inner, border. r = <e2, e1 - e3>, dr/de1 = e2, dr/de2 = e1 - e3, dr/de3 =
 * -e2. */
static void border_angles(int n, const double *x, const double *p, double *r, double *J) {
  (void)n, (void)p;
  lam_vec3 e[3];
  double length[3];
  lam_unit_edges(x, 3, e, length);
  r[0] = lam_dot(e[1], lam_sub(e[0], e[2]));
  if (!J) return;
  lam_vec3 de[3] = {e[1], lam_sub(e[0], e[2]), lam_scale(e[1], -1)};
  lam_edges_row(J, 3, e, length, de);
}

/* The family of the inner edge of every border vertex with three edges; -1 elsewhere. */
static int *inner_families(const lam_scope *scope) {
  const lam_net *net = scope->net;
  int *family = LAM_NEW(scope->problem->arena, int, net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) family[v] = -1;
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      int v = net->edges[e].vertex[k], first = net->ring_start[v];
      if (net->boundary[v] && net->ring_start[v + 1] - first == 3 &&
          net->ring[first + 1] == net->edges[e].vertex[1 - k])
        family[v] = net->edges[e].family;
    }
  return family;
}

void lam_border_angles_add(lam_scope *scope, const char *name, int family, double weight) {
  const int *all, *inner = inner_families(scope);
  int total = lam_scope_half_stars(scope, &all), count = 0;
  int *nodes = LAM_NEW(scope->problem->arena, int, 4 * total);
  for (int i = 0; i < total; i++) {
    if (family >= 0 && inner[all[4 * i]] != family) continue;
    for (int k = 0; k < 4; k++) nodes[4 * count + k] = all[4 * i + k];
    count++;
  }
  lam_problem_add(scope->problem, (lam_block){.name = name,
                                              .kernel = border_angles,
                                              .rows = 1,
                                              .weight = weight,
                                              .count = count,
                                              .arity = 4,
                                              .nodes = nodes});
}
