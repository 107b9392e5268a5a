/* Measures of the smooth surface that a net lies on, rather than of the net. Rows of the list in
 * net/measures/measure.c, which calls them. */
#include "net/measures/measure.h"

/* K of the surface at the vertices' parameters; a surface enlarged by the factor c has K / c^2. */
static void gauss_curvature(const lam_measuring *in, double *values) {
  for (int v = 0; in->surface && v < in->net->mesh.vertex_count; v++) {
    lam_jet jet;
    lam_surface_eval(in->surface, in->parameters[v].x, in->parameters[v].y, &jet);
    double K = lam_jet_curvature(&jet).K / (in->surface_scale * in->surface_scale);
    if (isfinite(K)) values[v] = K;
  }
}

/* Lines are traced before the net is solved, which moves it a little. */
static void coverage(const lam_measuring *in, double *values) {
  if (in->coverage > 0) values[0] = in->coverage;
}

const lam_measure_kind lam_measure_coverage = {
    "coverage", "",
    "share of the surface's area over its ranges of u and v that a net of traced lines covered "
    "when it was traced, to a percent; undefined for others",
    LAM_ON_NET, coverage};
const lam_measure_kind lam_measure_surface_gauss_curvature = {
    "surface_gauss_curvature", "1/m2",
    "Gauss curvature of the smooth surface at the vertices, edges included, where they still lie "
    "on their parameter lines",
    LAM_ON_VERTICES, gauss_curvature};
