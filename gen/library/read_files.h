/* Files of meshes, surfaces, curves and points, in any format that is read: the one place that
 * opens them. Called by the readers of lamella/format.h and by sources.c. */
#ifndef LAM_LIBRARY_READ_FILES_H
#define LAM_LIBRARY_READ_FILES_H

#include "core/error.h"
#include "core/model.h"

/* The quads / triangles of a file, in arena. False with messages when it cannot be read. */
bool lam_input_mesh(lam_arena *arena, const char *path, lam_errors *errors, lam_mesh *mesh);
bool lam_input_triangles(lam_arena *arena, const char *path, lam_errors *errors, lam_trimesh *mesh);
/* Surface number `face` (from 1) of a file; note says what of it is not read, NULL: nothing. */
bool lam_input_surface(lam_arena *arena, const char *path, int face, lam_errors *errors,
                       lam_spline_surface *surface, const char **note);
/* All curves of a file. */
bool lam_input_curves(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_named_curve **curves);
/* All points of a file: of text, or the vertices of a mesh. */
bool lam_input_points(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_vec3 **points);

#endif
