/* The constraint `isothermic`: equal products of opposite edges. Listed in constraints.c;
 * net/kinds/isothermic_net.c adds it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Products of opposite edges of a face are equal (thesis 3.5.3, definition 25: with a circumcircle
 * the cross-ratio of the corners is then -1). With the edges E_k around the face:
 *   r = ln|E0| - ln|E1| + ln|E2| - ln|E3|   (dimensionless),  dr/dE_k = +-E_k / |E_k|^2
 * The logarithm weighs small and large faces alike and keeps edges from vanishing. */
static void isothermic(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  r[0] = 0;
  for (int c = 0; J && c < n; c++) J[c] = 0;

  for (int k = 0; k < 4; k++) {
    lam_vec3 E = lam_sub(lam_local(x, (k + 1) % 4), lam_local(x, k));
    double sign = k % 2 ? -1 : 1, square = lam_dot(E, E);
    r[0] += sign * .5 * log(square);
    if (!J) continue;
    lam_add_to(J, (k + 1) % 4, lam_scale(E, sign / square));
    lam_add_to(J, k, lam_scale(E, -sign / square));
  }
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  lam_face_block_add(scope, "isothermic", isothermic, 1, weight);
}

const lam_constraint_kind lam_con_isothermic = {
    {"isothermic", "Equal products of opposite edges",
     "The products of opposite edges of every face are equal. On a circular net the cross-ratio of "
     "every face is then -1, and faces are as square as they can be: the net discretizes "
     "isothermic curvature lines.",
     "|e1||e3| = |e2||e4| around every face", "thesis 3.5.3, definition 25", NULL, 0},
    add};
