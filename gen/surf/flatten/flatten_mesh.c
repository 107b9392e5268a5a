/* Triangulated surfaces to be laid flat: grids of spline surfaces, disks of triangles, and
 * where their vertices lie at first. Called by whoever calls lam_flatten. */
#include "solve/assemble.h"
#include "solve/factor.h"
#include "surf/flatten/flatten_parts.h"
#include "surf/spline/spline_surface.h"
#include <stdlib.h>
#include <string.h>

/* ---- grids ---- */

/* A grid of cells x cells squares of parameters. */
typedef struct grid {
  const lam_nurbs *nurbs;
  double low[2], step[2];
  int cells;
} grid;

/* The length over the edge from grid point a to grid point b: the chord, or lam_flat_length's
 * geodesic with k the normal curvature in the middle of the edge. */
static double length_over(const grid *g, const lam_vec3 *x, const int a[2], const int b[2],
                          lam_flat_length kind) {
  int row = g->cells + 1;
  double chord = lam_distance(x[a[0] * row + a[1]], x[b[0] * row + b[1]]),
         du = (b[0] - a[0]) * g->step[0], dv = (b[1] - a[1]) * g->step[1];
  if (kind == LAM_FLAT_CHORDS) return chord;

  lam_jet jet;
  lam_nurbs_eval(g->nurbs, g->low[0] + 0.5 * (a[0] + b[0]) * g->step[0],
                 g->low[1] + 0.5 * (a[1] + b[1]) * g->step[1], &jet);
  lam_curvature c = lam_jet_curvature(&jet);
  double k = (c.L * du * du + 2 * c.M * du * dv + c.N * dv * dv) /
             (c.E * du * du + 2 * c.F * du * dv + c.G * dv * dv);
  return chord * (1 + k * k * chord * chord / 24);
}

/* Mean length of the two sides that run in direction d. */
static double side_length(const lam_vec3 *x, int cells, int d) {
  int row = cells + 1, step = d ? 1 : row, across = d ? row : 1;
  double sum = 0;
  for (int side = 0; side < 2; side++)
    for (int k = 0; k < cells; k++) {
      int a = side * cells * across + k * step;
      sum += lam_distance(x[a], x[a + step]) / 2;
    }
  return sum;
}

/* The points of the grid, v running fastest. */
static lam_vec3 *grid_points(lam_arena *arena, const grid *g) {
  int row = g->cells + 1, count = row * row;
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, count);
  for (int v = 0; v < count; v++) {
    lam_jet jet;
    lam_nurbs_eval(g->nurbs, g->low[0] + v / row * g->step[0], g->low[1] + v % row * g->step[1],
                   &jet);
    x[v] = jet.x;
  }
  return x;
}

/* The edges that begin at vertex (i,j), along v, along u and along both: fills them and their
 * lengths from index `made` on, and returns how many there are then. */
static int add_edges(const grid *g, const lam_vec3 *x, int i, int j, lam_flat_length kind,
                     int (*edges)[2], double *lengths, int made) {
  int row = g->cells + 1;
  for (int k = 1; k < 4; k++) {
    const int a[2] = {i, j}, b[2] = {i + (k >> 1), j + (k & 1)};
    if (b[0] > g->cells || b[1] > g->cells) continue;
    edges[made][0] = i * row + j;
    edges[made][1] = b[0] * row + b[1];
    lengths[made++] = length_over(g, x, a, b, kind);
  }
  return made;
}

/* Vertex by vertex: where it starts, its edges, and the two triangles of the cell above it. */
lam_flat_mesh lam_flat_grid(lam_arena *arena, const lam_spline_surface *s, int cells,
                            lam_flat_length kind) {
  grid g = {.nurbs = lam_nurbs_make(arena, s), .cells = cells};
  int row = cells + 1, vertices = row * row, filled = 0, made = 0;
  for (int d = 0; d < 2; d++) {
    g.low[d] = s->knots[d][s->degree[d]];
    g.step[d] = (s->knots[d][s->count[d]] - g.low[d]) / cells;
  }

  lam_vec3 *x = grid_points(arena, &g);
  int(*triangles)[3] = lam_arena_alloc(arena, (size_t)(2 * cells * cells), sizeof *triangles);
  int edge_count = 3 * cells * cells + 2 * cells, (*edges)[2];
  edges = lam_arena_alloc(arena, (size_t)edge_count, sizeof *edges);
  double *lengths = LAM_NEW(arena, double, edge_count);
  lam_vec2 *start = LAM_NEW(arena, lam_vec2, vertices);

  double width = side_length(x, cells, 0), height = side_length(x, cells, 1);
  for (int i = 0; i < row; i++)
    for (int j = 0; j < row; j++) {
      int v = i * row + j;
      start[v] = (lam_vec2){width * i / cells, height * j / cells};
      made = add_edges(&g, x, i, j, kind, edges, lengths, made);
      if (i == cells || j == cells) continue;
      memcpy(triangles[filled++], (int[3]){v, v + row, v + row + 1}, sizeof *triangles);
      memcpy(triangles[filled++], (int[3]){v, v + row + 1, v + 1}, sizeof *triangles);
    }

  return (lam_flat_mesh){
      vertices, x,    filled, (const int(*)[3])triangles, made, (const int(*)[2])edges,
      lengths,  start};
}

/* ---- disks ---- */

/* By the lower, then by the higher vertex; for qsort. */
static int compare_edges(const void *a, const void *b) {
  const int *p = a, *q = b;
  return p[0] != q[0] ? (p[0] > q[0]) - (p[0] < q[0]) : (p[1] > q[1]) - (p[1] < q[1]);
}

/* All edges, each once; false when an edge has more than two triangles. */
static bool find_edges(lam_arena *arena, lam_flat_mesh *mesh) {
  int total = 3 * mesh->triangle_count, kept = 0,
      (*all)[2] = lam_arena_alloc(arena, (size_t)total, sizeof *all);
  for (int t = 0; t < total; t++) {
    int a = mesh->triangles[t / 3][t % 3], b = mesh->triangles[t / 3][(t + 1) % 3];
    all[t][0] = a < b ? a : b;
    all[t][1] = a < b ? b : a;
  }

  qsort(all, (size_t)total, sizeof *all, compare_edges);
  for (int t = 0, run = 0; t < total; t++) {
    run = t && !compare_edges(all[t], all[t - 1]) ? run + 1 : 1;
    if (run > 2) return false;
    if (run == 1) {
      all[kept][0] = all[t][0];
      all[kept++][1] = all[t][1];
    }
  }

  mesh->edge_count = kept;
  mesh->edges = (const int(*)[2])all;
  return true;
}

/* An edge of one triangle only is on the boundary; `next` leads from vertex to vertex along
 * them. */
int lam_flat_boundary(lam_arena *arena, const lam_flat_mesh *mesh, int **loop) {
  int total = 3 * mesh->triangle_count, n = mesh->vertex_count, sides = 0, first = -1, count = 0;
  /* The lower vertex, the higher one, whether the triangle runs upward. */
  int(*sorted)[3] = lam_arena_alloc(arena, (size_t)total, sizeof *sorted);

  int *next = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++) next[v] = -1;

  for (int t = 0; t < total; t++) {
    int a = mesh->triangles[t / 3][t % 3], b = mesh->triangles[t / 3][(t + 1) % 3];
    memcpy(sorted[t], (int[3]){a < b ? a : b, a < b ? b : a, a < b}, sizeof *sorted);
  }
  qsort(sorted, (size_t)total, sizeof *sorted, compare_edges);

  /* Sorted, the two triangles of an inner edge are neighbors. */
  for (int t = 0; t < total; t++) {
    bool before = t && !compare_edges(sorted[t], sorted[t - 1]);
    bool after = t + 1 < total && !compare_edges(sorted[t], sorted[t + 1]);
    if (before || after) continue;
    int a = sorted[t][!sorted[t][2]], b = sorted[t][sorted[t][2]];
    if (next[a] >= 0) return 0;
    next[a] = b;
    first = a;
    sides++;
  }

  *loop = LAM_NEW(arena, int, sides);
  for (int v = first; v >= 0 && count < sides; v = next[v]) {
    (*loop)[count++] = v;
    if (next[v] == first) break;
  }
  return count == sides ? count : 0;
}

/* x_b - x_a: every vertex in the middle of its neighbors at the minimum. */
static void spread(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  (void)n;
  for (int i = 0; i < 2; i++) {
    r[i] = x[2 + i] - x[i];
    if (!J) continue;
    for (int k = 0; k < 4; k++) J[4 * i + k] = 0;
    J[4 * i + i] = -1;
    J[4 * i + 2 + i] = 1;
  }
}

/* The boundary on a circle of its length, every vertex at its share of the way. */
static void put_on_circle(const lam_flat_mesh *mesh, const int *loop, int count, lam_vec2 *start) {
  double around = 0, at = 0;
  for (int k = 0; k < count; k++)
    around += lam_distance(mesh->vertices[loop[k]], mesh->vertices[loop[(k + 1) % count]]);

  double radius = around / (2 * acos(-1));
  for (int k = 0; k < count; k++) {
    start[loop[k]] = (lam_vec2){radius * cos(at / radius), radius * sin(at / radius)};
    at += lam_distance(mesh->vertices[loop[k]], mesh->vertices[loop[(k + 1) % count]]);
  }
}

/* Every vertex that is not on the boundary moves to the middle of its neighbors (Tutte's
 * embedding: the boundary is convex, so no triangle is turned over). */
static void center_inner(lam_arena *arena, const lam_flat_mesh *mesh, const int *loop, int count,
                         lam_vec2 *start) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_problem *problem = lam_flat_problem(arena, mesh->vertex_count, start);
  for (int k = 0; k < count; k++) problem->fixed[loop[k]] = true;
  lam_problem_add(problem, (lam_block){.name = "spread",
                                       .kernel = spread,
                                       .rows = 2,
                                       .linear = true,
                                       .role = LAM_HARD,
                                       .weight = 1,
                                       .count = mesh->edge_count,
                                       .arity = 2,
                                       .nodes = mesh->edges[0]});

  lam_flat_system s = lam_flat_system_make(arena, problem);
  if (s.size && lam_flat_system_assemble(&s) >= 0 && lam_flat_system_step(&s, 0))
    lam_flat_system_move(&s, 1);
  lam_flat_positions(problem, start);
  lam_arena_release(arena, mark);
}

/* A disk: Euler's characteristic is 1 and the boundary is one loop. */
bool lam_flat_disk(lam_arena *arena, int vertex_count, const lam_vec3 *vertices,
                   const lam_vec3 *normals, int triangle_count, const int (*triangles)[3],
                   lam_flat_mesh *mesh) {
  *mesh = (lam_flat_mesh){vertex_count, vertices, triangle_count, triangles, 0, NULL, NULL, NULL};

  int *loop, count;
  if (!find_edges(arena, mesh) || vertex_count - mesh->edge_count + triangle_count != 1)
    return false;
  if (!(count = lam_flat_boundary(arena, mesh, &loop))) return false;

  double *lengths = LAM_NEW(arena, double, mesh->edge_count);
  for (int e = 0; e < mesh->edge_count; e++) {
    int a = mesh->edges[e][0], b = mesh->edges[e][1];
    lam_vec3 chord = lam_sub(vertices[b], vertices[a]);

    /* k = -dn.dx/dx.dx */
    double bend = normals ? lam_dot(lam_sub(normals[b], normals[a]), chord) : 0,
           square = lam_dot(chord, chord);
    lengths[e] = sqrt(square) * (1 + (square > 0 ? bend * bend / square / 24 : 0));
  }

  lam_vec2 *start = LAM_NEW(arena, lam_vec2, vertex_count);
  put_on_circle(mesh, loop, count, start);
  center_inner(arena, mesh, loop, count, start);
  mesh->lengths = lengths;
  mesh->start = start;
  return true;
}
