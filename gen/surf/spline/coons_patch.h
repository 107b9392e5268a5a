/* Surfaces between four boundary curves (S. A. Coons 1967; Farin, Curves and Surfaces for CAGD,
 * ch. 22), as exact spline surfaces over [0,1]^2. Called by surf/kinds/coons.c and
 * surf/developable/developable.c. Opposite sides are brought to common degrees and knots.
 *
 * Rational sides are blended where they lie, not with their weights: the patch is the formula
 * at every point, whatever weights describe the sides. With W0 and W2 the weight functions of
 * the sides along u, and W1 and W3 of those along v, it is a rational surface with the
 * denominator W0(u) W2(u) W1(v) W3(v), where equal factors and constant ones stand once or not
 * at all. So all weights are positive, and the sides' weights need not agree at the corners.
 *
 * Preconditions: the sides are joined (lam_sides_join), lam_coons_degree is at most
 * LAM_BASIS_MAX_DEGREE. */
#ifndef LAM_SURF_SPLINE_COONS_PATCH_H
#define LAM_SURF_SPLINE_COONS_PATCH_H

#include "surf/spline/sides.h"

/* How the patch runs from side to side: linearly, or by Hermite's cubics. */
typedef enum lam_coons_blend {
  LAM_COONS_BILINEAR,
  LAM_COONS_HERMITE /* meets derivatives across the sides, too */
} lam_coons_blend;

typedef struct lam_coons_gaps {
  double slope; /* m: between a side's slope at its end and the derivative given there */
  double twist; /* m: between the two mixed derivatives at a corner */
} lam_coons_gaps;

/* How well the derivatives of a Hermite patch fit together, with parameters from 0 to 1. What
 * is not 0 is met in the mean only. */
lam_coons_gaps lam_coons_check(lam_arena *arena, const lam_sides *sides);

/* The degree of the patch in direction d (0: u, 1: v). */
int lam_coons_degree(lam_arena *arena, const lam_sides *sides, lam_coons_blend blend, int d);

/* The patch, owned by the arena.
 *
 * BILINEAR: x = (1-v) c0(u) + v c2(u) + (1-u) c1(v) + u c3(v) - sum_ij b_i(u) b_j(v) corner_ij.
 *
 * HERMITE, with Hermite's cubics and the derivatives d across the sides:
 *   x = F0(v) c0(u) + F1(v) c2(u) + G0(v) d0(u) + G1(v) d2(u) + the same in the other direction
 *       - the tensor product of corners, slopes and twists.
 * Derivatives that are not given are mixed linearly from the slopes of the two sides that end
 * there. Where the two twists of a corner differ their mean is taken, and the derivatives
 * across are then met at the corners only. */
lam_spline_surface lam_coons_surface(lam_arena *arena, const lam_sides *sides,
                                     lam_coons_blend blend);

#endif
