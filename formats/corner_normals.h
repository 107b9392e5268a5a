/* Vertices for shading: smooth along a strip, split at its edges. */
#ifndef LAM_FORMATS_MESH_CORNER_NORMALS_H
#define LAM_FORMATS_MESH_CORNER_NORMALS_H

#include "core/arena.h"
#include "core/model.h"

/* A mesh whose vertices have one normal each: a vertex of the solid is repeated for every normal it
 * needs. */
typedef struct lam_shaded_mesh {
  int vertex_count;
  int *source;       /* per vertex: its vertex in the solid */
  lam_vec3 *normals; /* unit */
  int triangle_count;
  int (*triangles)[3];
} lam_shaded_mesh;

/* The normal of a corner is the sum of the normals of the triangles around its vertex that lie
 * within `angle` of its own triangle, weighted by their angles at the vertex. Triangles without
 * area are dropped. Owned by arena. */
lam_shaded_mesh lam_shaded_mesh_make(lam_arena *arena, const lam_trimesh *mesh, double angle);

#endif
