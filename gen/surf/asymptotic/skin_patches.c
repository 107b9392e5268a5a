/* Skins over cells of any connectivity: every edge once, for both of its patches. Called by
 * fab/parts/skin.c. */
#include "surf/asymptotic/asymptotic_skin.h"
#include "surf/asymptotic/conormal.h"

#include <stdlib.h>
#include <string.h>

/* A side of a cell, by the lower and the higher number of its vertices. */
typedef struct skin_edge {
  int low, high; /* vertices */
  int cell, side;
} skin_edge;

/* Side k of a cell runs along u or v: r1, r2, r3, r4. */
static const int side_ends[4][2] = {{0, 1}, {0, 3}, {3, 2}, {1, 2}};

/* Sides of the same edge come together; the rest makes the order unique. */
static int by_ends(const void *a, const void *b) {
  const skin_edge *p = a, *q = b;
  if (p->low != q->low) return p->low < q->low ? -1 : 1;
  if (p->high != q->high) return p->high < q->high ? -1 : 1;
  if (p->cell != q->cell) return p->cell < q->cell ? -1 : 1;
  return p->side - q->side;
}

/* The points in the opposite order. */
static void reverse(int count, lam_vec3 *points) {
  for (int j = 0; j < count / 2; j++) {
    lam_vec3 p = points[j];
    points[j] = points[count - 1 - j];
    points[count - 1 - j] = p;
  }
}

/* Lists every edge once, from the vertex with the lower number, and sets for every cell and side
 * which one it is. Returns how many edges there are. */
static int list_arcs(lam_arena *arena, int cell_count, const lam_skin_cell *cells,
                     lam_conormal_arc *arcs, int (*side_arc)[4]) {
  skin_edge *edges = LAM_NEW(arena, skin_edge, 4 * cell_count);
  int count = 0;
  for (int k = 0; k < 4 * cell_count; k++) {
    const int *v = cells[k / 4].vertex, *end = side_ends[k % 4];
    int a = v[end[0]], b = v[end[1]];
    edges[k] = (skin_edge){a < b ? a : b, a < b ? b : a, k / 4, k % 4};
  }

  qsort(edges, (size_t)(4 * cell_count), sizeof *edges, by_ends);
  for (int k = 0; k < 4 * cell_count; k++) {
    const skin_edge *e = &edges[k];
    const lam_skin_cell *cell = &cells[e->cell];
    const int *end = side_ends[e->side];
    bool reversed = cell->vertex[end[0]] != e->low;
    if (k == 0 || e->low != e[-1].low || e->high != e[-1].high) {
      lam_conormal_arc *arc = &arcs[count++];

      /* Quarter turns at both ends, after which the edge runs along the first direction. */
      for (int i = 0; i < 2; i++) {
        int corner = end[reversed ? 1 - i : i];
        arc->vertex[i] = cell->vertex[corner];
        arc->turn[i] = (cell->turn[corner] + e->side % 2 + (reversed ? 2 : 0)) & 3;
      }
    }
    side_arc[e->cell][e->side] = count - 1;
  }
  return count;
}

/* The curve of a side of a cell that begins at vertex `start`, with its conormals. */
static lam_conormal_edge side_of(const lam_conormal_vertex *vertices, const lam_conormal_arc *arc,
                                 int start) {
  lam_conormal_edge edge = lam_conormal_edge_make(vertices, arc);
  if (arc->vertex[0] != start) {
    reverse(LAM_CONORMAL_CURVE + 1, edge.points);
    reverse(LAM_CONORMAL_POINTS, edge.conormals);
  }
  return edge;
}

/* The patch over four sides, whose points it keeps; false: it folds over, and its surface has no
 * points. */
static bool make_patch(lam_arena *arena, const lam_conormal_plate *plate,
                       lam_conormal_edge sides[4], const double *knots, const double *surface_knots,
                       lam_asymptotic_patch *patch) {
  int count = LAM_CONORMAL_SURFACE + 1;
  *patch = (lam_asymptotic_patch){.energy = 0};
  for (int c = 0; c < 4; c++)
    patch->boundary.curve[c] = (lam_quad_curve){
        LAM_CONORMAL_CURVE, LAM_CONORMAL_CURVE + 1, knots, sides[c].points, NULL, false};

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count * count);
  if (!lam_conormal_patch_make(plate, sides, points, &patch->energy)) return false;
  patch->surface = (lam_spline_surface){.degree = {LAM_CONORMAL_SURFACE, LAM_CONORMAL_SURFACE},
                                        .count = {count, count},
                                        .knots = {surface_knots, surface_knots},
                                        .points = points};
  return true;
}

/* The conormals of all vertices first, then the patches one by one. */
lam_skin_fit lam_asymptotic_skin_fill(lam_arena *arena, int vertex_count,
                                      lam_conormal_vertex *vertices, int cell_count,
                                      const lam_skin_cell *cells, lam_asymptotic_patch *patches) {
  int order, count;
  const double *knots = lam_knots_repeat(arena, LAM_CONORMAL_CURVE, 0, NULL, 1, &order);
  const double *surface_knots = lam_knots_repeat(arena, LAM_CONORMAL_SURFACE, 0, NULL, 1, &count);
  const lam_conormal_plate *plate = lam_conormal_plate_make(arena);
  lam_conormal_arc *arcs = LAM_NEW(arena, lam_conormal_arc, 4 * cell_count);
  int(*side_arc)[4] = lam_arena_alloc(arena, (size_t)cell_count, sizeof *side_arc);

  int arc_count = list_arcs(arena, cell_count, cells, arcs, side_arc);
  int contradictions = lam_conormal_signs(arena, vertex_count, vertices, arc_count, arcs);
  lam_skin_fit fit = lam_conormal_fit(arena, vertex_count, vertices, arc_count, arcs);
  fit.contradictions = contradictions;

  for (int k = 0; k < cell_count; k++) {
    lam_conormal_edge *sides = LAM_NEW(arena, lam_conormal_edge, 4);
    for (int c = 0; c < 4; c++)
      sides[c] = side_of(vertices, &arcs[side_arc[k][c]], cells[k].vertex[side_ends[c][0]]);
    fit.made += make_patch(arena, plate, sides, knots, surface_knots, &patches[k]);
  }
  return fit;
}
