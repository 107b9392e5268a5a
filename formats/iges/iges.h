/* Reading IGES: what iges_read.c offers to the format's row in iges.c. */
#ifndef LAM_FORMATS_IGES_IGES_H
#define LAM_FORMATS_IGES_IGES_H

#include "formats/format.h"

/* The rational B-spline surfaces (entity 128) of an IGES file in the order of
 * its directory, in meters, moved by their transformation matrices (entity
 * 124), without trimming (their notes say where that matters). bytes must
 * stay; the list is owned by arena. At least one, or false with a message. */
bool lam_iges_read_surfaces(lam_arena *arena, const char *bytes, size_t count,
                            lam_location location, lam_errors *errors, lam_spline_list *surfaces);
/* The curves of an IGES file in the same way: rational B-splines (126), lines (110), arcs (100)
 * and polylines (106), not those in the parameters of surfaces; named by their labels, of no
 * family. At least one, or false with a message. */
bool lam_iges_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                          lam_errors *errors, lam_curve_list *curves);

#endif
