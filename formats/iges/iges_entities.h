/* Geometry out of the directory entries of an IGES file; for iges_read.c. */
#ifndef LAM_FORMATS_IGES_IGES_ENTITIES_H
#define LAM_FORMATS_IGES_IGES_ENTITIES_H

#include "formats/iges/iges_file.h"
#include "formats/spline/curves.h"

/* Each reads the entity whose directory entry begins at line `at`, in meters. False with a message.
 */
bool lam_iges_surface(lam_iges_reader *r, int at, lam_spline_surface *surface);
/* Entity 126 (over its own range of parameters), 110, 100, or 106 as a polyline. count is 0 when it
 * is none of these, or a curve in the parameters of a surface. */
bool lam_iges_curve(lam_iges_reader *r, int at, lam_spline_curve *curve);
/* Marks what lies in the parameters of surfaces: per directory line (from 0), whether a curve on a
 * surface (142) or a boundary (141) uses it so. What cannot be read is passed over. */
void lam_iges_mark_plane_curves(lam_iges_reader *r, bool *plane);
/* Whether the trimmed or bounded surface (144, 143) at line `at` is cut off inside its surface's
 * own boundary; sets surface to the directory line of that (from 0), or -1. What cannot be read is
 * passed over. */
bool lam_iges_trims(lam_iges_reader *r, int at, int *surface);

#endif
