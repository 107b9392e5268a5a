/* Conditions that are linear in the lengths of a few edges. */
#ifndef LAM_CON_EDGE_SUMS_H
#define LAM_CON_EDGE_SUMS_H

#include "con/constraint.h"

/* r = sum p[k] |b_k - a_k| (in mean edges); nodes a_0, b_0, a_1, b_1, ... A vertex may be listed
 * twice. */
void lam_edge_sum(int n, const double *x, const double *p, double *r, double *J);

/* A growing list of elements with edges_each edges. */
typedef struct lam_edge_list {
  int edges_each, count;
  int *nodes;
} lam_edge_list;

/* capacity: the most elements that will be added. */
lam_edge_list lam_edge_list_new(lam_arena *arena, int edges_each, int capacity);
/* Adds an element: 2 edges_each vertices. */
void lam_edge_list_push(lam_edge_list *list, const int *vertices);
/* The block sum coefficients[k] |edge k| = 0 of all elements. */
void lam_edge_sum_add(lam_scope *scope, const char *name, double weight, const lam_edge_list *list,
                      const double *coefficients);
/* The edge of face f opposite to edge e of it, as vertices a, b in the direction of edge e. False:
 * e is no side of f.
 */
bool lam_opposite_edge(const lam_net *net, int f, const lam_edge *e, int opposite[2]);

#endif
