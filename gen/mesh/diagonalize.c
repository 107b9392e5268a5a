#include "mesh/diagonalize.h"

#include <string.h>

/* Two colors that differ along every edge; false when a line of an odd number of edges closes. */
static bool color_vertices(lam_arena *arena, const lam_net *net, int *color) {
  int n = net->mesh.vertex_count, *queue = LAM_NEW(arena, int, n);
  memset(color, -1, sizeof *color * (size_t)n);
  for (int seed = 0; seed < n; seed++) {
    if (color[seed] >= 0) continue;
    int head = 0, tail = 0;
    queue[tail++] = seed;
    color[seed] = 0;
    while (head < tail) {
      int v = queue[head++];
      for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++) {
        int w = net->ring[i];
        if (color[w] == color[v]) return false;
        if (color[w] >= 0) continue;
        color[w] = !color[v];
        queue[tail++] = w;
      }
    }
  }
  return true;
}

const char *lam_net_diagonalize(lam_arena *arena, const lam_net *net, lam_mesh *mesh) {
  int n = net->mesh.vertex_count, *color = LAM_NEW(arena, int, n), *index = LAM_NEW(arena, int, n);
  if (!color_vertices(arena, net, color)) return "a closed line has an odd number of edges";
  bool irregular[2] = {false, false};
  for (int v = 0; v < n; v++)
    if (!net->boundary[v]) irregular[color[v]] |= net->ring_start[v + 1] - net->ring_start[v] != 4;
  int stays = irregular[1] ? 1 : 0;
  if (irregular[!stays]) return "irregular vertices lie an odd number of edges apart";
  *mesh = (lam_mesh){0};
  mesh->faces = (int(*)[4])lam_arena_alloc(arena, (size_t)n, sizeof *mesh->faces);
  for (int s = 0; s < net->star_count; s++) {
    const lam_star *star = &net->stars[s];
    if (color[star->center] == stays) continue;
    for (int k = 0; k < 4; k++) {
      mesh->faces[mesh->face_count][k] = star->neighbor[k];
      index[star->neighbor[k]] = 1;
    }
    mesh->face_count++;
  }
  if (!mesh->face_count) return "it has no inner vertex to put a face around";
  mesh->vertices = LAM_NEW(arena, lam_vec3, n);
  for (int v = 0; v < n; v++)
    if (index[v]) {
      mesh->vertices[mesh->vertex_count] = net->mesh.vertices[v];
      index[v] = mesh->vertex_count++;
    }
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 4; k++) mesh->faces[f][k] = index[mesh->faces[f][k]];
  return NULL;
}
