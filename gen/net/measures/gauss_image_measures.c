#include "core/numbers.h"
#include "net/measures/measure.h"

#include <math.h>

/* Signed area of the spherical triangle of unit vectors: tan(area / 2) = <a, b x c> / (1 + <a,b> +
 * <b,c> + <c,a>), van Oosterom & Strackee (1983). */
static double spherical_area(lam_vec3 a, lam_vec3 b, lam_vec3 c) {
  return 2 * atan2(lam_dot(a, lam_cross(b, c)), 1 + lam_dot(a, b) + lam_dot(b, c) + lam_dot(c, a));
}

/* The Gauss image of a face is the spherical quad of the unit normals at its corners. Normals on
 * the boundary are those of half stars: faces there are left out. */
static void add_areas(const lam_measuring *in, double *value, double (*of)(double area)) {
  const lam_mesh *mesh = &in->net->mesh;
  lam_vec3 *n = LAM_NEW(in->arena, lam_vec3, mesh->vertex_count);
  lam_net_normals(in->net, in->positions, n);
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
    "normals of inner faces, "
    "by absolute value; 0 on developable surfaces",
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
