/* Points as designs give them, in numbers or in a file: the keys `points`, `file` and `unit`.
 * Called by surf/kinds (interpolation, approximation, nurbs), by sides_keys.c and by
 * surf/area/least_area.c. */
#ifndef LAM_SURF_SPLINE_POINT_KEYS_H
#define LAM_SURF_SPLINE_POINT_KEYS_H

#include "surf/surface_kind.h"

/* A member of the parameters of a kind; filled by LAM_POINT_KEYS. */
typedef struct lam_point_keys {
  lam_list list;        /* of numbers: x, y, z of every point */
  lam_point_file cloud; /* in place of the list */
  int unit;             /* index in lam_point_units */
} lam_point_keys;

/* Rows for the key table of a kind: params.member is a lam_point_keys, text the default list. */
#define LAM_POINT_KEYS(params, member, text, sentence)                                             \
  LAM_NUMBER_KEY(params, "points", member.list, text, 0, 0, sentence),                             \
      LAM_TEXT_KEY(params, "file", member.cloud.file, "~",                                         \
                   "In place of points: a file beside the design, .xyz, .pts, .csv, .txt or .asc " \
                   "with x, y and z in every line, or the vertices of an .obj or .stl mesh."),     \
      LAM_CHOICE_KEY(params, "unit", member.unit, "m", lam_point_units,                            \
                     "Unit of the numbers in points.")

/* The points that the keys give, in meters; owned by the arena. Sets count. NULL, with a
 * message, when they are fewer than `least` or the file has not been read. location: of the
 * surface in the design. */
const lam_vec3 *lam_points_given(lam_arena *arena, const lam_point_keys *keys, int least,
                                 lam_location location, lam_errors *errors, int *count);

/* The points of a list of x, y, z, in meters; unit is an index of lam_point_units. Owned by the
 * arena. Precondition: the length of the list is a multiple of 3. */
lam_vec3 *lam_points_read(lam_arena *arena, const lam_list *list, int unit);

/* Whether all weights of a list are positive; otherwise false, with a message at the key. */
bool lam_weights_check(const lam_list *weights, const char *key, lam_location location,
                       lam_errors *errors);

#endif
