/* Planarity of vertex stars and of faces. Rows of the list in net/measures/measure.c,
 * which calls them. */
#include "core/numeric/fit.h"
#include "net/measures/measure.h"

#include <math.h>

enum { most_points = 64 };

/* Largest distance of a star's points to their plane of best fit, over the mean edge around;
 * inner vertices of any valence below most_points. */
static void star_planarity(const lam_measuring *in, double *values) {
  const lam_net *net = in->net;
  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int valence = net->ring_start[v + 1] - net->ring_start[v];
    if (net->boundary[v] || valence >= most_points) continue;

    lam_vec3 points[most_points], center;
    double spread[3], edge = 0, worst = 0;
    points[0] = in->positions[v];
    for (int k = 0; k < valence; k++) {
      points[k + 1] = in->positions[net->ring[net->ring_start[v] + k]];
      edge += lam_distance(points[0], points[k + 1]) / valence;
    }

    lam_vec3 normal = lam_fit_plane(points, valence + 1, &center, spread);
    for (int k = 0; k <= valence; k++)
      worst = fmax(worst, fabs(lam_dot(normal, lam_sub(points[k], center))));
    values[v] = worst / edge;
  }
}

/* Distance of the lines through the diagonals, over their mean length. */
static void face_planarity(const lam_measuring *in, double *values) {
  const lam_mesh *mesh = &in->net->mesh;
  for (int f = 0; f < mesh->face_count; f++) {
    const int *c = mesh->faces[f];
    const lam_vec3 *x = in->positions;
    lam_vec3 d1 = lam_sub(x[c[2]], x[c[0]]), d2 = lam_sub(x[c[3]], x[c[1]]);
    lam_vec3 n = lam_unit(lam_cross(d1, d2));
    values[f] =
        fabs(lam_dot(n, lam_sub(x[c[1]], x[c[0]]))) / ((lam_length(d1) + lam_length(d2)) / 2);
  }
}

const lam_measure_kind lam_measure_star_planarity = {
    "star_planarity", "",
    "largest distance of a vertex and its neighbors to their plane of best fit, over the mean edge "
    "around",
    LAM_ON_VERTICES, star_planarity};
const lam_measure_kind lam_measure_face_planarity = {
    "face_planarity", "", "distance of a face's diagonals over their mean length", LAM_ON_FACES,
    face_planarity};
