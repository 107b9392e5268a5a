/* The net as Wavefront OBJ. */
#ifndef LAM_FORMATS_OBJ_H
#define LAM_FORMATS_OBJ_H

#include "core/model.h"
#include "core/text.h"

/* Faces and polylines of the model's net at the given positions of its vertices. */
void lam_obj_net(const lam_model *model, const lam_vec3 *vertices, lam_text *out);

#endif
