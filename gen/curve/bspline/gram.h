/* Integrals of products of B-spline functions: the quadratic forms that fairing and fitting
 * minimize. */
#ifndef LAM_CURVE_BSPLINE_GRAM_H
#define LAM_CURVE_BSPLINE_GRAM_H

#include "core/arena.h"

/* The count x count matrix gram[i * count + j] = integral N_i^(order) N_j^(order) over the
 * domain, owned by the arena. Preconditions: 0 <= order <= 3, sound knots. */
double *lam_spline_gram(lam_arena *arena, int degree, int count, const double *knots, int order);

#endif
