/* How far the polylines are from geodesics, by the angles of vertex stars, by rolling strips out
 * flat and by Clairaut's relation. Rows of the list in net/measures/measure.c, which calls them. */
#include "core/numbers.h"
#include "net/measures/measuring.h"

#include <math.h>

/* ---- angles of stars ---- */

/* The four angles of a star in degrees, from one edge to the next. */
static void angles_of(const lam_measuring *in, const lam_star *star, double angle[4]) {
  lam_vec3 E[4];
  for (int k = 0; k < 4; k++)
    E[k] = lam_sub(in->positions[star->neighbor[k]], in->positions[star->center]);
  for (int k = 0; k < 4; k++) angle[k] = lam_angle(E[k], E[(k + 1) & 3]) * LAM_DEGREES_PER_RADIAN;
}

/* The larger difference of the two pairs of opposite angles, degrees. */
static void opposite_angles(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    double a[4];
    angles_of(in, &in->net->stars[s], a);
    values[in->net->stars[s].center] = fmax(fabs(a[0] - a[2]), fabs(a[1] - a[3]));
  }
}

/* Largest less smallest of the four angles, degrees. */
static void angle_spread(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    double a[4];
    angles_of(in, &in->net->stars[s], a);
    values[in->net->stars[s].center] =
        fmax(fmax(a[0], a[1]), fmax(a[2], a[3])) - fmin(fmin(a[0], a[1]), fmin(a[2], a[3]));
  }
}

/* The line turns out of a geodesic by half the difference of the angles on its two sides. */
static void geodesic_error(const lam_measuring *in, int family, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    double a[4];
    angles_of(in, &in->net->stars[s], a);
    double left = family ? a[1] + a[2] : a[0] + a[1], right = family ? a[0] + a[3] : a[2] + a[3];
    values[in->net->stars[s].center] = fabs(left - right) / 2;
  }
}
static void geodesic_error_u(const lam_measuring *in, double *values) {
  geodesic_error(in, 0, values);
}
static void geodesic_error_v(const lam_measuring *in, double *values) {
  geodesic_error(in, 1, values);
}

/* |crossing angle - 90 degrees|. */
static void orthogonality(const lam_measuring *in, double *values) {
  for (int s = 0; s < in->net->star_count; s++) {
    const lam_star *star = &in->net->stars[s];
    values[star->center] = fabs(lam_star_crossing_angle(in, star) * LAM_DEGREES_PER_RADIAN - 90);
  }
}

/* ---- lines rolled out ---- */

/* Turning angle of a polyline at its k-th vertex when the strips beside it are rolled out
 * flat, radians: half the difference of the angles to its left and right; 0 where the vertex
 * is no regular star. */
static double flat_turn(const lam_measuring *in, const lam_polyline *line, int k) {
  int n = line->count, s = in->net->star_of_vertex[line->vertices[k]];
  if (s < 0) return 0;

  /* d: the edge of the star along which the line leaves */
  const lam_star *star = &in->net->stars[s];
  int before = line->vertices[(k + n - 1) % n], after = line->vertices[(k + 1) % n];
  for (int d = 0; d < 4; d++) {
    if (star->neighbor[d] != after || star->neighbor[(d + 2) & 3] != before) continue;
    double a[4];
    angles_of(in, star, a);
    return (a[d] + a[(d + 1) & 3] - a[(d + 2) & 3] - a[(d + 3) & 3]) / (2 * LAM_DEGREES_PER_RADIAN);
  }
  return 0;
}

/* Distance of the vertices of a rolled-out polyline from its chord, over its length. A vertex on
 * several lines keeps the largest. */
static void line_straightness(const lam_measuring *in, const lam_polyline *line, double *values) {
  int n = line->count;
  lam_vec2 *p = LAM_NEW(in->arena, lam_vec2, n);
  double direction = 0, length = 0;
  for (int k = 1; k < n; k++) {
    double l = lam_distance(in->positions[line->vertices[k - 1]], in->positions[line->vertices[k]]);
    if (k > 1) direction += flat_turn(in, line, k - 1);
    p[k] = (lam_vec2){p[k - 1].x + l * cos(direction), p[k - 1].y + l * sin(direction)};
    length += l;
  }

  double cx = p[n - 1].x, cy = p[n - 1].y, chord = hypot(cx, cy);
  for (int k = 0; k < n; k++) {
    double off = chord > 0 ? fabs(p[k].x * cy - p[k].y * cx) / chord / length : NAN,
           *value = &values[line->vertices[k]];
    if (!(*value >= off)) *value = off;
  }
}

/* Open lines of a family with at least one inner vertex; lines of the boundary are left out. */
static void straightness(const lam_measuring *in, int family, double *values) {
  for (int l = 0; l < in->net->polyline_count; l++) {
    const lam_polyline *line = &in->net->polylines[l];
    if (line->family != family || line->closed || line->count < 3 ||
        in->net->boundary[line->vertices[1]])
      continue;
    line_straightness(in, line, values);
  }
}
static void straightness_u(const lam_measuring *in, double *values) { straightness(in, 0, values); }
static void straightness_v(const lam_measuring *in, double *values) { straightness(in, 1, values); }

/* ---- Clairaut's relation ---- */

/* |r cos(alpha)| at the k-th vertex, meters: r is the distance from the axis of revolution, alpha
 * the angle of the line's tangent with the parallel circle. It is constant along a geodesic. */
static double clairaut_constant(const lam_measuring *in, const lam_polyline *line, int k) {
  int n = line->count;
  const double *a = in->axis;
  lam_vec3 x = in->positions[line->vertices[k]], axis = lam_unit(lam_v3(a[3], a[4], a[5]));
  lam_vec3 before = lam_unit(lam_sub(in->positions[line->vertices[(k + n - 1) % n]], x));
  lam_vec3 after = lam_unit(lam_sub(in->positions[line->vertices[(k + 1) % n]], x));
  lam_vec3 around = lam_cross(axis, lam_sub(x, lam_v3(a[0], a[1], a[2]))); /* its length is r */
  return fabs(lam_dot(around, lam_unit(lam_sub(after, before))));
}

/* Spread of Clairaut's constant over the inner vertices of each line, which all get it. Undefined
 * without an axis. */
static void clairaut(const lam_measuring *in, int family, double *values) {
  for (int l = 0; in->axis && l < in->net->polyline_count; l++) {
    const lam_polyline *line = &in->net->polylines[l];
    int first = line->closed ? 0 : 1, last = line->closed ? line->count : line->count - 1;
    if (line->family != family || first >= last || in->net->boundary[line->vertices[first]])
      continue;

    double low = INFINITY, high = -INFINITY;
    for (int k = first; k < last; k++) {
      double c = clairaut_constant(in, line, k);
      low = fmin(low, c);
      high = fmax(high, c);
    }
    for (int k = first; k < last; k++) values[line->vertices[k]] = high - low;
  }
}
static void clairaut_u(const lam_measuring *in, double *values) { clairaut(in, 0, values); }
static void clairaut_v(const lam_measuring *in, double *values) { clairaut(in, 1, values); }

const lam_measure_kind lam_measure_opposite_angle = {
    "opposite_angle", "deg",
    "difference of opposite angles at regular vertices; 0 when both families are geodesics",
    LAM_ON_VERTICES, opposite_angles};
const lam_measure_kind lam_measure_angle_spread = {
    "angle_spread", "deg", "largest less smallest of the four angles at regular vertices",
    LAM_ON_VERTICES, angle_spread};
const lam_measure_kind lam_measure_geodesic_error_u = {
    "geodesic_error_u", "deg",
    "angle by which a line along u turns sideways at a vertex; 0 on a geodesic", LAM_ON_VERTICES,
    geodesic_error_u};
const lam_measure_kind lam_measure_geodesic_error_v = {
    "geodesic_error_v", "deg",
    "angle by which a line along v turns sideways at a vertex; 0 on a geodesic", LAM_ON_VERTICES,
    geodesic_error_v};
const lam_measure_kind lam_measure_orthogonality = {
    "orthogonality", "deg", "crossing angle of the families at regular vertices against 90 degrees",
    LAM_ON_VERTICES, orthogonality};
const lam_measure_kind lam_measure_straightness_u = {
    "straightness_u", "", "distance of a rolled-out line along u from its chord, over its length",
    LAM_ON_VERTICES, straightness_u};
const lam_measure_kind lam_measure_straightness_v = {
    "straightness_v", "", "distance of a rolled-out line along v from its chord, over its length",
    LAM_ON_VERTICES, straightness_v};
const lam_measure_kind lam_measure_clairaut_u = {
    "clairaut_u", "m",
    "spread of r cos(alpha) along a line along u on a surface of revolution; 0 on a geodesic",
    LAM_ON_VERTICES, clairaut_u};
const lam_measure_kind lam_measure_clairaut_v = {
    "clairaut_v", "m",
    "spread of r cos(alpha) along a line along v on a surface of revolution; 0 on a geodesic",
    LAM_ON_VERTICES, clairaut_v};
