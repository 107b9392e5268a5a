#include "solve/problem.h"

#include <assert.h>
#include <string.h>

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

int lam_problem_node(lam_problem *problem, int size, const double *start) {
  assert(size > 0);
  int n = problem->node_count, unknowns = problem->offset[n];
  if (n == problem->node_capacity) {
    int capacity = n + n / 2 + 16;
    int *sizes = LAM_NEW(problem->arena, int, capacity),
        *offsets = LAM_NEW(problem->arena, int, capacity + 1);
    bool *fixed = LAM_NEW(problem->arena, bool, capacity);
    double *x = LAM_NEW(problem->arena, double, unknowns + 8 * (capacity - n));
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
  assert(size <= 8);
  problem->size[n] = size;
  problem->offset[n + 1] = unknowns + size;
  memcpy(problem->x + unknowns, start, sizeof(double) * (size_t)size);
  problem->node_count++;
  return n;
}

void lam_problem_add(lam_problem *problem, lam_block block) {
  if (block.count == 0) return;
  assert(block.kernel && block.rows > 0 && block.arity > 0 && block.nodes);
  if (problem->block_count == problem->block_capacity) {
    int capacity = 2 * problem->block_capacity + 8;
    lam_block *blocks = LAM_NEW(problem->arena, lam_block, capacity);
    if (problem->block_count)
      memcpy(blocks, problem->blocks, sizeof *blocks * (size_t)problem->block_count);
    problem->blocks = blocks;
    problem->block_capacity = capacity;
  }
  problem->blocks[problem->block_count++] = block;
}

void lam_problem_positions(const lam_problem *problem, lam_vec3 *positions) {
  for (int v = 0; v < problem->vertex_count; v++)
    positions[v] = lam_v3(problem->x[3 * v], problem->x[3 * v + 1], problem->x[3 * v + 2]);
}
