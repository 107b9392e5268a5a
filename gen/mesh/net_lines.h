/* The last steps of lam_net_build (net.c, which alone calls them): lines, stars and boundary loops.
 * They need edges with families, rings and boundary; what they add is owned by arena. */
#ifndef LAM_MESH_NET_LINES_H
#define LAM_MESH_NET_LINES_H

#include "core/arena.h"
#include "mesh/net.h"

/* Fills polylines: sorted by family, then by their first two vertices. */
void lam_net_trace_lines(lam_arena *arena, lam_net *net);
/* Fills stars and star_of_vertex. Needs the polylines: +u is where the line of family 0 goes on. */
void lam_net_list_stars(lam_arena *arena, lam_net *net);
/* Fills the boundary loops, each from its vertex with the smallest index. */
void lam_net_trace_loops(lam_arena *arena, lam_net *net);

#endif
