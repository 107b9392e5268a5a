/* Unknowns joined to nodes, and the graph of the nodes. Called by front_plan.c. */
#include "solve/factor/elimination.h"

#include <stdbool.h>
#include <string.h>

/* How many columns hold an unknown, and how many of them hold the next unknown just below it. */
typedef struct holders {
  int *all, *with_next;
} holders;

static holders count_holders(lam_arena *arena, const lam_pattern *p) {
  holders h = {LAM_NEW(arena, int, p->n), LAM_NEW(arena, int, p->n)};
  for (int c = 0; c < p->n; c++)
    for (int e = p->start[c]; e < p->start[c + 1]; e++) {
      h.all[p->row[e]]++;
      if (e + 1 < p->start[c + 1] && p->row[e + 1] == p->row[e] + 1) h.with_next[p->row[e]]++;
    }
  return h;
}

/* Whether c belongs to the node of c - 1: next to it in the order, the same rows below, and every
 * column that holds one of them holds both (c's own column besides). */
static bool joins(const lam_pattern *p, const int *position, const holders *h, int c) {
  int before = p->start[c] - p->start[c - 1], here = p->start[c + 1] - p->start[c];
  if (position[c] != position[c - 1] + 1 || before != here + 1) return false;
  if (memcmp(p->row + p->start[c - 1] + 1, p->row + p->start[c], sizeof(int) * (size_t)here) != 0)
    return false;
  return h->with_next[c - 1] == h->all[c - 1] && h->all[c] == h->all[c - 1] + 1;
}

/* Ranges of unknowns, and the order of the nodes: that of their first unknowns. */
static void find_ranges(lam_arena *arena, const lam_pattern *p, lam_nodes *nodes) {
  int *position = LAM_NEW(arena, int, p->n);
  for (int k = 0; k < p->n; k++) position[p->order[k]] = k;
  holders h = count_holders(arena, p);

  nodes->first = LAM_NEW(arena, int, p->n + 1);
  nodes->of = LAM_NEW(arena, int, p->n);
  for (int c = 0; c < p->n; c++) {
    if (c == 0 || !joins(p, position, &h, c)) nodes->first[nodes->count++] = c;
    nodes->of[c] = nodes->count - 1;
  }
  nodes->first[nodes->count] = p->n;

  nodes->order = LAM_NEW(arena, int, nodes->count);
  nodes->position = LAM_NEW(arena, int, nodes->count);
  for (int k = 0, next = 0; k < p->n; k++) {
    int node = nodes->of[p->order[k]];
    if (nodes->first[node] != p->order[k]) continue;
    nodes->position[node] = next;
    nodes->order[next++] = node;
  }
}

/* The nodes below node v in its column, one after the other: e runs through the column of its
 * first unknown. -1 at the end. */
static int next_below(const lam_pattern *p, const lam_nodes *nodes, int v, int *e) {
  int end = p->start[nodes->first[v] + 1];
  while (*e < end) {
    int u = nodes->of[p->row[*e]];
    while (*e < end && nodes->of[p->row[*e]] == u) ++*e;
    if (u != v) return u;
  }
  return -1;
}

/* Every edge at both of its nodes: counted, then listed. */
static void find_graph(lam_arena *arena, const lam_pattern *p, lam_nodes *nodes) {
  int n = nodes->count;
  nodes->start = LAM_NEW(arena, int, n + 1);
  for (int v = 0; v < n; v++)
    for (int e = p->start[nodes->first[v]], u; (u = next_below(p, nodes, v, &e)) >= 0;) {
      nodes->start[v + 1]++;
      nodes->start[u + 1]++;
    }
  for (int v = 0; v < n; v++) nodes->start[v + 1] += nodes->start[v];

  int *fill = LAM_NEW(arena, int, n);
  nodes->neighbor = LAM_NEW(arena, int, nodes->start[n]);
  for (int v = 0; v < n; v++)
    for (int e = p->start[nodes->first[v]], u; (u = next_below(p, nodes, v, &e)) >= 0;) {
      nodes->neighbor[nodes->start[v] + fill[v]++] = u;
      nodes->neighbor[nodes->start[u] + fill[u]++] = v;
    }
}

lam_nodes lam_nodes_find(lam_arena *arena, const lam_pattern *pattern) {
  lam_nodes nodes = {0};
  find_ranges(arena, pattern, &nodes);
  find_graph(arena, pattern, &nodes);
  return nodes;
}
