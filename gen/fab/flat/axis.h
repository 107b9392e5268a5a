/* Coordinates on a developed strip: s along its developed middle line (the axis, a polyline
 * with at least two different points), h across, positive to the left of the direction of
 * travel. Meters. Used by all that is drawn on strips: fab/flat (face, splice, sheet) and
 * fab/lamella (flat patterns, marks). */
#ifndef LAM_FAB_FLAT_AXIS_H
#define LAM_FAB_FLAT_AXIS_H

#include "core/arena.h"
#include "fab/flat/path.h"

typedef struct lam_axis {
  int count;
  const lam_vec2 *points;
  const lam_vec2 *normals; /* unit, to the left; at a corner along the bisector */
  const double *s;         /* arc length at the points, from 0 */
  double length;
} lam_axis;

/* The axis along count >= 2 points, which are kept by pointer; the rest is allocated in arena. */
lam_axis lam_axis_make(lam_arena *arena, const lam_vec2 *points, int count);
/* The point of the plane at (s, h). Beyond its ends the axis goes on straight. The unit normal
 * there is written to normal unless it is NULL. */
lam_vec2 lam_axis_point(const lam_axis *axis, double s, double h, lam_vec2 *normal);
/* The coordinates (s, h), as x and y, of a point of the plane: those of the nearest point of
 * the axis (of its straight continuation beyond the ends), |h| being the distance from it. */
lam_vec2 lam_axis_locate(const lam_axis *axis, lam_vec2 point);

#endif
