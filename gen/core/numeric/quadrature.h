/* Numerical integration. */
#ifndef LAM_CORE_NUMERIC_QUADRATURE_H
#define LAM_CORE_NUMERIC_QUADRATURE_H

/* The Gauss-Legendre rule on [0,1] with count >= 1 places and their weights, ascending: exact for
 * polynomials of degree 2 count - 1. */
void lam_gauss_rule(int count, double *places, double *weights);

#endif
