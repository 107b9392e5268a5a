/* The constraint `opposite-angles`: geodesic nets. Listed in constraints.c; geodesic, Voss and DIG
 * nets (net/kinds) add it. */
#include "con/star_cosines.h"

/* Geodesic net: both families are geodesics (thesis 3.4; its eq. 3.10 is one of the two equations).
 *   <e1,e2> = <e3,e4>,   <e2,e3> = <e4,e1>   (2 rows, dimensionless; Jacobian in star_cosines.c)
 * Then <e1 + e3, e2 - e4> = 0 and <e2 + e4, e1 - e3> = 0: the principal normals of both lines are
 * normal to the net. */
static void opposite_angles(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  static const lam_cosines rows[] = {{{1, 0, -1, 0}}, {{0, 1, 0, -1}}};
  lam_star_cosines(2, rows, n, x, r, J);
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_star_params *given = params;
  lam_star_block_add(scope, "opposite-angles", opposite_angles, 2, given && given->border, weight);
}

static const lam_key keys[] = {
    LAM_FLAG_KEY(lam_star_params, "border", border, "no",
                 "Reentrant corners of the border, which have four edges, take part."),
    {0}};

const lam_constraint_kind lam_con_opposite_angles = {
    {"opposite-angles", "Equal opposite angles",
     "At every vertex opposite angles are equal: the lines of both families are geodesics of the "
     "net.",
     "<e1,e2> = <e3,e4>, <e2,e3> = <e4,e1>", "thesis 3.4, eq. 3.10, completed", keys,
     sizeof(lam_star_params)},
    add};
