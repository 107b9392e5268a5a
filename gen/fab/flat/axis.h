/* Coordinates on a developed strip: s along its developed middle line (the axis, a polyline with at
 * least two different points), h across, positive to the left of the direction of travel. */
#ifndef LAM_FAB_FLAT_AXIS_H
#define LAM_FAB_FLAT_AXIS_H

#include "core/arena.h"
#include "fab/flat/path.h"

typedef struct lam_axis {
  int count;
  const lam_vec2 *points;
  const lam_vec2
      *normals;    /* unit, left of the direction of travel: at a corner they halve its angle */
  const double *s; /* arc length at the points, from 0 */
  double length;
} lam_axis;

/* points are kept by pointer. */
lam_axis lam_axis_make(lam_arena *arena, const lam_vec2 *points, int count);
/* The point of the plane at (s, h). Beyond its ends the axis goes on straight. The unit normal
 * there is written to normal unless it is NULL. */
lam_vec2 lam_axis_point(const lam_axis *axis, double s, double h, lam_vec2 *normal);
/* The coordinates (s, h), as x and y, of a point of the plane: those at the nearest segment of the
 * axis. */
lam_vec2 lam_axis_locate(const lam_axis *axis, lam_vec2 point);

#endif
