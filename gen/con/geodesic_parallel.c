/* The constraint `geodesic-parallel`: geodesic parallel coordinates. Listed in constraints.c;
 * net/kinds/geodesic_parallel_net.c adds it. */
#include "con/star_cosines.h"

/* Geodesic parallel coordinates (thesis 3.3.2, theorem 7, condition 2). With the geodesics in
 * family 0:
 *   <e1, e2 - e4> = <e1,e2> - <e4,e1> = 0,   <e3, e2 - e4> = <e2,e3> - <e3,e4> = 0
 * (2 rows, dimensionless; Jacobian in star_cosines.c). Both edges of the line along u make equal
 * angles with the crossing line on its left and on its right. The angles on both sides of the line
 * have the same sum, so it is a geodesic, and the families cross at right angles. */
static void along_u(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  static const lam_cosines rows[] = {{{1, 0, 0, -1}}, {{0, 1, -1, 0}}};
  lam_star_cosines(2, rows, n, x, r, J);
}

/* The same with the geodesics in family 1: <e2, e1 - e3> = <e4, e1 - e3> = 0. */
static void along_v(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  static const lam_cosines rows[] = {{{1, -1, 0, 0}}, {{0, 0, -1, 1}}};
  lam_star_cosines(2, rows, n, x, r, J);
}

/* On the border where the geodesics end the same holds for their last edge. Without it the crossing
 * lines zigzag. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)location;
  const lam_geodesic_params *given = params;
  lam_star_block_add(scope, "geodesic-parallel", given->family ? along_v : along_u, 2,
                     given->border, weight);
  if (given->border) lam_border_angles_add(scope, "geodesic-parallel", given->family, weight);
}

static const lam_key keys[] = {
    LAM_INTEGER_KEY(lam_geodesic_params, "geodesics", family, "0", 0, 1,
                    "Family whose lines are geodesics: 0, along u, or 1, along v."),
    LAM_FLAG_KEY(lam_geodesic_params, "border", border, "yes",
                 "Where geodesics end at the border they meet it at right angles too; without it "
                 "the lines across zigzag."),
    {0}};

const lam_constraint_kind lam_con_geodesic_parallel = {
    {"geodesic-parallel", "Geodesic parallel coordinates",
     "The lines of one family are geodesics and the other family crosses them at right angles, as "
     "meridians and parallels do on a surface of revolution. Strips between two lines across have "
     "the same width all along.",
     "<e1, e2 - e4> = <e3, e2 - e4> = 0; at the ends <e, e2 - e4> = 0",
     "thesis 3.3.2, def. 16 and theorem 7", keys, sizeof(lam_geodesic_params)},
    add};
