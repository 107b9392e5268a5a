/* Area of the Gauss image and angle defects: the Gauss curvature of a net by its integral. Rows
 * of the list in net/measures/measure.c, which calls them. */
#include "core/numbers.h"
#include "net/measures/measuring.h"

#include <math.h>

/* Signed area of the spherical triangle of unit vectors, van Oosterom & Strackee (1983):
 *   tan(area / 2) = <a, b x c> / (1 + <a,b> + <b,c> + <c,a>). */
static double spherical_area(lam_vec3 a, lam_vec3 b, lam_vec3 c) {
  return 2 * atan2(lam_dot(a, lam_cross(b, c)), 1 + lam_dot(a, b) + lam_dot(b, c) + lam_dot(c, a));
}

/* Adds of(area) for the Gauss images of all inner faces to *value, which stays undefined when
 * there are none. The Gauss image of a face is the spherical quad of the unit normals at its
 * corners. Normals on the boundary are those of half stars: faces there are left out. */
static void add_areas(const lam_measuring *in, double *value, double (*of)(double area)) {
  const lam_mesh *mesh = &in->net->mesh;
  const lam_vec3 *n = lam_measuring_normals(in);
  for (int f = 0; f < mesh->face_count; f++) {
    const int *c = mesh->faces[f];
    bool inside = true;
    for (int k = 0; k < 4; k++) inside &= !in->net->boundary[c[k]];
    if (!inside) continue;

    double area =
        of(spherical_area(n[c[0]], n[c[1]], n[c[2]]) + spherical_area(n[c[0]], n[c[2]], n[c[3]]));
    *value = *value == LAM_UNDEFINED ? area : *value + area;
  }
}

static double signed_area(double area) { return area; }

static void gauss_image_area(const lam_measuring *in, double *values) {
  add_areas(in, values, fabs);
}

static void gauss_image_area_signed(const lam_measuring *in, double *values) {
  add_areas(in, values, signed_area);
}

/* 360 degrees less the angles around an inner vertex: the integral of K over it, in degrees. */
static void angle_defect(const lam_measuring *in, double *values) {
  const lam_net *net = in->net;
  const lam_vec3 *x = in->positions;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int first = net->ring_start[v], valence = net->ring_start[v + 1] - first;
    if (net->boundary[v]) continue;

    double sum = 0;
    for (int k = 0; k < valence; k++)
      sum += lam_angle(lam_sub(x[net->ring[first + k]], x[v]),
                       lam_sub(x[net->ring[first + (k + 1) % valence]], x[v]));
    values[v] = 360 - sum * LAM_DEGREES_PER_RADIAN;
  }
}

const lam_measure_kind lam_measure_gauss_image_area = {
    "gauss_image_area", "sr",
    "area that the normals of the net cover on the unit sphere: spherical quads of the vertex "
    "normals of inner faces, by absolute value; 0 on developable surfaces",
    LAM_ON_NET, gauss_image_area};
const lam_measure_kind lam_measure_gauss_image_area_signed = {
    "gauss_image_area_signed", "sr",
    "the same with sign: the integral of the Gauss curvature over inner faces, negative where "
    "saddles prevail",
    LAM_ON_NET, gauss_image_area_signed};
const lam_measure_kind lam_measure_angle_defect = {
    "angle_defect", "deg",
    "360 degrees minus the sum of the angles between consecutive edges at an inner vertex",
    LAM_ON_VERTICES, angle_defect};
