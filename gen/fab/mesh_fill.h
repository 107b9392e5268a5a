/* Triangle meshes whose size is known beforehand, filled triangle by triangle: how the solids of
 * parts are made. Used by fab/turned.c and by the solids of fab/lamella and fab/parts. */
#ifndef LAM_FAB_MESH_FILL_H
#define LAM_FAB_MESH_FILL_H

#include "core/arena.h"
#include "core/model.h"

#include <string.h>

/* A mesh with room for so many vertices and triangles, owned by arena. It has all its vertices from
 * the start (zero, to be set by the caller) and no triangle yet. */
static inline lam_trimesh lam_trimesh_empty(lam_arena *arena, int vertices, int triangles) {
  lam_trimesh mesh = {vertices, LAM_NEW(arena, lam_vec3, vertices), 0, NULL};
  mesh.triangles = (int(*)[3])lam_arena_alloc(arena, (size_t)triangles, sizeof *mesh.triangles);
  return mesh;
}

/* Appends the triangle of three vertices, counterclockwise from outside, where there is room. */
static inline void lam_trimesh_triangle(lam_trimesh *mesh, int a, int b, int c) {
  memcpy(mesh->triangles[mesh->triangle_count++], (int[3]){a, b, c}, sizeof(int[3]));
}

/* Appends the quad a b c d as two triangles, split along the diagonal from a to c. */
static inline void lam_trimesh_quad(lam_trimesh *mesh, int a, int b, int c, int d) {
  lam_trimesh_triangle(mesh, a, b, c);
  lam_trimesh_triangle(mesh, a, c, d);
}

#endif
