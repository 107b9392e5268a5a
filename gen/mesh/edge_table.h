/* The edge between two vertices of a net, found through a table: for net_lines.c and
 * subdivide.c. */
#ifndef LAM_MESH_EDGE_TABLE_H
#define LAM_MESH_EDGE_TABLE_H

#include "core/arena.h"
#include "mesh/net.h"

/* Every edge is listed at its end with the smaller index, in increasing order: the edges of vertex
 * v are list[first[v] .. first[v + 1] - 1]. */
typedef struct lam_edge_table {
  const lam_net *net;
  int *first, *list;
} lam_edge_table;

/* Needs only net->edges. The table is owned by arena and valid as long as the net is. */
lam_edge_table lam_edge_table_new(lam_arena *arena, const lam_net *net);
/* The edge between vertices a and b, in either direction; -1: there is none. */
int lam_edge_table_find(const lam_edge_table *table, int a, int b);

#endif
