/* Measures of a mesh laid flat: energy, strains, flips, stretch; and its alignment with another
 * one. Called by flatten_solve.c, texture.c, surf/developable and net/measures. */
#include "surf/flatten/flatten_parts.h"

/* The distance of two points of the plane. */
static double length(lam_vec2 a, lam_vec2 b) { return hypot(b.x - a.x, b.y - a.y); }

/* Computed anew from the points; a triangle without area counts as turned over. */
void lam_flat_measure(const lam_flat_mesh *mesh, lam_flattening *result) {
  const lam_vec2 *x = result->points;
  double squares = 0;
  result->energy = result->max_strain = 0;
  result->flips = 0;

  for (int e = 0; e < mesh->edge_count; e++) {
    double wanted = mesh->lengths[e],
           error = length(x[mesh->edges[e][0]], x[mesh->edges[e][1]]) - wanted;
    result->energy += error * error;
    result->max_strain = fmax(result->max_strain, fabs(error) / wanted);
    squares += error * error / (wanted * wanted);
  }

  result->rms_strain = mesh->edge_count ? sqrt(squares / mesh->edge_count) : 0;

  for (int t = 0; t < mesh->triangle_count; t++) {
    lam_vec2 a = x[mesh->triangles[t][0]], b = x[mesh->triangles[t][1]],
             c = x[mesh->triangles[t][2]];
    result->flips += !((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0);
  }
}

/* With both sets about their means, the angle that makes the sum of target . turned points
 * largest. */
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
    double px = points[i].x - from.x, py = points[i].y - from.y, qx = target[i].x - to.x,
           qy = target[i].y - to.y;
    along += px * qx + py * qy;
    across += px * qy - py * qx;
  }

  double size = hypot(along, across), c = size > 0 ? along / size : 1,
         s = size > 0 ? across / size : 0;

  for (int i = 0; i < count; i++) {
    double px = points[i].x - from.x, py = points[i].y - from.y;
    points[i] = (lam_vec2){to.x + c * px - s * py, to.y + s * px + c * py};
    sum += pow(length(points[i], target[i]), 2);
  }
  return count ? sqrt(sum / count) : 0;
}

/* With a, b as columns of A and p, q as those of P the map is J = A P^-1. In the frame of its
 * first column and the normal to that in the plane of both, J is [[j, k], [0, l]], and
 * s1 +- s2 = |(j +- l, k)|. */
lam_vec2 lam_flat_stretch(lam_vec2 p, lam_vec2 q, lam_vec3 a, lam_vec3 b) {
  double det = p.x * q.y - p.y * q.x;
  lam_vec3 du = lam_scale(lam_sub(lam_scale(a, q.y), lam_scale(b, p.y)), 1 / det);
  lam_vec3 dv = lam_scale(lam_sub(lam_scale(b, p.x), lam_scale(a, q.x)), 1 / det);
  double j = lam_length(du), k = lam_dot(du, dv) / j, l = lam_length(lam_cross(du, dv)) / j;
  double sum = hypot(j + l, k), difference = hypot(j - l, k);
  return (lam_vec2){(sum + difference) / 2, (sum - difference) / 2};
}

/* The two sides of every triangle at its first corner, flat and in space. */
void lam_flat_stretches(const lam_flat_mesh *mesh, const lam_vec2 *flat, lam_vec2 *stretch) {
  for (int t = 0; t < mesh->triangle_count; t++) {
    const int *v = mesh->triangles[t];
    const lam_vec3 *x = mesh->vertices;
    lam_vec2 p = {flat[v[1]].x - flat[v[0]].x, flat[v[1]].y - flat[v[0]].y};
    lam_vec2 q = {flat[v[2]].x - flat[v[0]].x, flat[v[2]].y - flat[v[0]].y};
    stretch[t] = lam_flat_stretch(p, q, lam_sub(x[v[1]], x[v[0]]), lam_sub(x[v[2]], x[v[0]]));
  }
}

/* One triangle at a time, so that nothing is allocated. */
double lam_flat_anisotropy(const lam_flat_mesh *mesh, const lam_vec2 *flat, double *ratios) {
  double most = 0;
  for (int t = 0; t < mesh->triangle_count; t++) {
    lam_flat_mesh one = *mesh;
    lam_vec2 s;
    one.triangles = mesh->triangles + t;
    one.triangle_count = 1;
    lam_flat_stretches(&one, flat, &s);
    if (ratios) ratios[t] = s.x / s.y;
    most = fmax(most, s.x / s.y);
  }
  return most;
}
