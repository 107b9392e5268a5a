/* Color maps of measures as single files. Called by measure_net.c. */
#ifndef LAM_LIBRARY_WRITE_WRITE_MAP_H
#define LAM_LIBRARY_WRITE_WRITE_MAP_H

#include "core/error.h"
#include "core/model.h"

/* Whether a map can be written under this name: the ending is .svg, .png or .glb; otherwise one
 * message. */
bool lam_measure_map_check(const char *path, lam_errors *errors);
/* Writes the first map of the model to path, whose ending lam_measure_map_check allows. The file
 * appears complete or not at all. Every failure has a message in errors.
 *
 *   LAM_IO               the file cannot be written
 *   LAM_MISSING_PROGRAM  rsvg-convert, which makes PNG from SVG, is not installed
 *   LAM_FAILED           rsvg-convert, or the library behind the format, failed */
lam_status lam_measure_map_write(const lam_model *model, const char *path, lam_errors *errors);

#endif
