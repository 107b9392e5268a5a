/* BFGS with numerical gradients (Nocedal & Wright, Numerical Optimization, ch. 6). Called by
 * surf/asymptotic/complete.c and surf/asymptotic/rational.c. */
#include "core/numeric/minimize.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MAX = LAM_MINIMIZE_MAX };

typedef struct objective {
  int count;
  double (*value)(void *data, const double *x);
  void *data;
} objective;

/* Gradient and second derivatives along the axes by central differences, the latter with wider
 * steps, as they lose more digits. at: the value at x; second may be NULL. Where a neighbor has
 * no value, the axis is left alone: slope 0. */
static void derive(const objective *f, const double *x, double at, double *gradient,
                   double *second) {
  const double h = 2e-5, wide = 1e-3;
  double y[MAX], side[2];
  memcpy(y, x, (size_t)f->count * sizeof *y);

  for (int i = 0; i < f->count; i++) {
    for (int k = 0; k < 2; k++) {
      y[i] = x[i] + (k ? h : -h);
      side[k] = f->value(f->data, y);
    }

    gradient[i] = (side[1] - side[0]) / (2 * h);
    if (!isfinite(gradient[i])) gradient[i] = 0;

    for (int k = 0; second && k < 2; k++) {
      y[i] = x[i] + (k ? wide : -wide);
      side[k] = f->value(f->data, y);
    }
    if (second) second[i] = (side[0] + side[1] - 2 * at) / (wide * wide);

    y[i] = x[i];
  }
}

/* The inverse Hessian to begin with: diagonal, from the second derivatives, or with a step of a
 * tenth where the function is not curved upward. */
static void reset(int n, const double *second, const double *gradient, double *inverse) {
  memset(inverse, 0, (size_t)(n * n) * sizeof *inverse);
  for (int i = 0; i < n; i++) {
    bool curved = isfinite(second[i]) && second[i] > 1e-6 * fabs(gradient[i]);
    inverse[i * n + i] = curved ? 1 / second[i] : 0.1 / (fabs(gradient[i]) + 1e-12);
  }
}

/* a . b */
static double product(int n, const double *a, const double *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* The BFGS update of the inverse Hessian H for a step s and its change of gradient y, with r =
 * s.y (eq. 6.17 multiplied out):
 *   H + ((1 + y'H y / r) s s' - H y s' - s (H y)') / r.
 * Left out where s.y is not clearly positive: H stays positive definite. */
static void update(int n, const double *step, const double *change, double *inverse) {
  double along = product(n, step, change), image[MAX];
  if (!(along > 1e-14 * sqrt(product(n, step, step) * product(n, change, change)))) return;

  for (int i = 0; i < n; i++) image[i] = product(n, inverse + i * n, change);
  double factor = 1 + product(n, change, image) / along;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      inverse[i * n + j] +=
          (factor * step[i] * step[j] - image[i] * step[j] - step[i] * image[j]) / along;
}

/* Steps -H g, halved until the value falls by 1e-4 of what the slope promises (Armijo's rule). */
double lam_minimize(int count, double (*value)(void *data, const double *x), void *data, int steps,
                    double *x) {
  objective f = {count, value, data};
  double at = value(data, x), gradient[MAX], second[MAX], inverse[MAX * MAX];
  derive(&f, x, at, gradient, second);
  reset(count, second, gradient, inverse);

  for (int round = 0; round < steps; round++) {
    double step[MAX], y[MAX], next[MAX], slope = 0, length = 0, reached = INFINITY, t = 1;
    for (int i = 0; i < count; i++) step[i] = -product(count, inverse + i * count, gradient);
    slope = product(count, step, gradient);

    for (int halving = 0; halving < 30; halving++, t /= 2) {
      for (int i = 0; i < count; i++) y[i] = x[i] + t * step[i];
      reached = value(data, y);
      if (reached <= at + 1e-4 * t * slope) break;
    }

    if (!(reached <= at)) return at;
    for (int i = 0; i < count; i++) {
      step[i] *= t;
      x[i] = y[i];
      length = fmax(length, fabs(step[i]));
    }

    at = reached;
    if (length < 1e-8) break;

    derive(&f, x, at, next, NULL);
    for (int i = 0; i < count; i++) y[i] = next[i] - gradient[i];
    update(count, step, y, inverse);
    memcpy(gradient, next, (size_t)count * sizeof *next);
  }
  return at;
}
