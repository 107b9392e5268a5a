/* The net as Wavefront OBJ, and what is read of OBJ besides meshes. */
#ifndef LAM_FORMATS_MESH_OBJ_H
#define LAM_FORMATS_MESH_OBJ_H

#include "core/error.h"
#include "core/model.h"
#include "core/text.h"
#include "formats/spline/curves.h"

/* Faces and polylines of the model's net at the given positions of its vertices. */
void lam_obj_net(const lam_model *model, const lam_vec3 *vertices, lam_text *out);

/* The free-form surfaces / curves of a file: B-splines and Bezier, rational or not, in the file's
 * unit taken as meters. Trimming is not read (the notes of surfaces say so). At least one, or an
 * error. */
bool lam_obj_read_surfaces(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                           lam_errors *errors, lam_spline_list *surfaces);
bool lam_obj_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                         lam_errors *errors, lam_curve_list *curves);

#endif
