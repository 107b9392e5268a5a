/* Folds and flatness of a whole net. Rows of the list in net/measures/measure.c, which calls
 * them; degenerate.c judges by them. */
#include "core/numeric/fit.h"
#include "net/measures/measure.h"

#include <math.h>

/* Unit normal of face f, from its diagonals. */
static lam_vec3 face_normal(const lam_measuring *in, int f) {
  const int *c = in->net->mesh.faces[f];
  return lam_unit(lam_cross(lam_sub(in->positions[c[2]], in->positions[c[0]]),
                            lam_sub(in->positions[c[3]], in->positions[c[1]])));
}

/* Edges whose two faces turn by more than 120 degrees. */
static void foldovers(const lam_measuring *in, double *values) {
  values[0] = 0;
  for (int e = 0; e < in->net->edge_count; e++) {
    const int *f = in->net->edges[e].face;
    if (f[1] >= 0 && lam_dot(face_normal(in, f[0]), face_normal(in, f[1])) < -.5) values[0]++;
  }
}

/* Whether a vertex is the center of a star or a neighbor of one. */
static bool in_a_star(const lam_net *net, int v) {
  bool is = !net->boundary[v];
  for (int i = net->ring_start[v]; i < net->ring_start[v + 1]; i++)
    is |= !net->boundary[net->ring[i]];
  return is;
}

/* Thickness of the net over its length: standard deviation across and along the plane of best
 * fit. Corners of an open net, which belong to no star, do not count when a net has stars:
 * constraints on stars leave them where they were. */
static void flatness(const lam_measuring *in, double *values) {
  const lam_net *net = in->net;
  bool has_stars = net->star_count + net->irregular_count > 0;
  lam_vec3 *points = LAM_NEW(in->arena, lam_vec3, net->mesh.vertex_count), center;
  int count = 0;
  for (int v = 0; v < net->mesh.vertex_count; v++)
    if (!has_stars || in_a_star(net, v)) points[count++] = in->positions[v];

  double spread[3];
  lam_fit_plane(points, count, &center, spread);
  values[0] = spread[2] > 0 ? spread[0] / spread[2] : 0;
}

const lam_measure_kind lam_measure_foldovers = {
    "foldovers", LAM_UNIT_COUNT, "number of edges whose two faces turn by more than 120 degrees",
    LAM_ON_NET, foldovers};
const lam_measure_kind lam_measure_flatness = {
    "flatness", "",
    "spread of the vertices of all stars across their common plane over the spread along it",
    LAM_ON_NET, flatness};
