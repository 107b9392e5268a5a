/* The constraint `planar-face`: flat quads. Listed in constraints.c; the kinds of nets with flat
 * faces (net/kinds) and s_isothermic.c add it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Planar quad (thesis 3.1): the distance of the two diagonals relative to their mean length.
 *   d1 = v2 - v0,  d2 = v3 - v1,  E = v1 - v0,  N = unit(d1 x d2),
 *   D = N . E,  m = (|d1| + |d2|) / 2,  r = D / m   (dimensionless)
 * dD/dd1 = d2 x g, dD/dd2 = g x d1 with g = (E - N D) / |d1 x d2|, and dD/dE = N;
 * dm/dd_i = d_i / (2 |d_i|). */
static void planar_face(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  lam_vec3 v0 = lam_local(x, 0), v1 = lam_local(x, 1);
  lam_vec3 d1 = lam_sub(lam_local(x, 2), v0), d2 = lam_sub(lam_local(x, 3), v1),
           E = lam_sub(v1, v0);
  lam_vec3 M = lam_cross(d1, d2);
  double size = lam_length(M), l1 = lam_length(d1), l2 = lam_length(d2), m = (l1 + l2) / 2;
  lam_vec3 N = lam_scale(M, 1 / size);
  double D = lam_dot(N, E);
  r[0] = D / m;
  if (!J) return;

  /* r1, r2, rE: derivatives of r by d1, d2, E */
  for (int c = 0; c < n; c++) J[c] = 0;
  lam_vec3 g = lam_scale(lam_along(E, -D, N), 1 / size);
  double slope = -D / (2 * m * m);
  lam_vec3 r1 = lam_along(lam_scale(lam_cross(d2, g), 1 / m), slope / l1, d1);
  lam_vec3 r2 = lam_along(lam_scale(lam_cross(g, d1), 1 / m), slope / l2, d2);
  lam_vec3 rE = lam_scale(N, 1 / m);
  lam_add_to(J, 0, lam_scale(lam_add(r1, rE), -1));
  lam_add_to(J, 1, lam_sub(rE, r2));
  lam_add_to(J, 2, r1);
  lam_add_to(J, 3, r2);
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  lam_face_block_add(scope, "planar-face", planar_face, 1, weight);
}

const lam_constraint_kind lam_con_planar_face = {
    {"planar-face", "Planar faces",
     "Every quad is flat, so that it can be cut from sheet or glass. A net of planar quads "
     "discretizes a conjugate net; start from one (principal lines, for instance), or the quads "
     "collapse to slivers on the way.",
     "N.(v1 - v0) / ((|v2 - v0| + |v3 - v1|) / 2) = 0, N = unit((v2 - v0) x (v3 - v1))",
     "thesis 3.1", NULL, 0},
    add};
