/* The constraint `opposite-edges`: generalized Chebyshev nets. Listed in constraints.c;
 * net/kinds/chebyshev_net.c adds it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Opposite edges of a quad are equally long (generalized Chebyshev net, thesis 3.1). With
 * q = |edge|^2:
 *   r1 = (q01 - q32) / (q01 + q32),  r2 = (q12 - q03) / (q12 + q03)
 * dimensionless: close to equality the relative difference of the lengths. For r = (q - q') /
 * (q + q'), dr/dq = 2 q' / (q + q')^2, dr/dq' = -2 q / (q + q')^2, and dq = 2 edge. */
static void opposite_edges(int n, const double *x, const double *p, double *r, double *J) {
  (void)p;
  static const int ends[2][2][2] = {{{0, 1}, {3, 2}}, {{1, 2}, {0, 3}}};
  for (int i = 0; i < 2; i++) {
    lam_vec3 E[2];
    double q[2];
    for (int k = 0; k < 2; k++) {
      E[k] = lam_sub(lam_local(x, ends[i][k][1]), lam_local(x, ends[i][k][0]));
      q[k] = lam_dot(E[k], E[k]);
    }
    double sum = q[0] + q[1];
    r[i] = (q[0] - q[1]) / sum;
    if (!J) continue;

    double *row = J + i * n;
    for (int c = 0; c < n; c++) row[c] = 0;
    for (int k = 0; k < 2; k++) {
      lam_vec3 d = lam_scale(E[k], (k ? -4 : 4) * q[1 - k] / (sum * sum));
      lam_add_to(row, ends[i][k][1], d);
      lam_add_to(row, ends[i][k][0], lam_scale(d, -1));
    }
  }
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  lam_face_block_add(scope, "opposite-edges", opposite_edges, 2, weight);
}

const lam_constraint_kind lam_con_opposite_edges = {
    {"opposite-edges", "Equal opposite edges",
     "In every quad opposite edges are equally long: a generalized Chebyshev net. All edges "
     "between two neighboring polylines are then of one length, so that a flat grid of bars on "
     "hinges can be pushed into the shape.",
     "(|v1 - v0|^2 - |v2 - v3|^2) / (|v1 - v0|^2 + |v2 - v3|^2) = 0, and so for the other two "
     "edges",
     "thesis 3.1, after def. 3", NULL, 0},
    add};
