/* Conditions that are linear in the lengths of a few edges: what equal_edges.c, jacobi.c and
 * strip_widths.c are made of. */
#ifndef LAM_CON_EDGE_SUMS_H
#define LAM_CON_EDGE_SUMS_H

#include "con/constraint.h"

/* A list of elements with edges_each edges; an edge is two vertices. */
typedef struct lam_edge_list {
  int edges_each, count;
  int *nodes; /* 2 edges_each per element */
} lam_edge_list;

/* An empty list, owned by arena. capacity: the most elements that will be added. */
lam_edge_list lam_edge_list_new(lam_arena *arena, int edges_each, int capacity);
/* Adds an element of 2 edges_each vertices, which are copied. Precondition: there is room. */
void lam_edge_list_push(lam_edge_list *list, const int *vertices);
/* A hard block: sum coefficients[k] |edge k| = 0 for all elements of the list, whose nodes it
 * keeps by pointer. coefficients: edges_each, copied. */
void lam_edge_sum_add(lam_scope *scope, const char *name, double weight, const lam_edge_list *list,
                      const double *coefficients);
/* The edge of face f opposite to edge e of it, as two vertices in the direction of edge e. False: e
 * is no side of f. */
bool lam_opposite_edge(const lam_net *net, int f, const lam_edge *e, int opposite[2]);

#endif
