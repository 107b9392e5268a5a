/* Conditions on the angles of a star that are linear in their cosines: what geodesic nets are made
 * of. */
#ifndef LAM_CON_STAR_COSINES_H
#define LAM_CON_STAR_COSINES_H

#include "con/constraint.h"
#include "con/kernel.h"

/* Coefficients of a row: r = c1 <e1,e2> + c2 <e2,e3> + c3 <e3,e4> + c4 <e4,e1>. */
typedef struct lam_cosines {
  signed char c[4];
} lam_cosines;

/* Rows of a star kernel with 5 nodes (center, +u, +v, -u, -v). */
void lam_star_cosines(int rows, const lam_cosines *cosines, int n, const double *x, double *r,
                      double *J);
/* A block of that kernel on the regular stars; border: reentrant corners of the boundary take part.
 */
void lam_star_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        bool border, double weight);
/* r = <e_inner, e_a - e_b> at border vertices with one inner edge: the inner edge leaves the border
 * at equal angles. family: of the inner edge; -1: both. */
void lam_border_angles_add(lam_scope *scope, const char *name, int family, double weight);

#endif
