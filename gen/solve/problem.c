/* Building a problem: nodes and blocks are appended. Called by con (blocks and their auxiliary
 * nodes), net/optimize.c and surf/flatten. */
#include "solve/problem.h"

#include "core/grow.h"

#include <assert.h>
#include <string.h>

/* Node v is vertex v: its unknowns are x[3 v .. 3 v + 2]. */
lam_problem *lam_problem_new(lam_arena *arena, int vertex_count, const lam_vec3 *positions) {
  lam_problem *problem = LAM_NEW(arena, lam_problem, 1);
  problem->arena = arena;
  problem->vertex_count = problem->node_count = problem->node_capacity = vertex_count;
  problem->size = LAM_NEW(arena, int, vertex_count);
  problem->offset = LAM_NEW(arena, int, vertex_count + 1);
  problem->fixed = LAM_NEW(arena, bool, vertex_count);
  problem->x = LAM_NEW(arena, double, 3 * vertex_count);

  for (int v = 0; v < vertex_count; v++) {
    problem->size[v] = 3;
    problem->offset[v + 1] = 3 * (v + 1);
    problem->x[3 * v] = positions[v].x;
    problem->x[3 * v + 1] = positions[v].y;
    problem->x[3 * v + 2] = positions[v].z;
  }

  return problem;
}

enum { LARGEST_NODE = 8 }; /* unknowns */

/* Half as much room again for nodes; four arrays share one capacity. */
static void grow_nodes(lam_problem *problem) {
  int n = problem->node_count, unknowns = problem->offset[n], capacity = n + n / 2 + 16;
  int *sizes = LAM_NEW(problem->arena, int, capacity),
      *offsets = LAM_NEW(problem->arena, int, capacity + 1);
  bool *fixed = LAM_NEW(problem->arena, bool, capacity);
  double *x = LAM_NEW(problem->arena, double, unknowns + LARGEST_NODE * (capacity - n));

  memcpy(sizes, problem->size, sizeof(int) * (size_t)n);
  memcpy(offsets, problem->offset, sizeof(int) * (size_t)(n + 1));
  memcpy(fixed, problem->fixed, sizeof(bool) * (size_t)n);
  memcpy(x, problem->x, sizeof(double) * (size_t)unknowns);

  problem->size = sizes;
  problem->offset = offsets;
  problem->fixed = fixed;
  problem->x = x;
  problem->node_capacity = capacity;
}

/* The unknowns of the new node follow those of the last one. */
int lam_problem_node(lam_problem *problem, int size, const double *start) {
  assert(size > 0 && size <= LARGEST_NODE);
  if (problem->node_count == problem->node_capacity) grow_nodes(problem);

  int n = problem->node_count++, unknowns = problem->offset[n];
  problem->size[n] = size;
  problem->offset[n + 1] = unknowns + size;
  memcpy(problem->x + unknowns, start, sizeof(double) * (size_t)size);
  return n;
}

void lam_problem_add(lam_problem *problem, lam_block block) {
  if (block.count == 0) return;
  assert(block.kernel && block.rows > 0 && block.arity > 0 && block.nodes);
  LAM_APPEND(problem->arena, problem->blocks, problem->block_count, problem->block_capacity, block);
}

void lam_problem_positions(const lam_problem *problem, lam_vec3 *positions) {
  for (int v = 0; v < problem->vertex_count; v++)
    positions[v] = lam_v3(problem->x[3 * v], problem->x[3 * v + 1], problem->x[3 * v + 2]);
}
