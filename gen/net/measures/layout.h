/* Pictures of a net in the plane that some measures compare it with: those of
 * distortion_measures.c. Used by measure.c and measure_map.c. */
#ifndef LAM_NET_MEASURES_LAYOUT_H
#define LAM_NET_MEASURES_LAYOUT_H

#include "net/measures/measure.h"

/* Where the vertices lie in the plane that this measure compares the net with: vertex_count
 * points in in->arena; NULL when the measure compares it with none, or this net has none. */
const lam_vec2 *lam_measure_layout(const lam_measure_kind *kind, const lam_measuring *in);
/* Whether the measure solves for its picture, which takes seconds on a large net: only measured
 * when it is named. */
bool lam_measure_is_slow(const lam_measure_kind *kind);
/* A word (static text): color maps of one design whose measures have the same one share their
 * colors. NULL: none. */
const char *lam_measure_scale(const lam_measure_kind *kind);

#endif
