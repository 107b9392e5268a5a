/* What the glTF writers beside it share (gltf.c, plot_gltf.c, animation.c): a model's data as the
 * arrays that a scene takes. */
#ifndef LAM_FORMATS_GLTF_GLTF_SCENE_H
#define LAM_FORMATS_GLTF_GLTF_SCENE_H

#include "core/model.h"
#include "core/text.h"
#include "formats/gltf/glb.h"

/* The matrix of a root node, column-major: the axes x, y, z (up) become x, -z, y (up). */
extern const double lam_gltf_y_up[16];

/* The same for a model, with its local origin as translation. Owned by arena. */
const double *lam_gltf_root(lam_arena *arena, const lam_model *model);

/* A vector as three floats, without negative zeros. */
void lam_gltf_vector(float *to, lam_vec3 v);
/* The edges of the model's polylines as lines: two vertices of the net each, index_count in all.
 * Owned by arena. */
int *lam_gltf_lines(lam_arena *arena, const lam_model *model, int *index_count);

#endif
