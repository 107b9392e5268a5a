/* Guided projection: damped Gauss-Newton with fading fairness (thesis 3.7, in the form with the
 * vertices as unknowns). Called by net/optimize.c. */
#ifndef LAM_SOLVE_GUIDED_H
#define LAM_SOLVE_GUIDED_H

#include "core/progress.h"
#include "solve/factor.h"
#include "solve/problem.h"

/* How the weights go, and when the iteration ends. */
typedef struct lam_schedule {
  double fairness;  /* weight at the start; 0: none */
  int hold;         /* iterations at the start weight */
  double decay;     /* factor per iteration afterwards */
  double floor;     /* below this the weight becomes 0 */
  double tolerance; /* on the largest hard residual (mean edge length = 1) */
  int max_iterations;
  bool fade_soft; /* soft blocks fade with the fairness too: terms of a guide */
} lam_schedule;

/* What a solve came to. */
typedef struct lam_solution {
  bool converged;
  const char *reason; /* why it ended, a static text; never NULL */
  int iterations;     /* accepted steps */
  int factorizations;
  double residual, rms; /* of the hard blocks, at the end: largest and root mean square */
  const char *worst;    /* hard block with the largest residual; NULL: all are 0 */
  int history_count;
  double *history; /* history_count; largest hard residual before the first and after every step */
  /* Processor time of the thread, s. */
  double seconds_analysis; /* pattern and symbolic analysis, once */
  double seconds_assembly, seconds_factor, seconds_solve, seconds_total;
  lam_factor_stats factor;
  int unknowns, residuals;
} lam_solution;

/* No fairness, tolerance 1e-12, at most 100 iterations. */
lam_schedule lam_schedule_default(void);
/* Iterations until the fairness is gone. */
int lam_schedule_fade(const lam_schedule *schedule);
/* Solves in place (problem->x) in damped steps that never raise the energy. Non-convergence is a
 * result, not an error. The history is owned by the problem's arena. progress may be NULL. */
lam_solution lam_guided_solve(lam_problem *problem, const lam_schedule *schedule,
                              const lam_progress *progress);
/* The same with full Gauss-Newton steps and the constant damping epsilon^2 of thesis 3.7. Nothing
 * keeps the residual from rising; soft blocks keep their weight until the fairness is gone, then
 * they are dropped. epsilon > 0. */
lam_solution lam_gauss_newton_solve(lam_problem *problem, const lam_schedule *schedule,
                                    double epsilon, const lam_progress *progress);
/* One linear solve that minimizes the fairness blocks and (closeness to the start)^2 * weight^2:
 * for noisy starts. Moves problem->x; leaves it where the matrix is not positive definite. */
void lam_guided_smooth(lam_problem *problem, double weight);

#endif
