/* The constraint `equal-angles`: discrete orthogonal geodesic nets. Listed in constraints.c;
 * net/kinds/dog_net.c adds it. */
#include "con/star_cosines.h"

/* Discrete orthogonal geodesic net (Rabinovich, Hoffmann & Sorkine-Hornung 2018; thesis 3.4.1):
 * four equal angles.
 *   <e1,e2> = <e2,e3> = <e3,e4> = <e4,e1>   (3 rows, dimensionless; Jacobian in star_cosines.c) */
static void equal_angles(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  static const lam_cosines rows[] = {{{1, -1, 0, 0}}, {{0, 1, -1, 0}}, {{0, 0, 1, -1}}};
  lam_star_cosines(3, rows, n, x, r, J);
}

/* On the border the inner edge leaves at equal angles to both sides. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_star_params *given = params;
  bool border = given && given->border;
  lam_star_block_add(scope, "equal-angles", equal_angles, 3, border, weight);
  if (border) lam_border_angles_add(scope, "equal-angles", -1, weight);
}

const lam_constraint_kind lam_con_equal_angles = {
    {"equal-angles", "Four equal angles",
     "At every vertex the four angles are equal: both families are geodesics and cross at right "
     "angles, which is only possible on a developable surface.",
     "<e1,e2> = <e2,e3> = <e3,e4> = <e4,e1>", "thesis 3.4.1", lam_star_keys,
     sizeof(lam_star_params)},
    add};
