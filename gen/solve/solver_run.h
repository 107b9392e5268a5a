/* What the solvers share: a problem with its normal equations, their factorization and the
 * bookkeeping of a solution. For guided.c and gauss_newton.c only. */
#ifndef LAM_SOLVE_SOLVER_RUN_H
#define LAM_SOLVE_SOLVER_RUN_H

#include "solve/assemble.h"
#include "solve/guided.h"

/* A solve at work. */
typedef struct lam_run {
  lam_problem *problem;
  const lam_schedule *schedule;
  lam_system *system;
  lam_factor *factor;      /* NULL when n is 0 */
  int n;                   /* unknowns that are not fixed */
  double *values;          /* of H, on the system's pattern */
  double *gradient, *step; /* n each */
  double *trial;           /* of all unknowns */
  lam_solution *solution;
} lam_run;

/* Finds the pattern and analyzes it. problem, schedule and solution are kept by pointer; the
 * memory is the problem's arena's. */
lam_run lam_run_new(lam_problem *problem, const lam_schedule *schedule, lam_solution *solution);
/* A whole solve: iterates where there are unknowns, judges the start where there are none.
 * iterate sets the reason and the verdict; context is handed to it. The solver's memory is
 * released afterwards, the history stays. */
lam_solution lam_run_solve(lam_problem *problem, const lam_schedule *schedule,
                           void (*iterate)(lam_run *run, const void *context,
                                           const lam_progress *progress),
                           const void *context, const lam_progress *progress);
/* Lets blocks that follow a foot point look at the unknowns (lam_block.update). */
void lam_run_update(const lam_run *run);
/* Assembles the normal equations at the unknowns, notes the residual in the solution and its
 * history, and tells the progress. */
lam_residual lam_run_assemble(lam_run *run, int iteration, lam_weights weights,
                              const lam_progress *progress);
/* Whether the iteration is over: at a residual that is not a number (with this reason), at
 * convergence once nothing fades any more, or at the limit of iterations. Notes the reason and
 * the verdict. */
bool lam_run_ended(lam_run *run, int iteration, const lam_residual *here, bool faded,
                   const char *not_a_number);
/* Solves (H + mu I) step = gradient; damped is what the diagonal has already. False: not positive
 * definite. */
bool lam_run_step(lam_run *run, double mu, double damped);
/* Soft blocks compete with hard ones, so both together end in a compromise. They take part until
 * the fairness is gone and a step gains less than this share of the energy, or none is left; then
 * they are dropped, and the rest of the steps satisfies the hard blocks from there. */
static const double lam_settled = .01;
/* Whether there are soft blocks. */
bool lam_run_has_soft(const lam_run *run);
/* The weights at this iteration: hard blocks 1, fairness by the schedule, soft ones 1 or fading. */
lam_weights lam_schedule_weights(const lam_schedule *schedule, int iteration);
/* Seconds that this thread has computed: other programs do not count. */
double lam_run_clock(void);

#endif
