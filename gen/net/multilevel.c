#include "net/multilevel.h"
#include "mesh/coarsen.h"

#include <stdlib.h>
#include <string.h>

/* A fine vertex and the coarse vertices between which it lies, in order: one, the two ends of an
 * edge, or the four corners of a face. */
typedef struct cell {
  int vertex;
  int corner[4]; /* -1: fewer */
} cell;

static int by_number(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }
static int by_corners(const void *a, const void *b) {
  return memcmp(((const cell *)a)->corner, ((const cell *)b)->corner,
                sizeof((const cell *)a)->corner);
}

static cell cell_of(int vertex, const int *corners, int count) {
  int sorted[4] = {-1, -1, -1, -1}, n = 0;
  cell c = {vertex, {-1, -1, -1, -1}};
  memcpy(sorted, corners, sizeof *corners * (size_t)count);
  qsort(sorted, (size_t)count, sizeof *sorted, by_number);
  for (int k = 0; k < count; k++)
    if (n == 0 || c.corner[n - 1] != sorted[k]) c.corner[n++] = sorted[k];
  return c;
}

/* The fine vertex in the cell of the given corners, or -1. */
static int find(const cell *cells, int count, const int *corners, int corner_count) {
  cell wanted = cell_of(-1, corners, corner_count);
  const cell *found = bsearch(&wanted, cells, (size_t)count, sizeof *cells, by_corners);
  return found ? found->vertex : -1;
}

bool lam_level_make(lam_arena *arena, const lam_net *fine, int least_faces, lam_level *level) {
  lam_coarse coarse;
  int n = fine->mesh.vertex_count;
  if (fine->mesh.face_count < 4 * least_faces || lam_net_coarsen(arena, fine, &coarse))
    return false;
  lam_errors quiet = {
      .arena = arena}; /* a closed net of few cells may have no coarse net: that is no error */
  if (!lam_net_build(arena, &coarse.mesh, (lam_location){0}, &quiet, &level->net)) return false;
  const lam_net *net = &level->net;
  int vertices = coarse.mesh.vertex_count;
  if (vertices + net->edge_count + coarse.mesh.face_count != n)
    return false; /* an odd number of cells somewhere */
  cell *cells = LAM_NEW(arena, cell, n);
  for (int v = 0; v < n; v++) cells[v] = cell_of(v, coarse.parents[v], 4);
  qsort(cells, (size_t)n, sizeof *cells, by_corners);
  for (int i = 0; i + 1 < n; i++) /* around a ring of two cells, two edges have the same ends */
    if (by_corners(&cells[i], &cells[i + 1]) == 0) return false;
  int *nearest = LAM_NEW(arena, int, n), *at = level->fine = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++) nearest[v] = coarse.parents[v][0];
  level->nearest = nearest;
  for (int v = 0; v < vertices; v++) *at++ = coarse.kept[v];
  for (int e = 0; e < net->edge_count; e++) *at++ = find(cells, n, net->edges[e].vertex, 2);
  for (int f = 0; f < coarse.mesh.face_count; f++) *at++ = find(cells, n, coarse.mesh.faces[f], 4);
  for (int v = 0; v < n; v++)
    if (level->fine[v] < 0) return false;
  return true;
}

void lam_level_refine(lam_arena *arena, const lam_level *level, lam_vec3 *positions) {
  lam_mesh refined = lam_net_four_point(arena, &level->net);
  for (int v = 0; v < refined.vertex_count; v++) positions[level->fine[v]] = refined.vertices[v];
}
