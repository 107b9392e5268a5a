#include "solve/guided.h"
#include "solve/assemble.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Damping. The system (H + mu I) dx = -g is solved with mu = lambda * rms(hard residuals): close to a solution mu
 * vanishes with the residual, so the step becomes the Gauss-Newton step and converges quadratically although the
 * problem is under-determined. */
static const double lambda_start = 1e-3, lambda_min = 1e-7, lambda_max = 1e8;
static const double mu_min = 1e-12, mu_max = 1e6;
static const double shrink = .2, grow = 8;
enum { max_rejections = 12, stall_window = 12 };

lam_schedule lam_schedule_default(void) {
  return (lam_schedule){
      .fairness = 0, .hold = 0, .decay = .5, .floor = 1e-3, .tolerance = 1e-12, .max_iterations = 100};
}

typedef struct run {
  lam_problem *problem;
  const lam_schedule *schedule;
  lam_system *system;
  lam_factor *factor;
  int n;
  double *values, *gradient, *step, *trial;
  double lambda;
  lam_solution *solution;
} run;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double fairness_at(const lam_schedule *s, int iteration) {
  if (iteration < s->hold) return s->fairness;
  double w = s->fairness * pow(s->decay, iteration - s->hold + (s->hold > 0));
  return w < s->floor ? 0 : w;
}

int lam_schedule_fade(const lam_schedule *schedule) {
  int k = 0;
  while (k < schedule->max_iterations && fairness_at(schedule, k) > 0) k++;
  return k;
}

static lam_weights weights_at(const lam_schedule *s, int iteration) {
  double fairness = fairness_at(s, iteration);
  return (lam_weights){1, s->fade_soft && s->fairness > 0 ? fairness / s->fairness : 1, fairness};
}

static void update_blocks(const run *r) {
  for (int b = 0; b < r->problem->block_count; b++) {
    lam_block *block = &r->problem->blocks[b];
    if (block->update) block->update(block, r->problem->x, r->problem->offset, block->context);
  }
}

/* One damped step that lowers the energy. Returns the length of the longest move of an unknown, or a negative number
 * when no step was found. */
static double take_step(run *r, const lam_residual *here, lam_weights weights, lam_residual *after) {
  lam_solution *s = r->solution;
  const int *unknown = lam_system_unknowns(r->system);
  double damped = 0;
  for (int attempt = 0; attempt < max_rejections; attempt++) {
    double scale = here->rms > 0 ? fmin(here->rms, 1) : 1;
    double mu = fmin(fmax(r->lambda * scale, mu_min), mu_max), t = now();
    lam_system_damp(r->system, mu - damped, r->values);
    damped = mu;
    bool definite = lam_factor_refactor(r->factor, r->values);
    s->seconds_factor += now() - t;
    s->factorizations++;
    if (!definite) {
      r->lambda = fmin(fmax(r->lambda, mu_min / scale) * grow * grow, lambda_max);
      continue;
    }
    t = now();
    lam_factor_solve(r->factor, r->gradient, r->step);
    s->seconds_solve += now() - t;
    t = now();
    double model = 0, longest = 0;
    memcpy(r->trial, r->problem->x, sizeof(double) * (size_t)r->problem->offset[r->problem->node_count]);
    for (int i = 0; i < r->n; i++) {
      double d = -r->step[i];
      r->trial[unknown[i]] += d;
      model += .5 * (mu * d * d - r->gradient[i] * d);
      longest = fmax(longest, fabs(d));
    }
    *after = lam_system_residual(r->system, r->trial, weights);
    s->seconds_assembly += now() - t;
    double gain = model > 0 ? (here->energy - after->energy) / model : -1;
    if (isfinite(after->energy) && after->energy < here->energy) {
      memcpy(r->problem->x, r->trial, sizeof(double) * (size_t)r->problem->offset[r->problem->node_count]);
      if (gain > .25)
        r->lambda = fmax(r->lambda * shrink, lambda_min);
      else
        r->lambda = fmin(r->lambda * 2, lambda_max);
      return longest;
    }
    if (longest < 1e-13) return -1;
    r->lambda = fmin(fmax(r->lambda, mu_min / scale) * grow, lambda_max);
  }
  return -1;
}

static bool has_stalled(const lam_solution *s) {
  if (s->history_count <= stall_window) return false;
  return s->history[s->history_count - 1] > .5 * s->history[s->history_count - 1 - stall_window];
}

static bool has_wishes(const lam_problem *problem) {
  for (int b = 0; b < problem->block_count; b++)
    if (problem->blocks[b].role == LAM_SOFT) return true;
  return false;
}

/* Soft blocks compete with hard ones, so both together end in a compromise. They take part until the fairness is gone
 * and a step gains less than this share of the energy, or none is left; then they are dropped, and the rest of the
 * steps satisfies the hard blocks from there. */
static const double settled = .01;

static void iterate(run *r, const lam_progress *progress) {
  lam_solution *s = r->solution;
  const lam_schedule *schedule = r->schedule;
  lam_residual after;
  bool wishes = has_wishes(r->problem);
  int calm = 0; /* iterations since the fairness and the soft blocks ended */
  for (int k = 0;; k++) {
    update_blocks(r);
    lam_weights weights = weights_at(schedule, k);
    if (!wishes) weights.soft = 0;
    double t = now();
    lam_residual here = lam_system_assemble(r->system, r->problem->x, weights, r->values, r->gradient);
    s->seconds_assembly += now() - t;
    s->residual = here.max;
    s->rms = here.rms;
    s->worst = here.worst;
    s->history[s->history_count++] = here.max;
    s->iterations = k;
    char detail[80];
    snprintf(detail, sizeof detail, "iteration %d, residual %.1e", k, here.max);
    lam_progress_tell(progress, "solve", (double)k / schedule->max_iterations, detail);
    bool faded = weights.fairness == 0 && !wishes;
    calm = faded ? calm + 1 : 0;
    if (!isfinite(here.energy)) {
      s->reason = "the residual is not a number: the start is singular";
      return;
    }
    if (faded && here.max <= schedule->tolerance) {
      s->converged = true;
      s->reason = "converged";
      return;
    }
    if (k >= schedule->max_iterations) {
      s->reason = "the limit of iterations was reached";
      return;
    }
    if (calm > stall_window && has_stalled(s)) {
      s->reason = "stalled: the residual no longer falls";
      return;
    }
    double moved = take_step(r, &here, weights, &after);
    bool gained = moved >= 0 && after.energy < (1 - settled) * here.energy;
    bool met = after.energy <= .5 * schedule->tolerance * schedule->tolerance;
    if (wishes && weights.fairness == 0 && (!gained || met || 4 * k >= 3 * schedule->max_iterations)) {
      wishes = false;
      r->lambda = lambda_start;
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

static run run_new(lam_problem *problem, const lam_schedule *schedule, lam_solution *solution) {
  lam_arena *arena = problem->arena;
  run r = {.problem = problem, .schedule = schedule, .lambda = lambda_start, .solution = solution};
  r.system = lam_system_new(arena, problem);
  r.n = lam_system_size(r.system);
  const int *columns = lam_system_columns(r.system);
  r.values = LAM_NEW(arena, double, columns[r.n]);
  r.gradient = LAM_NEW(arena, double, r.n);
  r.step = LAM_NEW(arena, double, r.n);
  r.trial = LAM_NEW(arena, double, problem->offset[problem->node_count]);
  if (r.n > 0)
    r.factor = lam_factor_analyze(arena, r.n, columns, lam_system_rows(r.system), lam_system_order(r.system));
  return r;
}

lam_solution lam_guided_solve(lam_problem *problem, const lam_schedule *schedule, const lam_progress *progress) {
  double begin = now();
  lam_solution solution = {.reason = "nothing to solve"};
  solution.history = LAM_NEW(problem->arena, double, schedule->max_iterations + 2);
  for (int b = 0; b < problem->block_count; b++)
    solution.residuals += problem->blocks[b].count * problem->blocks[b].rows;
  lam_arena_mark mark = lam_arena_mark_get(problem->arena);
  run r = run_new(problem, schedule, &solution);
  solution.unknowns = r.n;
  if (r.n > 0) {
    iterate(&r, progress);
    solution.factor = lam_factor_get_stats(r.factor);
  } else { /* every node is fixed */
    update_blocks(&r);
    lam_residual here = lam_system_residual(r.system, problem->x, (lam_weights){1, 1, 0});
    solution.residual = here.max;
    solution.rms = here.rms;
    solution.worst = here.worst;
    solution.converged = isfinite(here.energy) && here.max <= schedule->tolerance;
    if (!solution.converged) solution.reason = "everything is fixed, but constraints are not satisfied";
  }
  lam_arena_release(problem->arena, mark);
  solution.seconds_total = now() - begin;
  return solution;
}

void lam_guided_smooth(lam_problem *problem, double weight) {
  lam_arena_mark mark = lam_arena_mark_get(problem->arena);
  lam_schedule schedule = lam_schedule_default();
  lam_solution solution = {0};
  run r = run_new(problem, &schedule, &solution);
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
