#include "net/measure.h"

#include <math.h>

static double length_of(const lam_measuring *in, int e) {
  const int *v = in->net->edges[e].vertex;
  return lam_distance(in->positions[v[0]], in->positions[v[1]]);
}

static void edge_length(const lam_measuring *in, double *values) {
  for (int e = 0; e < in->net->edge_count; e++) values[e] = length_of(in, e);
}

static void shortest_edge(const lam_measuring *in, double *values) {
  double least = INFINITY;
  for (int e = 0; e < in->net->edge_count; e++) least = fmin(least, length_of(in, e));
  values[0] = in->mean_edge > 0 ? least / in->mean_edge : 0;
}

static void edge_ratio(const lam_measuring *in, double *values) {
  for (int f = 0; f < in->net->mesh.face_count; f++) {
    const int *c = in->net->mesh.faces[f];
    double low = INFINITY, high = 0;
    for (int k = 0; k < 4; k++) {
      double length = lam_distance(in->positions[c[k]], in->positions[c[(k + 1) % 4]]);
      low = fmin(low, length), high = fmax(high, length);
    }
    values[f] = high / low;
  }
}

const lam_measure_kind lam_measure_edge_length = {"edge_length", "m", "length of the edges", LAM_ON_EDGES, edge_length};
const lam_measure_kind lam_measure_shortest_edge = {"shortest_edge", "", "shortest edge over the mean edge", LAM_ON_NET,
                                                    shortest_edge};
const lam_measure_kind lam_measure_edge_ratio = {"edge_ratio", "", "longest over shortest edge of a face", LAM_ON_FACES,
                                                 edge_ratio};
