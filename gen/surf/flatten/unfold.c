/* Unfolding: triangles are turned into the plane one after the other, each over the edge to a
 * neighbor that lies there already. On a developable surface it does not matter in which order,
 * and how far a strip winds around does not either. Called by flatten_solve.c. */
#include "core/numbers.h"
#include "surf/flatten/flatten_parts.h"
#include <stdlib.h>

/* A side of a triangle, its ends in ascending order. */
typedef struct side {
  int low, high, triangle;
} side;

/* By vertices, then by triangle, so that the order is always the same; for qsort. */
static int compare(const void *a, const void *b) {
  const side *p = a, *q = b;
  if (p->low != q->low) return p->low - q->low;
  return p->high != q->high ? p->high - q->high : p->triangle - q->triangle;
}

/* The neighbor over every side (3 t + k: from corner k to the next), -1 at the boundary. */
static int *find_neighbors(lam_arena *arena, const lam_flat_mesh *mesh) {
  int total = 3 * mesh->triangle_count, *neighbor = LAM_NEW(arena, int, total);
  side *sides = LAM_NEW(arena, side, total);
  for (int i = 0; i < total; i++) {
    int a = mesh->triangles[i / 3][i % 3], b = mesh->triangles[i / 3][(i + 1) % 3];
    sides[i] = (side){a < b ? a : b, a < b ? b : a, i};
    neighbor[i] = -1;
  }

  qsort(sides, (size_t)total, sizeof *sides, compare);
  for (int i = 1; i < total; i++) {
    if (sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high) continue;
    neighbor[sides[i].triangle] = sides[i - 1].triangle;
    neighbor[sides[i - 1].triangle] = sides[i].triangle;
  }
  return neighbor;
}

/* The direction of the side from corner k to the next, against the triangle's first side,
 * radians. */
static double direction(const lam_flat_mesh *mesh, int t, int k) {
  const int *c = mesh->triangles[t];
  const lam_vec3 *x = mesh->vertices;
  lam_vec3 first = lam_sub(x[c[1]], x[c[0]]), along = lam_sub(x[c[(k + 1) % 3]], x[c[k]]);
  double sine = lam_length(lam_cross(first, along));
  return atan2(k == 2 ? -sine : sine, lam_dot(first, along));
}

/* Breadth first from the middle of the list, which is the middle of a grid. */
void lam_flat_unfold(lam_arena *arena, const lam_flat_mesh *mesh, double *angles) {
  int n = mesh->triangle_count, *neighbor = find_neighbors(arena, mesh),
      *queue = LAM_NEW(arena, int, n), filled = 0;
  bool *seen = LAM_NEW(arena, bool, n);
  seen[n / 2] = true;
  angles[n / 2] = 0;
  queue[filled++] = n / 2;

  for (int i = 0; i < filled; i++)
    for (int k = 0; k < 3; k++) {
      int over = neighbor[3 * queue[i] + k], t = over / 3;
      if (over < 0 || seen[t]) continue;
      seen[t] = true;
      queue[filled++] = t;

      /* the neighbor runs along the common edge the other way */
      angles[t] =
          angles[queue[i]] + direction(mesh, queue[i], k) - direction(mesh, t, over % 3) + LAM_PI;
    }
}
