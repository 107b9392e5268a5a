/* Damped Newton on the p-th power of ||K||_p: (H + lambda t I) step = -gradient, t the mean of H's
 * diagonal, lambda by the gain ratio. The first steps use the Gauss-Newton part of H
 * (Levenberg-Marquardt), which is never indefinite; then come exact second derivatives, which
 * converge in a few steps where the curvature that remains makes Gauss-Newton crawl. Where it
 * stops, a negative eigenvalue of H tells a saddle point: the surface leaves it along the
 * eigenvector, to both sides, and takes the lower one. */
#include "core/numeric/dense.h"
#include "surf/developable/developable_parts.h"
#include <string.h>

typedef struct state {
  lam_developing *d;
  int n;
  double *gradient, *hessian, *factor, *step;
} state;

/* The norm at x. A high power of a value well below the scale would vanish: the scale is lowered to
 * it then. */
static lam_gauss_value evaluate(const lam_developing *d, const lam_vec3 *x) {
  d->result->evaluations++;
  lam_gauss_value value =
      lam_gauss_norm_eval(d->norm, x, d->power, d->scale, LAM_ORDER_VALUE, NULL, NULL);
  if (d->logarithm && value.power < 1e-250 && value.max > 0)
    value = lam_gauss_norm_eval(d->norm, x, d->power, value.max, LAM_ORDER_VALUE, NULL, NULL);
  return value;
}

/* What is minimized: the p-th power of the norm, or the logarithm of the norm. */
static double objective(const lam_developing *d, const lam_gauss_value *value) {
  return d->logarithm ? log(value->scale) + log(value->power) / d->power : value->power;
}

/* With F the power: the gradient of log(F)/p is g/(pF), its Hessian H/(pF) - g g^T/(pF^2). */
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

static double mean_diagonal(const state *s) {
  double sum = 0;
  for (int i = 0; i < s->n; i++) sum += fabs(s->hessian[i * s->n + i]);
  return sum / s->n;
}

static bool factor(state *s, double shift) {
  memcpy(s->factor, s->hessian, (size_t)s->n * (size_t)s->n * sizeof *s->factor);
  for (int i = 0; i < s->n; i++) s->factor[i * s->n + i] += shift;
  return lam_cholesky_factor(s->n, s->factor);
}

/* The largest move of a control point. */
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

static void accept(lam_developing *d, const lam_gauss_value *value) {
  lam_vec3 *t = d->x;
  d->x = d->trial;
  d->trial = t;
  if (d->logarithm) d->scale = value->max;
}

/* What the model promises of a step: -(g.d + d.Hd/2). */
static double promise(const state *s, const double *step) {
  double sum = -0.5 * bend(s, step);
  for (int i = 0; i < s->n; i++) sum -= s->gradient[i] * step[i];
  return sum;
}

static void descend(state *s, int gauss_newton_steps) {
  lam_developing *d = s->d;
  double lambda = 1e-3, raise = 2;
  d->result->converged = true;
  d->result->reason = "the norm is at its minimum";
  for (int it = 0, tried = 0; it < d->max_iterations; it++) {
    lam_gauss_value now =
        assemble(s, it < gauss_newton_steps ? LAM_ORDER_GAUSS_NEWTON : LAM_ORDER_NEWTON);
    double unit = mean_diagonal(s), size = 0;
    if (!(unit > 0)) return;
    bool moved = false;
    lam_gauss_value next = now;
    while (!moved && tried++ < 4 * d->max_iterations) {
      if (!factor(s, lambda * unit)) {
        lambda = fmax(4 * lambda, 1e-8);
        continue;
      }
      for (int i = 0; i < s->n; i++) s->step[i] = -s->gradient[i];
      lam_cholesky_solve(s->n, s->factor, s->step);
      size = reach(s, s->step);
      double cap = fmin(1, 0.25 * d->size / size), expected;
      for (int i = 0; i < s->n; i++) s->step[i] *= cap;
      expected = promise(s, s->step);
      if (expected <= (d->logarithm ? 1e-14 : 1e-15 * now.power) && it >= gauss_newton_steps)
        return;
      lam_developing_try(d, s->step);
      next = evaluate(d, d->trial);
      double gain = (objective(d, &now) - objective(d, &next)) / expected;
      if (gain > 0 && lam_developing_sound(d, &next)) {
        moved = true;
        lambda = fmax(1e-14, lambda * fmax(0.1, 1 - pow(2 * fmin(gain, 1) - 1, 3)));
        raise = 2;
      } else {
        if (size * cap < 1e-12 * d->size) { /* what is left is rounding */
          if (it >= gauss_newton_steps) return;
          break;
        }
        lambda *= raise;
        raise *= 2;
      }
    }
    if (!moved && it >= gauss_newton_steps) break;
    if (!moved) {
      it = gauss_newton_steps - 1;
      continue;
    }
    accept(d, &next);
    d->result->iterations++;
  }
  d->result->converged = false;
  d->result->reason = "the largest number of steps was reached";
}

/* The eigenvector of the least eigenvalue of H, by inverse iteration just above it, into step;
 * false when H is positive definite to rounding. */
static bool downhill(state *s) {
  assemble(s, LAM_ORDER_NEWTON);
  double unit = mean_diagonal(s), low = 1e-9 * unit, high = low;
  if (factor(s, low)) return false;
  while (high < 1e9 * unit && !factor(s, high)) high *= 4;
  if (!(high < 1e9 * unit)) return false;
  while (high > 1.01 * low) {
    double middle = sqrt(low * high);
    if (factor(s, middle))
      high = middle;
    else
      low = middle;
  }
  if (!factor(s, high)) return false;
  for (int i = 0; i < s->n; i++) s->step[i] = 1 + 0.1 * sin(i + 1.);
  for (int k = 0; k < 30; k++) {
    lam_cholesky_solve(s->n, s->factor, s->step);
    double size = reach(s, s->step);
    for (int i = 0; i < s->n; i++) s->step[i] /= size;
  }
  return bend(s, s->step) < 0;
}

/* Leaves a saddle point: the lowest of places on both sides. */
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

void lam_developable_newton(lam_developing *d, int gauss_newton_steps) {
  enum { most_escapes = 5 };
  int n = d->norm->unknowns;
  state s = {d,
             n,
             LAM_NEW(d->arena, double, n),
             LAM_NEW(d->arena, double, (size_t)n *(size_t)n),
             LAM_NEW(d->arena, double, (size_t)n *(size_t)n),
             LAM_NEW(d->arena, double, n)};
  descend(&s, gauss_newton_steps);
  for (int k = 0; k < most_escapes && d->result->converged && leave(&s); k++) descend(&s, 0);
}
