/* Conditions on the angles of a star that are linear in their cosines: the common part of
 * geodesic_parallel.c, opposite_angles.c and equal_angles.c. */
#include "con/star_cosines.h"

/* r = sum c_k <e_k, e_(k+1)>, cyclic (dimensionless), so
 *   dr/de_k = c_k e_(k+1) + c_(k-1) e_(k-1) */
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

/* Border vertex, nodes center, border, inner, border:
 *   r = <e2, e1 - e3>  (dimensionless),  dr/de1 = e2, dr/de2 = e1 - e3, dr/de3 = -e2 */
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
      int v = net->edges[e].vertex[k], inner = net->ring_start[v] + 1;
      if (net->boundary[v] && lam_net_valence(net, v) == 3 &&
          net->ring[inner] == net->edges[e].vertex[1 - k])
        family[v] = net->edges[e].family;
    }
  return family;
}

/* Of the half stars those whose inner edge has the family. */
void lam_border_angles_add(lam_scope *scope, const char *name, int family, double weight) {
  const int *all, *inner = inner_families(scope);
  int total = lam_scope_half_stars(scope, &all), count = 0;
  int *nodes = LAM_NEW(scope->problem->arena, int, 4 * total);
  for (int i = 0; i < total; i++) {
    if (family >= 0 && inner[all[4 * i]] != family) continue;
    for (int k = 0; k < 4; k++) nodes[4 * count + k] = all[4 * i + k];
    count++;
  }

  lam_block block = {.name = name, .kernel = border_angles, .rows = 1, .weight = weight};
  block.count = count;
  block.arity = 4;
  block.nodes = nodes;
  lam_problem_add(scope->problem, block);
}
