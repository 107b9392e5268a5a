/* Which nodes are eliminated together: columns of the same rows, and small fronts merged into their
 * parents as long as a model of the time gains by it. Called by front_plan.c. */
#include "solve/factor/elimination.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A supernode while it grows. One that was merged is found through its heir. */
typedef struct group {
  int first, last; /* its own columns, before merging */
  int heir;        /* itself, or the one that it was merged into */
  int next, tail;  /* the chain of those merged into it: -1 ends it */
  int parent;
  int pivots, rows; /* unknowns, those of all merged */
  int64_t peak;     /* numbers that its tree needs at once for update matrices */
} group;

typedef struct groups {
  group *group;
  int count;
} groups;

/* Consecutive columns, each the parent of the one before, with the same rows below. */
static groups find_groups(lam_arena *arena, const lam_nodes *nodes, const lam_forest *forest) {
  int n = nodes->count, *of = LAM_NEW(arena, int, n);
  groups all = {.group = LAM_NEW(arena, group, n)};
  for (int j = 0; j < n; j++) {
    bool begins =
        j == 0 || forest->parent[j - 1] != j || forest->rows[j - 1] != forest->rows[j] + 1;
    if (begins) {
      int i = all.count++;
      all.group[i] =
          (group){.first = j, .heir = i, .next = -1, .tail = i, .rows = forest->unknowns[j]};
    }
    group *g = &all.group[all.count - 1];
    of[j] = all.count - 1;
    g->last = j;
    g->pivots += lam_node_size(nodes, nodes->order[j]);
  }
  for (int i = 0; i < all.count; i++) {
    int parent = forest->parent[all.group[i].last];
    all.group[i].parent = parent < 0 ? -1 : of[parent];
  }
  return all;
}

/* ---- merging ---- */

/* Time of a front with k pivots and m rows below, in multiplications: starting it, eliminating, and
 * moving its update matrix and its panel through memory. Measured once; the optimum is flat. */
static double cost(double k, double m) {
  double all = k + m;
  return 20000 + k * all * all - k * k * all + k * k * k / 3 + 15 * m * m + 30 * k * all;
}

/* Follows the heirs, and shortens the way for the next. */
static int find_heir(groups *all, int i) {
  while (all->group[i].heir != i) {
    all->group[i].heir = all->group[all->group[i].heir].heir;
    i = all->group[i].heir;
  }
  return i;
}

/* Whether a parent should take up one of its children. */
static bool pays(const group *child, const group *parent) {
  double below = parent->rows - parent->pivots;
  return cost(child->pivots + parent->pivots, below) <=
         cost(child->pivots, child->rows - child->pivots) + cost(parent->pivots, below);
}

/* Three sweeps, children first: what a parent has grown to may make the next one pay. */
static void merge(groups *all) {
  for (int sweep = 0; sweep < 3; sweep++)
    for (int i = 0; i < all->count; i++) {
      group *g = &all->group[i];
      if (g->heir != i || g->parent < 0) continue;
      int p = find_heir(all, g->parent);
      group *parent = &all->group[p];
      if (!pays(g, parent)) continue;

      g->heir = p;
      parent->pivots += g->pivots;
      parent->rows += g->pivots;
      all->group[parent->tail].next = i;
      parent->tail = g->tail;
    }
  for (int i = 0; i < all->count; i++)
    if (all->group[i].parent >= 0) all->group[i].parent = find_heir(all, all->group[i].parent);
}

/* ---- order ---- */

/* Numbers in the update matrix of a group. */
static int64_t update_size(const group *g) {
  int64_t m = g->rows - g->pivots;
  return m * m / 2;
}

/* A child in the order in which children are eliminated: those that leave the most room free behind
 * them come first. */
typedef struct sibling {
  int64_t key;
  int index;
} sibling;

static int compare_siblings(const void *a, const void *b) {
  const sibling *x = a, *y = b;
  if (x->key != y->key) return x->key > y->key ? -1 : 1;
  return (x->index > y->index) - (x->index < y->index);
}

/* The groups that are left, by parents: those of p are list[start[p + 1] .. start[p + 2] - 1],
 * those without a parent begin at start[0]. */
typedef struct families {
  int *start;
  sibling *list;
} families;

static families find_families(lam_arena *arena, const groups *all) {
  families f = {LAM_NEW(arena, int, all->count + 2), LAM_NEW(arena, sibling, all->count)};
  int *fill = LAM_NEW(arena, int, all->count + 1);
  for (int i = 0; i < all->count; i++)
    if (all->group[i].heir == i) f.start[all->group[i].parent + 2]++;
  for (int i = 0; i <= all->count; i++) f.start[i + 1] += f.start[i];
  for (int i = 0; i < all->count; i++)
    if (all->group[i].heir == i) {
      int p = all->group[i].parent + 1;
      f.list[f.start[p] + fill[p]++].index = i;
    }
  return f;
}

/* Sorts children, and finds what a tree needs at once. Groups come after their children. */
static void sort_families(groups *all, families *f) {
  for (int i = 0; i < all->count; i++) {
    if (all->group[i].heir != i) continue;
    sibling *child = f->list + f->start[i + 1];
    int count = f->start[i + 2] - f->start[i + 1];
    for (int c = 0; c < count; c++) {
      const group *g = &all->group[child[c].index];
      child[c].key = g->peak - update_size(g);
    }
    qsort(child, (size_t)count, sizeof *child, compare_siblings);

    int64_t live = 0, peak = 0;
    for (int c = 0; c < count; c++) {
      const group *g = &all->group[child[c].index];
      if (live + g->peak > peak) peak = live + g->peak;
      live += update_size(g);
    }
    live += update_size(&all->group[i]);
    all->group[i].peak = live > peak ? live : peak;
  }
}

/* The groups that are left, children before parents; list[k] is the k-th, *count of them. */
static int *walk(lam_arena *arena, const groups *all, const families *f, int *count) {
  int *list = LAM_NEW(arena, int, all->count), *stack = LAM_NEW(arena, int, all->count + 1);
  int *next = LAM_NEW(arena, int, all->count + 1), top = 0;
  memcpy(next, f->start, sizeof(int) * (size_t)(all->count + 1));
  stack[top++] = 0; /* above the roots */
  *count = 0;
  while (top) {
    int p = stack[top - 1];
    if (next[p] < f->start[p + 1])
      stack[top++] = f->list[next[p]++].index + 1;
    else if (top--, p > 0)
      list[(*count)++] = p - 1;
  }
  return list;
}

static int compare_int(const void *a, const void *b) {
  int x = *(const int *)a, y = *(const int *)b;
  return (x > y) - (x < y);
}

/* The nodes of each supernode, by number: neighbors in the mesh stay neighbors, and what children
 * add lands in long runs. */
static void order_nodes(lam_arena *arena, lam_nodes *nodes, const groups *all, const int *list,
                        lam_supernodes *s) {
  int *order = LAM_NEW(arena, int, nodes->count), count = 0;
  for (int k = 0; k < s->count; k++) {
    s->first[k] = count;
    for (int i = list[k]; i >= 0; i = all->group[i].next)
      for (int j = all->group[i].first; j <= all->group[i].last; j++)
        order[count++] = nodes->order[j];
    qsort(order + s->first[k], (size_t)(count - s->first[k]), sizeof(int), compare_int);
  }
  s->first[s->count] = count;
  for (int k = 0; k < count; k++) {
    nodes->order[k] = order[k];
    nodes->position[order[k]] = k;
  }
}

lam_supernodes lam_supernodes_merge(lam_arena *arena, lam_nodes *nodes, const lam_forest *forest) {
  groups all = find_groups(arena, nodes, forest);
  merge(&all);
  families f = find_families(arena, &all);
  sort_families(&all, &f);

  lam_supernodes s = {0};
  int *list = walk(arena, &all, &f, &s.count), *place = LAM_NEW(arena, int, all.count);
  s.first = LAM_NEW(arena, int, s.count + 1);
  s.parent = LAM_NEW(arena, int, s.count);
  for (int k = 0; k < s.count; k++) place[list[k]] = k;
  for (int k = 0; k < s.count; k++) {
    int parent = all.group[list[k]].parent;
    s.parent[k] = parent < 0 ? -1 : place[parent];
  }
  order_nodes(arena, nodes, &all, list, &s);
  return s;
}
