#include "core/numbers.h"
#include "core/numeric/fit.h"
#include "net/measures/measure.h"

#include <math.h>

/* A sphere through a vertex v with the unit normal N there and the curvature k contains v + E when
 * E.N = k |E|^2 / 2: inverted at v, y = E / |E|^2, its points lie in the plane y.N = k / 2. So the
 * plane of best fit of the inverted neighbors is the sphere of best fit through the vertex; planes
 * are spheres of curvature 0. */
enum { most_points = 64 };

typedef struct fitted_sphere {
  lam_vec3 normal;  /* towards the normal of the net */
  double curvature; /* positive when the center lies on that side */
  double deviation; /* largest distance of a neighbor from the sphere, over the mean edge around */
} fitted_sphere;

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
  for (int k = 0; k < valence; k++) { /* | |E - N/k| - 1/|k| |, in a form that allows k = 0 */
    lam_vec3 towards = lam_along(lam_scale(E[k], s.curvature), -1, s.normal);
    double off = (s.curvature * lam_dot(E[k], E[k]) - 2 * lam_dot(s.normal, E[k])) /
                 (lam_length(towards) + 1);
    if (!(fabs(off) <= s.deviation * edge)) s.deviation = fabs(off) / edge;
  }
  return s;
}

/* Interior vertices whose sphere is not determined by the neighbors' number alone: four and more.
 */
static bool has_sphere(const lam_net *net, int v) {
  int valence = net->ring_start[v + 1] - net->ring_start[v];
  return !net->boundary[v] && valence >= 4 && valence < most_points;
}

static lam_vec3 *normals_of(const lam_measuring *in) {
  lam_vec3 *normals = LAM_NEW(in->arena, lam_vec3, in->net->mesh.vertex_count);
  lam_net_normals(in->net, in->positions, normals);
  return normals;
}

static void star_sphericity(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = normals_of(in);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (has_sphere(in->net, v)) values[v] = sphere_of(in, v, normals[v]).deviation;
}

static void star_curvature(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = normals_of(in);
  for (int v = 0; v < in->net->mesh.vertex_count; v++)
    if (has_sphere(in->net, v)) values[v] = sphere_of(in, v, normals[v]).curvature;
}

static void curvature_spread(const lam_measuring *in, double *values) {
  const lam_vec3 *normals = normals_of(in);
  double low = INFINITY, high = -INFINITY;
  for (int v = 0; v < in->net->mesh.vertex_count; v++) {
    if (!has_sphere(in->net, v)) continue;
    double k = sphere_of(in, v, normals[v]).curvature;
    if (!(k >= low)) low = k; /* what is not a number stays */
    if (!(k <= high)) high = k;
  }
  if (low != INFINITY) values[0] = (high - low) * in->mean_edge;
}

/* The tangent at v of the circle through a, v, b makes with the chord from v to a the angle that
 * the circle's chord is seen under from b: turn the unit chord by it in the plane of the three. */
static lam_vec3 circle_tangent(lam_vec3 v, lam_vec3 a, lam_vec3 b) {
  lam_vec3 chord = lam_unit(lam_sub(a, v)),
           axis = lam_unit(lam_cross(lam_sub(b, v), lam_sub(a, v)));
  double angle = lam_angle(lam_sub(v, b), lam_sub(a, b));
  return lam_along(lam_scale(chord, cos(angle)), sin(angle), lam_cross(axis, chord));
}

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
    "best, over the mean "
    "edge around",
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
    "aimed at (90 degrees "
    "by "
    "default)",
    LAM_ON_VERTICES, circle_angle_deviation};
