/* The net as Wavefront OBJ (written by obj.c, also for frames.c), and what is read of OBJ besides
 * meshes (by surface_obj_read.c, for the row in obj.c). */
#ifndef LAM_FORMATS_MESH_OBJ_H
#define LAM_FORMATS_MESH_OBJ_H

#include "core/error.h"
#include "core/model.h"
#include "core/text.h"
#include "formats/scan.h"
#include "formats/spline/curves.h"

/* Adds the faces and polylines of the model's net, with its vertices at the given positions (one
 * per vertex of the net), in meters. */
void lam_obj_net(const lam_model *model, const lam_vec3 *vertices, lam_text *out);

/* Starts reading an OBJ file: a backslash at the end of a line joins the next one to it. */
lam_scan lam_obj_scan(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors);

/* The free-form surfaces / curves of a file: B-splines and Bezier, rational or not, in the file's
 * unit taken as meters. Trimming is not read (the notes of surfaces say so). bytes must stay; the
 * lists are owned by arena. At least one item, or false with a message. */
bool lam_obj_read_surfaces(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                           lam_errors *errors, lam_spline_list *surfaces);
bool lam_obj_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                         lam_errors *errors, lam_curve_list *curves);

#endif
