/* Gauss-Newton as the thesis has it: full steps, constant damping. Called by net/optimize.c where
 * a design asks for it; guided.c is the solver with damped steps. */
#include "solve/solver_run.h"

#include <math.h>

/* Takes the whole step, x = x - step, and returns the longest move of an unknown. */
static double take_full_step(lam_run *r) {
  const int *unknown = lam_system_unknowns(r->system);
  double longest = 0;
  for (int i = 0; i < r->n; i++) {
    r->problem->x[unknown[i]] -= r->step[i];
    longest = fmax(longest, fabs(r->step[i]));
  }
  return longest;
}

/* Thesis 3.7, with every equation linearized at X_n:
 *   ||H X - r||^2 + ||K X - s||^2 + eps^2 ||X - X_n||^2 -> min,
 *   (H'H + K'K + eps^2 I) X = H'r + K's + eps^2 X_n,
 * and the whole step is taken, whatever it does to the residual. H'H + K'K is what the assembler
 * makes, and its gradient at X_n is H'phi + K'(K X_n - s), so X = X_n - step. Reported is |phi(X)|
 * itself, not the linearized ||H X - r||, which is smaller by orders while steps are long. */
static void iterate(lam_run *r, const void *context, const lam_progress *progress) {
  double epsilon = *(const double *)context;
  const lam_schedule *schedule = r->schedule;
  bool soft = lam_run_has_soft(r); /* soft blocks take part */
  double energy = INFINITY;        /* before the last step; infinite while the fairness fades */

  for (int k = 0;; k++) {
    lam_run_update(r);
    lam_weights weights = lam_schedule_weights(schedule, k);
    if (!soft) weights.soft = 0;
    lam_residual here = lam_run_assemble(r, k, weights, progress);
    bool faded = weights.fairness == 0 && !soft;

    /* Soft blocks are dropped from the next step on: once steps gain little, or late. */
    bool late = 4 * k >= 3 * schedule->max_iterations;
    bool settled = here.energy > (1 - lam_settled) * energy;
    if (soft && weights.fairness == 0 && (late || settled)) soft = false;
    energy = weights.fairness == 0 ? here.energy : INFINITY;

    const char *not_a_number =
        k ? "the residual is not a number: full steps have left the net's neighborhood"
          : "the residual is not a number: the start is singular";
    if (lam_run_ended(r, k, &here, faded, not_a_number)) return;
    if (!lam_run_step(r, epsilon * epsilon, 0)) {
      r->solution->reason = "the normal equations are not positive definite: epsilon is too small";
      return;
    }

    if (take_full_step(r) < 1e-14 && faded) {
      r->solution->reason = "stationary: the constraints contradict each other";
      r->solution->iterations = k + 1;
      return;
    }
  }
}

lam_solution lam_gauss_newton_solve(lam_problem *problem, const lam_schedule *schedule,
                                    double epsilon, const lam_progress *progress) {
  return lam_run_solve(problem, schedule, iterate, &epsilon, progress);
}
