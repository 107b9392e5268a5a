/* What several measures compute from a net before they measure it. For the files *_measures.c and
 * measure_map.c of this folder. */
#ifndef LAM_NET_MEASURES_MEASURING_H
#define LAM_NET_MEASURES_MEASURING_H

#include "net/measures/measure.h"

/* The four unit edges e of a star from its center, in the order of its neighbors: +u,
 * +v, -u, -v. */
static inline void lam_star_unit_edges(const lam_measuring *in, const lam_star *star,
                                       lam_vec3 e[4]) {
  for (int k = 0; k < 4; k++)
    e[k] = lam_unit(lam_sub(in->positions[star->neighbor[k]], in->positions[star->center]));
}

/* Crossing angle of the families at a star, radians: between the tangents e_u - e_-u and e_v -
 * e_-v (thesis 3.1, def. 5). */
static inline double lam_star_crossing_angle(const lam_measuring *in, const lam_star *star) {
  lam_vec3 e[4];
  lam_star_unit_edges(in, star, e);
  return lam_angle(lam_sub(e[0], e[2]), lam_sub(e[1], e[3]));
}

/* The unit normals of all vertices, in in->arena. */
static inline lam_vec3 *lam_measuring_normals(const lam_measuring *in) {
  lam_vec3 *normals = LAM_NEW(in->arena, lam_vec3, in->net->mesh.vertex_count);
  lam_net_normals(in->net, in->positions, normals);
  return normals;
}

#endif
