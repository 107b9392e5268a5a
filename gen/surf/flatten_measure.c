#include "surf/flatten_parts.h"

static double length(lam_vec2 a, lam_vec2 b) { return hypot(b.x - a.x, b.y - a.y); }

void lam_flat_measure(const lam_flat_mesh *mesh, lam_flattening *result) {
  const lam_vec2 *x = result->points;
  double squares = 0;
  result->energy = result->max_strain = 0;
  result->flips = 0;
  for (int e = 0; e < mesh->edge_count; e++) {
    double wanted = mesh->lengths[e], error = length(x[mesh->edges[e][0]], x[mesh->edges[e][1]]) - wanted;
    result->energy += error * error;
    result->max_strain = fmax(result->max_strain, fabs(error) / wanted);
    squares += error * error / (wanted * wanted);
  }
  result->rms_strain = mesh->edge_count ? sqrt(squares / mesh->edge_count) : 0;
  for (int t = 0; t < mesh->triangle_count; t++) {
    lam_vec2 a = x[mesh->triangles[t][0]], b = x[mesh->triangles[t][1]], c = x[mesh->triangles[t][2]];
    result->flips += !((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0);
  }
}

/* With both sets about their means, the angle that makes the sum of target.turned points largest. */
double lam_flat_align(int count, const lam_vec2 *target, lam_vec2 *points) {
  lam_vec2 to = {0}, from = {0};
  double along = 0, across = 0, sum = 0;
  for (int i = 0; i < count; i++) {
    to.x += target[i].x / count;
    to.y += target[i].y / count;
    from.x += points[i].x / count;
    from.y += points[i].y / count;
  }
  for (int i = 0; i < count; i++) {
    double px = points[i].x - from.x, py = points[i].y - from.y, qx = target[i].x - to.x, qy = target[i].y - to.y;
    along += px * qx + py * qy;
    across += px * qy - py * qx;
  }
  double size = hypot(along, across), c = size > 0 ? along / size : 1, s = size > 0 ? across / size : 0;
  for (int i = 0; i < count; i++) {
    double px = points[i].x - from.x, py = points[i].y - from.y;
    points[i] = (lam_vec2){to.x + c * px - s * py, to.y + s * px + c * py};
    sum += pow(length(points[i], target[i]), 2);
  }
  return count ? sqrt(sum / count) : 0;
}

/* Edges in the plane of the triangle as columns of P, flat ones as columns of Q: the map is P Q^-1. With S = |P Q^-1|^2
 * (Frobenius) and D its determinant, s1 +- s2 = sqrt(S +- 2 D). */
double lam_flat_anisotropy(const lam_flat_mesh *mesh, const lam_vec2 *flat, double *ratios) {
  double most = 0;
  for (int t = 0; t < mesh->triangle_count; t++) {
    const int *v = mesh->triangles[t];
    lam_vec3 a = lam_sub(mesh->vertices[v[1]], mesh->vertices[v[0]]);
    lam_vec3 b = lam_sub(mesh->vertices[v[2]], mesh->vertices[v[0]]);
    double px = flat[v[1]].x - flat[v[0]].x, py = flat[v[1]].y - flat[v[0]].y;
    double qx = flat[v[2]].x - flat[v[0]].x, qy = flat[v[2]].y - flat[v[0]].y, det = px * qy - py * qx;
    lam_vec3 du = lam_scale(lam_sub(lam_scale(a, qy), lam_scale(b, py)), 1 / det);
    lam_vec3 dv = lam_scale(lam_sub(lam_scale(b, px), lam_scale(a, qx)), 1 / det);
    double S = lam_dot(du, du) + lam_dot(dv, dv), D = lam_length(lam_cross(du, dv));
    double sum = sqrt(S + 2 * D), difference = sqrt(fmax(0, S - 2 * D)),
           ratio = (sum + difference) / (sum - difference);
    if (ratios) ratios[t] = ratio;
    most = fmax(most, ratio);
  }
  return most;
}
