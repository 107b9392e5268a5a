/* Skins over cells of any connectivity: every edge once, for both of its patches. */
#include "surf/asymptotic_conormal.h"
#include "surf/asymptotic_skin.h"

#include <stdlib.h>
#include <string.h>

typedef struct skin_edge {
  int low, high; /* vertices */
  int cell, side;
} skin_edge;

/* Side k of a cell runs along u or v: r1, r2, r3, r4. */
static const int side_ends[4][2] = {{0, 1}, {0, 3}, {3, 2}, {1, 2}};

static int by_ends(const void *a, const void *b) {
  const skin_edge *p = a, *q = b;
  if (p->low != q->low) return p->low < q->low ? -1 : 1;
  if (p->high != q->high) return p->high < q->high ? -1 : 1;
  if (p->cell != q->cell) return p->cell < q->cell ? -1 : 1;
  return p->side - q->side;
}

/* A vertex seen after quarter turns. The curve that was along u runs along -v then: it bends to the same side, but
 * torsion is that of the other family. */
static lam_skin_vertex turned(lam_skin_vertex v, int turns) {
  for (turns &= 3; turns > 0; turns--) {
    lam_skin_vertex w = {v.point, {v.tangent[1], lam_scale(v.tangent[0], -1)}, {-v.curvature[1], v.curvature[0]}, 0};
    w.torsion = -v.torsion;
    v = w;
  }
  return v;
}

/* The other way round. */
static void reverse(int count, lam_vec3 *points) {
  for (int j = 0; j < count / 2; j++) {
    lam_vec3 p = points[j];
    points[j] = points[count - 1 - j];
    points[count - 1 - j] = p;
  }
}

/* Every side of every cell in its own direction. Shared ones are computed once, from the vertex with the lower number,
 * so that both patches get the same bits. */
static lam_conormal_edge (*make_edges(lam_arena *arena, const lam_skin_vertex *vertices, int cell_count,
                                      const lam_skin_cell *cells))[4] {
  skin_edge *edges = LAM_NEW(arena, skin_edge, 4 * cell_count);
  lam_conormal_edge(*sides)[4] = lam_arena_alloc(arena, (size_t)cell_count, sizeof *sides);
  for (int k = 0; k < 4 * cell_count; k++) {
    const int *v = cells[k / 4].vertex, *end = side_ends[k % 4];
    int a = v[end[0]], b = v[end[1]];
    edges[k] = (skin_edge){a < b ? a : b, a < b ? b : a, k / 4, k % 4};
  }
  qsort(edges, (size_t)(4 * cell_count), sizeof *edges, by_ends);
  lam_conormal_edge shared = {0};
  for (int k = 0; k < 4 * cell_count; k++) {
    const skin_edge *e = &edges[k];
    const lam_skin_cell *cell = &cells[e->cell];
    const int *end = side_ends[e->side];
    bool reversed = cell->vertex[end[0]] != e->low;
    if (k == 0 || e->low != e[-1].low || e->high != e[-1].high) {
      lam_skin_vertex at[2];
      for (int i = 0; i < 2; i++) { /* seen so that the edge runs along the first tangent */
        int corner = end[reversed ? 1 - i : i];
        at[i] = turned(vertices[cell->vertex[corner]], cell->turn[corner] + e->side % 2 + (reversed ? 2 : 0));
      }
      shared = lam_conormal_edge_make(&at[0], &at[1]);
    }
    lam_conormal_edge *own = &sides[e->cell][e->side];
    *own = shared;
    if (!reversed) continue;
    reverse(LAM_SKIN_POINTS, own->points);
    for (int f = 0; f < own->field_count; f++) reverse(LAM_CONORMAL_POINTS, own->field[f]);
  }
  return sides;
}

int lam_asymptotic_skin_fill(lam_arena *arena, const lam_skin_vertex *vertices, int cell_count,
                             const lam_skin_cell *cells, lam_place place, lam_errors *errors,
                             lam_asymptotic_patch *patches) {
  int order, total, made = 0;
  const double *knots = lam_knots_repeat(arena, LAM_SKIN_DEGREE, 0, NULL, 1, &order);
  const double *surface_knots = lam_knots_repeat(arena, LAM_CONORMAL_SURFACE, 0, NULL, 1, &total);
  lam_conormal_edge(*sides)[4] = make_edges(arena, vertices, cell_count, cells);
  for (int k = 0; k < cell_count; k++) {
    lam_asymptotic_patch *patch = &patches[k];
    *patch = (lam_asymptotic_patch){.energy = 0};
    for (int c = 0; c < 4; c++)
      patch->boundary.curve[c] =
          (lam_quad_curve){LAM_SKIN_DEGREE, LAM_SKIN_POINTS, knots, sides[k][c].points, NULL, false};
    lam_vec3 *points = LAM_NEW(arena, lam_vec3, total * total);
    lam_arena_mark mark = lam_arena_mark_get(arena);
    if (!lam_conormal_patch_make(arena, sides[k], place, errors, patch)) {
      patch->surface = (lam_spline_surface){0}; /* the memory may hold the message */
      continue;
    }
    memcpy(points, patch->surface.points, (size_t)(total * total) * sizeof *points);
    lam_arena_release(arena, mark);
    patch->surface.points = points;
    patch->surface.knots[0] = patch->surface.knots[1] = surface_knots;
    made++;
  }
  return made;
}
