/* What guided.c and gauss_newton.c share: the schedule of the weights, assembling and solving with
 * the time they take, and the frame of a whole solve. */
#include "solve/solver_run.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

double lam_run_clock(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* For lam_guided_smooth and for tests: kinds of nets have schedules of their own. */
lam_schedule lam_schedule_default(void) {
  return (lam_schedule){.fairness = 0,
                        .hold = 0,
                        .decay = .5,
                        .floor = 1e-3,
                        .tolerance = 1e-12,
                        .max_iterations = 100};
}

/* fairness for `hold` iterations, then fairness decay^k, and 0 below the floor. */
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

/* Soft blocks that fade do so in proportion to the fairness. */
lam_weights lam_schedule_weights(const lam_schedule *s, int iteration) {
  double fairness = fairness_at(s, iteration);
  return (lam_weights){1, s->fade_soft && s->fairness > 0 ? fairness / s->fairness : 1, fairness};
}

/* Before every assembly, so that foot points belong to the unknowns. */
void lam_run_update(const lam_run *r) {
  for (int b = 0; b < r->problem->block_count; b++) {
    lam_block *block = &r->problem->blocks[b];
    if (block->update) block->update(block, r->problem->x, r->problem->offset, block->context);
  }
}

bool lam_run_has_soft(const lam_run *r) {
  for (int b = 0; b < r->problem->block_count; b++)
    if (r->problem->blocks[b].role == LAM_SOFT) return true;
  return false;
}

/* Every call adds one entry to the history: the residual before the first and after every step. */
lam_residual lam_run_assemble(lam_run *r, int iteration, lam_weights weights,
                              const lam_progress *progress) {
  lam_solution *s = r->solution;
  double t = lam_run_clock();
  lam_residual here =
      lam_system_assemble(r->system, r->problem->x, weights, r->values, r->gradient);
  s->seconds_assembly += lam_run_clock() - t;

  s->residual = here.max;
  s->rms = here.rms;
  s->worst = here.worst;
  s->history[s->history_count++] = here.max;
  s->iterations = iteration;

  char detail[80];
  snprintf(detail, sizeof detail, "iteration %d, residual %.1e", iteration, here.max);
  lam_progress_tell(progress, "solve", -1, detail); /* nobody knows how many are to come */
  return here;
}

/* The diagonal is damped once more by the difference to what it has, so that rejected steps need
 * no new assembly. */
bool lam_run_step(lam_run *r, double mu, double damped) {
  lam_solution *s = r->solution;
  double t = lam_run_clock();
  lam_system_damp(r->system, mu - damped, r->values);
  bool definite = lam_factor_refactor(r->factor, r->values);
  s->seconds_factor += lam_run_clock() - t;
  s->factorizations++;
  if (!definite) return false;

  t = lam_run_clock();
  lam_factor_solve(r->factor, r->gradient, r->step);
  s->seconds_solve += lam_run_clock() - t;
  return true;
}

/* In this order: a residual that is not a number is never convergence. */
bool lam_run_ended(lam_run *r, int iteration, const lam_residual *here, bool faded,
                   const char *not_a_number) {
  lam_solution *s = r->solution;
  if (!isfinite(here->energy)) {
    s->reason = not_a_number;
    return true;
  }

  if (faded && here->max <= r->schedule->tolerance) {
    s->converged = true;
    s->reason = "converged";
    return true;
  }

  if (iteration >= r->schedule->max_iterations) {
    s->reason = "the limit of iterations was reached";
    return true;
  }
  return false;
}

/* Arrays of a size that the system knows, and the analyzed factor. */
lam_run lam_run_new(lam_problem *problem, const lam_schedule *schedule, lam_solution *solution) {
  lam_arena *arena = problem->arena;
  lam_run r = {.problem = problem, .schedule = schedule, .solution = solution};
  r.system = lam_system_new(arena, problem);
  r.n = lam_system_size(r.system);
  const int *columns = lam_system_columns(r.system);
  r.values = LAM_NEW(arena, double, columns[r.n]);
  r.gradient = LAM_NEW(arena, double, r.n);
  r.step = LAM_NEW(arena, double, r.n);
  r.trial = LAM_NEW(arena, double, problem->offset[problem->node_count]);

  if (r.n > 0)
    r.factor = lam_factor_analyze(arena, r.n, columns, lam_system_rows(r.system),
                                  lam_system_order(r.system));
  return r;
}

/* The verdict where nothing can move. */
static void judge_start(lam_run *r) {
  lam_solution *s = r->solution;
  lam_run_update(r);
  lam_residual here = lam_system_residual(r->system, r->problem->x, (lam_weights){1, 1, 0});
  s->residual = here.max;
  s->rms = here.rms;
  s->worst = here.worst;
  s->converged = isfinite(here.energy) && here.max <= r->schedule->tolerance;
  if (!s->converged) s->reason = "everything is fixed, but constraints are not satisfied";
}

/* The history is made before the mark, everything else of the solver behind it. */
lam_solution lam_run_solve(lam_problem *problem, const lam_schedule *schedule,
                           void (*iterate)(lam_run *run, const void *context,
                                           const lam_progress *progress),
                           const void *context, const lam_progress *progress) {
  double begin = lam_run_clock();
  lam_solution solution = {.reason = "nothing to solve"};
  solution.history = LAM_NEW(problem->arena, double, schedule->max_iterations + 2);
  for (int b = 0; b < problem->block_count; b++)
    solution.residuals += problem->blocks[b].count * problem->blocks[b].rows;

  lam_arena_mark mark = lam_arena_mark_get(problem->arena);
  lam_run r = lam_run_new(problem, schedule, &solution);
  solution.seconds_analysis = lam_run_clock() - begin;
  solution.unknowns = r.n;

  if (r.n > 0) {
    iterate(&r, context, progress);
    solution.factor = lam_factor_get_stats(r.factor);
  } else
    judge_start(&r);

  lam_arena_release(problem->arena, mark);
  solution.seconds_total = lam_run_clock() - begin;
  return solution;
}
