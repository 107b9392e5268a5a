/* Small derivative rules that kernels share. An element's unknowns are its nodes' coordinates one after the other. */
#ifndef LAM_CON_KERNEL_H
#define LAM_CON_KERNEL_H

#include "core/vec3.h"

/* Coordinates of the k-th vertex of an element. */
static inline lam_vec3 lam_local(const double *x, int k) { return lam_v3(x[3 * k], x[3 * k + 1], x[3 * k + 2]); }

/* Adds the derivative d to the k-th vertex's columns of a Jacobian row. */
static inline void lam_add_to(double *row, int k, lam_vec3 d) {
  row[3 * k] += d.x;
  row[3 * k + 1] += d.y;
  row[3 * k + 2] += d.z;
}

/* The derivative with respect to E of f(unit(E)), given df/de at e = unit(E), |E| = length: (I - e e') g / |E|. */
static inline lam_vec3 lam_unit_pullback(lam_vec3 e, double length, lam_vec3 g) {
  return lam_scale(lam_along(g, -lam_dot(e, g), e), 1 / length);
}

#endif
