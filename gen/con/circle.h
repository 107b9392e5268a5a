/* Tangents of circles through three consecutive vertices of a polyline, and their derivatives: for
 * the kernels of angle.c and spherical_star.c. */
#ifndef LAM_CON_CIRCLE_H
#define LAM_CON_CIRCLE_H

#include "con/kernel.h"

/* The circle through v, v + E1 and v + E3 has at v the tangent a = E1 |E3|^2 - E3 |E1|^2 (thesis
 * 3.2.3, def. 10; cubic in length, from E3 towards E1). On a straight line it is along the line. */
static inline lam_vec3 lam_circle_tangent(lam_vec3 E1, lam_vec3 E3) {
  return lam_along(lam_scale(E1, lam_dot(E3, E3)), -lam_dot(E1, E1), E3);
}

/* Adds to d1 and d3 the derivatives by E1 and E3 of f(a), given g = df/da:
 *   d1 += |E3|^2 g - 2 (E3.g) E1,  d3 += -|E1|^2 g + 2 (E1.g) E3 */
static inline void lam_circle_pullback(lam_vec3 E1, lam_vec3 E3, lam_vec3 g, lam_vec3 *d1,
                                       lam_vec3 *d3) {
  *d1 = lam_along(lam_along(*d1, lam_dot(E3, E3), g), -2 * lam_dot(E3, g), E1);
  *d3 = lam_along(lam_along(*d3, -lam_dot(E1, E1), g), 2 * lam_dot(E1, g), E3);
}

/* Adds to a Jacobian row the derivatives dE by the edges from the first vertex of an element to the
 * next count vertices. */
static inline void lam_star_row(double *row, int count, const lam_vec3 *dE) {
  for (int k = 0; k < count; k++) {
    lam_add_to(row, k + 1, dE[k]);
    lam_add_to(row, 0, lam_scale(dE[k], -1));
  }
}

#endif
