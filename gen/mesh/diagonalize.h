/* The net of the diagonals, which design/net_stage.c offers as an edit of a net. */
#ifndef LAM_MESH_DIAGONALIZE_H
#define LAM_MESH_DIAGONALIZE_H

#include "mesh/net.h"

/* Vertices are colored so that every edge joins two colors. The vertices of one color stay; around
 * every inner vertex of the other color they are the corners of a new face, so the new edges are
 * diagonals of the old faces. Triangles at the boundary are left out, and its edge becomes a
 * zigzag. The color of the first vertex stays, unless an irregular vertex of the other color would
 * make a face that is no quad. Returns NULL, or why there is no such net (static text); mesh must
 * not be used then. Owned by arena. */
const char *lam_net_diagonalize(lam_arena *arena, const lam_net *net, lam_mesh *mesh);

#endif
