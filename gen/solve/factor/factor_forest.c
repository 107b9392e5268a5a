/* The elimination forest: parents, a postorder, and how long the columns of the factor are (Liu,
 * The role of elimination trees in sparse factorization, 1990). Called by front_plan.c. */
#include "solve/factor/elimination.h"

#include <string.h>

/* The parent of a column is the first row below its diagonal. Ancestors are followed by shortcuts,
 * which every walk bends to the column it ends in. */
static int *find_parents(lam_arena *arena, const lam_nodes *nodes) {
  int n = nodes->count, *parent = LAM_NEW(arena, int, n), *shortcut = LAM_NEW(arena, int, n);
  for (int j = 0; j < n; j++) {
    parent[j] = shortcut[j] = -1;
    int v = nodes->order[j];
    for (int e = nodes->start[v]; e < nodes->start[v + 1]; e++)
      for (int i = nodes->position[nodes->neighbor[e]]; i >= 0 && i < j;) {
        int next = shortcut[i];
        shortcut[i] = j;
        if (next < 0) parent[i] = j;
        i = next;
      }
  }
  return parent;
}

/* Columns, every tree in a row and children before parents: post[k] is the k-th. */
static int *find_postorder(lam_arena *arena, int n, const int *parent) {
  /* children, and roots at the end, as chains in ascending order */
  int *child = LAM_NEW(arena, int, n + 1), *sibling = LAM_NEW(arena, int, n);
  for (int j = 0; j <= n; j++) child[j] = -1;
  for (int j = n - 1; j >= 0; j--) {
    int *head = &child[parent[j] < 0 ? n : parent[j]];
    sibling[j] = *head;
    *head = j;
  }

  int *post = LAM_NEW(arena, int, n), *stack = LAM_NEW(arena, int, n + 1), count = 0, top = 0;
  stack[top++] = n;
  while (top) {
    int j = stack[top - 1];
    if (child[j] >= 0) {
      stack[top++] = child[j];
      child[j] = sibling[child[j]];
    } else {
      top--;
      if (j < n) post[count++] = j;
    }
  }
  return post;
}

/* Nodes and parents are renamed to the postorder. */
static void apply(lam_arena *arena, const int *post, lam_nodes *nodes, int *parent) {
  int n = nodes->count;
  int *order = LAM_NEW(arena, int, n), *renamed = LAM_NEW(arena, int, n),
      *at = LAM_NEW(arena, int, n);
  for (int k = 0; k < n; k++) at[post[k]] = k;
  for (int k = 0; k < n; k++) {
    order[k] = nodes->order[post[k]];
    nodes->position[order[k]] = k;
    renamed[k] = parent[post[k]] < 0 ? -1 : at[parent[post[k]]];
  }
  memcpy(nodes->order, order, sizeof(int) * (size_t)n);
  memcpy(parent, renamed, sizeof(int) * (size_t)n);
}

/* Row i of the factor holds the columns on the paths from i's neighbors before it up to i. */
static void count_rows(lam_arena *arena, const lam_nodes *nodes, lam_forest *forest) {
  int n = nodes->count, *mark = LAM_NEW(arena, int, n);
  for (int j = 0; j < n; j++) mark[j] = -1;
  for (int i = 0; i < n; i++) {
    int v = nodes->order[i], size = lam_node_size(nodes, v);
    mark[i] = i;
    forest->rows[i]++;
    forest->unknowns[i] += size;
    for (int e = nodes->start[v]; e < nodes->start[v + 1]; e++)
      for (int j = nodes->position[nodes->neighbor[e]]; j < i && mark[j] != i;
           j = forest->parent[j]) {
        mark[j] = i;
        forest->rows[j]++;
        forest->unknowns[j] += size;
      }
  }
}

lam_forest lam_forest_grow(lam_arena *arena, lam_nodes *nodes) {
  lam_forest forest = {.parent = find_parents(arena, nodes),
                       .rows = LAM_NEW(arena, int, nodes->count),
                       .unknowns = LAM_NEW(arena, int, nodes->count)};
  apply(arena, find_postorder(arena, nodes->count, forest.parent), nodes, forest.parent);
  count_rows(arena, nodes, &forest);
  return forest;
}
