/* Mean curvature by cotangent weights, a second opinion beside curvature_measures.c. A row of the
 * list in net/measures/measure.c, which calls it. */
#include "net/measures/measuring.h"

#include <math.h>

/* Adds what one triangle gives to the sums and areas of its corners t.
 *
 * The mean curvature vector of a triangle mesh at x_i is
 *   sum_j (cot a_ij + cot b_ij) (x_j - x_i) / (4 A_i) = H n
 * with the angles a, b opposite to the edge and the Voronoi area A (in obtuse triangles: half or
 * a quarter of the triangle). Meyer, Desbrun, Schroeder & Barr, Discrete differential-geometry
 * operators (2003), sec. 3.3 and 3.5. */
static void add_triangle(const lam_vec3 *x, const int t[3], lam_vec3 *sum, double *area) {
  double cot[3], square[3], least = INFINITY, half = 0;
  for (int k = 0; k < 3; k++) {
    lam_vec3 a = lam_sub(x[t[(k + 1) % 3]], x[t[k]]), b = lam_sub(x[t[(k + 2) % 3]], x[t[k]]);
    half = lam_length(lam_cross(a, b)) / 2;
    cot[k] = lam_dot(a, b) / (2 * half);
    square[k] = lam_dot(lam_sub(b, a), lam_sub(b, a)); /* of the edge opposite to corner k */
    least = fmin(least, cot[k]);
  }

  for (int k = 0; k < 3; k++) {
    int i = (k + 1) % 3, j = (k + 2) % 3;
    lam_vec3 edge = lam_scale(lam_sub(x[t[j]], x[t[i]]), cot[k]);
    sum[t[i]] = lam_add(sum[t[i]], edge);
    sum[t[j]] = lam_sub(sum[t[j]], edge);
    if (least < 0) /* obtuse */
      area[t[k]] += cot[k] < 0 ? half / 2 : half / 4;
    else
      area[t[k]] += (square[j] * cot[j] + square[i] * cot[i]) / 8;
  }
}

/* Both ways to split the faces are added: sums and areas are doubled alike. The sign is that of
 * the mean curvature vector along the net's normal. */
static void cotangent_mean_curvature(const lam_measuring *in, double *values) {
  static const int splits[4][3] = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}};
  const lam_mesh *mesh = &in->net->mesh;
  int n = mesh->vertex_count;
  lam_vec3 *sum = LAM_NEW(in->arena, lam_vec3, n);
  double *area = LAM_NEW(in->arena, double, n);
  for (int f = 0; f < mesh->face_count; f++)
    for (int s = 0; s < 4; s++) {
      int t[3];
      for (int k = 0; k < 3; k++) t[k] = mesh->faces[f][splits[s][k]];
      add_triangle(in->positions, t, sum, area);
    }

  const lam_vec3 *normals = lam_measuring_normals(in);
  for (int v = 0; v < n; v++)
    if (!in->net->boundary[v])
      values[v] = copysign(lam_length(sum[v]), lam_dot(sum[v], normals[v])) / (4 * area[v]);
}

const lam_measure_kind lam_measure_cotangent_mean_curvature = {
    "cotangent_mean_curvature", "1/m",
    "mean curvature by cotangent weights at inner vertices, from both ways to split the faces into "
    "triangles",
    LAM_ON_VERTICES, cotangent_mean_curvature};
