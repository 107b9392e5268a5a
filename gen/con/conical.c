#include "con/constraint.h"
#include "con/kernel.h"

/* Conical vertex: both pairs of opposite angles between the edges of a star have the same sum
 * (thesis 3.5.2, theorem 11). With a_k the angle of the unit edges e_k and e_(k+1): r = a_1 - a_2 +
 * a_3 - a_4                         (radians) da/de_k = -(e_(k+1) - c e_k) / s,  c = cos a, s = sin
 * a The thesis asks for cos(a_1 + a_3) = cos(a_2 + a_4). Both sums are near 180 degrees where the
 * net is nearly flat, and the cosine is stationary there: residuals of 1e-6 go with sums that are
 * degrees apart. The sums themselves have no such place. */
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
    double slope =
        -sign / fmax(s, 1e-12); /* edges on top of each other have no angle to differentiate */
    de[k] = lam_along(de[k], slope, lam_along(e[next], -c, e[k]));
    de[next] = lam_along(de[next], slope, lam_along(e[k], -c, e[next]));
  }
  if (J) lam_edges_row(J, 4, e, length, de);
}

static void add(lam_scope *scope, const void *params, double weight, lam_location location) {
  (void)params, (void)location;
  const lam_net *net = scope->net;
  lam_block block = {.name = "conical", .kernel = conical, .rows = 1, .weight = weight, .arity = 5};
  block.count = lam_scope_stars(scope, false, &block.nodes);
  for (int v = 0; v < net->mesh.vertex_count; v++) /* three planes always touch a cone */
    if (!net->boundary[v] && net->ring_start[v + 1] - net->ring_start[v] == 3) scope->skipped--;
  lam_problem_add(scope->problem, block);
}

const lam_constraint_kind lam_con_conical = {
    {"conical", "Conical vertices",
     "Both pairs of opposite angles at every vertex have the same sum. Together with planar faces, "
     "the four face "
     "planes "
     "at every vertex touch a cone of revolution: the net discretizes curvature lines and has "
     "offsets at a constant "
     "distance between the face planes. Vertices with three faces are conical anyway; those with "
     "more than four are "
     "left out.",
     "a12 + a34 = a23 + a41 for the angles of neighboring edges",
     "thesis 3.5.2, theorem 11, without its cosines", NULL, 0},
    add};
