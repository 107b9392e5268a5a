/* The sides of a net that has the shape of a rectangle or of a tube, and its vertices by grid
 * position: what handles name (net/handles.c). */
#ifndef LAM_MESH_NET_SIDES_H
#define LAM_MESH_NET_SIDES_H

#include "mesh/net.h"

/* u0: where the lines of family 0 begin, u1: where they end; v0, v1: the same for family 1. */
typedef enum lam_side {
  LAM_SIDE_U0,
  LAM_SIDE_U1,
  LAM_SIDE_V0,
  LAM_SIDE_V1,
  LAM_SIDE_COUNT
} lam_side;
extern const char *const lam_side_names[]; /* NULL-terminated */

/* The vertices of a side, in the direction in which the other family's number grows. The corner of
 * u0 and v0 is the one with the smallest index. A net with one boundary loop has sides when the
 * loop has four corners (boundary vertices with two edges); one with two loops without corners has
 * u0 and u1, or v0 and v1, as closed lines. False: there is no such side, and line is not filled.
 * Its vertices are owned by arena. */
bool lam_net_side(lam_arena *arena, const lam_net *net, lam_side side, lam_polyline *line);

/* The vertex at which line j of family 0 and line i of family 1 cross, counted from the corner of
 * u0 and v0; -1: there is none, or the net has no corners. arena: for what it needs on the way. */
int lam_net_grid_vertex(lam_arena *arena, const lam_net *net, int i, int j);

#endif
