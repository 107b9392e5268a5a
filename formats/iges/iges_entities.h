/* Geometry out of the directory entries of an IGES file; called by iges_read.c. */
#ifndef LAM_FORMATS_IGES_IGES_ENTITIES_H
#define LAM_FORMATS_IGES_IGES_ENTITIES_H

#include "formats/iges/iges_file.h"
#include "formats/spline/curves.h"

/* Reads the entity 128 whose directory entry begins at line `at` (from 0), in meters. False with
 * a message. The arrays are owned by the reader's arena. */
bool lam_iges_surface(lam_iges_reader *r, int at, lam_spline_surface *surface);
/* The same for a curve: entity 126 (over its own range of parameters), 110, 100, or 106 as a
 * polyline. True with count 0 when it is none of these, or a curve in the parameters of a
 * surface. */
bool lam_iges_curve(lam_iges_reader *r, int at, lam_spline_curve *curve);
/* Marks what lies in the parameters of surfaces: plane[at], per directory line (from 0), becomes
 * true when a curve on a surface (142) or a boundary (141) uses the curve there so. What cannot
 * be read is passed over, without messages. */
void lam_iges_mark_plane_curves(lam_iges_reader *r, bool *plane);
/* Whether the trimmed or bounded surface (144, 143) at line `at` is cut off inside its surface's
 * own boundary; sets surface to the directory line of that (from 0), or -1. What cannot be read
 * is passed over, without messages. */
bool lam_iges_trims(lam_iges_reader *r, int at, int *surface);

#endif
