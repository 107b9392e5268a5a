/* Integrals of products of B-spline functions. */
#ifndef LAM_CURVE_BSPLINE_GRAM_H
#define LAM_CURVE_BSPLINE_GRAM_H

#include "core/arena.h"

/* gram[i * count + j]: integral of the products of the derivatives of this order <= 3 of functions
 * i and j. */
double *lam_spline_gram(lam_arena *arena, int degree, int count, const double *knots, int order);

#endif
