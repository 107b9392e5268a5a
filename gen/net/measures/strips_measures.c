/* Lengths of edges in strips and along lines, and how edges and angles changed against the start.
 * Rows of the list in net/measures/measure.c, which calls them. */
#include "net/measures/measure.h"

#include <math.h>

/* Length of the edge between vertices v[0] and v[1] at positions x. */
static double length_of(const lam_vec3 *x, const int *v) { return lam_distance(x[v[0]], x[v[1]]); }

/* ---- ladders: rows of opposite edges through neighboring faces ---- */

typedef int face_edges[4];

/* The four edges of every face, in no order. */
static face_edges *edges_of_faces(lam_arena *arena, const lam_net *net) {
  face_edges *edge_at = LAM_NEW(arena, face_edges, net->mesh.face_count);
  int *fill = LAM_NEW(arena, int, net->mesh.face_count);
  for (int e = 0; e < net->edge_count; e++)
    for (int side = 0; side < 2; side++) {
      int f = net->edges[e].face[side];
      if (f >= 0) edge_at[f][fill[f]++] = e;
    }
  return edge_at;
}

/* The edge opposite to edge e in face f: the one that shares no vertex with it; -1 outside. */
static int across(face_edges *edge_at, const lam_net *net, int f, int e) {
  for (int k = 0; f >= 0 && k < 4; k++) {
    int other = edge_at[f][k];
    const int *a = net->edges[e].vertex, *b = net->edges[other].vertex;
    if (other != e && a[0] != b[0] && a[0] != b[1] && a[1] != b[0] && a[1] != b[1]) return other;
  }
  return -1;
}

/* Collects the ladder of edge `first`, from it to both sides, into rung and marks its edges as
 * done; returns their number. */
static int collect_ladder(const lam_net *net, face_edges *edge_at, int first, bool *done,
                          int *rung) {
  int count = 0;
  for (int side = 0; side < 2; side++)
    for (int e = first, f = net->edges[first].face[side]; e >= 0;) {
      if (!done[e]) rung[count++] = e;
      done[e] = true;
      e = across(edge_at, net, f, e);
      if (e < 0 || done[e]) break;
      f = net->edges[e].face[0] == f ? net->edges[e].face[1] : net->edges[e].face[0];
    }
  return count;
}

/* All edges of a ladder of the family get (longest - shortest) / mean. */
static void ladder_variation(const lam_measuring *in, int family, double *values) {
  const lam_net *net = in->net;
  face_edges *edge_at = edges_of_faces(in->arena, net);
  int *rung = LAM_NEW(in->arena, int, net->edge_count);
  bool *done = LAM_NEW(in->arena, bool, net->edge_count);

  for (int first = 0; first < net->edge_count; first++) {
    if (done[first] || net->edges[first].family != family) continue;
    int count = collect_ladder(net, edge_at, first, done, rung);
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

/* ---- lines ---- */

/* All vertices of a line of the family get (longest - shortest) / mean of its edges. */
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

/* ---- strains against in->start; undefined without it ---- */

/* |length / length at the start - 1|. */
static void edge_strain(const lam_measuring *in, double *values) {
  for (int e = 0; in->start && e < in->net->edge_count; e++) {
    const int *v = in->net->edges[e].vertex;
    values[e] = fabs(length_of(in->positions, v) / length_of(in->start, v) - 1);
  }
}

/* A quarter of a23 + a41 - a12 - a34: the angle by which the crossing of the families is off
 * 90 degrees, radians. */
static double crossing(const lam_vec3 *x, const lam_star *star) {
  lam_vec3 E[4];
  for (int k = 0; k < 4; k++) E[k] = lam_sub(x[star->neighbor[k]], x[star->center]);
  return (lam_angle(E[1], E[2]) + lam_angle(E[3], E[0]) - lam_angle(E[0], E[1]) -
          lam_angle(E[2], E[3])) /
         4;
}

/* Half the change of the crossing angle, radians. */
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
