/* Reading STEP: what step_read.c offers to the format's row in step.c. */
#ifndef LAM_FORMATS_STEP_STEP_H
#define LAM_FORMATS_STEP_STEP_H

#include "formats/format.h"

/* The B-spline surfaces of a STEP file in the order of their numbers, rational or not, in meters,
 * without trimming and without the placement of components (their notes say where that matters).
 * bytes must stay; the list is owned by arena. At least one, or false with a message. */
bool lam_step_read_surfaces(lam_arena *arena, const char *bytes, size_t count,
                            lam_location location, lam_errors *errors, lam_spline_list *surfaces);
/* The curves of a STEP file in the order of their numbers: edges, trimmed curves, polylines, and
 * B-spline curves that serve none of these; on B-splines, straight lines, circles and ellipses;
 * others are left out. Of no family. At least one, or false with a message. */
bool lam_step_read_curves(lam_arena *arena, const char *bytes, size_t count, lam_location location,
                          lam_errors *errors, lam_curve_list *curves);

#endif
