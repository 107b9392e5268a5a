/* Thin solids over patches: points and normals on a grid in every patch, those on common sides used
 * by both. */
#include "fab/parts/skin.h"
#include "surf/spline/spline_surface.h"

#include <stdlib.h>
#include <string.h>

typedef struct corner {
  lam_vec3 point;
  int cell, number;
} corner;

typedef struct side {
  int low, high; /* numbers of corner points */
  int cell, number;
} side;

static int by_point(const void *a, const void *b) {
  const lam_vec3 *p = &((const corner *)a)->point, *q = &((const corner *)b)->point;
  if (p->x != q->x) return p->x < q->x ? -1 : 1;
  if (p->y != q->y) return p->y < q->y ? -1 : 1;
  return (p->z > q->z) - (p->z < q->z);
}

static int by_corners(const void *a, const void *b) {
  const side *p = a, *q = b;
  if (p->low != q->low) return p->low - q->low;
  if (p->high != q->high) return p->high - q->high;
  return p->cell != q->cell ? p->cell - q->cell : p->number - q->number;
}

/* Corners in the order (0,0), (1,0), (1,1), (0,1), and the corners of the sides r1, r2, r3, r4. */
static const int side_corners[4][2] = {{0, 1}, {0, 3}, {3, 2}, {1, 2}};

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

/* The index in a cell's grid of place k of a side, or of a corner. */
static int side_index(int number, int k, int n) {
  const int at[4] = {k * (n + 1), k, k * (n + 1) + n, n * (n + 1) + k};
  return at[number];
}

static int corner_index(int number, int n) {
  return number == 0 ? 0 : number == 1 ? n * (n + 1) : number == 2 ? n * (n + 1) + n : n;
}

/* Numbers equal corner points; ids: 4 per cell. Returns how many there are. */
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

/* Two patches with the same corners share a side when its middles agree too. */
static bool agree(const lam_skin_mesh *mesh, const lam_vec3 *points, const side *a, const side *b,
                  bool reversed) {
  int n = mesh->subdivisions, all = (n + 1) * (n + 1), k = (n + 1) / 2;
  lam_vec3 p = points[a->cell * all + side_index(a->number, k, n)];
  lam_vec3 q = points[b->cell * all + side_index(b->number, reversed ? n - k : k, n)];
  double length = lam_distance(points[a->cell * all + side_index(a->number, 0, n)],
                               points[a->cell * all + side_index(a->number, n, n)]);
  return lam_distance(p, q) <= 1e-9 * length;
}

/* Gives every place of the grids an index; own[k] is the first place that has it. */
static void share(lam_arena *arena, lam_skin_mesh *mesh, const lam_vec3 *points, int *own) {
  int n = mesh->subdivisions, all = (n + 1) * (n + 1), count = mesh->cell_count;
  int *ids = LAM_NEW(arena, int, 4 * count), *of_corner;
  int numbers = number_corners(arena, count, mesh, points, ids);
  side *sides = LAM_NEW(arena, side, 4 * count);
  of_corner = LAM_NEW(arena, int, numbers);
  memset(mesh->grid, -1, sizeof(int) * (size_t)(count * all));
  for (int k = 0; k < numbers; k++) of_corner[k] = -1;
  for (int k = 0; k < 4 * count; k++) {
    int at = k / 4 * all + corner_index(k % 4, n), *index = &of_corner[ids[k]];
    if (*index < 0) own[ *index = mesh->point_count++] = at;
    mesh->grid[at] = *index;
    int a = ids[4 * (k / 4) + side_corners[k % 4][0]],
        b = ids[4 * (k / 4) + side_corners[k % 4][1]];
    sides[k] = (side){a < b ? a : b, a < b ? b : a, k / 4, k % 4};
    mesh->neighbors[k / 4][k % 4] = -1;
  }
  qsort(sides, (size_t)(4 * count), sizeof *sides, by_corners);
  for (int k = 0; k < 4 * count; k++) {
    const side *s = &sides[k], *before = k ? &sides[k - 1] : NULL;
    bool same = before && before->low == s->low && before->high == s->high && s->low != s->high &&
                mesh->neighbors[before->cell][before->number] < 0,
         reversed = false;
    if (same) {
      reversed = ids[4 * s->cell + side_corners[s->number][0]] !=
                 ids[4 * before->cell + side_corners[before->number][0]];
      same = agree(mesh, points, s, before, reversed);
    }
    if (same) {
      mesh->neighbors[s->cell][s->number] = before->cell;
      mesh->neighbors[before->cell][before->number] = s->cell;
    }
    for (int j = 1; j < n; j++) {
      int at = s->cell * all + side_index(s->number, j, n);
      if (same) {
        mesh->grid[at] =
            mesh->grid[before->cell * all + side_index(before->number, reversed ? n - j : j, n)];
      } else {
        own[mesh->grid[at] = mesh->point_count++] = at;
      }
    }
  }
  for (int k = 0; k < count * all; k++)
    if (mesh->grid[k] < 0) own[mesh->grid[k] = mesh->point_count++] = k;
}

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

static void add_quad(lam_trimesh *mesh, int a, int b, int c, int d) {
  memcpy(mesh->triangles[mesh->triangle_count++], (int[3]){a, b, c}, sizeof(int[3]));
  memcpy(mesh->triangles[mesh->triangle_count++], (int[3]){a, c, d}, sizeof(int[3]));
}

lam_trimesh lam_skin_shell(lam_arena *arena, const lam_skin_mesh *mesh, const int *piece,
                           int number, double low, double high) {
  int n = mesh->subdivisions, all = (n + 1) * (n + 1), count = 0, used = 0;
  int *index = LAM_NEW(arena, int, mesh->point_count); /* 1 + number of the point in the piece */
  for (int c = 0; c < mesh->cell_count; c++) {
    if (piece[c] != number) continue;
    count++;
    for (int k = 0; k < all; k++)
      if (!index[mesh->grid[c * all + k]]) index[mesh->grid[c * all + k]] = ++used;
  }
  lam_trimesh solid = {2 * used, LAM_NEW(arena, lam_vec3, 2 * used), 0, NULL};
  solid.triangles = (int(*)[3])lam_arena_alloc(arena, (size_t)(count * (4 * n * n + 8 * n)),
                                               sizeof *solid.triangles);
  for (int k = 0; k < mesh->point_count; k++) {
    if (!index[k]) continue;
    solid.vertices[index[k] - 1] = lam_along(mesh->points[k], high, mesh->normals[k]);
    solid.vertices[used + index[k] - 1] = lam_along(mesh->points[k], low, mesh->normals[k]);
  }
  for (int c = 0; c < mesh->cell_count; c++) {
    if (piece[c] != number) continue;
    const int *grid = mesh->grid + c * all;
    for (int i = 0; i < n; i++)
      for (int j = 0; j < n; j++) {
        int a = index[grid[i * (n + 1) + j]] - 1, b = index[grid[(i + 1) * (n + 1) + j]] - 1;
        int d = index[grid[i * (n + 1) + j + 1]] - 1,
            e = index[grid[(i + 1) * (n + 1) + j + 1]] - 1;
        add_quad(&solid, a, b, e, d);
        add_quad(&solid, used + a, used + d, used + e, used + b);
      }
    for (int s = 0; s < 4; s++) {
      int next = mesh->neighbors[c][s];
      if (next >= 0 && piece[next] == number) continue;
      for (int k = 0; k < n;
           k++) { /* r1 and r4 run counterclockwise around the patch, r2 and r3 clockwise */
        bool with = s == 0 || s == 3;
        int a = index[grid[side_index(s, with ? k : k + 1, n)]] - 1;
        int b = index[grid[side_index(s, with ? k + 1 : k, n)]] - 1;
        add_quad(&solid, b, a, used + a, used + b);
      }
    }
  }
  return solid;
}
