/* Figures of best fit through points (least squares). */
#ifndef LAM_CORE_NUMERIC_FIT_H
#define LAM_CORE_NUMERIC_FIT_H

#include "core/vec3.h"

/* Eigenvalues of a symmetric 3 x 3 matrix by Jacobi rotations, in no order, and its eigenvectors as
 * columns. a is overwritten. */
void lam_eigen3(double a[3][3], double value[3], double vector[3][3]);

/* The plane of best fit through count >= 1 points: returns its unit normal; center is a point of
 * it, spread the standard deviations of the points across it and along it, ascending. */
lam_vec3 lam_fit_plane(const lam_vec3 *points, int count, lam_vec3 *center, double spread[3]);

#endif
