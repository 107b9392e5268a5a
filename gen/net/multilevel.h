/* Coarse-to-fine solving: a coarse net, solved first, carries the shape of a fine one; a fine net
 * alone zigzags. Used by net/optimize.c. */
#ifndef LAM_NET_MULTILEVEL_H
#define LAM_NET_MULTILEVEL_H

#include "mesh/net.h"

typedef struct lam_level {
  lam_net net; /* every other line of the fine net, its vertices where they are there */
  /* per vertex of lam_net_four_point(net): the vertex of the fine net that it stands for */
  int *fine;
  const int *nearest; /* per fine vertex: a coarse vertex that it is, or is next to */
} lam_level;

/* The net that fine refines by halving every edge, whatever its topology. False when there is
 * none (an odd number of cells across, irregular vertices an odd number of edges apart, fewer
 * than least_faces faces left); level is not defined then. Owned by arena. */
bool lam_level_make(lam_arena *arena, const lam_net *fine, int least_faces, lam_level *level);
/* Positions of all vertices of the fine net (out) from those of the level's net, by the
 * interpolating four-point rule; in the units of level->net. */
void lam_level_refine(lam_arena *arena, const lam_level *level, lam_vec3 *positions);

#endif
