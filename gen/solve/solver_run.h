/* What the solvers share: a problem with its normal equations, their factorization and the
 * bookkeeping of a solution. For files of this folder only. */
#ifndef LAM_SOLVE_SOLVER_RUN_H
#define LAM_SOLVE_SOLVER_RUN_H

#include "solve/assemble.h"
#include "solve/guided.h"

typedef struct lam_run {
  lam_problem *problem;
  const lam_schedule *schedule;
  lam_system *system;
  lam_factor *factor; /* NULL when n is 0 */
  int n;              /* unknowns that are not fixed */
  double *values, *gradient, *step;
  double *trial; /* of all unknowns */
  lam_solution *solution;
} lam_run;

/* Finds the pattern and analyzes it, in the problem's arena. */
lam_run lam_run_new(lam_problem *problem, const lam_schedule *schedule, lam_solution *solution);
/* A whole solve: iterates where there are unknowns, judges the start where there are none. The
 * solver's memory is released afterwards. */
lam_solution lam_run_solve(lam_problem *problem, const lam_schedule *schedule,
                           void (*iterate)(lam_run *run, const void *context,
                                           const lam_progress *progress),
                           const void *context, const lam_progress *progress);
/* Lets blocks that follow a foot point look at the unknowns. */
void lam_run_update(const lam_run *run);
/* Assembles the normal equations at the unknowns, and notes the residual in the solution and its
 * history. */
lam_residual lam_run_assemble(lam_run *run, int iteration, lam_weights weights,
                              const lam_progress *progress);
/* Factorizes and solves (H + mu I) step = gradient; damped is what the diagonal has already. False:
 * not positive definite. */
bool lam_run_step(lam_run *run, double mu, double damped);
/* Soft blocks compete with hard ones, so both together end in a compromise. They take part until
 * the fairness is gone and a step gains less than this share of the energy, or none is left; then
 * they are dropped, and the rest of the steps satisfies the hard blocks from there. */
static const double lam_settled = .01;
bool lam_run_has_soft(const lam_run *run);
lam_weights lam_schedule_weights(const lam_schedule *schedule, int iteration);
/* Seconds that this thread has computed: other programs do not count. */
double lam_run_clock(void);

#endif
