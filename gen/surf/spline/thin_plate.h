/* Thin-plate energy of polynomial tensor-product splines, as a quadratic form of the control
 * net. Called by surf/asymptotic. */
#ifndef LAM_SURF_SPLINE_THIN_PLATE_H
#define LAM_SURF_SPLINE_THIN_PLATE_H

#include "core/arena.h"
#include "curve/bspline/gram.h"
#include <stdbool.h>

/* For nets of count[0] x count[1] numbers (one coordinate of the points; v runs fastest):
 *   energy(a) = integral a_uu^2 + 2 a_uv^2 + a_vv^2 = sum a (G2 a G0 + 2 G1 a G1 + G0 a G2),
 *   Gk[i][j] = integral of the k-th derivatives of functions i and j.
 * The inner points, those at least two from the edge, may be filled in to least energy; where
 * an inner knot is repeated as often as the degree, they are filled so that the inner part has
 * a continuous derivative there. */
typedef struct lam_thin_plate {
  int count[2];
  const double *gram[2][3];
  int inner[2];          /* free rows and columns */
  const double *lift[2]; /* count x inner: the rows that follow from the free ones */
  const double *factor;  /* of the energy of the inner points */
} lam_thin_plate;

/* Knots are clamped, with count + degree + 1 entries. Owned by the arena. false: no unique
 * least energy. */
bool lam_thin_plate_make(lam_arena *arena, const int degree[2], const int count[2],
                         const double *const knots[2], lam_thin_plate *plate);

/* The gradient of energy / 2: product = G2 a G0 + 2 G1 a G1 + G0 a G2. Both are count[0] x
 * count[1]. */
void lam_thin_plate_apply(lam_arena *arena, const lam_thin_plate *plate, const double *net,
                          double *product);

/* Replaces the inner points of net by those of least energy with the given outer two rings. */
void lam_thin_plate_fill(lam_arena *arena, const lam_thin_plate *plate, double *net);

#endif
