/* Vertices for shading: one normal per vertex, split at the edges of a strip. Called by the glTF
 * writer (formats/gltf/gltf.c) and for the meshes of POV-Ray scenes (formats/pov/pov_net.c). */
#include "formats/corner_normals.h"

/* Corners by vertex: those of vertex v are corners[first[v] .. first[v+1]-1], ascending; corner
 * 3 t + k is corner k of triangle t. first: vertex_count + 1 zeros; corners: 3 triangle_count. */
static void sort_corners(const lam_trimesh *mesh, int *first, int *corners) {
  for (int i = 0; i < 3 * mesh->triangle_count; i++) first[mesh->triangles[i / 3][i % 3] + 1]++;
  for (int v = 0; v < mesh->vertex_count; v++) first[v + 1] += first[v];

  /* Filled from behind, so that first[v + 1] ends as the beginning of v: it moves to first[v]. */
  for (int i = 3 * mesh->triangle_count - 1; i >= 0; i--)
    corners[--first[mesh->triangles[i / 3][i % 3] + 1]] = i;
  for (int v = 0; v < mesh->vertex_count; v++) first[v] = first[v + 1];
  first[mesh->vertex_count] = 3 * mesh->triangle_count;
}

/* The angle of a triangle at one of its corners, radians. */
static double corner_angle(const lam_trimesh *mesh, int corner) {
  const int *t = mesh->triangles[corner / 3];
  lam_vec3 x = mesh->vertices[t[corner % 3]];
  return lam_angle(lam_sub(mesh->vertices[t[(corner + 1) % 3]], x),
                   lam_sub(mesh->vertices[t[(corner + 2) % 3]], x));
}

static bool has_area(lam_vec3 normal) { return lam_dot(normal, normal) > 0; }

static bool same(lam_vec3 a, lam_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/* Unit normals of the triangles; zero where a triangle has no area. */
static lam_vec3 *flat_normals(lam_arena *arena, const lam_trimesh *mesh) {
  lam_vec3 *flat = LAM_NEW(arena, lam_vec3, mesh->triangle_count);
  for (int t = 0; t < mesh->triangle_count; t++) {
    const int *c = mesh->triangles[t];
    const lam_vec3 *x = mesh->vertices;
    flat[t] = lam_unit(lam_cross(lam_sub(x[c[1]], x[c[0]]), lam_sub(x[c[2]], x[c[0]])));
  }
  return flat;
}

/* The unit normal at the corner `own`: the flat normals of the triangles around its vertex whose
 * cosine with its own is `least` or more, weighted by their angles. around: all corners of the
 * vertex, summed in their order, so that corners with the same neighbors get the same bits. */
static lam_vec3 corner_normal(const lam_trimesh *mesh, const lam_vec3 *flat, int own,
                              const int *around, int count, double least) {
  lam_vec3 sum = {0, 0, 0};
  for (int j = 0; j < count; j++) {
    lam_vec3 other = flat[around[j] / 3];
    if (around[j] == own || lam_dot(flat[own / 3], other) >= least)
      sum = lam_along(sum, corner_angle(mesh, around[j]), other);
  }
  return lam_unit(sum);
}

/* The shaded copy of vertex v with this normal, among those from `begin` on; added when missing. */
static int shaded_vertex(lam_shaded_mesh *shaded, int begin, int v, lam_vec3 normal) {
  int k = begin;
  while (k < shaded->vertex_count && !same(shaded->normals[k], normal)) k++;
  if (k < shaded->vertex_count) return k;

  shaded->normals[k] = normal;
  shaded->source[k] = v;
  shaded->vertex_count++;
  return k;
}

/* Vertices are made in the order of the solid's vertices and, at each, of its corners. */
lam_shaded_mesh lam_shaded_mesh_make(lam_arena *arena, const lam_trimesh *mesh, double angle) {
  int corner_count = 3 * mesh->triangle_count;
  lam_shaded_mesh shaded = {
      .source = LAM_NEW(arena, int, corner_count),
      .normals = LAM_NEW(arena, lam_vec3, corner_count),
      .triangles = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof(int[3]))};

  /* What follows is needed only here, and released at the end. */
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int *first = LAM_NEW(arena, int, mesh->vertex_count + 1);
  int *corners = LAM_NEW(arena, int, corner_count);
  int *vertex = LAM_NEW(arena, int, corner_count); /* per corner: its vertex of the shaded mesh */
  lam_vec3 *flat = flat_normals(arena, mesh);
  sort_corners(mesh, first, corners);

  double least = cos(angle);
  for (int v = 0; v < mesh->vertex_count; v++) {
    int begin = shaded.vertex_count, around = first[v + 1] - first[v];
    for (int i = first[v]; i < first[v + 1]; i++) {
      if (!has_area(flat[corners[i] / 3])) continue;
      lam_vec3 normal = corner_normal(mesh, flat, corners[i], corners + first[v], around, least);
      vertex[corners[i]] = shaded_vertex(&shaded, begin, v, normal);
    }
  }

  for (int t = 0; t < mesh->triangle_count; t++) {
    if (!has_area(flat[t])) continue;
    for (int k = 0; k < 3; k++) shaded.triangles[shaded.triangle_count][k] = vertex[3 * t + k];
    shaded.triangle_count++;
  }
  lam_arena_release(arena, mark);
  return shaded;
}
