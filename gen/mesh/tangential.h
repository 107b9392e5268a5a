/* Faces with an incircle, and the spheres that S-isothermic nets have at their vertices. The
 * constraint con/s_isothermic.c starts from them; net/measures/faces_measures.c and
 * fab/parts/circles.c show them. */
#ifndef LAM_MESH_TANGENTIAL_H
#define LAM_MESH_TANGENTIAL_H

#include "mesh/net.h"

/* The circle inside a face that comes nearest to touching its four edges. */
typedef struct lam_incircle {
  lam_vec3 center;
  lam_vec3 normal; /* unit, on the side from which the corners run counterclockwise */
  double radius;
  double tangent[4]; /* from every corner to the points where its two edges touch */
} lam_incircle;

/* Exact when the face is flat and tangential (both pairs of opposite edges have the same sum); a
 * mean over the corners otherwise. corners: 4, counterclockwise, in any unit. Precondition: the
 * face has an area and no corner of 0 degrees. */
lam_incircle lam_incircle_of(const lam_vec3 *corners);
/* Radius of the sphere at every vertex: the mean of the tangents of its faces. positions, radii:
 * vertex_count each, in the same unit. */
void lam_net_sphere_radii(const lam_net *net, const lam_vec3 *positions, double *radii);

#endif
