/* From a sparse pattern to a tree of fronts: what is eliminated together, in which order. Symbolic:
 * no values. Used by front_plan.c.
 *
 * Unknowns that stand together and have the same neighbors, as the three of a vertex do, form a
 * node; all that follows is done on nodes, which is nine times less work. */
#ifndef LAM_SOLVE_FACTOR_ELIMINATION_H
#define LAM_SOLVE_FACTOR_ELIMINATION_H

#include "core/arena.h"

/* A symmetric pattern: the lower triangle by columns, rows ascending, diagonal first; and the order
 * in which unknowns are wanted to be eliminated. */
typedef struct lam_pattern {
  int n;
  const int *start; /* n + 1 */
  const int *row;   /* start[n] */
  const int *order; /* n: order[k] is eliminated k-th */
} lam_pattern;

/* The graph of nodes. A node is a range of unknowns. */
typedef struct lam_nodes {
  int count;
  int *first;    /* count + 1: node v is the unknowns first[v] .. first[v + 1] - 1 */
  int *of;       /* n: the node of an unknown */
  int *start;    /* count + 1 */
  int *neighbor; /* start[count]: every edge is listed at both of its nodes */
  int *order;    /* count: order[k] is eliminated k-th */
  int *position; /* count: the inverse of order */
} lam_nodes;

/* All arrays belong to the arena. */
lam_nodes lam_nodes_find(lam_arena *arena, const lam_pattern *pattern);

/* Unknowns in a node. */
static inline int lam_node_size(const lam_nodes *nodes, int node) {
  return nodes->first[node + 1] - nodes->first[node];
}

/* The elimination forest of the nodes, which are reordered so that every tree is a row of
 * consecutive nodes (a postorder). Index: position in the order. */
typedef struct lam_forest {
  int *parent;   /* count: -1 at roots */
  int *rows;     /* count: nodes in the column of the factor, itself included */
  int *unknowns; /* count: unknowns in them */
} lam_forest;

/* Changes the order of the nodes, and their positions. */
lam_forest lam_forest_grow(lam_arena *arena, lam_nodes *nodes);

/* Supernodes: consecutive nodes that are eliminated in one dense front, children before parents. */
typedef struct lam_supernodes {
  int count;
  int *first;  /* count + 1: positions in the order of nodes */
  int *parent; /* count: -1 at roots */
} lam_supernodes;

/* Merges nodes into supernodes, and supernodes into their parents where a model of the time says
 * that it pays. Changes the order of the nodes, and their positions. */
lam_supernodes lam_supernodes_merge(lam_arena *arena, lam_nodes *nodes, const lam_forest *forest);

#endif
