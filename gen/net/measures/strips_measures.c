#include "net/measures/measure.h"

#include <math.h>

/* Lengths of edges in strips, and how they changed against the start. */

static double length_of(const lam_vec3 *x, const int *v) { return lam_distance(x[v[0]], x[v[1]]); }

/* The edge opposite to edge e in face f; edge_at lists the four edges of every face. */
static int across(int (*edge_at)[4], const lam_net *net, int f, int e) {
  for (int k = 0; f >= 0 && k < 4; k++) {
    int other = edge_at[f][k];
    const int *a = net->edges[e].vertex, *b = net->edges[other].vertex;
    if (other != e && a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1]) return other;
  }
  return -1;
}

/* A ladder is a row of opposite edges through neighboring faces. All its edges get (longest -
 * shortest) / mean. */
static void ladder_variation(const lam_measuring *in, int family, double *values) {
  const lam_net *net = in->net;
  int(*edge_at)[4] =
      (int(*)[4])lam_arena_alloc(in->arena, (size_t)net->mesh.face_count, sizeof *edge_at);
  int *fill = LAM_NEW(in->arena, int, net->mesh.face_count),
      *rung = LAM_NEW(in->arena, int, net->edge_count);
  bool *done = LAM_NEW(in->arena, bool, net->edge_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      int f = net->edges[e].face[side];
      if (f >= 0) edge_at[f][fill[f]++] = e;
    }
  for (int first = 0; first < net->edge_count; first++) {
    if (done[first] || net->edges[first].family != family) continue;
    int count = 0;
    for (int side = 0; side < 2; side++)
      for (int e = first, f = net->edges[first].face[side]; e >= 0;) {
        if (!done[e]) rung[count++] = e;
        done[e] = true;
        e = across(edge_at, net, f, e);
        if (e < 0 || done[e]) break;
        f = net->edges[e].face[0] == f ? net->edges[e].face[1] : net->edges[e].face[0];
      }
    double low = INFINITY, high = 0, sum = 0;
    for (int i = 0; i < count; i++) {
      double length = length_of(in->positions, net->edges[rung[i]].vertex);
      low = fmin(low, length);
      high = fmax(high, length);
      sum += length;
    }
    for (int i = 0; i < count; i++) values[rung[i]] = (high - low) * count / sum;
  }
}
static void edge_variation_u(const lam_measuring *in, double *values) {
  ladder_variation(in, 0, values);
}
static void edge_variation_v(const lam_measuring *in, double *values) {
  ladder_variation(in, 1, values);
}

/* Edges along a line: all its edges get (longest - shortest) / mean. */
static void line_variation(const lam_measuring *in, int family, double *values) {
  for (int l = 0; l < in->net->polyline_count; l++) {
    const lam_polyline *line = &in->net->polylines[l];
    int n = line->count, edges = line->closed ? n : n - 1;
    if (line->family != family) continue;
    double low = INFINITY, high = 0, sum = 0;
    for (int k = 0; k < edges; k++) {
      double length = lam_distance(in->positions[line->vertices[k]],
                                   in->positions[line->vertices[(k + 1) % n]]);
      low = fmin(low, length);
      high = fmax(high, length);
      sum += length;
    }
    for (int k = 0; k < n; k++) values[line->vertices[k]] = (high - low) * edges / sum;
  }
}
static void spacing_u(const lam_measuring *in, double *values) { line_variation(in, 0, values); }
static void spacing_v(const lam_measuring *in, double *values) { line_variation(in, 1, values); }

static void edge_strain(const lam_measuring *in, double *values) {
  for (int e = 0; in->start && e < in->net->edge_count; e++) {
    const int *v = in->net->edges[e].vertex;
    values[e] = fabs(length_of(in->positions, v) / length_of(in->start, v) - 1);
  }
}

/* A quarter of a23 + a41 - a12 - a34: the angle by which the crossing of the families is off 90
 * degrees. */
static double crossing(const lam_vec3 *x, const lam_star *star) {
  lam_vec3 E[4];
  for (int k = 0; k < 4; k++) E[k] = lam_sub(x[star->neighbor[k]], x[star->center]);
  return (lam_angle(E[1], E[2]) + lam_angle(E[3], E[0]) - lam_angle(E[0], E[1]) -
          lam_angle(E[2], E[3])) /
         4;
}

static void shear_strain(const lam_measuring *in, double *values) {
  for (int s = 0; in->start && s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    values[star->center] = fabs(crossing(in->positions, star) - crossing(in->start, star)) / 2;
  }
}

const lam_measure_kind lam_measure_edge_variation_u = {
    "edge_variation_u", "",
    "(longest - shortest) / mean of the edges along u between two neighboring lines along v",
    LAM_ON_EDGES, edge_variation_u};
const lam_measure_kind lam_measure_edge_variation_v = {
    "edge_variation_v", "",
    "(longest - shortest) / mean of the edges along v between two neighboring lines along u",
    LAM_ON_EDGES, edge_variation_v};
const lam_measure_kind lam_measure_spacing_u = {
    "spacing_u", "", "(longest - shortest) / mean of the edges of a line along u", LAM_ON_VERTICES,
    spacing_u};
const lam_measure_kind lam_measure_spacing_v = {
    "spacing_v", "", "(longest - shortest) / mean of the edges of a line along v", LAM_ON_VERTICES,
    spacing_v};
const lam_measure_kind lam_measure_edge_strain = {
    "edge_strain", "", "relative change of the edge lengths against the start", LAM_ON_EDGES,
    edge_strain};
const lam_measure_kind lam_measure_shear_strain = {
    "shear_strain", "", "half the change of the crossing angle against the start, in radians",
    LAM_ON_VERTICES, shear_strain};
