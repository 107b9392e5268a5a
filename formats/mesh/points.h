/* Points from text files: surveys and scans as .xyz, .pts, .csv, .txt. */
#ifndef LAM_FORMATS_MESH_POINTS_H
#define LAM_FORMATS_MESH_POINTS_H

#include "core/error.h"
#include "core/vec3.h"
#include <stdbool.h>
#include <stddef.h>

/* One point in a line: x, y and z, separated by spaces, tabs, semicolons or commas; what follows
 * them (colors, intensity) is not read, nor are empty lines, comments after # and a first line that
 * is no point (names of columns, a number of points). bytes stay; points are as written, without a
 * unit. Errors name the line: not a number, less than three, commas in numbers. At least one point
 * when it succeeds. */
bool lam_points_parse(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                      lam_errors *errors, int *point_count, const lam_vec3 **points);

#endif
