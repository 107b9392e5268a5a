/* Normal equations the slow and plain way: dense, one element after the other, from the kernels
 * alone. */
#ifndef LAM_TESTS_SOLVE_FIXTURE_H
#define LAM_TESTS_SOLVE_FIXTURE_H

#include "net_fixture.h"
#include "solve/assemble.h"
#include "solve/factor.h"

typedef struct dense_system {
  int n;         /* unknowns of free nodes, in the order of x */
  double *H, *g; /* n x n, n */
  double energy, max, rms;
} dense_system;

static inline double dense_weight(const lam_block *block, lam_weights weights) {
  double role[] = {
      [LAM_HARD] = weights.hard, [LAM_SOFT] = weights.soft, [LAM_FAIRNESS] = weights.fairness};
  return block->weight * role[block->role];
}

/* Local unknowns of an element: their places in x go to at, the number is returned. */
static inline int element_unknowns(const lam_problem *problem, const lam_block *block, int element,
                                   int *at) {
  int n = 0;
  for (int i = 0; i < block->arity; i++) {
    int node = block->nodes[element * block->arity + i];
    for (int c = 0; c < problem->size[node]; c++) at[n++] = problem->offset[node] + c;
  }
  return n;
}

static inline const double *element_params(const lam_block *block, int element) {
  return block->params ? block->params + element * block->param_count : NULL;
}

/* H = sum w^2 J'J, g = sum w^2 J'r over the free unknowns. */
static inline dense_system dense_assemble(lam_arena *arena, const lam_problem *problem,
                                          const double *x, lam_weights weights) {
  int all = problem->offset[problem->node_count], *column = LAM_NEW(arena, int, all),
      *at = LAM_NEW(arena, int, all + 64);
  dense_system d = {0};
  for (int v = 0; v < problem->node_count; v++)
    for (int c = 0; c < problem->size[v]; c++)
      column[problem->offset[v] + c] = problem->fixed[v] ? -1 : d.n++;
  d.H = LAM_NEW(arena, double, d.n *d.n);
  d.g = LAM_NEW(arena, double, d.n);
  long hard = 0;
  for (int b = 0; b < problem->block_count; b++) {
    const lam_block *block = &problem->blocks[b];
    double w = dense_weight(block, weights);
    for (int e = 0; e < block->count; e++) {
      int n = element_unknowns(problem, block, e, at);
      double *local = LAM_NEW(arena, double, n), *r = LAM_NEW(arena, double, block->rows);
      double *J = LAM_NEW(arena, double, block->rows *n);
      for (int i = 0; i < n; i++) local[i] = x[at[i]];
      block->kernel(n, local, element_params(block, e), r, J);
      for (int k = 0; k < block->rows; k++) {
        d.energy += .5 * w * w * r[k] * r[k];
        if (block->role == LAM_HARD) {
          hard++;
          d.rms += r[k] * r[k];
          d.max = fmax(d.max, fabs(r[k]));
        }
        for (int i = 0; i < n; i++) {
          if (column[at[i]] < 0) continue;
          d.g[column[at[i]]] += w * w * J[k * n + i] * r[k];
          for (int j = 0; j < n; j++)
            if (column[at[j]] >= 0)
              d.H[column[at[i]] * d.n + column[at[j]]] += w * w * J[k * n + i] * J[k * n + j];
        }
      }
    }
  }
  if (hard) d.rms = sqrt(d.rms / (double)hard);
  return d;
}

/* The lower triangle of a system as a full symmetric matrix. */
static inline double *dense_values(lam_arena *arena, const lam_system *system,
                                   const double *values) {
  int n = lam_system_size(system);
  const int *start = lam_system_columns(system), *row = lam_system_rows(system);
  double *H = LAM_NEW(arena, double, n *n);
  for (int c = 0; c < n; c++)
    for (int k = start[c]; k < start[c + 1]; k++) H[row[k] * n + c] = H[c * n + row[k]] = values[k];
  return H;
}

/* Fails unless the assembled system equals the dense one, to rounding. */
static inline void assert_system(lam_arena *arena, const lam_problem *problem, const double *x,
                                 lam_weights weights) {
  dense_system d = dense_assemble(arena, problem, x, weights);
  lam_system *system = lam_system_new(arena, problem);
  int n = lam_system_size(system);
  assert_int_equal(n, d.n);
  double *values = LAM_NEW(arena, double, lam_system_columns(system)[n]),
         *gradient = LAM_NEW(arena, double, n);
  lam_residual r = lam_system_assemble(system, x, weights, values, gradient);
  double *H = dense_values(arena, system, values), scale = 0, slope = 0;
  for (int i = 0; i < n * n; i++) scale = fmax(scale, fabs(d.H[i]));
  for (int i = 0; i < n; i++) slope = fmax(slope, fabs(d.g[i]));
  for (int i = 0; i < n * n; i++) assert_near(H[i], d.H[i], 1e-13 * scale);
  for (int i = 0; i < n; i++) assert_near(gradient[i], d.g[i], 1e-13 * (slope + scale));
  assert_near(r.energy, d.energy, 1e-13 * (1 + d.energy));
  assert_near(r.max, d.max, 0);
  assert_near(r.rms, d.rms, 1e-13 * (1 + d.rms));
}

#endif
