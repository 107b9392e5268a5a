/* Normal equations by elements: the pattern of H, its order for the factorization, and the sums
 * of J'J and J'r. Called by solver_run.c, surf/flatten/flatten_system.c and the benchmarks. */
#include "solve/assemble.h"
#include "solve/factor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The pattern is found on nodes. Column node J of the lower triangle holds its diagonal block
 * first and then the blocks of the nodes I > J that share an element with it. The entries of
 * block (I, J) in scalar column (J, c) start at
 *   column_start[J0 + c] + (size_J - c) + before(I, J),
 * those of the diagonal block at column_start[J0 + c], with J0 the first column of J and
 * before(I, J) the number of rows of the blocks between the diagonal one and (I, J). So one
 * integer per node pair of an element, before(I, J), is all that the scatter needs. */
typedef struct block_map {
  int columns; /* unknowns of an element */
  /* Per element and pair i >= j of its nodes: before(I, J), or -1 when either is fixed. */
  int *slot;
  double *constant; /* linear blocks: J'J of the whole block at weight 1; NULL otherwise */
  /* Blocks from this one on that share their elements and are scattered together; 0: this one
   * belongs to an earlier block's group. */
  int members;
  int rows; /* residuals of an element in the whole group */
} block_map;

enum { largest_node = 8 }; /* unknowns */

struct lam_system {
  const lam_problem *problem;
  int size;
  int *column_start, *row, *order, *unknown;
  int *column_of_node; /* first column of a node, -1 when fixed */
  block_map *maps;
  double *local;               /* scratch: x, r, J of one element of a group */
  int most_columns, most_rows; /* of an element, over all groups */
};

/* Which nodes share an element: node v has neighbor[start[v] .. start[v + 1] - 1]. */
typedef struct pattern {
  int *start, *neighbor; /* ascending, larger free nodes only */
} pattern;

static int compare_int(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* Goes through all pairs of free nodes that share an element, with repetition. Without a list,
 * counts the pairs of every smaller node in at; with it, appends the larger node at
 * list[at[smaller]++]. */
static void visit_pairs(const lam_problem *problem, size_t *at, int *list) {
  for (int b = 0; b < problem->block_count; b++) {
    const lam_block *block = &problem->blocks[b];

    for (int e = 0; e < block->count; e++) {
      const int *nodes = block->nodes + (size_t)e * (size_t)block->arity;
      for (int i = 0; i < block->arity; i++)
        for (int j = 0; j < i; j++) {
          int low = nodes[i] < nodes[j] ? nodes[i] : nodes[j], high = nodes[i] + nodes[j] - low;
          if (low == high || problem->fixed[low] || problem->fixed[high]) continue;
          if (list) list[at[low]] = high;
          at[low]++;
        }
    }
  }
}

/* Larger neighbors of every free node, sorted and unique. */
static pattern find_pattern(lam_arena *arena, const lam_problem *problem) {
  int n = problem->node_count;
  size_t *begin = LAM_NEW(arena, size_t, n + 1), *end = LAM_NEW(arena, size_t, n);
  visit_pairs(problem, begin + 1, NULL);
  for (int v = 0; v < n; v++) begin[v + 1] += begin[v];

  int *list = LAM_NEW(arena, int, begin[n]);
  for (int v = 0; v < n; v++) end[v] = begin[v];
  visit_pairs(problem, end, list);

  /* The unique ones move to the front: what is kept never overtakes what is read. */
  pattern p = {LAM_NEW(arena, int, n + 1), list};
  int kept = 0;
  for (int v = 0; v < n; v++) {
    int *mine = list + begin[v], total = (int)(begin[v + 1] - begin[v]);
    qsort(mine, (size_t)total, sizeof(int), compare_int);
    p.start[v] = kept;
    for (int i = 0; i < total; i++)
      if (i == 0 || mine[i] != mine[i - 1]) list[kept++] = mine[i];
  }
  p.start[n] = kept;
  return p;
}

/* Every free node's place among the free ones, and back; returns how many there are. */
static int number_free_nodes(const lam_problem *problem, int *compact, int *node) {
  int count = 0;
  for (int v = 0; v < problem->node_count; v++)
    if (!problem->fixed[v]) {
      compact[v] = count;
      node[count++] = v;
    }
  return count;
}

/* AMD on the graph of free nodes, then every node's unknowns in a row. */
static void find_order(lam_arena *arena, lam_system *system, const pattern *p) {
  const lam_problem *problem = system->problem;
  int n = problem->node_count;
  int *compact = LAM_NEW(arena, int, n), *node = LAM_NEW(arena, int, n);
  int free_count = number_free_nodes(problem, compact, node);

  /* The pattern has every edge at its smaller node; AMD wants it at both. */
  int *start = LAM_NEW(arena, int, free_count + 1), *fill = LAM_NEW(arena, int, free_count);
  for (int v = 0; v < n; v++)
    for (int i = p->start[v]; i < p->start[v + 1]; i++) {
      start[compact[v] + 1]++;
      start[compact[p->neighbor[i]] + 1]++;
    }
  for (int v = 0; v < free_count; v++) start[v + 1] += start[v];
  int *neighbor = LAM_NEW(arena, int, start[free_count]);
  for (int v = 0; v < n; v++)
    for (int i = p->start[v]; i < p->start[v + 1]; i++) {
      int a = compact[v], b = compact[p->neighbor[i]];
      neighbor[start[a] + fill[a]++] = b;
      neighbor[start[b] + fill[b]++] = a;
    }

  int *order = LAM_NEW(arena, int, free_count);
  lam_factor_order(arena, free_count, start, neighbor, order);
  system->order = LAM_NEW(arena, int, system->size);
  for (int k = 0, column = 0; k < free_count; k++)
    for (int c = 0; c < problem->size[node[order[k]]]; c++)
      system->order[column++] = system->column_of_node[node[order[k]]] + c;
}

/* before(high, low): the neighbors of low are searched for high, which is one of them. */
static int find_before(const pattern *p, const int *prefix, int low, int high) {
  int a = p->start[low], b = p->start[low + 1] - 1;
  while (a < b) {
    int middle = (a + b) / 2;
    if (p->neighbor[middle] < high)
      a = middle + 1;
    else
      b = middle;
  }
  return prefix[a];
}

/* The compressed columns, and in prefix before(I, J) for every entry of the pattern. */
static void find_columns(lam_arena *arena, lam_system *system, const pattern *p, int *prefix) {
  const lam_problem *problem = system->problem;
  int n = problem->node_count, entries = 0;
  system->column_start = LAM_NEW(arena, int, system->size + 1);

  /* First the lengths: a scalar column c of a node has size - c rows of its own and those below. */
  for (int v = 0; v < n; v++) {
    int below = 0, size = problem->size[v];
    for (int i = p->start[v]; i < p->start[v + 1]; i++) {
      prefix[i] = below;
      below += problem->size[p->neighbor[i]];
    }
    if (problem->fixed[v]) continue;
    for (int c = 0; c < size; c++) {
      system->column_start[system->column_of_node[v] + c] = entries;
      entries += size - c + below;
    }
  }

  system->column_start[system->size] = entries;
  system->row = LAM_NEW(arena, int, entries);

  /* Then the rows: the node's own from the diagonal on, and those of its larger neighbors. */
  for (int v = 0; v < n; v++) {
    if (problem->fixed[v]) continue;
    int first = system->column_of_node[v], size = problem->size[v];
    for (int c = 0; c < size; c++) {
      int *row = system->row + system->column_start[first + c];
      for (int r = c; r < size; r++) *row++ = first + r;
      for (int i = p->start[v]; i < p->start[v + 1]; i++)
        for (int r = 0; r < problem->size[p->neighbor[i]]; r++)
          *row++ = system->column_of_node[p->neighbor[i]] + r;
    }
  }
}

/* Linear blocks stay alone, because their J'J is kept. */
static bool same_elements(const lam_block *a, const lam_block *b) {
  return !a->linear && !b->linear && a->count == b->count && a->arity == b->arity &&
         memcmp(a->nodes, b->nodes, sizeof(int) * (size_t)a->count * (size_t)a->arity) == 0;
}

/* Consecutive blocks on the same elements are evaluated and scattered as one group: the first
 * one's map has the members and the sum of their rows. */
static void find_groups(lam_system *system) {
  const lam_problem *problem = system->problem;
  for (int b = 0; b < problem->block_count;) {
    block_map *map = &system->maps[b];
    do {
      map->rows += problem->blocks[b + map->members].rows;
      map->members++;
    } while (b + map->members < problem->block_count &&
             same_elements(&problem->blocks[b], &problem->blocks[b + map->members]));
    b += map->members;
  }
}

/* The slots of a group, and the largest element so far. */
static void find_map(lam_arena *arena, lam_system *system, const pattern *p, const int *prefix,
                     int b) {
  const lam_problem *problem = system->problem;
  const lam_block *block = &problem->blocks[b];
  block_map *map = &system->maps[b];
  int pairs = block->arity * (block->arity + 1) / 2;
  if (map->members == 0) return;

  map->slot = LAM_NEW(arena, int, (size_t)block->count *(size_t)pairs);
  for (int i = 0; i < block->arity; i++) map->columns += problem->size[block->nodes[i]];
  if (map->columns > system->most_columns) system->most_columns = map->columns;
  if (map->rows > system->most_rows) system->most_rows = map->rows;

  int *slot = map->slot;
  for (int e = 0; e < block->count; e++) {
    const int *nodes = block->nodes + (size_t)e * (size_t)block->arity;
    for (int i = 0; i < block->arity; i++)
      for (int j = 0; j <= i; j++, slot++) {
        int low = nodes[i] < nodes[j] ? nodes[i] : nodes[j], high = nodes[i] + nodes[j] - low;
        if (problem->fixed[low] || problem->fixed[high])
          *slot = -1;
        else
          *slot = low == high ? 0 : find_before(p, prefix, low, high);
      }
  }
}

/* block[3 c + r] = sum_k J[k][row_at + r] J[k][column_at + c], for two nodes of 3 unknowns:
 * nearly all nodes are vertices, and loops of known length are faster. */
static void product_3x3(int rows, int n, const double *J, int row_at, int column_at,
                        double block[9]) {
  for (int i = 0; i < 9; i++) block[i] = 0;
  for (int k = 0; k < rows; k++) {
    const double *a = J + k * n + row_at, *b = J + k * n + column_at;
    for (int c = 0; c < 3; c++)
      for (int r = 0; r < 3; r++) block[3 * c + r] += a[r] * b[c];
  }
}

/* The block of a pair of nodes, any sizes: block[row_size c + r]. */
static void product(int rows, int n, const double *J, int row_at, int row_size, int column_at,
                    int column_size, double *block) {
  for (int c = 0; c < column_size; c++)
    for (int r = 0; r < row_size; r++) {
      double sum = 0;
      for (int k = 0; k < rows; k++) sum += J[k * n + row_at + r] * J[k * n + column_at + c];
      block[c * row_size + r] = sum;
    }
}

/* Adds J'J of one element (of a whole group) to values, block by block. */
static void scatter(const lam_system *system, const lam_block *block, const block_map *map,
                    int element, const double *J, double *values) {
  const lam_problem *problem = system->problem;
  const int *nodes = block->nodes + (size_t)element * (size_t)block->arity;
  const int *slot = map->slot + (size_t)element * (size_t)(block->arity * (block->arity + 1) / 2);

  double entries[largest_node * largest_node];
  for (int i = 0, at_i = 0; i < block->arity; at_i += problem->size[nodes[i]], i++)
    for (int j = 0, at_j = 0; j <= i; at_j += problem->size[nodes[j]], j++, slot++) {
      if (*slot < 0) continue;
      bool swap = nodes[i] < nodes[j]; /* the smaller node gives the column */
      int column_node = swap ? nodes[i] : nodes[j], row_node = swap ? nodes[j] : nodes[i];
      int column_at = swap ? at_i : at_j, row_at = swap ? at_j : at_i;
      int column_size = problem->size[column_node], row_size = problem->size[row_node];

      const int *start = system->column_start + system->column_of_node[column_node];
      if (column_size == 3 && row_size == 3)
        product_3x3(map->rows, map->columns, J, row_at, column_at, entries);
      else
        product(map->rows, map->columns, J, row_at, row_size, column_at, column_size, entries);

      if (row_node != column_node) {
        /* Below the diagonal block, by the slot. */
        for (int c = 0; c < column_size; c++) {
          double *to = values + start[c] + column_size - c + *slot;
          for (int r = 0; r < row_size; r++) to[r] += entries[c * row_size + r];
        }
      } else {
        /* The lower triangle; a node that an element lists twice brings its transpose too. */
        for (int c = 0; c < column_size; c++)
          for (int r = c; r < row_size; r++)
            values[start[c] + r - c] +=
                entries[c * row_size + r] + (i == j ? 0 : entries[r * row_size + c]);
      }
    }
}

/* The unknowns of one element, one after the other, to local. */
static void gather(const lam_problem *problem, const lam_block *block, int element, const double *x,
                   double *local) {
  const int *nodes = block->nodes + (size_t)element * (size_t)block->arity;
  for (int i = 0; i < block->arity; i++) {
    const double *from = x + problem->offset[nodes[i]];
    for (int c = 0; c < problem->size[nodes[i]]; c++) *local++ = from[c];
  }
}

/* The parameters of one element; NULL when the block has none. */
static const double *params_of(const lam_block *block, int element) {
  return block->params ? block->params + (size_t)element * (size_t)block->param_count : NULL;
}

/* The entries of the pattern. */
static int entry_count(const lam_system *system) { return system->column_start[system->size]; }

/* Columns for the free nodes, and the unknown behind each column. */
static void number_columns(lam_arena *arena, lam_system *system) {
  const lam_problem *problem = system->problem;
  system->column_of_node = LAM_NEW(arena, int, problem->node_count);
  for (int v = 0; v < problem->node_count; v++) {
    system->column_of_node[v] = problem->fixed[v] ? -1 : system->size;
    if (!problem->fixed[v]) system->size += problem->size[v];
  }

  system->unknown = LAM_NEW(arena, int, system->size);
  for (int v = 0; v < problem->node_count; v++)
    for (int c = 0; !problem->fixed[v] && c < problem->size[v]; c++)
      system->unknown[system->column_of_node[v] + c] = problem->offset[v] + c;
}

/* J'J of a linear block, which stays what it is. */
static void sum_linear_block(lam_arena *arena, lam_system *system, int b) {
  const lam_problem *problem = system->problem;
  const lam_block *block = &problem->blocks[b];
  block_map *map = &system->maps[b];
  map->constant = LAM_NEW(arena, double, entry_count(system));
  double *x = system->local, *r = x + system->most_columns, *J = r + system->most_rows;
  for (int e = 0; e < block->count; e++) {
    gather(problem, block, e, problem->x, x);
    block->kernel(map->columns, x, params_of(block, e), r, J);
    scatter(system, block, map, e, J, map->constant);
  }
}

/* Columns, pattern, order and maps, in this order: each needs those before it. */
lam_system *lam_system_new(lam_arena *arena, const lam_problem *problem) {
  lam_system *system = LAM_NEW(arena, lam_system, 1);
  system->problem = problem;
  number_columns(arena, system);

  pattern p = find_pattern(arena, problem);
  int *prefix = LAM_NEW(arena, int, p.start[problem->node_count] + 1);
  find_columns(arena, system, &p, prefix);
  find_order(arena, system, &p);

  system->maps = LAM_NEW(arena, block_map, problem->block_count);
  find_groups(system);
  for (int b = 0; b < problem->block_count; b++) find_map(arena, system, &p, prefix, b);

  system->local =
      LAM_NEW(arena, double, system->most_columns + system->most_rows * (1 + system->most_columns));
  for (int b = 0; b < problem->block_count; b++)
    if (problem->blocks[b].linear) sum_linear_block(arena, system, b);
  return system;
}

int lam_system_size(const lam_system *system) { return system->size; }
const int *lam_system_columns(const lam_system *system) { return system->column_start; }
const int *lam_system_rows(const lam_system *system) { return system->row; }
const int *lam_system_order(const lam_system *system) { return system->order; }
const int *lam_system_unknowns(const lam_system *system) { return system->unknown; }

/* The factor on a block of this role. */
static double role_weight(lam_weights weights, lam_role role) {
  return role == LAM_HARD ? weights.hard : role == LAM_SOFT ? weights.soft : weights.fairness;
}

/* Adds J'r of one element to the gradient. */
static void add_gradient(const lam_system *system, const lam_block *block, const block_map *map,
                         int element, const double *J, const double *r, double *gradient) {
  const lam_problem *problem = system->problem;
  const int *nodes = block->nodes + (size_t)element * (size_t)block->arity;
  for (int i = 0, at = 0; i < block->arity; at += problem->size[nodes[i]], i++) {
    int column = system->column_of_node[nodes[i]], size = problem->size[nodes[i]];
    if (column < 0) continue;
    for (int c = 0; c < size; c++)
      for (int k = 0; k < map->rows; k++)
        gradient[column + c] += J[k * map->columns + at + c] * r[k];
  }
}

/* Counts the residuals of one element of a block, and multiplies them and their Jacobian (rows x
 * columns; may be NULL) by weight. */
static void weigh(const lam_block *block, double weight, int columns, double *r, double *J,
                  lam_residual *sum, long *hard) {
  for (int k = 0; k < block->rows; k++) {
    double size = fabs(r[k]);
    if (block->role == LAM_HARD) {
      ++*hard;
      sum->rms += size * size;
      if (!(size <= sum->max)) {
        sum->max = size;
        sum->worst = block->name;
      }
    }

    r[k] *= weight;
    sum->energy += .5 * r[k] * r[k];
  }

  for (int i = 0; J && weight != 1 && i < block->rows * columns; i++) J[i] *= weight;
}

/* Residuals of all blocks; with values and gradient, the normal equations too. rms holds the sum
 * of squares until the end. */
static lam_residual pass(lam_system *system, const double *x, lam_weights weights, double *values,
                         double *gradient) {
  const lam_problem *problem = system->problem;
  lam_residual result = {0, 0, 0, NULL};
  double *local = system->local, *r = local + system->most_columns, *J = r + system->most_rows;
  long hard_count = 0;

  for (int b = 0; b < problem->block_count; b += system->maps[b].members) {
    const lam_block *block = &problem->blocks[b];
    const block_map *map = &system->maps[b];
    double weight = block->weight * role_weight(weights, block->role);
    /* A block without weight is left out, unless its residuals are judged or its group has other
     * blocks. */
    if (weight == 0 && block->role != LAM_HARD && map->members == 1) continue;

    if (values && map->constant)
      for (int k = 0, n = entry_count(system); k < n; k++)
        values[k] += weight * weight * map->constant[k];

    for (int e = 0; e < block->count; e++) {
      gather(problem, block, e, x, local);
      for (int m = 0, row = 0; m < map->members; row += block[m].rows, m++) {
        double *rows = values ? J + row * map->columns : NULL;
        block[m].kernel(map->columns, local, params_of(&block[m], e), r + row, rows);
        weigh(&block[m], block[m].weight * role_weight(weights, block[m].role), map->columns,
              r + row, rows, &result, &hard_count);
      }

      if (!values) continue;
      add_gradient(system, block, map, e, J, r, gradient);
      if (!map->constant) scatter(system, block, map, e, J, values);
    }
  }

  if (hard_count) result.rms = sqrt(result.rms / (double)hard_count);
  return result;
}

/* H and g are sums over blocks, so they begin at zero. */
lam_residual lam_system_assemble(lam_system *system, const double *x, lam_weights weights,
                                 double *values, double *gradient) {
  memset(values, 0, sizeof(double) * (size_t)entry_count(system));
  memset(gradient, 0, sizeof(double) * (size_t)system->size);
  return pass(system, x, weights, values, gradient);
}

lam_residual lam_system_residual(lam_system *system, const double *x, lam_weights weights) {
  return pass(system, x, weights, NULL, NULL);
}

void lam_system_damp(const lam_system *system, double mu, double *values) {
  for (int c = 0; c < system->size; c++) values[system->column_start[c]] += mu;
}
