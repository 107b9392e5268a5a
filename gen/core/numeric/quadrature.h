/* Numerical integration. Used wherever curves and surfaces are integrated: curve, surf. */
#ifndef LAM_CORE_NUMERIC_QUADRATURE_H
#define LAM_CORE_NUMERIC_QUADRATURE_H

/* The Gauss-Legendre rule on [0,1]: nodes[count], ascending, and weights[count], which sum to 1;
 * count >= 1. Exact for polynomials of degree 2 count - 1. */
void lam_gauss_rule(int count, double *nodes, double *weights);

#endif
