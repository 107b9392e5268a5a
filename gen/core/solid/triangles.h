/* Plain operations on meshes, without connectivity. */
#ifndef LAM_CORE_SOLID_TRIANGLES_H
#define LAM_CORE_SOLID_TRIANGLES_H

#include "core/arena.h"
#include "core/model.h"

/* A triangle mesh of a quad mesh: every quad is split along its shorter diagonal. */
lam_trimesh lam_mesh_triangles(lam_arena *arena, const lam_mesh *mesh);
/* The mesh with vertices at exactly the same coordinates (or within tolerance, by snapping to a
 * grid of that size when tolerance > 0) merged, and degenerate triangles dropped. Order of first
 * appearance is kept. O(n log n) or better. */
lam_trimesh lam_trimesh_weld(lam_arena *arena, const lam_trimesh *mesh, double tolerance);
/* The mesh with vertices transformed by frame. */
lam_trimesh lam_trimesh_placed(lam_arena *arena, const lam_trimesh *mesh, const lam_pose *frame);
/* One mesh of many, in order. */
lam_trimesh lam_trimesh_join(lam_arena *arena, const lam_trimesh *const *meshes, int count);
/* Volume enclosed (signed; meaningful when closed) and area. */
double lam_trimesh_volume(const lam_trimesh *mesh);
double lam_trimesh_area(const lam_trimesh *mesh);
void lam_points_bounds(const lam_vec3 *points, int count, lam_vec3 *min, lam_vec3 *max);

#endif
