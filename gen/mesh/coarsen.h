/* Coarser nets: every other line of each family, the reverse of a subdivision. net/multilevel.c
 * solves on them first; design/net_stage.c offers them as an edit of a net. */
#ifndef LAM_MESH_COARSEN_H
#define LAM_MESH_COARSEN_H

#include "mesh/net.h"

typedef struct lam_coarse {
  lam_mesh mesh; /* families as in the fine net; vertices in the fine net's order */
  int *kept;     /* per coarse vertex: its index in the fine net */
  /* Per fine vertex: the four coarse vertices (repeated where they are fewer) whose mean it is. A
   * kept vertex names itself, one in the middle of a coarse edge the ends twice each, one in the
   * middle of a coarse face its corners. A displacement of the coarse net is carried over by these
   * means. */
  int (*parents)[4];
} lam_coarse;

/* Leaves out every other line of each family on any net that is a subdivision, with irregular
 * vertices and closed lines. Four faces become one. Open lines with an odd number of edges keep
 * both ends: the last coarse cell is one fine cell wide then. On a grid the vertices (2i, 2j)
 * stay. Returns NULL, or why the net cannot be coarsened (static text); coarse is not filled then.
 * Owned by arena. */
const char *lam_net_coarsen(lam_arena *arena, const lam_net *net, lam_coarse *coarse);

#endif
