/* Figures of best fit through points (least squares). Used by the measures of nets, and by curve,
 * mesh, surf/spline and fab. */
#ifndef LAM_CORE_NUMERIC_FIT_H
#define LAM_CORE_NUMERIC_FIT_H

#include "core/vec3.h"

/* Eigenvalues of a symmetric 3 x 3 matrix by Jacobi rotations, in no order, and its unit
 * eigenvectors as columns: vector[.][k] belongs to value[k]. a is overwritten. */
void lam_eigen3(double a[3][3], double value[3], double vector[3][3]);

/* The plane of best fit through count >= 1 points: returns its unit normal, of either sign.
 *
 * center  the mean of the points, which lies in the plane
 * spread  standard deviations of the points, ascending: across the plane, then along it */
lam_vec3 lam_fit_plane(const lam_vec3 *points, int count, lam_vec3 *center, double spread[3]);

#endif
