/* Files of meshes, surfaces, curves and points, in any format that is read: the one place that
 * opens them. Called by the readers of lamella/format.h, by sources.c, compare_meshes.c and
 * bench/bench_run.c.
 *
 * The format follows from the ending of path. What is read is owned by arena, in meters unless the
 * function says otherwise, and meaningful when true is returned. False: the file cannot be read, or
 * is wrong; messages are added to errors. */
#ifndef LAM_LIBRARY_READ_FILES_H
#define LAM_LIBRARY_READ_FILES_H

#include "core/error.h"
#include "core/model.h"

/* The faces of a mesh file, with three or four corners each. */
bool lam_input_mesh(lam_arena *arena, const char *path, lam_errors *errors, lam_mesh *mesh);
/* The triangles of a mesh file; faces with more corners are split. */
bool lam_input_triangles(lam_arena *arena, const char *path, lam_errors *errors, lam_trimesh *mesh);
/* Surface number `face` (from 1) of a file; *note: what of it is not read, NULL: nothing. */
bool lam_input_surface(lam_arena *arena, const char *path, int face, lam_errors *errors,
                       lam_spline_surface *surface, const char **note);
/* All curves of a file: (*curves)[0 .. *count - 1]. */
bool lam_input_curves(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_named_curve **curves);
/* All points of a text file, with the numbers as they are written there, or the vertices of a mesh:
 * (*points)[0 .. *count - 1]. */
bool lam_input_points(lam_arena *arena, const char *path, lam_errors *errors, int *count,
                      const lam_vec3 **points);

#endif
