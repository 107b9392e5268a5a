/* The boundary of a four-sided surface x(u,v): four spline curves that meet at its corners.
 * Read from designs by sides_keys.h; used by coons_patch.h and by surf/area. */
#ifndef LAM_SURF_SPLINE_SIDES_H
#define LAM_SURF_SPLINE_SIDES_H

#include "core/model.h"
#include "curve/bspline/bspline.h"

/* Sides 0 (v = 0) and 2 (v = 1) run along u, sides 1 (u = 0) and 3 (u = 1) along v. Corner
 * (i,j) is at u = i, v = j. */
enum { LAM_SIDES = 4 };

typedef struct lam_sides {
  lam_spline_curve side[LAM_SIDES];
  /* Derivatives across the sides (by v along sides 0 and 2, by u along 1 and 3, both from 0 to 1),
   * as splines of dimension 3 with the domain of their side; count == 0: not given. */
  lam_bspline across[LAM_SIDES];
} lam_sides;

/* Two ends of curves that should be one corner. */
typedef struct lam_sides_gap {
  double distance; /* m */
  int curve[2];    /* indices of the given curves */
  int end[2];      /* 0: where the curve starts, 1: where it ends */
} lam_sides_gap;

/* Turns four curves, sound (lam_spline_curve_problem) and in any order and direction, into
 * sides: clamped, over [0,1], with knots of opposite sides that differ by rounding made equal,
 * and without weights that are all the same.
 *
 * Order: the first curve is v = 0; of the curves that touch it the first in the list is u = 0.
 * Curves that are listed around the boundary, or as v = 0, v = 1, u = 0, u = 1, so keep these
 * roles. Ends that meet to a millionth of the size are moved to their middle.
 *
 * False when they do not meet (gap: the worst corner of the arrangement that fits best), or
 * when all points are one (gap->distance is 0). given and sides may be the same. Results are
 * owned by the arena; arrays of `given` that need no change are kept by pointer. */
bool lam_sides_join(lam_arena *arena, const lam_sides *given, lam_sides *sides, lam_sides_gap *gap);

#endif
