/* What the writers of prints share: formats/gltf/gltf.c and formats/pov/pov_print.c. */
#ifndef LAM_FORMATS_PRINT_H
#define LAM_FORMATS_PRINT_H

#include "core/arena.h"
#include "core/model.h"

/* Unit normals, one per vertex of mesh: the mean of those of the triangles around it, weighted by
 * their areas; (0, 0, 1) where that is zero. Owned by arena. */
const lam_vec3 *lam_print_normals(lam_arena *arena, const lam_trimesh *mesh);

#endif
