/* Coarse nets for coarse-to-fine solving, and the way back to the fine net.
 * Called by net/optimize.c. */
#include "net/multilevel.h"
#include "mesh/coarsen.h"

#include <stdlib.h>
#include <string.h>

/* A fine vertex and the coarse vertices between which it lies, in order: one, the two ends of an
 * edge, or the four corners of a face. */
typedef struct cell {
  int vertex;
  int corner[4]; /* ascending; -1: fewer */
} cell;

/* Orders of qsort and bsearch. */
static int by_number(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }
static int by_corners(const void *a, const void *b) {
  return memcmp(((const cell *)a)->corner, ((const cell *)b)->corner,
                sizeof((const cell *)a)->corner);
}

/* The cell of a fine vertex from count <= 4 coarse vertices, sorted, each once. */
static cell cell_of(int vertex, const int *corners, int count) {
  int sorted[4] = {-1, -1, -1, -1}, n = 0;
  cell c = {vertex, {-1, -1, -1, -1}};
  memcpy(sorted, corners, sizeof *corners * (size_t)count);
  qsort(sorted, (size_t)count, sizeof *sorted, by_number);
  for (int k = 0; k < count; k++)
    if (n == 0 || c.corner[n - 1] != sorted[k]) c.corner[n++] = sorted[k];
  return c;
}

/* The fine vertex in the cell of the given corners, or -1. cells: ordered by_corners. */
static int find(const cell *cells, int count, const int *corners, int corner_count) {
  cell wanted = cell_of(-1, corners, corner_count);
  const cell *found = bsearch(&wanted, cells, (size_t)count, sizeof *cells, by_corners);
  return found ? found->vertex : -1;
}

/* The cells of the n fine vertices, ordered by_corners; NULL when two have the same corners, as
 * the edges around a ring of two cells. */
static cell *ordered_cells(lam_arena *arena, int n, int (*parents)[4]) {
  cell *cells = LAM_NEW(arena, cell, n);
  for (int v = 0; v < n; v++) cells[v] = cell_of(v, parents[v], 4);
  qsort(cells, (size_t)n, sizeof *cells, by_corners);
  for (int i = 0; i + 1 < n; i++)
    if (by_corners(&cells[i], &cells[i + 1]) == 0) return NULL;
  return cells;
}

/* Coarsens, and numbers the refined net by finding for every vertex, edge and face of the coarse
 * net the fine vertex that lies there. */
bool lam_level_make(lam_arena *arena, const lam_net *fine, int least_faces, lam_level *level) {
  lam_coarse coarse;
  int n = fine->mesh.vertex_count;
  if (fine->mesh.face_count < 4 * least_faces || lam_net_coarsen(arena, fine, &coarse))
    return false;

  /* A closed net of few cells may have no coarse net: that is no error. */
  lam_errors quiet = {.arena = arena};
  if (!lam_net_build(arena, &coarse.mesh, (lam_location){0}, &quiet, &level->net)) return false;

  /* A subdivision puts one vertex on every vertex, edge and face; with an odd number of cells
   * somewhere there are fewer. */
  const lam_net *net = &level->net;
  int vertices = coarse.mesh.vertex_count;
  if (vertices + net->edge_count + coarse.mesh.face_count != n) return false;
  const cell *cells = ordered_cells(arena, n, coarse.parents);
  if (!cells) return false;

  int *nearest = LAM_NEW(arena, int, n), *at = level->fine = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++) nearest[v] = coarse.parents[v][0];
  level->nearest = nearest;

  /* The order of lam_net_four_point: vertices, edges, faces. */
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
