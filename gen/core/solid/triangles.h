/* Plain operations on meshes, without connectivity: splitting, welding, placing, bounds, volume.
 * Used by fab (volumes), by the measures of nets, by the readers and writers of meshes, and by
 * the pipeline. Results are owned by the arena and share no arrays with their arguments. */
#ifndef LAM_CORE_SOLID_TRIANGLES_H
#define LAM_CORE_SOLID_TRIANGLES_H

#include "core/arena.h"
#include "core/model.h"

/* A triangle mesh of a quad mesh: every quad is split along its shorter diagonal; triangles stay.
 * Vertices are copied. */
lam_trimesh lam_mesh_triangles(lam_arena *arena, const lam_mesh *mesh);
/* The mesh with vertices at exactly the same coordinates merged (or within tolerance, m, by
 * snapping to a grid of that size when tolerance > 0), and degenerate triangles dropped. Order of
 * first appearance is kept. Expected time O(n). */
lam_trimesh lam_trimesh_weld(lam_arena *arena, const lam_trimesh *mesh, double tolerance);
/* The mesh with vertices x -> frame->origin + x axis[0] + y axis[1] + z axis[2]; where the axes
 * mirror, triangles are turned, so that outside stays outside. */
lam_trimesh lam_trimesh_placed(lam_arena *arena, const lam_trimesh *mesh, const lam_pose *frame);
/* One mesh of `count` meshes, in order. For tests (tests/unit/mesh_fixture.h). */
lam_trimesh lam_trimesh_join(lam_arena *arena, const lam_trimesh *const *meshes, int count);
/* The volume enclosed, m^3: signed, positive when faces are counterclockwise from outside;
 * meaningful when the mesh is closed. */
double lam_trimesh_volume(const lam_trimesh *mesh);
/* The sum of the triangles' areas, m^2. For tests. */
double lam_trimesh_area(const lam_trimesh *mesh);
/* The box of the points; (0, 0, 0) twice when there are none. */
void lam_points_bounds(const lam_vec3 *points, int count, lam_vec3 *min, lam_vec3 *max);

#endif
