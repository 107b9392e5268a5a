/* Lengths of edges: single ones, of all edges and of the edges of a face. Rows of the list in
 * net/measures/measure.c, which calls them. */
#include "net/measures/measure.h"

#include <math.h>

static double length_of(const lam_measuring *in, int e) {
  const int *v = in->net->edges[e].vertex;
  return lam_distance(in->positions[v[0]], in->positions[v[1]]);
}

/* The edges of face f; side[k] runs from corner k to corner k + 1. */
static void side_lengths(const lam_measuring *in, int f, double side[4]) {
  const int *c = in->net->mesh.faces[f];
  for (int k = 0; k < 4; k++)
    side[k] = lam_distance(in->positions[c[k]], in->positions[c[(k + 1) % 4]]);
}

static void edge_length(const lam_measuring *in, double *values) {
  for (int e = 0; e < in->net->edge_count; e++) values[e] = length_of(in, e);
}

/* Over the mean edge; 0 when that vanishes. */
static void shortest_edge(const lam_measuring *in, double *values) {
  double least = INFINITY;
  for (int e = 0; e < in->net->edge_count; e++) least = fmin(least, length_of(in, e));
  values[0] = in->mean_edge > 0 ? least / in->mean_edge : 0;
}

/* Standard deviation over mean. */
static void edge_variation(const lam_measuring *in, double *values) {
  double mean = 0, square = 0, count = in->net->edge_count;
  for (int e = 0; e < in->net->edge_count; e++) mean += length_of(in, e) / count;
  for (int e = 0; e < in->net->edge_count; e++) square += pow(length_of(in, e) - mean, 2) / count;
  values[0] = sqrt(square) / mean;
}

/* The larger difference of the two pairs; not a number where one of them is not. */
static void opposite_edge_difference(const lam_measuring *in, double *values) {
  for (int f = 0; f < in->net->mesh.face_count; f++) {
    double side[4], sum = 0;
    side_lengths(in, f, side);
    for (int k = 0; k < 4; k++) sum += side[k];
    double d[2] = {fabs(side[0] - side[2]), fabs(side[1] - side[3])};
    values[f] = (d[1] > d[0] || isnan(d[1]) ? d[1] : d[0]) / (sum / 4);
  }
}

/* Longest over shortest edge of a face. */
static void edge_ratio(const lam_measuring *in, double *values) {
  for (int f = 0; f < in->net->mesh.face_count; f++) {
    double side[4], low = INFINITY, high = 0;
    side_lengths(in, f, side);
    for (int k = 0; k < 4; k++) low = fmin(low, side[k]), high = fmax(high, side[k]);
    values[f] = high / low;
  }
}

const lam_measure_kind lam_measure_edge_length = {"edge_length", "m", "length of the edges",
                                                  LAM_ON_EDGES, edge_length};
const lam_measure_kind lam_measure_shortest_edge = {
    "shortest_edge", "", "shortest edge over the mean edge", LAM_ON_NET, shortest_edge};
const lam_measure_kind lam_measure_edge_variation = {
    "edge_variation", "", "standard deviation of the lengths of all edges over their mean",
    LAM_ON_NET, edge_variation};
const lam_measure_kind lam_measure_opposite_edge_difference = {
    "opposite_edge_difference", "",
    "larger difference of a face's opposite edges over the mean of its edges", LAM_ON_FACES,
    opposite_edge_difference};
const lam_measure_kind lam_measure_edge_ratio = {
    "edge_ratio", "", "longest over shortest edge of a face", LAM_ON_FACES, edge_ratio};
