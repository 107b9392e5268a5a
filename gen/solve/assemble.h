/* Normal equations of a problem: H = sum w^2 J'J and g = sum w^2 J'r, straight into a
 * compressed-column pattern that is found once. Used by solver_run.c, by
 * surf/flatten/flatten_system.c and by the benchmarks. */
#ifndef LAM_SOLVE_ASSEMBLE_H
#define LAM_SOLVE_ASSEMBLE_H

#include "solve/problem.h"

typedef struct lam_system lam_system;

/* Finds the pattern and the element-to-entry maps. Fixed nodes have no columns. problem is kept
 * by pointer: its nodes, blocks and fixed must not change while the system is used; x, params and
 * weights may. */
lam_system *lam_system_new(lam_arena *arena, const lam_problem *problem);
/* The number of columns n, which is that of unknowns that are not fixed. */
int lam_system_size(const lam_system *system);
/* The lower triangle of H by columns: column c has the rows lam_system_rows[i] for
 * lam_system_columns[c] <= i < lam_system_columns[c + 1], ascending, the diagonal first. */
const int *lam_system_columns(const lam_system *system);
const int *lam_system_rows(const lam_system *system);
/* Fill-reducing order of the n columns: AMD on the graph of nodes, expanded to unknowns. */
const int *lam_system_order(const lam_system *system);
/* The unknown of the problem (index into x) behind each of the n columns. */
const int *lam_system_unknowns(const lam_system *system);

/* Factors on the blocks' own weights, by role, at this iteration. */
typedef struct lam_weights {
  double hard, soft, fairness;
} lam_weights;

/* What the residuals are at some x. */
typedef struct lam_residual {
  double energy;     /* sum of w^2 r^2 / 2 over all blocks */
  double max, rms;   /* largest |r| and root mean square of the hard blocks, unweighted */
  const char *worst; /* name of the hard block with the largest residual; NULL: all are 0 */
} lam_residual;

/* Assembles at x: H goes to values (as many as the pattern has entries), the gradient g to
 * gradient[n]. The diagonal is damped by lam_system_damp afterwards. */
lam_residual lam_system_assemble(lam_system *system, const double *x, lam_weights weights,
                                 double *values, double *gradient);
/* The residuals alone: no Jacobians. */
lam_residual lam_system_residual(lam_system *system, const double *x, lam_weights weights);
/* Adds mu to the diagonal of H. */
void lam_system_damp(const lam_system *system, double mu, double *values);

#endif
