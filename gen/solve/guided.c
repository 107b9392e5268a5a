/* Guided projection with damped steps that lower the energy, and the smoothing of noisy starts.
 * Called by net/optimize.c. */
#include "solve/solver_run.h"

#include <math.h>
#include <string.h>

/* Damping. The system (H + mu I) dx = -g is solved with mu = lambda * rms(hard residuals): close
 * to a solution mu vanishes with the residual, so the step becomes the Gauss-Newton step and
 * converges quadratically although the problem is under-determined. */
static const double lambda_start = 1e-3, lambda_min = 1e-7, lambda_max = 1e8;
static const double mu_min = 1e-12, mu_max = 1e6;
static const double shrink = .2, grow = 8;
enum {
  max_rejections = 12, /* trials of one step */
  stall_window = 30    /* iterations */
};

/* Where the step leads: trial = x - step. Returns the decrease of the energy that the quadratic
 * model promises: with d = -step and (H + mu I) d = -g, that is 1/2 (mu d.d - g.d). longest: the
 * longest move of an unknown. */
static double try_step(lam_run *r, double mu, double *longest) {
  const int *unknown = lam_system_unknowns(r->system);
  double model = 0;
  *longest = 0;
  memcpy(r->trial, r->problem->x,
         sizeof(double) * (size_t)r->problem->offset[r->problem->node_count]);
  for (int i = 0; i < r->n; i++) {
    double d = -r->step[i];
    r->trial[unknown[i]] += d;
    model += .5 * (mu * d * d - r->gradient[i] * d);
    *longest = fmax(*longest, fabs(d));
  }
  return model;
}

/* One damped step that lowers the energy. lambda follows the quality of the model (Levenberg and
 * Marquardt): it shrinks where the model is good and grows where the step is refused. Returns the
 * length of the longest move of an unknown, or a negative number when no step was found; after is
 * the residual then reached. */
static double take_step(lam_run *r, double *lambda, const lam_residual *here, lam_weights weights,
                        lam_residual *after) {
  double damped = 0; /* what the diagonal has already */
  for (int attempt = 0; attempt < max_rejections; attempt++) {
    double scale = here->rms > 0 ? fmin(here->rms, 1) : 1;
    double mu = fmin(fmax(*lambda * scale, mu_min), mu_max);
    bool definite = lam_run_step(r, mu, damped);
    damped = mu;
    if (!definite) {
      *lambda = fmin(fmax(*lambda, mu_min / scale) * grow * grow, lambda_max);
      continue;
    }

    double t = lam_run_clock(), longest, model = try_step(r, mu, &longest);
    *after = lam_system_residual(r->system, r->trial, weights);
    r->solution->seconds_assembly += lam_run_clock() - t;

    double gain = model > 0 ? (here->energy - after->energy) / model : -1;
    if (isfinite(after->energy) && after->energy < here->energy) {
      memcpy(r->problem->x, r->trial,
             sizeof(double) * (size_t)r->problem->offset[r->problem->node_count]);
      *lambda = gain > .25 ? fmax(*lambda * shrink, lambda_min) : fmin(*lambda * 2, lambda_max);
      return longest;
    }

    if (longest < 1e-13) return -1;
    *lambda = fmin(fmax(*lambda, mu_min / scale) * grow, lambda_max);
  }
  return -1;
}

/* Whether the residual has not even halved in the last stall_window iterations. */
static bool has_stalled(const lam_solution *s) {
  if (s->history_count <= stall_window) return false;
  return s->history[s->history_count - 1] > .5 * s->history[s->history_count - 1 - stall_window];
}

/* Damped steps while the weights follow the schedule. When the fairness is gone and the soft blocks
 * are met as well as can be, these are dropped; the rest of the steps satisfies the hard ones. */
static void iterate(lam_run *r, const void *context, const lam_progress *progress) {
  (void)context;
  lam_solution *s = r->solution;
  const lam_schedule *schedule = r->schedule;
  lam_residual after;
  bool soft = lam_run_has_soft(r); /* soft blocks take part */
  double lambda = lambda_start;
  int calm = 0; /* iterations since the fairness and the soft blocks ended */

  for (int k = 0;; k++) {
    lam_run_update(r);
    lam_weights weights = lam_schedule_weights(schedule, k);
    if (!soft) weights.soft = 0;
    lam_residual here = lam_run_assemble(r, k, weights, progress);
    bool faded = weights.fairness == 0 && !soft;
    calm = faded ? calm + 1 : 0;

    if (lam_run_ended(r, k, &here, faded, "the residual is not a number: the start is singular"))
      return;
    if (calm > stall_window && has_stalled(s)) {
      s->reason = "stalled: the residual no longer falls";
      return;
    }

    double moved = take_step(r, &lambda, &here, weights, &after);
    bool gained = moved >= 0 && after.energy < (1 - lam_settled) * here.energy;
    bool met = after.energy <= .5 * schedule->tolerance * schedule->tolerance;
    bool late = 4 * k >= 3 * schedule->max_iterations;
    if (soft && weights.fairness == 0 && (!gained || met || late)) {
      soft = false;
      lambda = lambda_start;
      continue;
    }

    if (moved < 0 && faded) {
      s->reason = "stalled: no step lowers the residual";
      return;
    }
    if (faded && moved >= 0 && moved < 1e-14) {
      s->reason = "stationary: the constraints contradict each other";
      return;
    }
  }
}

lam_solution lam_guided_solve(lam_problem *problem, const lam_schedule *schedule,
                              const lam_progress *progress) {
  return lam_run_solve(problem, schedule, iterate, NULL, progress);
}

/* The normal equations of the fairness blocks alone (weights 0, 0, 1), damped by weight^2. */
void lam_guided_smooth(lam_problem *problem, double weight) {
  lam_arena_mark mark = lam_arena_mark_get(problem->arena);
  lam_schedule schedule = lam_schedule_default();
  lam_solution solution = {0};
  lam_run r = lam_run_new(problem, &schedule, &solution);

  if (r.n > 0) {
    lam_weights weights = {0, 0, 1};
    const int *unknown = lam_system_unknowns(r.system);

    lam_system_assemble(r.system, problem->x, weights, r.values, r.gradient);
    lam_system_damp(r.system, weight * weight, r.values);
    if (lam_factor_refactor(r.factor, r.values)) {
      lam_factor_solve(r.factor, r.gradient, r.step);
      for (int i = 0; i < r.n; i++) problem->x[unknown[i]] -= r.step[i];
    }
  }

  lam_arena_release(problem->arena, mark);
}
