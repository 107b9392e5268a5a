/* Curvatures of the smooth surface through the net (mesh/net_curvature.h), and its principal
 * directions against the families. Rows of the list in net/measures/measure.c, which calls them. */
#include "core/numbers.h"
#include "mesh/net_curvature.h"
#include "net/measures/measuring.h"

#include <math.h>

/* Flat: the larger principal curvature bends the surface by less than 1e-9 over an edge. */
static bool is_flat(const lam_measuring *in, const lam_net_curvature *c) {
  return fmax(fabs(c->k1), fabs(c->k2)) * in->mean_edge < 1e-9;
}

static void mean_curvature(const lam_measuring *in, double *values) {
  const lam_net_curvature *c = lam_net_curvatures(in->arena, in->net, in->positions);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (c[v].degree) values[v] = c[v].H;
}

static void gauss_curvature(const lam_measuring *in, double *values) {
  const lam_net_curvature *c = lam_net_curvatures(in->arena, in->net, in->positions);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (c[v].degree) values[v] = c[v].K;
}

/* The principal curvature that is smaller by absolute value over the other one: in [-1, 1]. */
static void curvature_ratio(const lam_measuring *in, double *values) {
  const lam_net_curvature *c = lam_net_curvatures(in->arena, in->net, in->positions);
  for (int v = 0; v < in->net->mesh.vertex_count; v++) {
    if (!c[v].degree || is_flat(in, &c[v])) continue;
    bool first = fabs(c[v].k1) < fabs(c[v].k2);
    values[v] = first ? c[v].k1 / c[v].k2 : c[v].k2 / c[v].k1;
  }
}

/* Angle of the bisectors of T1 and T2 (they are orthogonal to each other) to the nearest
 * principal direction, degrees, 0 to 45. Tangents are the bisectors of the edges, T = unit(e_k -
 * e_k+2): thesis 3.2.1. Where the principal curvatures differ by less than a tenth of the larger
 * one, the directions say little. */
static void principal_deviation(const lam_measuring *in, double *values) {
  const lam_net_curvature *all = lam_net_curvatures(in->arena, in->net, in->positions);
  for (int s = 0; s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    const lam_net_curvature *c = &all[star->center];
    if (!c->degree || is_flat(in, c) || c->k1 - c->k2 < .1 * fmax(fabs(c->k1), fabs(c->k2)))
      continue;

    lam_vec3 e[4];
    lam_star_unit_edges(in, star, e);
    lam_vec3 bisector = lam_add(lam_unit(lam_sub(e[0], e[2])), lam_unit(lam_sub(e[1], e[3])));
    double angle =
        atan2(fabs(lam_dot(bisector, c->direction[1])), fabs(lam_dot(bisector, c->direction[0]))) *
        LAM_DEGREES_PER_RADIAN;
    values[star->center] = fmin(angle, 90 - angle);
  }
}

const lam_measure_kind lam_measure_mean_curvature = {
    "mean_curvature", "1/m",
    "mean curvature (k1 + k2) / 2 by a polynomial fitted to the two rings around an inner vertex; "
    "positive where the net curves towards its normal",
    LAM_ON_VERTICES, mean_curvature};
const lam_measure_kind lam_measure_gauss_curvature = {
    "gauss_curvature", "1/m2",
    "Gauss curvature k1 k2 by a polynomial fitted to the two rings around an inner vertex",
    LAM_ON_VERTICES, gauss_curvature};
const lam_measure_kind lam_measure_curvature_ratio = {
    "curvature_ratio", "",
    "smaller over larger principal curvature by absolute value: 1 at umbilics, 0 on developable, "
    "-1 on minimal surfaces; undefined where flat",
    LAM_ON_VERTICES, curvature_ratio};
const lam_measure_kind lam_measure_principal_deviation = {
    "principal_deviation", "deg",
    "angle between the bisectors of the two families and the principal directions at regular "
    "vertices; undefined near umbilics",
    LAM_ON_VERTICES, principal_deviation};
