/* Operations on triangle meshes that need no connectivity. Called by fab, net/measures,
 * net/trace, formats and design. */
#include "core/solid/triangles.h"

#include <stdint.h>
#include <string.h>

/* A triangle of a quad mesh has face[3] < 0. first: where the fan of the face begins, at corner 0
 * or 1, so that its diagonal is the shorter one. */
lam_trimesh lam_mesh_triangles(lam_arena *arena, const lam_mesh *mesh) {
  lam_trimesh result = {.vertex_count = mesh->vertex_count};
  result.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  if (mesh->vertex_count)
    memcpy(result.vertices, mesh->vertices, (size_t)mesh->vertex_count * sizeof(lam_vec3));
  result.triangles = lam_arena_alloc(arena, 2 * (size_t)mesh->face_count, sizeof *result.triangles);

  for (int i = 0; i < mesh->face_count; i++) {
    const int *f = mesh->faces[i];
    const lam_vec3 *p = mesh->vertices;
    int first = f[3] >= 0 && lam_distance(p[f[1]], p[f[3]]) < lam_distance(p[f[0]], p[f[2]]);

    for (int k = 0; k < (f[3] < 0 ? 1 : 2); k++) {
      int *t = result.triangles[result.triangle_count++];
      t[0] = f[first];
      t[1] = f[first + 1 + k];
      t[2] = f[(first + 2 + k) % 4];
    }
  }
  return result;
}

/* A hash table of points with open addressing. Keys are the coordinates, or the numbers of their
 * grid cells. */
typedef struct point_table {
  size_t mask;
  int *slot;     /* index of a vertex of the result + 1; 0: free */
  lam_vec3 *key; /* per vertex of the result */
} point_table;

/* The bits of the coordinates, mixed. */
static uint64_t hash_of(lam_vec3 key) {
  uint64_t words[3], hash = 0;
  memcpy(words, &key, sizeof words);
  for (int k = 0; k < 3; k++) { /* the finalizer of MurmurHash3 */
    hash ^= words[k];
    hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdULL;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    hash ^= hash >> 33;
  }
  return hash;
}

/* x + 0 turns -0 into 0, so that both have the same bits. */
static lam_vec3 key_of(lam_vec3 p, double tolerance) {
  if (tolerance > 0)
    p = lam_v3(nearbyint(p.x / tolerance), nearbyint(p.y / tolerance), nearbyint(p.z / tolerance));
  return lam_v3(p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

/* The index of the vertex with this key: an earlier one, or `next`, which is put in then. */
static int look_up(point_table *table, lam_vec3 key, int next) {
  size_t i = hash_of(key) & table->mask;
  for (; table->slot[i]; i = (i + 1) & table->mask)
    if (memcmp(&table->key[table->slot[i] - 1], &key, sizeof key) == 0) return table->slot[i] - 1;
  table->slot[i] = next + 1;
  table->key[next] = key;
  return next;
}

/* The table is at most half full. Everything but the result is released again. */
lam_trimesh lam_trimesh_weld(lam_arena *arena, const lam_trimesh *mesh, double tolerance) {
  lam_trimesh result = {0};
  result.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  result.triangles = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof *result.triangles);

  lam_arena_mark mark = lam_arena_mark_get(arena);
  point_table table = {.mask = 15};
  while (table.mask < 2 * (size_t)mesh->vertex_count) table.mask = 2 * table.mask + 1;
  table.slot = LAM_NEW(arena, int, table.mask + 1);
  table.key = LAM_NEW(arena, lam_vec3, mesh->vertex_count);

  int *to = LAM_NEW(arena, int, mesh->vertex_count);
  for (int i = 0; i < mesh->vertex_count; i++) {
    to[i] = look_up(&table, key_of(mesh->vertices[i], tolerance), result.vertex_count);
    if (to[i] == result.vertex_count) result.vertices[result.vertex_count++] = mesh->vertices[i];
  }

  for (int i = 0; i < mesh->triangle_count; i++) {
    const int *t = mesh->triangles[i];
    int a = to[t[0]], b = to[t[1]], c = to[t[2]];
    if (a == b || b == c || c == a) continue;
    int *kept = result.triangles[result.triangle_count++];
    kept[0] = a;
    kept[1] = b;
    kept[2] = c;
  }

  lam_arena_release(arena, mark);
  return result;
}

/* Vertices first; the sign of the axes' determinant tells whether they mirror. */
lam_trimesh lam_trimesh_placed(lam_arena *arena, const lam_trimesh *mesh, const lam_pose *frame) {
  lam_trimesh result = *mesh;
  result.vertices = LAM_NEW(arena, lam_vec3, mesh->vertex_count);
  for (int i = 0; i < mesh->vertex_count; i++) {
    lam_vec3 p = mesh->vertices[i];
    lam_vec3 q = lam_along(frame->origin, p.x, frame->axis[0]);
    result.vertices[i] = lam_along(lam_along(q, p.y, frame->axis[1]), p.z, frame->axis[2]);
  }

  result.triangles = lam_arena_alloc(arena, (size_t)mesh->triangle_count, sizeof *result.triangles);
  bool mirrors = lam_dot(frame->axis[0], lam_cross(frame->axis[1], frame->axis[2])) < 0;
  for (int i = 0; i < mesh->triangle_count; i++)
    for (int k = 0; k < 3; k++) result.triangles[i][k] = mesh->triangles[i][mirrors ? 2 - k : k];
  return result;
}

/* Sizes first, so that the arrays are made once. */
lam_trimesh lam_trimesh_join(lam_arena *arena, const lam_trimesh *const *meshes, int count) {
  lam_trimesh result = {0};
  size_t vertices = 0, triangles = 0;
  for (int i = 0; i < count; i++) {
    vertices += (size_t)meshes[i]->vertex_count;
    triangles += (size_t)meshes[i]->triangle_count;
  }

  result.vertices = LAM_NEW(arena, lam_vec3, vertices);
  result.triangles = lam_arena_alloc(arena, triangles, sizeof *result.triangles);

  for (int i = 0; i < count; i++) {
    const lam_trimesh *mesh = meshes[i];
    int first = result.vertex_count;
    for (int j = 0; j < mesh->vertex_count; j++)
      result.vertices[result.vertex_count++] = mesh->vertices[j];
    for (int j = 0; j < mesh->triangle_count; j++, result.triangle_count++)
      for (int k = 0; k < 3; k++)
        result.triangles[result.triangle_count][k] = first + mesh->triangles[j][k];
  }
  return result;
}

/* The sum of the tetrahedra between the triangles and the mesh's first vertex: (a-o) . ((b-o) x
 * (c-o)) / 6. */
double lam_trimesh_volume(const lam_trimesh *mesh) {
  double sum = 0;
  for (int i = 0; i < mesh->triangle_count; i++) {
    const int *t = mesh->triangles[i];
    const lam_vec3 *p = mesh->vertices, o = p[0];
    sum += lam_dot(lam_sub(p[t[0]], o), lam_cross(lam_sub(p[t[1]], o), lam_sub(p[t[2]], o)));
  }
  return sum / 6;
}

/* Half the lengths of the cross products of two sides. */
double lam_trimesh_area(const lam_trimesh *mesh) {
  double sum = 0;
  for (int i = 0; i < mesh->triangle_count; i++) {
    const int *t = mesh->triangles[i];
    const lam_vec3 *p = mesh->vertices;
    sum += lam_length(lam_cross(lam_sub(p[t[1]], p[t[0]]), lam_sub(p[t[2]], p[t[0]])));
  }
  return sum / 2;
}

/* Componentwise least and largest coordinates. */
void lam_points_bounds(const lam_vec3 *points, int count, lam_vec3 *min, lam_vec3 *max) {
  *min = *max = count ? points[0] : lam_v3(0, 0, 0);
  for (int i = 1; i < count; i++) {
    lam_vec3 p = points[i];
    *min = lam_v3(fmin(min->x, p.x), fmin(min->y, p.y), fmin(min->z, p.z));
    *max = lam_v3(fmax(max->x, p.x), fmax(max->y, p.y), fmax(max->z, p.z));
  }
}
