/* Curvatures of the smooth surface through a net, from its vertices alone: for the measures of
 * net/measures/curvature_measures.c. */
#ifndef LAM_MESH_NET_CURVATURE_H
#define LAM_MESH_NET_CURVATURE_H

#include "mesh/net.h"

typedef struct lam_net_curvature {
  int degree;            /* of the polynomial that was fitted; 0: none, and nothing below is set */
  double K, H;           /* Gaussian and mean curvature, 1/m^2 and 1/m */
  double k1, k2;         /* 1/m, k1 >= k2; positive where the net curves towards its normal */
  lam_vec3 direction[2]; /* unit principal directions of k1 and k2; any two where k1 = k2 */
} lam_net_curvature;

/* Curvatures at all vertices (vertex_count entries in the arena; positions in meters). Over the
 * tangent plane of the vertex, the height of the vertices of two rings of faces (5 x 5 in a regular
 * net; three rings next to the boundary) is fitted by a polynomial of degree 4, or less where there
 * are too few vertices for it; there is no fit on the boundary itself. On smooth surfaces the error
 * falls with the fourth power of the spacing inside and the third next to the boundary. Cazals &
 * Pouget, Estimating differential quantities using polynomial fitting of osculating jets (2005). */
lam_net_curvature *lam_net_curvatures(lam_arena *arena, const lam_net *net,
                                      const lam_vec3 *positions);

#endif
