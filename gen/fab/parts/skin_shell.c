/* Thin solids over patches: points and normals on a grid in every patch, those on common sides
 * used by both. Called by skin.c. */
#include "fab/mesh_fill.h"
#include "fab/parts/skin.h"
#include "surf/spline/spline_surface.h"

#include <stdlib.h>
#include <string.h>

/* A corner of a cell, with its point. */
typedef struct corner {
  lam_vec3 point;
  int cell, number;
} corner;

/* A side of a cell, between two corner points. */
typedef struct side {
  int low, high; /* numbers of corner points */
  int cell, number;
} side;

/* For qsort: by the coordinates; equal points are neighbors then. */
static int by_point(const void *a, const void *b) {
  const lam_vec3 *p = &((const corner *)a)->point, *q = &((const corner *)b)->point;
  if (p->x != q->x) return p->x < q->x ? -1 : 1;
  if (p->y != q->y) return p->y < q->y ? -1 : 1;
  return (p->z > q->z) - (p->z < q->z);
}

/* For qsort: by the corner points, then by cell and number, so that the order is fixed. */
static int by_corners(const void *a, const void *b) {
  const side *p = a, *q = b;
  if (p->low != q->low) return p->low - q->low;
  if (p->high != q->high) return p->high - q->high;
  return p->cell != q->cell ? p->cell - q->cell : p->number - q->number;
}

/* Corners in the order (0,0), (1,0), (1,1), (0,1), and the corners of the sides r1, r2, r3, r4. */
static const int side_corners[4][2] = {{0, 1}, {0, 3}, {3, 2}, {1, 2}};

/* The jet of a surface at (u, v) in the unit square, whatever its knots. */
static lam_jet jet_at(const lam_spline_surface *s, const lam_nurbs *nurbs, double u, double v) {
  lam_jet jet;
  double low[2], high[2];
  for (int d = 0; d < 2; d++) {
    low[d] = s->knots[d][s->degree[d]];
    high[d] = s->knots[d][s->count[d]];
  }
  lam_nurbs_eval(nurbs, low[0] + u * (high[0] - low[0]), low[1] + v * (high[1] - low[1]), &jet);
  return jet;
}

/* The index in a cell's grid of point k (0 to n) of a side. */
static int side_index(int number, int k, int n) {
  const int at[4] = {k * (n + 1), k, k * (n + 1) + n, n * (n + 1) + k};
  return at[number];
}

/* The same of a corner. */
static int corner_index(int number, int n) {
  return number == 0 ? 0 : number == 1 ? n * (n + 1) : number == 2 ? n * (n + 1) + n : n;
}

/* Numbers equal corner points from 0; ids: 4 per cell. Returns how many there are. */
static int number_corners(lam_arena *arena, int count, const lam_skin_mesh *mesh,
                          const lam_vec3 *points, int *ids) {
  int n = mesh->subdivisions, numbers = 0;
  corner *corners = LAM_NEW(arena, corner, 4 * count);
  for (int k = 0; k < 4 * count; k++)
    corners[k] = (corner){points[k / 4 * (n + 1) * (n + 1) + corner_index(k % 4, n)], k / 4, k % 4};
  qsort(corners, (size_t)(4 * count), sizeof *corners, by_point);
  for (int k = 0; k < 4 * count; k++) {
    if (k && by_point(&corners[k - 1], &corners[k]) != 0) numbers++;
    ids[4 * corners[k].cell + corners[k].number] = numbers;
  }
  return numbers + (count > 0);
}

/* Two patches with the same corners share a side when its middles agree too, to 1e-9 of its
 * chord. */
static bool agree(const lam_skin_mesh *mesh, const lam_vec3 *points, const side *a, const side *b,
                  bool reversed) {
  int n = mesh->subdivisions, all = (n + 1) * (n + 1), k = (n + 1) / 2;
  lam_vec3 p = points[a->cell * all + side_index(a->number, k, n)];
  lam_vec3 q = points[b->cell * all + side_index(b->number, reversed ? n - k : k, n)];

  double length = lam_distance(points[a->cell * all + side_index(a->number, 0, n)],
                               points[a->cell * all + side_index(a->number, n, n)]);
  return lam_distance(p, q) <= 1e-9 * length;
}

/* The grid points of all cells as they are numbered: own[k] is the first one with the index k. */
typedef struct numbering {
  lam_skin_mesh *mesh;
  const lam_vec3 *points; /* of all grids, (subdivisions + 1)^2 per cell */
  int *ids;               /* per cell and corner: the number of its point */
  int *own;
} numbering;

/* Gives the corners of all cells their indices, equal corner points the same one, and lists the
 * sides of all cells by the corners at their ends. */
static void share_corners(lam_arena *arena, numbering *all, int ids, side *sides) {
  lam_skin_mesh *mesh = all->mesh;
  int n = mesh->subdivisions, size = (n + 1) * (n + 1), *of_corner = LAM_NEW(arena, int, ids);
  for (int k = 0; k < ids; k++) of_corner[k] = -1;
  for (int k = 0; k < 4 * mesh->cell_count; k++) {
    int at = k / 4 * size + corner_index(k % 4, n), *index = &of_corner[all->ids[k]];
    if (*index < 0) {
      *index = mesh->point_count++;
      all->own[*index] = at;
    }
    mesh->grid[at] = *index;

    int a = all->ids[4 * (k / 4) + side_corners[k % 4][0]],
        b = all->ids[4 * (k / 4) + side_corners[k % 4][1]];
    sides[k] = (side){a < b ? a : b, a < b ? b : a, k / 4, k % 4};
    mesh->neighbors[k / 4][k % 4] = -1;
  }
}

/* Whether side s is the one before it in the list, in another cell: same ends, same middle, and not
 * paired yet (a third patch on a side is no neighbor). reversed: they run against each other. */
static bool is_shared(const numbering *all, const side *s, const side *before, bool *reversed) {
  *reversed = false;
  if (!before || before->low != s->low || before->high != s->high || s->low == s->high ||
      all->mesh->neighbors[before->cell][before->number] >= 0)
    return false;
  *reversed = all->ids[4 * s->cell + side_corners[s->number][0]] !=
              all->ids[4 * before->cell + side_corners[before->number][0]];
  return agree(all->mesh, all->points, s, before, *reversed);
}

/* Gives the points between the ends of a side their indices: those of the side before it in the
 * list when that is the same side, new ones otherwise. */
static void share_side(numbering *all, const side *s, const side *before) {
  lam_skin_mesh *mesh = all->mesh;
  int n = mesh->subdivisions, size = (n + 1) * (n + 1);
  bool reversed, same = is_shared(all, s, before, &reversed);
  if (same) {
    mesh->neighbors[s->cell][s->number] = before->cell;
    mesh->neighbors[before->cell][before->number] = s->cell;
  }

  for (int j = 1; j < n; j++) {
    int at = s->cell * size + side_index(s->number, j, n);
    if (same)
      mesh->grid[at] =
          mesh->grid[before->cell * size + side_index(before->number, reversed ? n - j : j, n)];
    else
      all->own[mesh->grid[at] = mesh->point_count++] = at;
  }
}

/* Gives every grid point an index, common ones the same: corners, then sides, then what lies
 * inside. own[k] becomes the first grid point with the index k. */
static void share(lam_arena *arena, lam_skin_mesh *mesh, const lam_vec3 *points, int *own) {
  int n = mesh->subdivisions, size = (n + 1) * (n + 1), count = mesh->cell_count;
  numbering all = {mesh, points, LAM_NEW(arena, int, 4 * count), own};
  int ids = number_corners(arena, count, mesh, points, all.ids);
  side *sides = LAM_NEW(arena, side, 4 * count);
  memset(mesh->grid, -1, sizeof(int) * (size_t)(count * size));
  share_corners(arena, &all, ids, sides);

  /* Sides with the same ends come one after the other. */
  qsort(sides, (size_t)(4 * count), sizeof *sides, by_corners);
  for (int k = 0; k < 4 * count; k++) share_side(&all, &sides[k], k ? &sides[k - 1] : NULL);

  for (int k = 0; k < count * size; k++)
    if (mesh->grid[k] < 0) own[mesh->grid[k] = mesh->point_count++] = k;
}

/* Every cell is sampled on its own; common points keep the position and normal of the first cell
 * that has them. */
lam_skin_mesh lam_skin_mesh_make(lam_arena *arena, int count, const lam_spline_surface *surfaces,
                                 int subdivisions) {
  int n = subdivisions, all = (n + 1) * (n + 1);
  lam_skin_mesh mesh = {
      .subdivisions = n, .cell_count = count, .grid = LAM_NEW(arena, int, count *all)};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, count * all),
           *normals = LAM_NEW(arena, lam_vec3, count * all);
  int *own = LAM_NEW(arena, int, count *all);
  mesh.neighbors = lam_arena_alloc(arena, (size_t)count, sizeof *mesh.neighbors);

  for (int c = 0; c < count; c++) {
    const lam_nurbs *nurbs = lam_nurbs_make(arena, &surfaces[c]);
    for (int k = 0; k < all; k++) {
      lam_jet jet =
          jet_at(&surfaces[c], nurbs, (double)(k / (n + 1)) / n, (double)(k % (n + 1)) / n);
      points[c * all + k] = jet.x;
      normals[c * all + k] = lam_unit(lam_cross(jet.u, jet.v));
    }
  }

  share(arena, &mesh, points, own);
  mesh.points = LAM_NEW(arena, lam_vec3, mesh.point_count);
  mesh.normals = LAM_NEW(arena, lam_vec3, mesh.point_count);
  for (int k = 0; k < mesh.point_count; k++) {
    mesh.points[k] = points[own[k]];
    mesh.normals[k] = normals[own[k]];
  }
  return mesh;
}

/* Pieces are what is reached over common sides, each from its first cell. */
int lam_skin_pieces(lam_arena *arena, const lam_skin_mesh *mesh, int *piece) {
  int *queue = LAM_NEW(arena, int, mesh->cell_count), pieces = 0;
  for (int c = 0; c < mesh->cell_count; c++) piece[c] = -1;
  for (int c = 0; c < mesh->cell_count; c++) {
    if (piece[c] >= 0) continue;
    int head = 0, tail = 0;
    queue[tail++] = c;
    piece[c] = pieces;

    while (head < tail) {
      int at = queue[head++];
      for (int k = 0; k < 4; k++) {
        int next = mesh->neighbors[at][k];
        if (next < 0 || piece[next] >= 0) continue;
        piece[next] = pieces;
        queue[tail++] = next;
      }
    }
    pieces++;
  }
  return pieces;
}

/* ---- the solid ---- */

/* Numbers the points of one piece from 1, in the order in which its cells use them; 0: points of
 * others. Returns how many there are; cells: how many cells the piece has. */
static int number_points(const lam_skin_mesh *mesh, const int *piece, int number, int *index,
                         int *cells) {
  int size = (mesh->subdivisions + 1) * (mesh->subdivisions + 1), used = 0;
  *cells = 0;
  for (int c = 0; c < mesh->cell_count; c++) {
    if (piece[c] != number) continue;
    ++*cells;
    for (int k = 0; k < size; k++)
      if (!index[mesh->grid[c * size + k]]) index[mesh->grid[c * size + k]] = ++used;
  }
  return used;
}

/* Both sides of a cell: n x n quads above, and the same turned over, `used` points further on. */
static void add_faces(lam_trimesh *solid, const int *grid, const int *index, int n, int used) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      int a = index[grid[i * (n + 1) + j]] - 1, b = index[grid[(i + 1) * (n + 1) + j]] - 1;
      int d = index[grid[i * (n + 1) + j + 1]] - 1, e = index[grid[(i + 1) * (n + 1) + j + 1]] - 1;
      lam_trimesh_quad(solid, a, b, e, d);
      lam_trimesh_quad(solid, used + a, used + d, used + e, used + b);
    }
}

/* The wall along side s of a cell. Sides r1 and r4 run counterclockwise around the patch, r2 and r3
 * clockwise. */
static void add_wall(lam_trimesh *solid, const int *grid, const int *index, int s, int n,
                     int used) {
  bool with = s == 0 || s == 3;
  for (int k = 0; k < n; k++) {
    int a = index[grid[side_index(s, with ? k : k + 1, n)]] - 1;
    int b = index[grid[side_index(s, with ? k + 1 : k, n)]] - 1;
    lam_trimesh_quad(solid, b, a, used + a, used + b);
  }
}

/* See the header. Vertices: all upper points of the piece, then all lower ones in the same order;
 * walls stand where the piece ends. */
lam_trimesh lam_skin_shell(lam_arena *arena, const lam_skin_mesh *mesh, const int *piece,
                           int number, double low, double high) {
  int n = mesh->subdivisions, size = (n + 1) * (n + 1), cells;
  int *index = LAM_NEW(arena, int, mesh->point_count);
  int used = number_points(mesh, piece, number, index, &cells);
  lam_trimesh solid = lam_trimesh_empty(arena, 2 * used, cells * (4 * n * n + 8 * n));
  for (int k = 0; k < mesh->point_count; k++) {
    if (!index[k]) continue;
    solid.vertices[index[k] - 1] = lam_along(mesh->points[k], high, mesh->normals[k]);
    solid.vertices[used + index[k] - 1] = lam_along(mesh->points[k], low, mesh->normals[k]);
  }

  for (int c = 0; c < mesh->cell_count; c++) {
    if (piece[c] != number) continue;
    const int *grid = mesh->grid + c * size;
    add_faces(&solid, grid, index, n, used);
    for (int s = 0; s < 4; s++) {
      int next = mesh->neighbors[c][s];
      if (next < 0 || piece[next] != number) add_wall(&solid, grid, index, s, n, used);
    }
  }
  return solid;
}
