#include "core/minimize.h"
#include "core/dense.h"
#include <math.h>
#include <string.h>

enum { MAX = LAM_MINIMIZE_MAX };

typedef struct lam_objective {
  int count;
  double (*value)(void *data, const double *x);
  void *data;
} lam_objective;

/* The value at x with two variables moved (i may be j: both moves add up). */
static double moved(const lam_objective *f, const double *x, int i, double a, int j, double b) {
  double y[MAX];
  memcpy(y, x, (size_t)f->count * sizeof *y);
  y[i] += a;
  y[j] += b;
  return f->value(f->data, y);
}

static void derive(const lam_objective *f, const double *x, double at, double *gradient, double *hessian) {
  const double h = 1e-4, small = 2e-5;
  int n = f->count;
  for (int i = 0; i < n; i++) {
    gradient[i] = (moved(f, x, i, small, i, 0) - moved(f, x, i, -small, i, 0)) / (2 * small);
    hessian[i * n + i] = (moved(f, x, i, h, i, 0) + moved(f, x, i, -h, i, 0) - 2 * at) / (h * h);
    for (int j = 0; j < i; j++)
      hessian[i * n + j] = hessian[j * n + i] =
          (moved(f, x, i, h, j, h) - moved(f, x, i, h, j, -h) - moved(f, x, i, -h, j, h) + moved(f, x, i, -h, j, -h)) /
          (4 * h * h);
  }
}

/* One step with the least damping that does not raise the value; its length, or 0 when there is none. */
static double advance(const lam_objective *f, double *x, double *at, double *damping) {
  double gradient[MAX], hessian[MAX * MAX];
  int n = f->count;
  derive(f, x, *at, gradient, hessian);
  for (int attempt = 0; attempt < 30; attempt++) {
    double matrix[MAX * MAX], move[MAX], y[MAX], length = 0;
    bool finite = true;
    for (int k = 0; k < n * n; k++) {
      matrix[k] = hessian[k];
      finite = finite && isfinite(matrix[k]);
    }
    for (int k = 0; k < n; k++) {
      double slope = isfinite(gradient[k]) ? gradient[k] : 0;
      if (!finite) matrix[k * n + k] = isfinite(hessian[k * n + k]) ? hessian[k * n + k] : 1;
      for (int j = 0; j < n && !finite; j++)
        if (j != k) matrix[k * n + j] = 0; /* at the edge of the domain: each variable by itself */
      matrix[k * n + k] += *damping * (fabs(matrix[k * n + k]) + 1e-12 * fabs(*at));
      move[k] = -slope;
    }
    if (lam_cholesky_factor(n, matrix)) {
      lam_cholesky_solve(n, matrix, move);
      for (int k = 0; k < n; k++) {
        y[k] = x[k] + move[k];
        length = fmax(length, fabs(move[k]));
      }
      double reached = f->value(f->data, y);
      if (reached <= *at) {
        memcpy(x, y, (size_t)n * sizeof *x);
        *at = reached;
        *damping = fmax(*damping / 10, 1e-14);
        return length;
      }
    }
    *damping = fmax(4 * *damping, 1e-8);
  }
  return 0;
}

double lam_minimize(int count, double (*value)(void *data, const double *x), void *data, int steps, double *x) {
  lam_objective f = {count, value, data};
  double at = value(data, x), damping = 1e-3;
  for (int step = 0; step < steps; step++)
    if (advance(&f, x, &at, &damping) < 1e-9) break;
  return at;
}
