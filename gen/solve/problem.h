/* A guided projection problem: unknowns, and blocks of like constraints on them. Filled by the
 * constraints of con, made and solved by net/optimize.c and surf/flatten, read by assemble.c.
 *
 * Unknowns come in nodes: nodes 0 .. vertex_count-1 are the mesh vertices (3 unknowns each);
 * further nodes of any size hold what a net truly has beside its vertices (a common radius, a
 * strip width). An element of a block lists its nodes; its kernel sees their unknowns one after
 * the other and returns residuals and their exact Jacobian. */
#ifndef LAM_SOLVE_PROBLEM_H
#define LAM_SOLVE_PROBLEM_H

#include "core/arena.h"
#include "core/vec3.h"
#include <stdbool.h>

/* Residuals r[rows] and Jacobian J[rows * n] (row-major; NULL: not wanted) of one element with n
 * unknowns x and parameters p. Pure: no allocation, no state. */
typedef void (*lam_kernel)(int n, const double *x, const double *p, double *r, double *J);

/* What a block is to the solver. */
typedef enum lam_role {
  LAM_HARD, /* must vanish: convergence is judged by it */
  /* A wish, such as proximity: keeps its weight until it is met as well as can be, then yields to
   * the hard ones. */
  LAM_SOFT,
  LAM_FAIRNESS /* weighted by the fading schedule */
} lam_role;

/* Constraints of one kind: `count` elements with the same kernel, arity and weight. */
typedef struct lam_block {
  const char *name;
  lam_kernel kernel;
  int rows;    /* residuals of an element */
  bool linear; /* the Jacobian does not depend on x or p: its normal matrix is kept */
  lam_role role;
  double weight;    /* multiplies the residuals */
  int count, arity; /* elements, nodes of an element */
  const int *nodes; /* count * arity */
  int param_count;  /* of an element */
  double *params;   /* count * param_count; may change between iterations through update */
  /* Called before every iteration with the current unknowns (node i begins at x[offset[i]]), for
   * constraints that follow a foot point; may be NULL. */
  void (*update)(struct lam_block *block, const double *x, const int *offset, void *context);
  void *context;
} lam_block;

/* Made by lam_problem_new; callers read the fields and may write fixed, x and params. */
typedef struct lam_problem {
  lam_arena *arena;
  int vertex_count;
  int node_count, node_capacity;
  int *size;   /* unknowns of a node */
  int *offset; /* first unknown of a node in x; node_count + 1 */
  bool *fixed; /* nodes that do not move */
  double *x;   /* all unknowns, offset[node_count] of them; the solvers move them */
  int block_count, block_capacity;
  lam_block *blocks;
} lam_problem;

/* A problem on vertices at positions (copied, m); nothing is fixed. arena owns it and all that is
 * added. */
lam_problem *lam_problem_new(lam_arena *arena, int vertex_count, const lam_vec3 *positions);
/* Adds a node of 1 to 8 unknowns that begin at start[size]; returns its index. May move size,
 * offset, fixed and x. Blocks added before do not change. */
int lam_problem_node(lam_problem *problem, int size, const double *start);
/* Adds a copy of a block (nothing when count is 0); nodes and params are kept by pointer. */
void lam_problem_add(lam_problem *problem, lam_block block);
/* Copies the vertices to positions[vertex_count]. */
void lam_problem_positions(const lam_problem *problem, lam_vec3 *positions);

#endif
