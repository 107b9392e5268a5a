/* What the writers of prints share. */
#ifndef LAM_FORMATS_MESH_PRINT_H
#define LAM_FORMATS_MESH_PRINT_H

#include "core/arena.h"
#include "core/model.h"

/* Unit normals of the vertices: the mean of those of the triangles, by area. */
const lam_vec3 *lam_print_normals(lam_arena *arena, const lam_trimesh *mesh);

#endif
