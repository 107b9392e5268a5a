/* Limited memory BFGS (Nocedal & Wright, Numerical Optimization, algorithm 7.4) on the area,
 * started from the Dirichlet energy's Hessian instead of the identity; backtracking with a
 * curvature check. Called by area_solve.c. */
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* Pairs of step and gradient change that are remembered. */
enum { PAIRS = 10 };

typedef struct lbfgs {
  int n, stored;                 /* inner points; pairs */
  lam_vec3 *s[PAIRS], *y[PAIRS]; /* steps and changes of the gradient, the oldest first */
  double rho[PAIRS];             /* 1 / (s.y) */
} lbfgs;

/* to += t from. */
static void add(int n, double t, const lam_vec3 *from, lam_vec3 *to) {
  for (int i = 0; i < n; i++) to[i] = lam_along(to[i], t, from[i]);
}

/* step = -H gradient by the two loops; the middle matrix is the inverse of the Dirichlet
 * energy's Hessian. */
static void direction(lam_arena *arena, const lbfgs *l, const lam_area_system *system,
                      const lam_vec3 *gradient, lam_vec3 *step) {
  double alpha[PAIRS] = {0};
  memcpy(step, gradient, (size_t)l->n * sizeof *step);

  for (int k = l->stored - 1; k >= 0; k--) {
    alpha[k] = l->rho[k] * lam_area_product(l->n, l->s[k], step);
    add(l->n, -alpha[k], l->y[k], step);
  }

  lam_area_system_step(arena, system, step, step);
  for (int k = 0; k < l->n; k++) step[k] = lam_scale(step[k], -1);

  for (int k = 0; k < l->stored; k++)
    add(l->n, alpha[k] - l->rho[k] * lam_area_product(l->n, l->y[k], step), l->s[k], step);
  for (int k = 0; k < l->n; k++) step[k] = lam_scale(step[k], -1);
}

/* Keeps s = t step and y = new - old gradient, unless they say that the area curves down. */
static void keep(lbfgs *l, double t, const lam_vec3 *step, const lam_vec3 *old,
                 const lam_vec3 *gradient) {
  if (l->stored == PAIRS) {
    lam_vec3 *s = l->s[0], *y = l->y[0];
    for (int k = 1; k < PAIRS; k++) {
      l->s[k - 1] = l->s[k];
      l->y[k - 1] = l->y[k];
      l->rho[k - 1] = l->rho[k];
    }
    l->s[PAIRS - 1] = s;
    l->y[PAIRS - 1] = y;
    l->stored--;
  }

  int k = l->stored;
  for (int i = 0; i < l->n; i++) {
    l->s[k][i] = lam_scale(step[i], t);
    l->y[k][i] = lam_sub(gradient[i], old[i]);
  }

  double sy = lam_area_product(l->n, l->s[k], l->y[k]);
  if (!(sy > 1e-12 * sqrt(lam_area_product(l->n, l->s[k], l->s[k]) *
                          lam_area_product(l->n, l->y[k], l->y[k]))))
    return;
  l->rho[k] = 1 / sy;
  l->stored++;
}

/* Halves the step until the area falls by a part of what its slope promises (Armijo). slope:
 * gradient.step. Sets trial to the points after it, value to their area, and the form's gradient.
 * Returns the length, or 0 when no step goes down. */
static double backtrack(const lam_area_form *form, const lam_vec3 *points, const lam_vec3 *step,
                        double slope, lam_vec3 *trial, double *value, int *evaluations) {
  double before = *value;
  for (double t = 1; t > 1e-10; t /= 2) {
    lam_area_move(form, points, t, step, trial);
    *value = lam_area_slope(form, trial);
    ++*evaluations;
    if (*value <= before + 1e-4 * t * slope) return t;
  }
  return 0;
}

/* Converged when the area has hardly fallen in three steps in a row, or is small enough. */
void lam_area_lbfgs(lam_arena *arena, const lam_area_form *form,
                    const lam_least_area_options *options, lam_vec3 *points,
                    lam_least_area_result *result) {
  int n = form->inner[0] * form->inner[1], all = form->surface.count[0] * form->surface.count[1],
      calm = 0;
  lbfgs l = {.n = n};
  for (int k = 0; k < PAIRS; k++) {
    l.s[k] = LAM_NEW(arena, lam_vec3, n);
    l.y[k] = LAM_NEW(arena, lam_vec3, n);
  }

  lam_vec3 *step = LAM_NEW(arena, lam_vec3, n), *old = LAM_NEW(arena, lam_vec3, n),
           *trial = LAM_NEW(arena, lam_vec3, all);
  lam_area_system system = lam_area_system_make(arena, form, 1);
  lam_area_dirichlet(form, points);
  if (!lam_area_system_factor(&system, form, 0)) {
    result->reason = "the surface is degenerate";
    return;
  }

  double scale = result->area, value = lam_area_slope(form, points);
  for (; result->iterations < options->most && !result->converged; result->iterations++) {
    double before = value;
    memcpy(old, form->gradient, (size_t)n * sizeof *old);
    direction(arena, &l, &system, old, step);
    double t = backtrack(form, points, step, lam_area_product(n, old, step), trial, &value,
                         &result->evaluations);
    if (!(t > 0)) {
      result->reason = "no step goes down any more";
      return;
    }

    memcpy(points, trial, (size_t)all * sizeof *points);
    keep(&l, t, step, old, form->gradient);
    calm = before - value <= options->tolerance * scale ? calm + 1 : 0;
    result->converged = options->enough > 0 ? value <= options->enough : calm >= 3;
  }

  if (result->converged) result->reason = lam_area_converged(options);
}
