/* Normals of the smooth surface that a net stands for, as parts need them: strips, panels and
 * offsets stand along them. Called by design/net_stage.c. */
#ifndef LAM_MESH_SURFACE_NORMALS_H
#define LAM_MESH_SURFACE_NORMALS_H

#include "core/arena.h"
#include "mesh/net.h"

/* Unit normals at all vertices, from positions (meters) alone; normals: vertex_count each. arena is
 * only used for scratch.
 *
 *   - Regular vertices: square to the circles through the neighbors along both lines. Exact on
 *     spheres, and for planar and spherical stars; of second order elsewhere.
 *   - On the border: the frames of the line that ends there are carried on, as they turn from one
 *     vertex to the next. Exact on orbits of screw motions with even steps (circles of a sphere,
 *     helices, parallels), of third order elsewhere. Beside planar stars, a border vertex whose
 *     three edges lie in one plane has its normal.
 *   - Irregular vertices, and where lines are too short: as lam_net_normals. */
void lam_surface_normals(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                         lam_vec3 *normals);

#endif
