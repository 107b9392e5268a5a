#include "solve/solver_run.h"

#include <math.h>

/* Thesis 3.7: with every equation linearized at X_n,
 *   ||H X - r||^2 + ||K X - s||^2 + eps^2 ||X - X_n||^2 -> min,   (H'H + K'K + eps^2 I) X = H'r +
 * K's + eps^2 X_n, and the whole step is taken, whatever it does to the residual. H'H + K'K is what
 * the assembler makes, and its gradient at X_n is H'phi + K'(K X_n - s), so X = X_n - step.
 * Reported is |phi(X)| itself, not the linearized ||H X - r||, which is smaller by orders while
 * steps are long. */
static void iterate(lam_run *r, const void *context, const lam_progress *progress) {
  double epsilon = *(const double *)context;
  lam_solution *s = r->solution;
  const int *unknown = lam_system_unknowns(r->system);
  bool soft = lam_run_has_soft(r);
  double energy = INFINITY; /* before the last step */
  for (int k = 0;; k++) {
    lam_run_update(r);
    lam_weights weights = lam_schedule_weights(r->schedule, k);
    if (!soft) weights.soft = 0;
    lam_residual here = lam_run_assemble(r, k, weights, progress);
    bool faded = weights.fairness == 0 && !soft;
    bool late = 4 * k >= 3 * r->schedule->max_iterations;
    if (soft && weights.fairness == 0 && (late || here.energy > (1 - lam_settled) * energy))
      soft = false;
    energy = weights.fairness == 0 ? here.energy : INFINITY;
    if (!isfinite(here.energy)) {
      s->reason = k ? "the residual is not a number: full steps have left the net's neighborhood"
                    : "the residual is not a number: the start is singular";
      return;
    }
    if (faded && here.max <= r->schedule->tolerance) {
      s->converged = true;
      s->reason = "converged";
      return;
    }
    if (k >= r->schedule->max_iterations) {
      s->reason = "the limit of iterations was reached";
      return;
    }
    if (!lam_run_step(r, epsilon * epsilon, 0)) {
      s->reason = "the normal equations are not positive definite: epsilon is too small";
      return;
    }
    double longest = 0;
    for (int i = 0; i < r->n; i++) {
      r->problem->x[unknown[i]] -= r->step[i];
      longest = fmax(longest, fabs(r->step[i]));
    }
    if (faded && longest < 1e-14) {
      s->reason = "stationary: the constraints contradict each other";
      s->iterations = k + 1;
      return;
    }
  }
}

lam_solution lam_gauss_newton_solve(lam_problem *problem, const lam_schedule *schedule,
                                    double epsilon, const lam_progress *progress) {
  return lam_run_solve(problem, schedule, iterate, &epsilon, progress);
}
