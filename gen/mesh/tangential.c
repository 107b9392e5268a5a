/* Incircles of faces and the spheres at vertices, from positions: starts of con/s_isothermic.c, and
 * what net/measures/faces_measures.c and fab/parts/circles.c look at. */
#include "mesh/tangential.h"

#include <math.h>

/* With the area A and the half perimeter s of a tangential quad, R = A / s; the tangent at a corner
 * of angle a is R cot(a/2), and the center lies on the bisector at the distance R / sin(a/2). */
lam_incircle lam_incircle_of(const lam_vec3 *corners) {
  lam_incircle c = {.center = {0, 0, 0}};
  double perimeter = 0;
  for (int k = 0; k < 4; k++) perimeter += lam_distance(corners[k], corners[(k + 1) % 4]);

  /* the product of the diagonals is twice the area, so the quotient by the whole perimeter is R */
  lam_vec3 area = lam_cross(lam_sub(corners[2], corners[0]), lam_sub(corners[3], corners[1]));
  c.normal = lam_unit(area);
  c.radius = lam_length(area) / perimeter;

  for (int k = 0; k < 4; k++) {
    lam_vec3 ahead = lam_unit(lam_sub(corners[(k + 1) % 4], corners[k]));
    lam_vec3 back = lam_unit(lam_sub(corners[(k + 3) % 4], corners[k]));
    double half = lam_angle(ahead, back) / 2;
    c.tangent[k] = c.radius / tan(half);
    lam_vec3 center = lam_along(corners[k], c.radius / sin(half), lam_unit(lam_add(ahead, back)));
    c.center = lam_along(c.center, .25, center);
  }
  return c;
}

/* A boundary vertex has one face less than edges. */
void lam_net_sphere_radii(const lam_net *net, const lam_vec3 *positions, double *radii) {
  const lam_mesh *mesh = &net->mesh;
  for (int v = 0; v < mesh->vertex_count; v++) radii[v] = 0;
  for (int f = 0; f < mesh->face_count; f++) {
    lam_vec3 corners[4];
    for (int k = 0; k < 4; k++) corners[k] = positions[mesh->faces[f][k]];
    lam_incircle circle = lam_incircle_of(corners);
    for (int k = 0; k < 4; k++) radii[mesh->faces[f][k]] += circle.tangent[k];
  }

  for (int v = 0; v < mesh->vertex_count; v++) {
    int faces = lam_net_valence(net, v) - net->boundary[v];
    radii[v] /= faces;
  }
}
