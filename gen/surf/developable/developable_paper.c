/* The two algorithms of Li & Deng, sec. 3.1.2, on F = ||K||_p itself (with exact gradients),
 * from G = H = I. Called by developable_solve.c for the methods trust-region and quasi-newton.
 *
 *   Algorithm 1, trust region:  (G + mu I) d = -g. rho is the gain over that of the model,
 *       -(g.d + d.Gd/2). mu * 4 where rho < beta1, mu / 2 where rho > beta2; a step with
 *       rho <= 0 is not made.
 *   Algorithm 2, quasi-Newton:  d = -H g. The step length of eq. 3.9 is always 1; it is halved
 *       while F does not fall.
 *
 * Both update by Broyden, Fletcher, Goldfarb and Shanno: G += y y'/y's - G s s'G/s'Gs. The
 * update is left out where y's <= 0, which would lose the positive definiteness. F has no
 * derivative where K vanishes altogether: there the gradient is small only by rounding, and the
 * iteration stops when steps gain nothing. */
#include "core/numeric/dense.h"
#include "surf/developable/developable_parts.h"
#include <string.h>

/* The matrix is G of algorithm 1 or H of algorithm 2, n x n, both triangles. */
typedef struct quasi {
  lam_developing *d;
  int n;                               /* unknowns */
  double *x_gradient, *trial_gradient; /* of F at d->x and at d->trial */
  double *step, *change;               /* s and y: the last step and the change of the gradient */
  double *product;                     /* room: the matrix times a vector */
  double *matrix, *factor;             /* factor: room for the one of G + mu I */
} quasi;

/* F = ||K||_p at control points x and its gradient, from the sum of w |K/scale|^p: dF = F/p
 * d(sum)/sum. at: the value that F was computed from. */
static double value(const quasi *q, const lam_vec3 *x, double *gradient, lam_gauss_value *at) {
  const lam_developing *d = q->d;
  *at = lam_gauss_norm_eval(d->norm, x, d->power, d->scale, LAM_ORDER_GRADIENT, gradient, NULL);
  double F = d->scale * pow(at->power, 1 / d->power);

  for (int i = 0; i < q->n; i++) gradient[i] *= at->power > 0 ? F / (d->power * at->power) : 0;
  d->result->evaluations++;
  return F;
}

/* The scalar product of two vectors of length n. */
static double dot(int n, const double *a, const double *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* Updates G by the step s and the change y of the gradient; inverse: H = G^-1 instead. */
static void update(quasi *q, bool inverse) {
  int n = q->n;
  double *s = q->step, *y = q->change, *m = q->product, sy = dot(n, s, y);
  if (!(sy > 1e-16 * sqrt(dot(n, s, s) * dot(n, y, y)))) return;

  for (int i = 0; i < n; i++) m[i] = dot(n, q->matrix + (size_t)i * n, inverse ? y : s);
  double through = dot(n, m, inverse ? y : s);

  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++)
      q->matrix[(size_t)i * n + k] +=
          inverse ? (1 + through / sy) * s[i] * s[k] / sy - (m[i] * s[k] + s[i] * m[k]) / sy
                  : y[i] * y[k] / sy - m[i] * m[k] / through;
}

/* The trial becomes the current surface, and the matrix learns from the change of the gradient. */
static void accept(quasi *q, bool inverse) {
  for (int i = 0; i < q->n; i++) q->change[i] = q->trial_gradient[i] - q->x_gradient[i];
  update(q, inverse);
  memcpy(q->x_gradient, q->trial_gradient, (size_t)q->n * sizeof *q->x_gradient);
  lam_developing_accept(q->d);
}

/* Solves (G + mu I) step = -gradient; false: the matrix is not positive definite. */
static bool trust_step(quasi *q, double mu) {
  int n = q->n;
  memcpy(q->factor, q->matrix, (size_t)n * (size_t)n * sizeof *q->factor);
  for (int i = 0; i < n; i++) {
    q->factor[(size_t)i * n + i] += mu;
    q->step[i] = -q->x_gradient[i];
  }

  if (!lam_cholesky_factor(n, q->factor)) return false;
  lam_cholesky_solve(n, q->factor, q->step);
  return true;
}

/* What the model promises of the step: -(g.d + d.Gd/2). */
static double promise(quasi *q) {
  int n = q->n;
  for (int i = 0; i < n; i++) q->product[i] = dot(n, q->matrix + (size_t)i * n, q->step);
  return -dot(n, q->x_gradient, q->step) - 0.5 * dot(n, q->step, q->product);
}

/* Algorithm 1 from d->x; false: the largest number of steps was reached. */
static bool trust_region(quasi *q) {
  static const double beta1 = 0.25, beta2 = 0.75, least_mu = 1e-12;
  lam_developing *d = q->d;
  lam_gauss_value at;
  double mu = 1e-2, F = value(q, d->x, q->x_gradient, &at);

  for (int it = 0, idle = 0; it < d->max_iterations; it++) {
    d->result->iterations++;
    if (!trust_step(q, mu)) {
      mu *= 4;
      continue;
    }

    double expected = promise(q);
    lam_developing_try(d, q->step);
    double next = value(q, d->trial, q->trial_gradient, &at);
    double rho = lam_developing_sound(d, &at) ? (F - next) / expected : -1;

    if (rho < beta1)
      mu *= 4;
    else if (rho > beta2)
      mu = fmax(least_mu, mu / 2);

    if (rho > 0) {
      idle = F - next <= 1e-12 * F ? idle + 1 : 0;
      F = next;
      accept(q, false);
    } else if (sqrt(dot(q->n, q->step, q->step)) < 1e-14 * d->size) {
      return true;
    }
    if (idle >= 3) return true;
  }
  return false;
}

/* Algorithm 2 from d->x; false: the largest number of steps was reached. */
static bool quasi_newton(quasi *q) {
  lam_developing *d = q->d;
  lam_gauss_value at;
  int n = q->n;
  double F = value(q, d->x, q->x_gradient, &at);

  for (int it = 0, idle = 0; it < d->max_iterations; it++) {
    for (int i = 0; i < n; i++) q->step[i] = -dot(n, q->matrix + (size_t)i * n, q->x_gradient);

    /* Halved until F falls on a sound surface, or until the step is only rounding. */
    for (;;) {
      if (sqrt(dot(n, q->step, q->step)) < 1e-14 * d->size) return true;
      lam_developing_try(d, q->step);
      double next = value(q, d->trial, q->trial_gradient, &at);
      if (next < F && lam_developing_sound(d, &at)) {
        idle = F - next <= 1e-12 * F ? idle + 1 : 0;
        F = next;
        break;
      }
      for (int i = 0; i < n; i++) q->step[i] *= 0.5;
    }

    accept(q, true);
    d->result->iterations++;
    if (idle >= 3) return true;
  }
  return false;
}

/* The matrix starts as the unit matrix. */
void lam_developable_paper(lam_developing *d, bool use_trust_region) {
  int n = d->norm->unknowns;
  lam_arena *a = d->arena;
  quasi q = {.d = d,
             .n = n,
             .x_gradient = LAM_NEW(a, double, n),
             .trial_gradient = LAM_NEW(a, double, n),
             .step = LAM_NEW(a, double, n),
             .change = LAM_NEW(a, double, n),
             .product = LAM_NEW(a, double, n),
             .matrix = LAM_NEW(a, double, (size_t)n *(size_t)n),
             .factor = LAM_NEW(a, double, (size_t)n *(size_t)n)};

  for (int i = 0; i < n; i++) q.matrix[(size_t)i * n + i] = 1;

  d->result->converged = use_trust_region ? trust_region(&q) : quasi_newton(&q);
  d->result->reason =
      d->result->converged ? "steps gain nothing more" : "the largest number of steps was reached";
}
