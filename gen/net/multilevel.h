/* Coarse nets: every other line left out. Solved first, they carry the shape; a fine net alone zigzags. */
#ifndef LAM_NET_MULTILEVEL_H
#define LAM_NET_MULTILEVEL_H

#include "net/net.h"

typedef struct lam_coarse {
  lam_net net;  /* vertices at the places of the fine vertices that stay */
  int *fine;    /* per vertex of lam_net_four_point(net): the vertex of the fine net that it stands for */
  int *nearest; /* per fine vertex: a coarse vertex that it is, or is next to */
} lam_coarse;

/* The net that fine refines by halving every edge, whatever its topology; positions (fine->mesh.vertex_count) are
 * those of the fine vertices. False when there is none (an odd number of cells across, irregular vertices an odd
 * number of edges apart, or fewer than least_faces faces would be left); nothing of coarse is defined then. */
bool lam_net_coarsen(lam_arena *arena, const lam_net *fine, const lam_vec3 *positions, int least_faces,
                     lam_coarse *coarse);
/* Positions of the fine vertices from those of the coarse net, by the interpolating 4-point rule. */
void lam_coarse_refine(lam_arena *arena, const lam_coarse *coarse, lam_vec3 *positions);

#endif
