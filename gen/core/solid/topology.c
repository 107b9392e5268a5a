/* Components, fans and edges of a triangle mesh, by sorting half-edges and by union-find. Called
 * by solid.c, solid_shim.cc and fab/workshop.c. */
#include "core/solid/topology.h"

#include <limits.h>
#include <stdlib.h>

/* A corner is numbered 3 triangle + k; the half-edge k runs from corner k to the next corner of its
 * triangle. */
typedef struct half_edge {
  int high; /* the larger vertex of the edge; half-edges are stored by the smaller one */
  int corner;
  bool forward; /* runs from the smaller vertex to the larger */
  bool joined;
  double angle; /* of the triangle around the edge */
} half_edge;

/* The mesh while it is joined. */
typedef struct joiner {
  const lam_trimesh *mesh;
  int *component, *fan; /* forests: the parent of every triangle and of every corner */
  lam_topology *topology;
} joiner;

/* The root of i's tree; paths are halved on the way. */
static int root_of(int *parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/* Joins two trees. The smaller root wins, so roots are the smallest members. */
static void unite(int *parent, int i, int j) {
  i = root_of(parent, i);
  j = root_of(parent, j);
  if (i < j)
    parent[j] = i;
  else
    parent[i] = j;
}

static int next_corner(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
/* The vertex at a corner. */
static int vertex_of(const lam_trimesh *mesh, int corner) {
  return mesh->triangles[corner / 3][corner % 3];
}

/* Joins two triangles at a common edge: the triangles, and their corners at both ends of the
 * edge. */
static void join(joiner *j, const half_edge *a, const half_edge *b) {
  unite(j->component, a->corner / 3, b->corner / 3);
  bool opposite = a->forward != b->forward;
  unite(j->fan, a->corner, opposite ? next_corner(b->corner) : b->corner);
  unite(j->fan, next_corner(a->corner), opposite ? b->corner : next_corner(b->corner));
}

/* By the edge's larger vertex, then by corner, which makes the order unique. */
static int by_edge(const void *x, const void *y) {
  const half_edge *a = x, *b = y;
  if (a->high != b->high) return a->high < b->high ? -1 : 1;
  return (a->corner > b->corner) - (a->corner < b->corner);
}

/* Around an edge, for join_wedges. At the same angle, the triangle that ends material comes
 * before the one that begins it, so that solids with a common face stay apart. */
static int by_angle(const void *x, const void *y) {
  const half_edge *a = x, *b = y;
  if (a->angle != b->angle) return a->angle < b->angle ? -1 : 1;
  if (a->forward != b->forward) return a->forward ? -1 : 1;
  return (a->corner > b->corner) - (a->corner < b->corner);
}

/* Joins the triangles that bound a wedge of material around a common edge.
 *
 * With d the direction of the edge (smaller to larger vertex) and w the direction from the edge
 * into a triangle, the triangle's normal is d x w when it runs forward, and w x d when it runs
 * backward. So, turning around d, material lies before a forward triangle and behind a backward
 * one: a backward triangle and the next forward one bound a wedge. */
static void join_wedges(joiner *j, half_edge *edges, int count) {
  const lam_vec3 *p = j->mesh->vertices;
  int tail = vertex_of(j->mesh, edges[0].forward ? edges[0].corner : next_corner(edges[0].corner));
  lam_vec3 d = lam_unit(lam_sub(p[edges[0].high], p[tail]));

  /* Angles in the plane across the edge. */
  lam_vec3 slanted = fabs(d.x) < 0.6 ? lam_v3(1, 0, 0) : lam_v3(0, 1, 0);
  lam_vec3 e1 = lam_unit(lam_cross(d, slanted)), e2 = lam_cross(d, e1);
  for (int i = 0; i < count; i++) {
    lam_vec3 w = lam_sub(p[vertex_of(j->mesh, next_corner(next_corner(edges[i].corner)))], p[tail]);
    edges[i].angle = atan2(lam_dot(w, e2), lam_dot(w, e1));
  }
  qsort(edges, (size_t)count, sizeof *edges, by_angle);

  /* The nearest wedges first: a pair that is joined drops out, as when brackets are matched. */
  for (int gap = 1; gap < count; gap++)
    for (int i = 0; i < count; i++) {
      half_edge *begin = &edges[i], *end = &edges[(i + gap) % count];
      if (begin->joined || end->joined || begin->forward || !end->forward) continue;
      join(j, begin, end);
      begin->joined = end->joined = true;
    }
}

enum { most_wedges = 64 }; /* triangles at one edge; where there are more, all are joined */

/* Counts an edge with its `count` half-edges, and joins the triangles there. */
static void join_edge(joiner *j, half_edge *edges, int count) {
  lam_topology *t = j->topology;
  int forward = 0;
  for (int i = 0; i < count; i++) forward += edges[i].forward;

  t->edges++;
  t->boundary_edges += count == 1;
  t->nonmanifold_edges += count > 2;
  if (count > 1 && 2 * forward != count) t->oriented = false;

  if (count > 2 && 2 * forward == count && count <= most_wedges) {
    join_wedges(j, edges, count);
    return;
  }

  for (int i = 1; i < count; i++) join(j, &edges[0], &edges[i]);
}

/* Indices in range, finite coordinates, three different vertices per triangle. */
static bool usable(const lam_trimesh *mesh) {
  if (mesh->vertex_count < 0 || mesh->triangle_count < 0 || mesh->triangle_count > INT_MAX / 3)
    return false;

  for (int i = 0; i < mesh->vertex_count; i++) {
    lam_vec3 p = mesh->vertices[i];
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z)) return false;
  }

  for (int i = 0; i < mesh->triangle_count; i++) {
    const int *t = mesh->triangles[i];
    for (int k = 0; k < 3; k++)
      if (t[k] < 0 || t[k] >= mesh->vertex_count || t[k] == t[(k + 1) % 3]) return false;
  }

  return true;
}

/* Replaces the parents of a forest by numbers in order of first appearance, and returns how many
 * there are. Roots are the smallest members, so they come first. */
static int number_roots(int *parent, int count) {
  int found = 0;
  for (int i = 0; i < count; i++) parent[i] = parent[i] == i ? found++ : parent[parent[i]];
  return found;
}

/* All half-edges by counting sort: those of smaller vertex v begin at start[v] and end before
 * start[v + 1]. start: vertex count + 2, zero before; while edges are filled in, start[v + 1] is
 * where the next one of v goes. */
static half_edge *list_half_edges(const lam_trimesh *mesh, lam_arena *arena, int *start) {
  int n = mesh->vertex_count, corners = 3 * mesh->triangle_count;
  half_edge *edges = LAM_NEW(arena, half_edge, corners);
  for (int c = 0; c < corners; c++) {
    int a = vertex_of(mesh, c), b = vertex_of(mesh, next_corner(c));
    start[(a < b ? a : b) + 2]++;
  }
  for (int v = 0; v < n; v++) start[v + 2] += start[v + 1];

  for (int c = 0; c < corners; c++) {
    int a = vertex_of(mesh, c), b = vertex_of(mesh, next_corner(c));
    edges[start[(a < b ? a : b) + 1]++] =
        (half_edge){.high = a < b ? b : a, .corner = c, .forward = a < b};
  }
  return edges;
}

/* Joins the triangles at every edge; half-edges of the same edge are neighbors once they are
 * sorted. */
static void join_all(joiner *j, lam_arena *arena) {
  int n = j->mesh->vertex_count, *start = LAM_NEW(arena, int, n + 2);
  half_edge *edges = list_half_edges(j->mesh, arena, start);

  for (int v = 0; v < n; v++) {
    half_edge *first = edges + start[v], *last = edges + start[v + 1];
    qsort(first, (size_t)(last - first), sizeof *first, by_edge);
    while (first < last) {
      half_edge *end = first;
      while (end < last && end->high == first->high) end++;
      join_edge(j, first, (int)(end - first));
      first = end;
    }
  }
}

/* Only those that triangles use. */
static void count_vertices(const lam_trimesh *mesh, lam_arena *arena, lam_topology *topology) {
  bool *used = LAM_NEW(arena, bool, mesh->vertex_count);
  for (int c = 0; c < 3 * mesh->triangle_count; c++) {
    int v = vertex_of(mesh, c);
    topology->vertices += !used[v];
    used[v] = true;
  }
}

/* Forests of triangles and corners grow together at the edges; their trees are then numbered. */
static void find_topology(const lam_trimesh *mesh, lam_arena *arena, int *component, int *fan,
                          lam_topology *topology) {
  int triangles = mesh->triangle_count, corners = 3 * triangles;
  joiner j = {mesh, component, fan, topology};
  for (int i = 0; i < triangles; i++) component[i] = i;
  for (int i = 0; i < corners; i++) fan[i] = i;
  join_all(&j, arena);

  for (int i = 0; i < triangles; i++) component[i] = root_of(component, i);
  for (int i = 0; i < corners; i++) fan[i] = root_of(fan, i);
  topology->components = number_roots(component, triangles);
  topology->fans = number_roots(fan, corners);

  count_vertices(mesh, arena, topology);
  topology->closed = triangles > 0 && !topology->boundary_edges && !topology->nonmanifold_edges;
}

/* An arena of its own, whose jump ends here: C++ frames may lie above. */
lam_status lam_topology_make(const lam_trimesh *mesh, int *component, int (*fan)[3],
                             lam_topology *topology) {
  *topology = (lam_topology){.oriented = true};
  if (!usable(mesh)) return LAM_BAD_INPUT;
  lam_arena *arena = lam_arena_new();
  if (!arena) return LAM_NO_MEMORY;
  jmp_buf point;
  if (!LAM_ARENA_TRY(arena, point)) {
    lam_arena_free(arena);
    return LAM_NO_MEMORY;
  }

  find_topology(mesh, arena, component, (int *)fan, topology);
  lam_arena_free(arena);
  return LAM_OK;
}
