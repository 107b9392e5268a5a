/* Damped Newton on the p-th power of ||K||_p, or on the logarithm of the norm: (H + lambda t I)
 * step = -gradient, t the mean of H's diagonal, lambda by the gain ratio. Called by
 * developable_solve.c and minimax.c.
 *
 * The first steps use the Gauss-Newton part of H (Levenberg-Marquardt), which is never
 * indefinite; then come exact second derivatives, which converge in a few steps where the
 * curvature that remains makes Gauss-Newton crawl. Where it stops, a negative eigenvalue of H
 * tells a saddle point: the surface leaves it along the eigenvector, to the side that is lower. */
#include "core/numeric/dense.h"
#include "surf/developable/developable_parts.h"
#include <string.h>

typedef struct state {
  lam_developing *d;
  int n;                    /* unknowns */
  double *gradient, *step;  /* n */
  double *hessian, *factor; /* n x n, lower triangles */
  double lambda, raise;     /* damping, and by what it grows after a step that failed */
  int tried;                /* steps of this descent, made or not */
} state;

/* The norm at x. A high power of a value well below the scale would vanish in rounding: the scale
 * is lowered to the largest |K| then. */
static lam_gauss_value evaluate(const lam_developing *d, const lam_vec3 *x) {
  d->result->evaluations++;
  lam_gauss_value value =
      lam_gauss_norm_eval(d->norm, x, d->power, d->scale, LAM_ORDER_VALUE, NULL, NULL);
  if (d->logarithm && value.power < 1e-250 && value.max > 0)
    value = lam_gauss_norm_eval(d->norm, x, d->power, value.max, LAM_ORDER_VALUE, NULL, NULL);
  return value;
}

/* What is minimized: the p-th power of the norm of K/scale, or the logarithm of the norm of K. */
static double objective(const lam_developing *d, const lam_gauss_value *value) {
  return d->logarithm ? log(value->scale) + log(value->power) / d->power : value->power;
}

/* Value, gradient and Hessian of the objective at d->x. With F the power, the gradient of
 * log(F)/p is g/(pF), its Hessian H/(pF) - g g^T/(pF^2). */
static lam_gauss_value assemble(state *s, lam_order order) {
  const lam_developing *d = s->d;
  d->result->evaluations++;
  lam_gauss_value value =
      lam_gauss_norm_eval(d->norm, d->x, d->power, d->scale, order, s->gradient, s->hessian);
  if (!d->logarithm) return value;

  double unit = 1 / (d->power * value.power);
  for (int i = 0; i < s->n; i++) s->gradient[i] *= unit;
  for (int i = 0; i < s->n; i++)
    for (int k = 0; k <= i; k++) {
      double *entry = &s->hessian[(size_t)i * s->n + k];
      *entry = unit * *entry - d->power * s->gradient[i] * s->gradient[k];
    }
  return value;
}

/* The mean of |H_ii|, the unit of the damping. */
static double mean_diagonal(const state *s) {
  double sum = 0;
  for (int i = 0; i < s->n; i++) sum += fabs(s->hessian[i * s->n + i]);
  return sum / s->n;
}

/* Factorizes H + shift I; false: it is not positive definite. */
static bool factor(state *s, double shift) {
  memcpy(s->factor, s->hessian, (size_t)s->n * (size_t)s->n * sizeof *s->factor);
  for (int i = 0; i < s->n; i++) s->factor[i * s->n + i] += shift;
  return lam_cholesky_factor(s->n, s->factor);
}

/* The largest move of a control point, m. */
static double reach(const state *s, const double *step) {
  double most = 0;
  for (int i = 0; i < s->n; i += 3)
    most = fmax(most, hypot(hypot(step[i], step[i + 1]), step[i + 2]));
  return most;
}

/* step^T H step, from the lower triangle. */
static double bend(const state *s, const double *step) {
  double sum = 0;
  for (int i = 0; i < s->n; i++)
    for (int k = 0; k <= i; k++)
      sum += (i == k ? 1 : 2) * step[i] * step[k] * s->hessian[i * s->n + k];
  return sum;
}

/* The trial, whose value is given, becomes the surface. The logarithm does not depend on the scale,
 * which may follow the largest |K|. */
static void accept(lam_developing *d, const lam_gauss_value *value) {
  lam_developing_accept(d);
  if (d->logarithm) d->scale = value->max;
}

/* What the model promises of a step: -(g.d + d.Hd/2). */
static double promise(const state *s, const double *step) {
  double sum = -0.5 * bend(s, step);
  for (int i = 0; i < s->n; i++) sum -= s->gradient[i] * step[i];
  return sum;
}

/* Solves (H + lambda unit I) step = -gradient and caps the step, so that no control point moves by
 * more than a quarter of the boundary's size. Returns how far the farthest moves, or -1 when the
 * matrix is not positive definite. */
static double damped_step(state *s, double unit) {
  if (!factor(s, s->lambda * unit)) return -1;
  for (int i = 0; i < s->n; i++) s->step[i] = -s->gradient[i];
  lam_cholesky_solve(s->n, s->factor, s->step);

  double size = reach(s, s->step), cap = fmin(1, 0.25 * s->d->size / size);
  for (int i = 0; i < s->n; i++) s->step[i] *= cap;
  return size * cap;
}

typedef enum outcome { MOVED, STUCK, FINISHED } outcome;

/* Raises the damping until a step lowers the objective. now: the value at d->x; exact: whether H is
 * complete.
 * MOVED: the trial is lower, with the value next. STUCK: no step was found. FINISHED: with the
 * exact H steps promise nothing or are only rounding. */
static outcome find_step(state *s, const lam_gauss_value *now, double unit, bool exact,
                         lam_gauss_value *next) {
  lam_developing *d = s->d;
  while (s->tried++ < 4 * d->max_iterations) {
    double length = damped_step(s, unit);
    if (length < 0) {
      s->lambda = fmax(4 * s->lambda, 1e-8);
      continue;
    }
    double expected = promise(s, s->step);
    if (expected <= (d->logarithm ? 1e-14 : 1e-15 * now->power) && exact) return FINISHED;

    lam_developing_try(d, s->step);
    *next = evaluate(d, d->trial);
    double gain = (objective(d, now) - objective(d, next)) / expected;
    if (gain > 0 && lam_developing_sound(d, next)) {
      s->lambda = fmax(1e-14, s->lambda * fmax(0.1, 1 - pow(2 * fmin(gain, 1) - 1, 3)));
      s->raise = 2;
      return MOVED;
    }

    if (length < 1e-12 * d->size) return exact ? FINISHED : STUCK;
    s->lambda *= s->raise;
    s->raise *= 2;
  }
  return STUCK;
}

/* Goes down to a stationary surface; the first gauss_newton_steps without the second derivatives of
 * K. Sets converged and reason of the result. */
static void descend(state *s, int gauss_newton_steps) {
  lam_developing *d = s->d;
  s->lambda = 1e-3;
  s->raise = 2;
  s->tried = 0;
  d->result->converged = true;
  d->result->reason = "the norm is at its minimum";

  for (int it = 0; it < d->max_iterations; it++) {
    bool exact = it >= gauss_newton_steps;
    lam_gauss_value now = assemble(s, exact ? LAM_ORDER_NEWTON : LAM_ORDER_GAUSS_NEWTON);
    double unit = mean_diagonal(s);
    if (!(unit > 0)) return;

    lam_gauss_value next = now;
    outcome found = find_step(s, &now, unit, exact, &next);
    if (found == FINISHED) return;
    if (found == STUCK && exact) break;

    /* Where Gauss-Newton is stuck, the exact Hessian comes next. */
    if (found == STUCK) {
      it = gauss_newton_steps - 1;
      continue;
    }
    accept(d, &next);
    d->result->iterations++;
  }
  d->result->converged = false;
  d->result->reason = "the largest number of steps was reached";
}

/* Sets step to the eigenvector of the least eigenvalue of H, its farthest control point moving
 * by 1; false when H is positive definite to rounding. */
static bool downhill(state *s) {
  assemble(s, LAM_ORDER_NEWTON);
  double unit = mean_diagonal(s), low = 1e-9 * unit, high = low;
  if (factor(s, low)) return false;
  while (high < 1e9 * unit && !factor(s, high)) high *= 4;
  if (!(high < 1e9 * unit)) return false;

  /* A little above minus the least eigenvalue, H + high I is just positive definite: bisection
   * in ratios. */
  while (high > 1.01 * low) {
    double middle = sqrt(low * high);
    if (factor(s, middle))
      high = middle;
    else
      low = middle;
  }
  if (!factor(s, high)) return false;

  /* Inverse iteration there, from a vector without symmetry. */
  for (int i = 0; i < s->n; i++) s->step[i] = 1 + 0.1 * sin(i + 1.);
  for (int k = 0; k < 30; k++) {
    lam_cholesky_solve(s->n, s->factor, s->step);
    double size = reach(s, s->step);
    for (int i = 0; i < s->n; i++) s->step[i] /= size;
  }
  return bend(s, s->step) < 0;
}

/* Leaves a saddle point for the lowest of 12 surfaces along the direction downhill, 6 to each
 * side; false: there is no such direction, or none of them is lower. */
static bool leave(state *s) {
  lam_developing *d = s->d;
  if (!downhill(s)) return false;

  double *way = LAM_NEW(d->arena, double, s->n), best = 0;
  lam_gauss_value here = evaluate(d, d->x);
  double least = objective(d, &here);
  for (int k = 0; k < 12; k++) {
    double length = (k % 2 ? -1 : 1) * d->size * 0.1 * pow(0.25, k / 2.);
    for (int i = 0; i < s->n; i++) way[i] = length * s->step[i];
    lam_developing_try(d, way);
    lam_gauss_value there = evaluate(d, d->trial);
    if (objective(d, &there) < least && lam_developing_sound(d, &there)) {
      least = objective(d, &there);
      best = length;
    }
  }

  if (best == 0) return false;
  for (int i = 0; i < s->n; i++) way[i] = best * s->step[i];
  lam_developing_try(d, way);
  here = evaluate(d, d->trial);
  accept(d, &here);
  d->result->escapes++;
  return true;
}

/* Descends, and leaves saddle points a few times. */
void lam_developable_newton(lam_developing *d, int gauss_newton_steps) {
  enum { most_escapes = 5 };
  int n = d->norm->unknowns;
  state s = {.d = d,
             .n = n,
             .gradient = LAM_NEW(d->arena, double, n),
             .step = LAM_NEW(d->arena, double, n),
             .hessian = LAM_NEW(d->arena, double, (size_t)n *(size_t)n),
             .factor = LAM_NEW(d->arena, double, (size_t)n *(size_t)n)};

  descend(&s, gauss_newton_steps);
  for (int k = 0; k < most_escapes && d->result->converged && leave(&s); k++) descend(&s, 0);
}
