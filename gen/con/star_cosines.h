/* Conditions on the angles of a star that are linear in their cosines: what the geodesic nets are
 * made of (geodesic_parallel.c, opposite_angles.c, equal_angles.c). */
#ifndef LAM_CON_STAR_COSINES_H
#define LAM_CON_STAR_COSINES_H

#include "con/constraint.h"
#include "con/kernel.h"

/* Coefficients of a row: r = c1 <e1,e2> + c2 <e2,e3> + c3 <e3,e4> + c4 <e4,e1> (dimensionless). */
typedef struct lam_cosines {
  signed char c[4];
} lam_cosines;

/* The residuals r and Jacobian J of a star kernel (lam_kernel) with 5 nodes, n = 15: center, +u,
 * +v, -u, -v. cosines: rows of them. */
void lam_star_cosines(int rows, const lam_cosines *cosines, int n, const double *x, double *r,
                      double *J);
/* A hard block r = <e_inner, e_a - e_b> at border vertices with one inner edge: the inner edge
 * leaves the border at equal angles. family: of the inner edge; -1: both. */
void lam_border_angles_add(lam_scope *scope, const char *name, int family, double weight);

#endif
