/* Edges of a skin. At an end let T be the unit tangent, nu the unit vector in the tangent plane perpendicular to it, on
 * the side of the other tangent, and n = T x nu. Curvature and torsion at the end are
 *   r''.n = 0,  r''.nu = k |r'|^2,  r'''.n = tau k |r'|^3
 * (tau = det(r', r'', r''') / |r' x r''|^2). With r' = 7 E, r'' = 42 (P2 - 2 P1 + P0), r''' = 210 (P3 - 3 P2 + 3 P1 -
 * P0) and P0, P1, P2 in the tangent plane, these fix P2 but for its part along T, and P3 but for its part in the plane:
 * six unknowns for both ends, from the least integral of |r'''|^2. Nothing divides by k. */
#include "surf/asymptotic_skin.h"
#include "core/dense.h"
#include "surf/asymptotic_parts.h"

#include <stdlib.h>
#include <string.h>

enum { DEGREE = LAM_SKIN_DEGREE, POINTS = LAM_SKIN_POINTS, UNKNOWNS = 6 };

/* The part of the edge at one end; `end` 1 is seen backwards: points 7, 6, 5, 4, with signs of odd derivatives turned.
 */
static void set_end(const lam_skin_vertex *vertex, int family, int end, lam_vec3 *points, int *moved, lam_vec3 *along) {
  lam_vec3 tangent = vertex->tangent[family], other = vertex->tangent[1 - family], t = lam_unit(tangent);
  lam_vec3 nu = lam_unit(lam_along(other, -lam_dot(other, t), t)), n = lam_cross(t, nu);
  double speed = lam_length(tangent), k = vertex->curvature[family], sign = end ? -1 : 1;
  double torsion = family ? -vertex->torsion : vertex->torsion;
  int step = end ? -1 : 1, at = end ? DEGREE : 0;
  points[at] = vertex->point;
  points[at + step] = lam_along(vertex->point, sign / DEGREE, tangent);
  points[at + 2 * step] = lam_along(points[at], k * speed * speed / 42, nu);
  points[at + 3 * step] = lam_along(points[at], sign * torsion * k * speed * speed * speed / 210, n);
  const lam_vec3 axis[3] = {t, t, nu};
  for (int j = 0; j < 3; j++) {
    moved[j] = at + (j ? 3 : 2) * step;
    along[j] = lam_scale(axis[j], speed);
  }
}

void lam_skin_edge(lam_arena *arena, const double *gram, const lam_skin_vertex *from, const lam_skin_vertex *to,
                   int family, lam_vec3 points[LAM_SKIN_POINTS]) {
  lam_vec3 along[UNKNOWNS];
  int moved[UNKNOWNS];
  double h[UNKNOWNS * UNKNOWNS], g[UNKNOWNS] = {0}, x[UNKNOWNS];
  set_end(from, family, 0, points, moved, along);
  set_end(to, family, 1, points, moved + 3, along + 3);
  for (int a = 0; a < UNKNOWNS; a++) {
    for (int j = 0; j < POINTS; j++) g[a] += gram[moved[a] * POINTS + j] * lam_dot(along[a], points[j]);
    for (int b = 0; b < UNKNOWNS; b++)
      h[a * UNKNOWNS + b] = gram[moved[a] * POINTS + moved[b]] * lam_dot(along[a], along[b]);
  }
  lam_least_energy(arena, UNKNOWNS, h, g, 0, NULL, NULL, 0, x);
  for (int a = 0; a < UNKNOWNS; a++) points[moved[a]] = lam_along(points[moved[a]], x[a], along[a]);
}

/* ---- the edges of all cells ---- */

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

/* The control points of every side of every cell, in its own direction. Shared ones are computed once. */
static lam_vec3 *(*make_edges(lam_arena *arena, const lam_skin_vertex *vertices, int cell_count,
                              const lam_skin_cell *cells, const double *gram))[4] {
  skin_edge *edges = LAM_NEW(arena, skin_edge, 4 * cell_count);
  lam_vec3 *(*sides)[4] = lam_arena_alloc(arena, (size_t)cell_count, sizeof *sides);
  for (int k = 0; k < 4 * cell_count; k++) {
    const int *v = cells[k / 4].vertex, *end = side_ends[k % 4];
    int a = v[end[0]], b = v[end[1]];
    edges[k] = (skin_edge){a < b ? a : b, a < b ? b : a, k / 4, k % 4};
  }
  qsort(edges, (size_t)(4 * cell_count), sizeof *edges, by_ends);
  for (int k = 0, first = 0; k < 4 * cell_count; k++) {
    const skin_edge *e = &edges[k];
    const lam_skin_cell *cell = &cells[e->cell];
    const int *end = side_ends[e->side];
    bool reversed = cell->vertex[end[0]] != e->low;
    if (k == 0 || e->low != edges[first].low || e->high != edges[first].high) first = k;
    lam_vec3 *own = sides[e->cell][e->side] = LAM_NEW(arena, lam_vec3, POINTS);
    if (first == k) { /* from the vertex with the lower number, so that reversing gives the same bits everywhere */
      lam_skin_vertex at[2];
      for (int i = 0; i < 2; i++) {
        int corner = end[reversed ? 1 - i : i];
        at[i] = turned(vertices[cell->vertex[corner]], cell->turn[corner] + (reversed ? 2 : 0));
      }
      lam_skin_edge(arena, gram, &at[0], &at[1], e->side % 2, own);
    } else {
      memcpy(own, sides[edges[first].cell][edges[first].side], POINTS * sizeof *own);
      int before = edges[first].side;
      bool was_reversed = cells[edges[first].cell].vertex[side_ends[before][0]] != e->low;
      reversed = reversed != was_reversed;
    }
    for (int j = 0; reversed && j < POINTS / 2; j++) {
      lam_vec3 p = own[j];
      own[j] = own[DEGREE - j];
      own[DEGREE - j] = p;
    }
  }
  return sides;
}

int lam_asymptotic_skin_fill(lam_arena *arena, const lam_skin_vertex *vertices, int cell_count,
                             const lam_skin_cell *cells, lam_place place, lam_errors *errors,
                             lam_asymptotic_patch *patches) {
  static const lam_quad_recipe recipe = {.degree = DEGREE, .surface = DEGREE + 2, .free = true};
  int order, total, made = 0;
  const double *knots = lam_knots_repeat(arena, DEGREE, 0, NULL, 1, &order);
  const double *surface_knots = lam_knots_repeat(arena, recipe.surface, 0, NULL, 1, &total);
  const double *gram = lam_spline_gram(arena, DEGREE, POINTS, knots, 3);
  lam_vec3 *(*sides)[4] = make_edges(arena, vertices, cell_count, cells, gram);
  for (int k = 0; k < cell_count; k++) {
    lam_asymptotic_patch *patch = &patches[k];
    *patch = (lam_asymptotic_patch){.energy = 0};
    for (int c = 0; c < 4; c++)
      patch->boundary.curve[c] = (lam_quad_curve){DEGREE, POINTS, knots, sides[k][c], NULL, false};
    lam_quad_boundary_measure(&patch->boundary);
    lam_vec3 *points = LAM_NEW(arena, lam_vec3, total * total);
    lam_arena_mark mark = lam_arena_mark_get(arena);
    if (!lam_quad_patch_free(arena, &patch->boundary, &recipe, place, errors, patch)) {
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

bool lam_asymptotic_skin_make(lam_arena *arena, const int count[2], const lam_skin_vertex *vertices, lam_place place,
                              lam_errors *errors, lam_asymptotic_patch *patches) {
  int rows = count[0] - 1, columns = count[1] - 1;
  for (int k = 0; k < count[0] * count[1]; k++) {
    const lam_vec3 *t = vertices[k].tangent;
    if (!(lam_length(lam_cross(t[0], t[1])) > 1e-6 * lam_length(t[0]) * lam_length(t[1]))) {
      lam_error_add(errors, place, "tangents", "the tangents at vertex %d, %d are parallel; expected two directions",
                    k / count[1], k % count[1]);
      return false;
    }
  }
  lam_skin_cell *cells = LAM_NEW(arena, lam_skin_cell, rows * columns);
  for (int c = 0; c < rows * columns; c++) {
    int k = c / columns * count[1] + c % columns;
    cells[c] = (lam_skin_cell){{k, k + count[1], k + count[1] + 1, k + 1}, {0}};
  }
  return lam_asymptotic_skin_fill(arena, vertices, rows * columns, cells, place, errors, patches) == rows * columns;
}
