/* Vertices for shading: smooth along a strip, split at its edges. For the writers that show parts
 * with normals: formats/gltf/gltf.c and formats/pov. */
#ifndef LAM_FORMATS_CORNER_NORMALS_H
#define LAM_FORMATS_CORNER_NORMALS_H

#include "core/arena.h"
#include "core/model.h"

/* A mesh whose vertices have one normal each: a vertex of the solid is repeated for every normal it
 * needs. */
typedef struct lam_shaded_mesh {
  int vertex_count;
  int *source;       /* per vertex: its vertex in the solid */
  lam_vec3 *normals; /* per vertex, unit */
  int triangle_count;
  int (*triangles)[3]; /* of vertices of this mesh, in the order of the solid's */
} lam_shaded_mesh;

/* The normal of a corner is the sum of the normals of the triangles around its vertex that lie
 * within `angle` (radians) of its own triangle, weighted by their angles at the vertex. Triangles
 * without area are dropped. The arrays of the result are owned by arena; mesh is only read. */
lam_shaded_mesh lam_shaded_mesh_make(lam_arena *arena, const lam_trimesh *mesh, double angle);

#endif
