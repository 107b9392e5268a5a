/* The constraint `circular`: faces with a circumcircle, once they are flat. Listed in
 * constraints.c; circular, isothermic and molding nets (net/kinds) add it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Unit edges e around a face, from corner k to corner k + 1, and their lengths. */
static void edges_around(const double *x, lam_vec3 e[4], double length[4]) {
  for (int k = 0; k < 4; k++) {
    lam_vec3 E = lam_sub(lam_local(x, (k + 1) % 4), lam_local(x, k));
    length[k] = lam_length(E);
    e[k] = lam_scale(E, 1 / length[k]);
  }
}

/* Both pairs of opposite angles of a face have the same sum, as in a circle (thesis 3.5.1, theorem
 * 10). With the edges around the face, E_k from corner k to corner k + 1, their unit vectors e_k,
 * and b_k the angle at corner k between f = -e_(k-1) and e_k:
 *   r = (b_0 - b_1 + b_2 - b_3) / 2                   (radians)
 *   db_k/de_k = -(f - c e_k) / s,  db_k/df = -(e_k - c f) / s,  c = cos b_k, s = sin b_k
 * The thesis' form with cosines, e_0.e_1 + e_2.e_3 = 0, has the same solutions; around irregular
 * vertices edges collapse on its way there. */
static void circular(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 e[4], de[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  double length[4];
  edges_around(x, e, length);

  r[0] = 0;
  for (int k = 0; k < 4; k++) {
    int back = (k + 3) % 4;
    double c = -lam_dot(e[k], e[back]), s = lam_length(lam_cross(e[k], e[back])),
           half = k % 2 ? -.5 : .5;
    r[0] += half * atan2(s, c);

    /* where both edges lie on one line the angle has no derivative: s is kept from 0 */
    double slope = half / fmax(s, 1e-12);
    de[k] = lam_along(de[k], slope, lam_along(e[back], c, e[k]));
    de[back] = lam_along(de[back], slope, lam_along(e[k], c, e[back]));
  }
  if (!J) return;

  for (int c = 0; c < n; c++) J[c] = 0;
  for (int k = 0; k < 4; k++) {
    lam_vec3 dE = lam_unit_pullback(e[k], length[k], de[k]);
    lam_add_to(J, (k + 1) % 4, dE);
    lam_add_to(J, k, lam_scale(dE, -1));
  }
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  lam_face_block_add(scope, "circular", circular, 1, weight);
}

const lam_constraint_kind lam_con_circular = {
    {"circular", "Faces with a circumcircle",
     "Both pairs of opposite angles of every face have the same sum. Together with planar faces, "
     "the four corners of every face lie on a circle: the net discretizes curvature lines.",
     "(b1 - b2 + b3 - b4) / 2 = 0 for the angles of every face",
     "thesis 3.5.1, theorem 10, without its cosines", NULL, 0},
    add};
