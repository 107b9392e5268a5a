/* The constraint `conical`: the faces at a vertex touch a cone, once they are flat. Listed in
 * constraints.c; conical and molding nets (net/kinds) add it. */
#include "con/constraint.h"
#include "con/kernel.h"

/* Conical vertex: both pairs of opposite angles between the edges of a star have the same sum
 * (thesis 3.5.2, theorem 11). With a_k the angle of the unit edges e_k and e_(k+1):
 *   r = a_1 - a_2 + a_3 - a_4                         (radians)
 *   da_k/de_k = -(e_(k+1) - c e_k) / s,  da_k/de_(k+1) = -(e_k - c e_(k+1)) / s,
 *   c = cos a_k, s = sin a_k
 * The thesis asks for cos(a_1 + a_3) = cos(a_2 + a_4). Both sums are near 180 degrees where the net
 * is nearly flat, and the cosine is stationary there: residuals of 1e-6 go with sums that are
 * degrees apart. The sums themselves are not stationary there. */
static void conical(int n, const double *x, const double *p, double *r, double *J) {
  (void)n, (void)p;
  lam_vec3 e[4], de[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  double length[4];
  lam_unit_edges(x, 4, e, length);

  r[0] = 0;
  for (int k = 0; k < 4; k++) {
    int next = (k + 1) % 4;
    double sign = k % 2 ? -1 : 1, c = lam_dot(e[k], e[next]),
           s = lam_length(lam_cross(e[k], e[next]));
    r[0] += sign * atan2(s, c);

    /* edges on top of each other have no angle to differentiate: s is kept from 0 */
    double slope = -sign / fmax(s, 1e-12);
    de[k] = lam_along(de[k], slope, lam_along(e[next], -c, e[k]));
    de[next] = lam_along(de[next], slope, lam_along(e[k], -c, e[next]));
  }
  if (J) lam_edges_row(J, 4, e, length, de);
}

/* Vertices with three faces are not counted as skipped: three planes always touch a cone. */
static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_net *net = scope->net;
  lam_star_block_add(scope, "conical", conical, 1, false, weight);
  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (!net->boundary[v] && lam_net_valence(net, v) == 3) scope->skipped--;
}

const lam_constraint_kind lam_con_conical = {
    {"conical", "Conical vertices",
     "Both pairs of opposite angles at every vertex have the same sum. Together with planar faces, "
     "the four face planes at every vertex touch a cone of revolution: the net discretizes "
     "curvature lines and has offsets at a constant distance between the face planes. Vertices "
     "with three faces are conical anyway; those with more than four are left out.",
     "a12 + a34 = a23 + a41 for the angles of neighboring edges",
     "thesis 3.5.2, theorem 11, without its cosines", NULL, 0},
    add};
