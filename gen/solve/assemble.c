#include "solve/assemble.h"
#include "solve/factor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The pattern is found on nodes. Column node J of the lower triangle holds its diagonal block first and then the blocks of the
 * nodes I > J that share an element with it. The entries of block (I, J) in scalar column (J, c) start at
 *   column_start[J0 + c] + (size_J - c) + before(I, J),   the diagonal block's at column_start[J0 + c],
 * so that one integer per node pair of an element, before(I, J), is all that the scatter needs. */
typedef struct block_map {
  int columns;      /* unknowns of an element */
  int *slot;        /* per element and pair a >= b of its nodes: before(I, J), or -1 when either is fixed */
  double *constant; /* linear blocks: J'J of the whole block at weight 1; NULL otherwise */
} block_map;

struct lam_system {
  const lam_problem *problem;
  int size;
  int *column_start, *row, *order, *unknown;
  int *column_of_node; /* first column of a node, -1 when fixed */
  block_map *maps;
  double *local;       /* scratch: x, r, J of one element */
  int most_columns, most_rows;
};

typedef struct pattern {
  int *start, *neighbor; /* per node, ascending, larger free nodes only */
} pattern;

static int compare_int(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* Larger neighbors of every free node, sorted and unique. */
static pattern find_pattern(lam_arena *arena, const lam_problem *problem) {
  int n = problem->node_count;
  size_t *count = LAM_NEW(arena, size_t, n + 1);
  for (int pass = 0;; pass++) {
    int *list = pass == 0 ? NULL : LAM_NEW(arena, int, count[n]);
    size_t *fill = pass == 0 ? NULL : LAM_NEW(arena, size_t, n);
    for (int b = 0; b < problem->block_count; b++) {
      const lam_block *block = &problem->blocks[b];
      for (int e = 0; e < block->count; e++) {
        const int *nodes = block->nodes + (size_t)e * (size_t)block->arity;
        for (int i = 0; i < block->arity; i++)
          for (int j = 0; j < i; j++) {
            int low = nodes[i] < nodes[j] ? nodes[i] : nodes[j], high = nodes[i] + nodes[j] - low;
            if (low == high || problem->fixed[low] || problem->fixed[high]) continue;
            if (list) list[count[low] + fill[low]++] = high;
            else count[low + 1]++;
          }
      }
    }
    if (!list) {
      for (int v = 0; v < n; v++) count[v + 1] += count[v];
      continue;
    }
    pattern p = {LAM_NEW(arena, int, n + 1), list};
    int kept = 0;
    for (int v = 0; v < n; v++) {
      int *mine = list + count[v], total = (int)(count[v + 1] - count[v]);
      qsort(mine, (size_t)total, sizeof(int), compare_int);
      p.start[v] = kept;
      for (int i = 0; i < total; i++)
        if (i == 0 || mine[i] != mine[i - 1]) list[kept++] = mine[i];
    }
    p.start[n] = kept;
    return p;
  }
}

/* AMD on the graph of free nodes, then every node's unknowns in a row. */
static void find_order(lam_arena *arena, lam_system *system, const pattern *p) {
  const lam_problem *problem = system->problem;
  int n = problem->node_count, free_count = 0;
  int *compact = LAM_NEW(arena, int, n), *node = LAM_NEW(arena, int, n);
  for (int v = 0; v < n; v++)
    if (!problem->fixed[v]) {
      compact[v] = free_count;
      node[free_count++] = v;
    }
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

static int find_before(const pattern *p, const int *prefix, int low, int high) {
  int a = p->start[low], b = p->start[low + 1] - 1;
  while (a < b) {
    int middle = (a + b) / 2;
    if (p->neighbor[middle] < high) a = middle + 1;
    else b = middle;
  }
  return prefix[a];
}

static void find_columns(lam_arena *arena, lam_system *system, const pattern *p, int *prefix) {
  const lam_problem *problem = system->problem;
  int n = problem->node_count, entries = 0;
  system->column_start = LAM_NEW(arena, int, system->size + 1);
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
  for (int v = 0; v < n; v++) {
    if (problem->fixed[v]) continue;
    int first = system->column_of_node[v], size = problem->size[v];
    for (int c = 0; c < size; c++) {
      int *row = system->row + system->column_start[first + c];
      for (int r = c; r < size; r++) *row++ = first + r;
      for (int i = p->start[v]; i < p->start[v + 1]; i++)
        for (int r = 0; r < problem->size[p->neighbor[i]]; r++) *row++ = system->column_of_node[p->neighbor[i]] + r;
    }
  }
}

static void find_map(lam_arena *arena, lam_system *system, const pattern *p, const int *prefix, int b) {
  const lam_problem *problem = system->problem;
  const lam_block *block = &problem->blocks[b];
  block_map *map = &system->maps[b];
  int pairs = block->arity * (block->arity + 1) / 2;
  map->slot = LAM_NEW(arena, int, (size_t)block->count * (size_t)pairs);
  for (int i = 0; i < block->arity; i++) map->columns += problem->size[block->nodes[i]];
  if (map->columns > system->most_columns) system->most_columns = map->columns;
  if (block->rows > system->most_rows) system->most_rows = block->rows;
  int *slot = map->slot;
  for (int e = 0; e < block->count; e++) {
    const int *nodes = block->nodes + (size_t)e * (size_t)block->arity;
    for (int i = 0; i < block->arity; i++)
      for (int j = 0; j <= i; j++, slot++) {
        int low = nodes[i] < nodes[j] ? nodes[i] : nodes[j], high = nodes[i] + nodes[j] - low;
        if (problem->fixed[low] || problem->fixed[high]) *slot = -1;
        else *slot = low == high ? 0 : find_before(p, prefix, low, high);
      }
  }
}

/* Adds scale * J'J of one element. */
static void scatter(const lam_system *system, const lam_block *block, const block_map *map, int element, double scale,
                    const double *J, double *values) {
  const lam_problem *problem = system->problem;
  const int *nodes = block->nodes + (size_t)element * (size_t)block->arity;
  const int *slot = map->slot + (size_t)element * (size_t)(block->arity * (block->arity + 1) / 2);
  int n = map->columns, rows = block->rows;
  for (int i = 0, at_i = 0; i < block->arity; at_i += problem->size[nodes[i]], i++)
    for (int j = 0, at_j = 0; j <= i; at_j += problem->size[nodes[j]], j++, slot++) {
      if (*slot < 0) continue;
      bool swap = nodes[i] < nodes[j]; /* the smaller node gives the column */
      int column_node = swap ? nodes[i] : nodes[j], row_node = swap ? nodes[j] : nodes[i];
      int column_at = swap ? at_i : at_j, row_at = swap ? at_j : at_i;
      int column_size = problem->size[column_node], row_size = problem->size[row_node];
      int first = system->column_of_node[column_node];
      bool same = row_node == column_node, diagonal = i == j;
      for (int c = 0; c < column_size; c++) {
        double *entry = values + system->column_start[first + c] + (same ? -c : column_size - c + *slot);
        for (int r = same ? c : 0; r < row_size; r++) {
          double sum = 0;
          for (int k = 0; k < rows; k++) sum += J[k * n + row_at + r] * J[k * n + column_at + c];
          if (same && !diagonal) /* a node that an element lists twice */
            for (int k = 0; k < rows; k++) sum += J[k * n + row_at + c] * J[k * n + column_at + r];
          entry[r] += scale * sum;
        }
      }
    }
}

static void gather(const lam_problem *problem, const lam_block *block, int element, const double *x, double *local) {
  const int *nodes = block->nodes + (size_t)element * (size_t)block->arity;
  for (int i = 0; i < block->arity; i++) {
    const double *from = x + problem->offset[nodes[i]];
    for (int c = 0; c < problem->size[nodes[i]]; c++) *local++ = from[c];
  }
}

static const double *params_of(const lam_block *block, int element) {
  return block->params ? block->params + (size_t)element * (size_t)block->param_count : NULL;
}

static int entry_count(const lam_system *system) { return system->column_start[system->size]; }

lam_system *lam_system_new(lam_arena *arena, const lam_problem *problem) {
  lam_system *system = LAM_NEW(arena, lam_system, 1);
  system->problem = problem;
  system->column_of_node = LAM_NEW(arena, int, problem->node_count);
  for (int v = 0; v < problem->node_count; v++) {
    system->column_of_node[v] = problem->fixed[v] ? -1 : system->size;
    if (!problem->fixed[v]) system->size += problem->size[v];
  }
  system->unknown = LAM_NEW(arena, int, system->size);
  for (int v = 0; v < problem->node_count; v++)
    for (int c = 0; !problem->fixed[v] && c < problem->size[v]; c++)
      system->unknown[system->column_of_node[v] + c] = problem->offset[v] + c;
  pattern p = find_pattern(arena, problem);
  int *prefix = LAM_NEW(arena, int, p.start[problem->node_count] + 1);
  find_columns(arena, system, &p, prefix);
  find_order(arena, system, &p);
  system->maps = LAM_NEW(arena, block_map, problem->block_count);
  for (int b = 0; b < problem->block_count; b++) find_map(arena, system, &p, prefix, b);
  system->local = LAM_NEW(arena, double, system->most_columns + system->most_rows * (1 + system->most_columns));
  for (int b = 0; b < problem->block_count; b++) {
    const lam_block *block = &problem->blocks[b];
    if (!block->linear) continue;
    block_map *map = &system->maps[b];
    map->constant = LAM_NEW(arena, double, entry_count(system));
    double *x = system->local, *r = x + system->most_columns, *J = r + system->most_rows;
    for (int e = 0; e < block->count; e++) {
      gather(problem, block, e, problem->x, x);
      block->kernel(map->columns, x, params_of(block, e), r, J);
      scatter(system, block, map, e, 1, J, map->constant);
    }
  }
  return system;
}

int lam_system_size(const lam_system *system) { return system->size; }
const int *lam_system_columns(const lam_system *system) { return system->column_start; }
const int *lam_system_rows(const lam_system *system) { return system->row; }
const int *lam_system_order(const lam_system *system) { return system->order; }
const int *lam_system_unknowns(const lam_system *system) { return system->unknown; }

static double role_weight(lam_weights weights, lam_role role) {
  return role == LAM_HARD ? weights.hard : role == LAM_SOFT ? weights.soft : weights.fairness;
}

/* Residuals of all blocks; with values and gradient, the normal equations too. */
static lam_residual pass(lam_system *system, const double *x, lam_weights weights, double *values, double *gradient) {
  const lam_problem *problem = system->problem;
  lam_residual result = {0, 0, 0, NULL};
  double *local = system->local, *r = local + system->most_columns, *J = r + system->most_rows;
  long hard_count = 0;
  for (int b = 0; b < problem->block_count; b++) {
    const lam_block *block = &problem->blocks[b];
    const block_map *map = &system->maps[b];
    double weight = block->weight * role_weight(weights, block->role), scale = weight * weight;
    if (scale == 0 && block->role != LAM_HARD) continue;
    if (values && map->constant)
      for (int k = 0, n = entry_count(system); k < n; k++) values[k] += scale * map->constant[k];
    for (int e = 0; e < block->count; e++) {
      gather(problem, block, e, x, local);
      block->kernel(map->columns, local, params_of(block, e), r, values ? J : NULL);
      for (int k = 0; k < block->rows; k++) {
        result.energy += .5 * scale * r[k] * r[k];
        if (block->role != LAM_HARD) continue;
        hard_count++;
        result.rms += r[k] * r[k];
        if (!(fabs(r[k]) <= result.max)) {
          result.max = fabs(r[k]);
          result.worst = block->name;
        }
      }
      if (!values) continue;
      const int *nodes = block->nodes + (size_t)e * (size_t)block->arity;
      for (int i = 0, at = 0; i < block->arity; i++) {
        int column = system->column_of_node[nodes[i]], size = problem->size[nodes[i]];
        for (int c = 0; c < size && column >= 0; c++)
          for (int k = 0; k < block->rows; k++) gradient[column + c] += scale * J[k * map->columns + at + c] * r[k];
        at += size;
      }
      if (!map->constant) scatter(system, block, map, e, scale, J, values);
    }
  }
  if (hard_count) result.rms = sqrt(result.rms / (double)hard_count);
  return result;
}

lam_residual lam_system_assemble(lam_system *system, const double *x, lam_weights weights, double *values,
                                 double *gradient) {
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
