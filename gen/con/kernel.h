/* Small derivative rules that the kernels of this folder and of con/thesis share. An element's
 * unknowns x are its nodes' coordinates one after the other, three per vertex. */
#ifndef LAM_CON_KERNEL_H
#define LAM_CON_KERNEL_H

#include "core/vec3.h"

/* Coordinates of the k-th vertex of an element. */
static inline lam_vec3 lam_local(const double *x, int k) {
  return lam_v3(x[3 * k], x[3 * k + 1], x[3 * k + 2]);
}

/* Adds the derivative d to the k-th vertex's columns of a Jacobian row. */
static inline void lam_add_to(double *row, int k, lam_vec3 d) {
  row[3 * k] += d.x;
  row[3 * k + 1] += d.y;
  row[3 * k + 2] += d.z;
}

/* The derivative with respect to E of f(unit(E)), given e = unit(E), length = |E| and g = df/de:
 *   (I - e e') g / |E| */
static inline lam_vec3 lam_unit_pullback(lam_vec3 e, double length, lam_vec3 g) {
  return lam_scale(lam_along(g, -lam_dot(e, g), e), 1 / length);
}

/* Unit edges e from the first vertex of an element to the next count vertices, and their
 * lengths. Precondition: no edge has length 0. */
static inline void lam_unit_edges(const double *x, int count, lam_vec3 *e, double *length) {
  lam_vec3 v = lam_local(x, 0);
  for (int k = 0; k < count; k++) {
    lam_vec3 E = lam_sub(lam_local(x, k + 1), v);
    length[k] = lam_length(E);
    e[k] = lam_scale(E, 1 / length[k]);
  }
}

/* Fills a Jacobian row of 3 (count + 1) columns from the derivatives de by those unit edges. */
static inline void lam_edges_row(double *row, int count, const lam_vec3 *e, const double *length,
                                 const lam_vec3 *de) {
  for (int c = 0; c < 3 * (count + 1); c++) row[c] = 0;
  for (int k = 0; k < count; k++) {
    lam_vec3 dE = lam_unit_pullback(e[k], length[k], de[k]);
    lam_add_to(row, k + 1, dE);
    lam_add_to(row, 0, lam_scale(dE, -1));
  }
}

#endif
