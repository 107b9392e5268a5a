/* Convex solids as lists of faces, cut by one plane after the other. Called by fab/parts/bars.c. */
#include "core/solid/convex.h"

#include "core/grow.h"

#include <string.h>

/* Returns the index of the new vertex. */
static int add_vertex(lam_convex *solid, lam_vec3 x) {
  LAM_APPEND(solid->arena, solid->vertices, solid->vertex_count, solid->vertex_capacity, x);
  return solid->vertex_count - 1;
}

/* Adds a face with a copy of its corners. */
static void add_face(lam_convex *solid, const int *corners, int count) {
  int *copy = LAM_NEW(solid->arena, int, count);
  memcpy(copy, corners, sizeof *copy * (size_t)count);
  struct lam_convex_face face = {count, copy};
  LAM_APPEND(solid->arena, solid->faces, solid->face_count, solid->face_capacity, face);
}

/* Sides, then the bottom (the polygon reversed), then the top. */
lam_convex lam_convex_prism(lam_arena *arena, const lam_vec3 *polygon, int count, lam_vec3 along,
                            double tolerance) {
  lam_convex solid = {.arena = arena, .tolerance = tolerance};
  int *ring = LAM_NEW(arena, int, count);
  for (int k = 0; k < count; k++) add_vertex(&solid, polygon[k]);
  for (int k = 0; k < count; k++) add_vertex(&solid, lam_add(polygon[k], along));

  for (int k = 0; k < count; k++) {
    int next = (k + 1) % count;
    add_face(&solid, (int[4]){k, next, count + next, count + k}, 4);
  }

  for (int k = 0; k < count; k++) ring[k] = count - 1 - k;
  add_face(&solid, ring, count);
  for (int k = 0; k < count; k++) ring[k] = count + k;
  add_face(&solid, ring, count);
  return solid;
}

/* ---- cutting ---- */

/* The corner where a cut edge meets the plane: the same for both of its faces. */
typedef struct crossing {
  int low, high, vertex;
} crossing;

/* A cut at work; arrays have room for the vertices before and one more per edge. */
typedef struct cut {
  lam_convex *solid;
  const double *height; /* over the plane, per corner; 0 on it */
  int crossing_count;
  crossing *crossings;
  int *next; /* per corner: the next one around the new face; -1 */
} cut;

/* The vertex where the edge a b meets the plane, made when its first face asks for it. It always
 * runs from the smaller index to the larger, so that both faces would give the same point. */
static int cross(cut *c, int a, int b) {
  int low = a < b ? a : b, high = a < b ? b : a;
  for (int i = 0; i < c->crossing_count; i++)
    if (c->crossings[i].low == low && c->crossings[i].high == high) return c->crossings[i].vertex;
  double t = c->height[low] / (c->height[low] - c->height[high]);
  int vertex = add_vertex(c->solid, lam_mix(c->solid->vertices[low], c->solid->vertices[high], t));
  c->crossings[c->crossing_count++] = (crossing){low, high, vertex};
  return vertex;
}

/* What is left of a face, into kept; the side along the plane is noted in next. Returns the
 * number of corners: less than 3 when nothing is left. */
static int cut_face(cut *c, const struct lam_convex_face *face, int *kept) {
  int count = 0, left = -1, entered = -1;
  for (int k = 0; k < face->count; k++) {
    int a = face->corners[k], b = face->corners[(k + 1) % face->count];
    bool in = c->height[a] >= 0, stays = c->height[b] >= 0;

    if (in) kept[count++] = a;
    if (in && !stays) {
      left = c->height[a] == 0 ? a : cross(c, a, b);
      if (left != a) kept[count++] = left;
    } else if (!in && stays) {
      entered = c->height[b] == 0 ? b : cross(c, a, b);
      if (entered != b) kept[count++] = entered;
    }
  }

  if (left >= 0 && left != entered) c->next[entered] = left;
  return count;
}

/* The new face: the ring of the sides that the cut faces left along the plane. */
static void close_cut(cut *c, int limit) {
  int *ring = LAM_NEW(c->solid->arena, int, limit), count = 0, start = 0;
  while (start < limit && c->next[start] < 0) start++;
  for (int v = start; v < limit && c->next[v] >= 0 && count < limit;) {
    int next = c->next[v];
    ring[count++] = v;
    c->next[v] = -1;
    v = next;
  }
  if (count >= 3) add_face(c->solid, ring, count);
}

/* Heights over the plane; where none is negative, nothing is cut off. Faces are cut in place of
 * the old ones: as every face leaves at most one, the list never grows past the face just read. */
void lam_convex_cut(lam_convex *solid, lam_vec3 point, lam_vec3 normal) {
  int before = solid->vertex_count, edges = 0, longest = 0;
  bool any = false;
  for (int f = 0; f < solid->face_count; f++) {
    edges += solid->faces[f].count;
    if (solid->faces[f].count > longest) longest = solid->faces[f].count;
  }

  int limit = before + edges;
  double *height = LAM_NEW(solid->arena, double, limit);
  for (int v = 0; v < before; v++) {
    height[v] = lam_dot(lam_sub(solid->vertices[v], point), normal);
    if (fabs(height[v]) < solid->tolerance) height[v] = 0;
    any |= height[v] < 0;
  }
  if (!any) return;

  cut c = {solid, height, 0, LAM_NEW(solid->arena, crossing, edges),
           LAM_NEW(solid->arena, int, limit)};
  int *kept = LAM_NEW(solid->arena, int, longest + 2), faces = solid->face_count;
  for (int v = 0; v < limit; v++) c.next[v] = -1;

  solid->face_count = 0;
  for (int f = 0; f < faces; f++) {
    int count = cut_face(&c, &solid->faces[f], kept);
    if (count >= 3) add_face(solid, kept, count);
  }

  close_cut(&c, limit);
}

/* Every face becomes a fan around its first corner. number: index + 1 in the mesh, 0 when not
 * used yet. */
lam_trimesh lam_convex_mesh(lam_arena *arena, const lam_convex *solid) {
  int *number = LAM_NEW(arena, int, solid->vertex_count), triangles = 0;
  lam_trimesh mesh = {0, LAM_NEW(arena, lam_vec3, solid->vertex_count), 0, NULL};
  for (int f = 0; f < solid->face_count; f++) triangles += solid->faces[f].count - 2;
  mesh.triangles = (int(*)[3])lam_arena_alloc(arena, (size_t)triangles, sizeof *mesh.triangles);

  for (int f = 0; f < solid->face_count; f++) {
    const struct lam_convex_face *face = &solid->faces[f];
    for (int k = 0; k < face->count; k++) {
      int v = face->corners[k];
      if (number[v]) continue;
      mesh.vertices[mesh.vertex_count++] = solid->vertices[v];
      number[v] = mesh.vertex_count;
    }

    for (int k = 2; k < face->count; k++) {
      const int corners[3] = {number[face->corners[0]] - 1, number[face->corners[k - 1]] - 1,
                              number[face->corners[k]] - 1};
      memcpy(mesh.triangles[mesh.triangle_count++], corners, sizeof corners);
    }
  }

  return mesh;
}
