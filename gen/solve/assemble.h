/* Normal equations of a problem: H = sum w^2 J'J and g = sum w^2 J'r, straight into a
 * compressed-column pattern that is found once. */
#ifndef LAM_SOLVE_ASSEMBLE_H
#define LAM_SOLVE_ASSEMBLE_H

#include "solve/problem.h"

typedef struct lam_system lam_system;

/* Finds the pattern and the element-to-entry maps. Fixed nodes have no columns. */
lam_system *lam_system_new(lam_arena *arena, const lam_problem *problem);
int lam_system_size(const lam_system *system);
const int *lam_system_columns(const lam_system *system);
const int *lam_system_rows(const lam_system *system);
/* Fill-reducing order: AMD on the graph of nodes, expanded to unknowns. */
const int *lam_system_order(const lam_system *system);
/* The unknown of the problem behind each column. */
const int *lam_system_unknowns(const lam_system *system);

/* Weights of the roles at this iteration. */
typedef struct lam_weights {
  double hard, soft, fairness;
} lam_weights;

/* Sum of w^2 r^2 / 2 at x, and the largest |r| and the root mean square of the hard blocks
 * (unweighted). */
typedef struct lam_residual {
  double energy, max, rms;
  const char *worst; /* name of the block with the largest residual */
} lam_residual;

/* H + mu I goes to values (mu is added by the caller through lam_system_damp), the gradient to
 * gradient. */
lam_residual lam_system_assemble(lam_system *system, const double *x, lam_weights weights,
                                 double *values, double *gradient);
lam_residual lam_system_residual(lam_system *system, const double *x, lam_weights weights);
/* Adds mu to the diagonal. */
void lam_system_damp(const lam_system *system, double mu, double *values);

#endif
