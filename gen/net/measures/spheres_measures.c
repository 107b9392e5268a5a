/* Spheres through vertex stars, their curvatures, and angles between circles through three
 * vertices. Rows of the list in net/measures/measure.c, which calls them. */
#include "core/numbers.h"
#include "core/numeric/fit.h"
#include "net/measures/measuring.h"

#include <math.h>

enum { most_points = 64 };

/* The sphere (or plane) of best fit through a vertex and its neighbors. */
typedef struct fitted_sphere {
  lam_vec3 normal;  /* towards the normal of the net */
  double curvature; /* positive when the center lies on that side */
  double deviation; /* largest distance of a neighbor from the sphere, over the mean edge around */
} fitted_sphere;

/* Signed distance of v + E from the sphere of curvature k through v with the normal N there: |E -
 * N/k| - 1/k = (|k E - N| - 1) / k, written so that k = 0 is allowed. */
static double distance_from_sphere(const fitted_sphere *s, lam_vec3 E) {
  lam_vec3 towards = lam_along(lam_scale(E, s->curvature), -1, s->normal);
  return (s->curvature * lam_dot(E, E) - 2 * lam_dot(s->normal, E)) / (lam_length(towards) + 1);
}

/* The sphere of vertex v. normal: of the net there.
 *
 * A sphere through v with the unit normal N there and the curvature k contains v + E when
 *   E.N = k |E|^2 / 2.
 * Inverted at v, y = E / |E|^2, its points lie in the plane y.N = k / 2. So the plane of best
 * fit of the inverted neighbors is the sphere of best fit through the vertex; planes are spheres
 * of curvature 0. */
static fitted_sphere sphere_of(const lam_measuring *in, int v, lam_vec3 normal) {
  const lam_net *net = in->net;
  int valence = net->ring_start[v + 1] - net->ring_start[v];
  lam_vec3 E[most_points], y[most_points], center;
  double spread[3], edge = 0;
  for (int k = 0; k < valence; k++) {
    E[k] = lam_sub(in->positions[net->ring[net->ring_start[v] + k]], in->positions[v]);
    y[k] = lam_scale(E[k], 1 / lam_dot(E[k], E[k]));
    edge += lam_length(E[k]) / valence;
  }

  fitted_sphere s = {.normal = lam_fit_plane(y, valence, &center, spread)};
  if (lam_dot(s.normal, normal) < 0) s.normal = lam_scale(s.normal, -1);
  s.curvature = 2 * lam_dot(s.normal, center);

  for (int k = 0; k < valence; k++) {
    double off = distance_from_sphere(&s, E[k]);
    if (!(fabs(off) <= s.deviation * edge)) s.deviation = fabs(off) / edge;
  }
  return s;
}

/* Inner vertices of valence four and more: through fewer neighbors there is always a sphere. */
static bool has_sphere(const lam_net *net, int v) {
  int valence = net->ring_start[v + 1] - net->ring_start[v];
  return !net->boundary[v] && valence >= 4 && valence < most_points;
}

static void star_sphericity(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = lam_measuring_normals(in);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (has_sphere(in->net, v)) values[v] = sphere_of(in, v, normals[v]).deviation;
}

static void star_curvature(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = lam_measuring_normals(in);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (has_sphere(in->net, v)) values[v] = sphere_of(in, v, normals[v]).curvature;
}

/* Largest less smallest curvature, times the mean edge. A curvature that is not a number stays
 * the smallest and the largest. */
static void curvature_spread(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = lam_measuring_normals(in);
  double low = INFINITY, high = -INFINITY;
  for (int v = 0; v < in->net->mesh.vertex_count; v++) {
    if (!has_sphere(in->net, v)) continue;
    double k = sphere_of(in, v, normals[v]).curvature;
    if (!(k >= low)) low = k;
    if (!(k <= high)) high = k;
  }
  if (low != INFINITY) values[0] = (high - low) * in->mean_edge;
}

/* The unit tangent at v of the circle through a, v, b. By the angle between tangent and chord it
 * makes with the chord from v to a the angle that this chord is seen under from b: the unit chord
 * is turned by it in the plane of the three. */
static lam_vec3 circle_tangent(lam_vec3 v, lam_vec3 a, lam_vec3 b) {
  lam_vec3 chord = lam_unit(lam_sub(a, v)),
           axis = lam_unit(lam_cross(lam_sub(b, v), lam_sub(a, v)));
  double angle = lam_angle(lam_sub(v, b), lam_sub(a, b));
  return lam_along(lam_scale(chord, cos(angle)), sin(angle), lam_cross(axis, chord));
}

/* Crossing angle of the circles through three vertices of both polylines against target_angle,
 * degrees (thesis 3.2.3, def. 10). */
static void circle_angle_deviation(const lam_measuring *in, double *values) {
  const lam_net *net = in->net;
  for (int s = 0; s < net->star_count; s++) {
    const lam_star *star = &net->stars[s];
    lam_vec3 v = in->positions[star->center], x[4];
    for (int k = 0; k < 4; k++) x[k] = in->positions[star->neighbor[k]];
    double angle = lam_angle(circle_tangent(v, x[0], x[2]), circle_tangent(v, x[1], x[3]));
    values[star->center] = fabs(angle - in->target_angle) * LAM_DEGREES_PER_RADIAN;
  }
}

const lam_measure_kind lam_measure_star_sphericity = {
    "star_sphericity", "",
    "largest distance of a vertex' neighbors from the sphere (or plane) through it that fits them "
    "best, over the mean edge around",
    LAM_ON_VERTICES, star_sphericity};
const lam_measure_kind lam_measure_star_curvature = {
    "star_curvature", "1/m",
    "curvature 1/r of the sphere of best fit through a vertex and its neighbors, positive towards "
    "the normal",
    LAM_ON_VERTICES, star_curvature};
const lam_measure_kind lam_measure_curvature_spread = {
    "curvature_spread", "",
    "largest minus smallest curvature of the stars' spheres, times the mean edge", LAM_ON_NET,
    curvature_spread};
const lam_measure_kind lam_measure_circle_angle_deviation = {
    "circle_angle_deviation", "deg",
    "crossing angle of the circles through three vertices of either polyline, against the angle "
    "aimed at (90 degrees by default)",
    LAM_ON_VERTICES, circle_angle_deviation};
