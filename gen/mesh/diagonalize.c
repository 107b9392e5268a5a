/* The net of the diagonals of a net: an edit that design/net_stage.c offers. */
#include "mesh/diagonalize.h"

#include <string.h>

/* Colors the connected piece of the vertex seed, from 0; false when a neighbor has the same color.
 * queue: room for all vertices. */
static bool color_piece(const lam_net *net, int seed, int *color, int *queue) {
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
  return true;
}

/* Two colors, 0 and 1, that differ along every edge; false when a line of an odd number of edges
 * closes. */
static bool color_vertices(lam_arena *arena, const lam_net *net, int *color) {
  int n = net->mesh.vertex_count, *queue = LAM_NEW(arena, int, n);
  memset(color, -1, sizeof *color * (size_t)n);
  for (int seed = 0; seed < n; seed++)
    if (color[seed] < 0 && !color_piece(net, seed, color, queue)) return false;
  return true;
}

/* The color whose vertices stay: irregular inner vertices have to be among them. -1: both colors
 * have some. */
static int color_that_stays(const lam_net *net, const int *color) {
  bool irregular[2] = {false, false};
  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (!net->boundary[v]) irregular[color[v]] |= lam_net_valence(net, v) != 4;
  if (irregular[0] && irregular[1]) return -1;
  return irregular[1] ? 1 : 0;
}

/* The faces around the regular inner vertices of the color that goes; corners are old indices.
 * used: per old vertex, set to 1 where a face has it as a corner. */
static void put_faces(const lam_net *net, const int *color, int stays, lam_mesh *mesh, int *used) {
  for (int s = 0; s < net->star_count; s++) {
    const lam_star *star = &net->stars[s];
    if (color[star->center] == stays) continue;
    for (int k = 0; k < 4; k++) {
      mesh->faces[mesh->face_count][k] = star->neighbor[k];
      used[star->neighbor[k]] = 1;
    }
    mesh->face_count++;
  }
}

/* Keeps the used vertices, in the old order, and renumbers the corners. index: used or not on
 * entry, the new index of used vertices on return. */
static void keep_vertices(const lam_net *net, lam_mesh *mesh, int *index) {
  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (index[v]) {
      mesh->vertices[mesh->vertex_count] = net->mesh.vertices[v];
      index[v] = mesh->vertex_count++;
    }
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 4; k++) mesh->faces[f][k] = index[mesh->faces[f][k]];
}

/* index holds first which vertices are corners of new faces, then their new indices. */
const char *lam_net_diagonalize(lam_arena *arena, const lam_net *net, lam_mesh *mesh) {
  int n = net->mesh.vertex_count, *color = LAM_NEW(arena, int, n), *index = LAM_NEW(arena, int, n);
  if (!color_vertices(arena, net, color)) return "a closed line has an odd number of edges";
  int stays = color_that_stays(net, color);
  if (stays < 0) return "irregular vertices lie an odd number of edges apart";

  *mesh = (lam_mesh){0};
  mesh->faces = (int(*)[4])lam_arena_alloc(arena, (size_t)n, sizeof *mesh->faces);
  put_faces(net, color, stays, mesh, index);
  if (!mesh->face_count) return "it has no inner vertex to put a face around";

  mesh->vertices = LAM_NEW(arena, lam_vec3, n);
  keep_vertices(net, mesh, index);
  return NULL;
}
