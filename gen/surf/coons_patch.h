/* Surfaces between four boundary curves (S. A. Coons 1967; Farin, Curves and Surfaces for CAGD, ch. 22). */
#ifndef LAM_SURF_COONS_PATCH_H
#define LAM_SURF_COONS_PATCH_H

#include "core/model.h"
#include "curve/bspline.h"

/* Sides: 0: v = 0 and 2: v = 1, both along u; 1: u = 0 and 3: u = 1, both along v. Corner (i,j) is at u = i, v = j. */
enum { LAM_COONS_SIDES = 4 };

typedef struct lam_coons {
  lam_spline_curve side[LAM_COONS_SIDES]; /* without weights, over any domains */
  /* Derivatives across the sides (by v along sides 0 and 2, by u along 1 and 3, both from 0 to 1), as splines of
   * dimension 3 with the domain of their side; count == 0: mixed linearly from the slopes of the two sides that end
   * there. Only for the Hermite blend. */
  lam_bspline across[LAM_COONS_SIDES];
} lam_coons;

typedef struct lam_coons_gaps {
  double corner; /* the largest distance of two sides at their common corner, m */
  double slope;  /* the largest difference between a side's slope at its end and the derivative given there, m */
  double twist;  /* the largest difference between the two mixed derivatives at a corner, m */
} lam_coons_gaps;

/* How well the sides fit together, with parameters from 0 to 1. What is not 0 is met in the mean only. */
lam_coons_gaps lam_coons_check(lam_arena *arena, const lam_coons *coons);

/* The bilinear blend over [0,1]^2, as an exact spline surface: opposite sides are brought to common degrees and knots.
 *   x = (1-v) c0(u) + v c2(u) + (1-u) c1(v) + u c3(v) - sum_ij b_i(u) b_j(v) corner_ij.
 * Where sides do not meet, the corner is the mean of their ends, and the surface misses the sides there. */
lam_spline_surface lam_coons_bilinear(lam_arena *arena, const lam_coons *coons);

/* The blend with Hermite's cubics, which meets the sides with the derivatives across them:
 *   x = F0(v) c0(u) + F1(v) c2(u) + G0(v) d0(u) + G1(v) d2(u) + the same in the other direction - the tensor product of
 * corners, slopes and twists. The degree is at least 3. Where the two twists of a corner differ their mean is taken,
 * and the derivatives across are then met at the corners only. */
lam_spline_surface lam_coons_hermite(lam_arena *arena, const lam_coons *coons);

#endif
