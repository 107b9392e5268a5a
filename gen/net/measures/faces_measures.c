/* Circles of faces: circumcircles, cross-ratios and incircles. Rows of the list in
 * net/measures/measure.c, which calls them. */
#include "mesh/tangential.h"
#include "net/measures/measure.h"

#include "core/complex_number.h"
#include <math.h>

/* The four corners of face f. */
static void corners_of(const lam_measuring *in, int f, lam_vec3 *corners) {
  for (int k = 0; k < 4; k++) corners[k] = in->positions[in->net->mesh.faces[f][k]];
}

/* Mean of the four edges between corners c. */
static double mean_edge(const lam_vec3 *c) {
  double sum = 0;
  for (int k = 0; k < 4; k++) sum += lam_distance(c[k], c[(k + 1) % 4]) / 4;
  return sum;
}

/* Distance of p from the circle through a, b, c. With B = b - a, C = c - a its center is
 *   a + ((|B|^2 C - |C|^2 B) x (B x C)) / (2 |B x C|^2). */
static double circle_distance(lam_vec3 a, lam_vec3 b, lam_vec3 c, lam_vec3 p) {
  lam_vec3 B = lam_sub(b, a), C = lam_sub(c, a), M = lam_cross(B, C);
  lam_vec3 mixed = lam_sub(lam_scale(C, lam_dot(B, B)), lam_scale(B, lam_dot(C, C)));
  lam_vec3 center = lam_along(a, .5 / lam_dot(M, M), lam_cross(mixed, M));

  lam_vec3 P = lam_sub(p, center);
  double height = lam_dot(P, lam_unit(M)), radius = lam_distance(a, center);
  return hypot(height, sqrt(fmax(lam_dot(P, P) - height * height, 0)) - radius);
}

/* The worst of the four corners; not a number where a distance is not. */
static void circularity(const lam_measuring *in, double *values) {
  for (int f = 0; f < in->net->mesh.face_count; f++) {
    lam_vec3 c[4];
    corners_of(in, f, c);
    double worst = 0;
    for (int k = 0; k < 4; k++) {
      double d = circle_distance(c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4], c[k]);
      if (!(d <= worst)) worst = d;
    }
    values[f] = worst / mean_edge(c);
  }
}

/* |q + 1| for the cross-ratio of the corners as complex numbers in the plane of the diagonals,
 *   q = (a - b)(c - d) / ((b - c)(d - a)). */
static void cross_ratio(const lam_measuring *in, double *values) {
  for (int f = 0; f < in->net->mesh.face_count; f++) {
    lam_vec3 c[4];
    corners_of(in, f, c);
    lam_vec3 x = lam_unit(lam_sub(c[2], c[0])), n = lam_unit(lam_cross(x, lam_sub(c[3], c[1]))),
             y = lam_cross(n, x);

    complex double edge[4];
    for (int k = 0; k < 4; k++) {
      lam_vec3 E = lam_sub(c[(k + 1) % 4], c[k]);
      edge[k] = lam_complex(lam_dot(E, x), lam_dot(E, y));
    }
    values[f] = cabs(edge[0] * edge[2] / (edge[1] * edge[3]) + 1);
  }
}

/* How far the incircle of face f misses the edge from a to b: returns the gap between the circle
 * and foot, which is the point of the edge next to its center. */
static double touch(const lam_measuring *in, int f, lam_vec3 a, lam_vec3 b, lam_vec3 *foot) {
  lam_vec3 c[4], e = lam_unit(lam_sub(b, a));
  corners_of(in, f, c);
  lam_incircle circle = lam_incircle_of(c);
  *foot = lam_along(a, lam_dot(e, lam_sub(circle.center, a)), e);
  return fabs(lam_distance(*foot, circle.center) - circle.radius);
}

/* The largest of the gaps to the incircles on both sides and of the distance between the two
 * points where they touch, over the edge. */
static void incircle_contact(const lam_measuring *in, double *values) {
  for (int e = 0; e < in->net->edge_count; e++) {
    const lam_edge *edge = &in->net->edges[e];
    lam_vec3 a = in->positions[edge->vertex[0]], b = in->positions[edge->vertex[1]], foot[2];
    double worst = 0, gap;
    for (int k = 0; k < 2; k++)
      if (edge->face[k] >= 0 && !((gap = touch(in, edge->face[k], a, b, &foot[k])) <= worst))
        worst = gap;

    if (edge->face[1] >= 0 && !(lam_distance(foot[0], foot[1]) <= worst))
      worst = lam_distance(foot[0], foot[1]);
    values[e] = worst / lam_distance(a, b);
  }
}

const lam_measure_kind lam_measure_circularity = {
    "circularity", "",
    "largest distance of a corner from the circle through the other three, over the face's mean "
    "edge",
    LAM_ON_FACES, circularity};
const lam_measure_kind lam_measure_cross_ratio = {
    "cross_ratio", "", "|q + 1| for the cross-ratio q of the corners of a face in its plane",
    LAM_ON_FACES, cross_ratio};
const lam_measure_kind lam_measure_incircle_contact = {
    "incircle_contact", "",
    "gap between an edge and the incircles of its faces, or between the points where they touch "
    "it, the larger one, over the edge",
    LAM_ON_EDGES, incircle_contact};
