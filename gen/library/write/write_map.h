/* Color maps of measures as single files. */
#ifndef LAM_LIBRARY_WRITE_WRITE_MAP_H
#define LAM_LIBRARY_WRITE_WRITE_MAP_H

#include "core/error.h"
#include "core/model.h"

/* Whether a map can be written under this name: the ending is .svg, .png or .glb; otherwise one
 * message. */
bool lam_measure_map_check(const char *path, lam_errors *errors);
/* Writes the first map of the model. PNG is made from SVG by rsvg-convert: LAM_MISSING_PROGRAM
 * without it. */
lam_status lam_measure_map_write(const lam_model *model, const char *path, lam_errors *errors);

#endif
