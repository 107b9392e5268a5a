#include "con/constraint.h"

static int valence_of(const lam_net *net, int v) {
  return net->ring_start[v + 1] - net->ring_start[v];
}

/* The family of the edge from v to its first neighbor. An edge lies on one polyline; edges are
 * found through the faces' order. */
static int *first_families(lam_arena *arena, const lam_net *net) {
  int *family = LAM_NEW(arena, int, net->mesh.vertex_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int k = 0; k < 2; k++) {
      int v = net->edges[e].vertex[k];
      if (net->ring[net->ring_start[v]] == net->edges[e].vertex[1 - k])
        family[v] = net->edges[e].family;
    }
  return family;
}

int lam_scope_stars(lam_scope *scope, bool border, const int **nodes) {
  const lam_net *net = scope->net;
  lam_arena *arena = scope->problem->arena;
  int count = 0, *list = LAM_NEW(arena, int, 5 * net->mesh.vertex_count);
  for (int s = 0; s < net->star_count; s++, count++) {
    list[5 * count] = net->stars[s].center;
    for (int k = 0; k < 4; k++) list[5 * count + 1 + k] = net->stars[s].neighbor[k];
  }
  const int *family = border ? first_families(arena, net) : NULL;
  for (int v = 0; border && v < net->mesh.vertex_count; v++) {
    if (!net->boundary[v] || valence_of(net, v) != 4) continue;
    list[5 * count] = v;
    for (int k = 0; k < 4; k++)
      list[5 * count + 1 + k] = net->ring[net->ring_start[v] + ((k + 3 * family[v]) & 3)];
    count++;
  }
  scope->skipped += net->irregular_count;
  *nodes = list;
  return count;
}

int lam_scope_half_stars(lam_scope *scope, const int **nodes) {
  const lam_net *net = scope->net;
  int count = 0, *list = LAM_NEW(scope->problem->arena, int, 4 * net->mesh.vertex_count);
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    if (!net->boundary[v] || valence_of(net, v) != 3) continue;
    list[4 * count] = v;
    for (int k = 0; k < 3; k++) list[4 * count + 1 + k] = net->ring[net->ring_start[v] + k];
    count++;
  }
  *nodes = list;
  return count;
}

const lam_key lam_star_keys[] = {LAM_FLAG_KEY(lam_star_params, "border", border, "no",
                                              "Vertices of the border take part: half stars, and "
                                              "reentrant corners, which have four edges."),
                                 {0}};
