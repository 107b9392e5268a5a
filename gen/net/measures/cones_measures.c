/* Conicality: how far the faces at a vertex are from touching a cone of revolution. A row of the
 * list in net/measures/measure.c, which calls it. */
#include "core/numbers.h"
#include "core/numeric/fit.h"
#include "mesh/offset.h"
#include "net/measures/measure.h"

#include <math.h>

/* The unit vector g with the smallest sum of (m_k . g)^2 over m_k = n_k - n_(k+1): the eigenvector
 * of sum m_k m_k^T with the smallest eigenvalue. False: the normals are not numbers. */
static bool axis_of_best_fit(const lam_vec3 *n, int count, lam_vec3 *g) {
  double M[3][3] = {{0}}, value[3], vector[3][3];
  for (int k = 0; k < count; k++) {
    lam_vec3 m = lam_sub(n[k], n[(k + 1) % count]);
    const double c[3] = {m.x, m.y, m.z};
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) M[i][j] += c[i] * c[j];
  }
  if (!isfinite(M[0][0] + M[1][1] + M[2][2])) return false;

  lam_eigen3(M, value, vector);
  int least = value[0] <= value[1] && value[0] <= value[2] ? 0 : value[1] <= value[2] ? 1 : 2;
  *g = lam_v3(vector[0][least], vector[1][least], vector[2][least]);
  return true;
}

/* The planes at a conical vertex touch a cone: its axis lies in the planes that bisect
 * neighboring faces, which have the normals m_k = n_k - n_(k+1). Returns the largest angle,
 * radians, by which the axis of best fit misses one of those planes; NAN when the normals are not
 * numbers. Faces in one plane have no bisector, and ask for nothing. n: unit normals of the faces
 * around the vertex, in order. */
static double axis_miss(const lam_vec3 *n, int count) {
  static const double same_plane = 1e-9;
  lam_vec3 g;
  double miss = 0;
  if (!axis_of_best_fit(n, count, &g)) return NAN;

  for (int k = 0; k < count; k++) {
    lam_vec3 m = lam_sub(n[k], n[(k + 1) % count]);
    double length = lam_length(m);
    if (length > same_plane) miss = fmax(miss, asin(fmin(fabs(lam_dot(m, g)) / length, 1)));
  }
  return miss;
}

enum { most_valence = 64 };

/* Inner vertices of four and more faces: three planes always touch a cone. Degrees. */
static void conicality(const lam_measuring *in, double *values) {
  const lam_net *net = in->net;
  lam_vec3 *normals = LAM_NEW(in->arena, lam_vec3, net->mesh.face_count), around[most_valence];
  int *rings = lam_net_face_rings(in->arena, net);
  lam_net_face_normals(net, in->positions, normals);

  for (int v = 0; v < net->mesh.vertex_count; v++) {
    int first = net->ring_start[v], valence = net->ring_start[v + 1] - first;
    if (net->boundary[v] || valence < 4 || valence > most_valence) continue;
    for (int k = 0; k < valence; k++) around[k] = normals[rings[first + k]];
    values[v] = axis_miss(around, valence) * LAM_DEGREES_PER_RADIAN;
  }
}

const lam_measure_kind lam_measure_conicality = {
    "conicality", "deg",
    "largest angle by which the axis of best fit at a vertex misses the planes that bisect its "
    "faces; three faces always have an axis",
    LAM_ON_VERTICES, conicality};
