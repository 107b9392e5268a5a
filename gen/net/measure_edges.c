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

const lam_measure_kind lam_measure_edge_length = {"edge_length", "m", "length of the edges", LAM_ON_EDGES, edge_length};
const lam_measure_kind lam_measure_shortest_edge = {"shortest_edge", "", "shortest edge over the mean edge", LAM_ON_NET,
                                                    shortest_edge};
