#include "formats/corner_normals.h"

/* Corners by vertex: corners[first[v] .. first[v+1]-1]; corner 3 t + k is corner k of triangle t.
 */
static void sort_corners(const lam_trimesh *mesh, int *first, int *corners) {
  for (int i = 0; i < 3 * mesh->triangle_count; i++) first[mesh->triangles[i / 3][i % 3] + 1]++;
  for (int v = 0; v < mesh->vertex_count; v++) first[v + 1] += first[v];
  for (int i = 3 * mesh->triangle_count - 1; i >= 0; i--)
    corners[--first[mesh->triangles[i / 3][i % 3] + 1]] = i;
  for (int v = 0; v < mesh->vertex_count; v++) first[v] = first[v + 1];
  first[mesh->vertex_count] = 3 * mesh->triangle_count;
}

static double corner_angle(const lam_trimesh *mesh, int corner) {
  const int *t = mesh->triangles[corner / 3];
  lam_vec3 x = mesh->vertices[t[corner % 3]];
  return lam_angle(lam_sub(mesh->vertices[t[(corner + 1) % 3]], x),
                   lam_sub(mesh->vertices[t[(corner + 2) % 3]], x));
}

static bool has_area(lam_vec3 normal) { return lam_dot(normal, normal) > 0; }

static bool same(lam_vec3 a, lam_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

lam_shaded_mesh lam_shaded_mesh_make(lam_arena *arena, const lam_trimesh *mesh, double angle) {
  int corner_count = 3 * mesh->triangle_count;
  lam_shaded_mesh shaded = {
      .source = LAM_NEW(arena, int, corner_count),
      .normals = LAM_NEW(arena, lam_vec3, corner_count),
      .triangles = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof(int[3]))};
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int *first = LAM_NEW(arena, int, mesh->vertex_count + 1),
      *corners = LAM_NEW(arena, int, corner_count);
  int *vertex = LAM_NEW(arena, int, corner_count); /* per corner: its vertex of the shaded mesh */
  lam_vec3 *flat = LAM_NEW(arena, lam_vec3, mesh->triangle_count);
  double least = cos(angle);
  for (int t = 0; t < mesh->triangle_count; t++) {
    const int *c = mesh->triangles[t];
    const lam_vec3 *x = mesh->vertices;
    flat[t] = lam_unit(lam_cross(lam_sub(x[c[1]], x[c[0]]), lam_sub(x[c[2]], x[c[0]])));
  }
  sort_corners(mesh, first, corners);
  for (int v = 0; v < mesh->vertex_count; v++) {
    int begin = shaded.vertex_count;
    for (int i = first[v]; i < first[v + 1]; i++) {
      lam_vec3 own = flat[corners[i] / 3], sum = {0, 0, 0};
      if (!has_area(own)) continue;
      /* always in the same order, so that corners with the same neighbors get the same bits */
      for (int j = first[v]; j < first[v + 1]; j++) {
        lam_vec3 other = flat[corners[j] / 3];
        if (i == j || lam_dot(own, other) >= least)
          sum = lam_along(sum, corner_angle(mesh, corners[j]), other);
      }
      sum = lam_unit(sum);
      int k = begin;
      while (k < shaded.vertex_count && !same(shaded.normals[k], sum)) k++;
      if (k == shaded.vertex_count) {
        shaded.normals[k] = sum;
        shaded.source[k] = v;
        shaded.vertex_count++;
      }
      vertex[corners[i]] = k;
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
