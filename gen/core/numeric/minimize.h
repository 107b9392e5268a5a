/* Minima of smooth functions of a few variables. */
#ifndef LAM_CORE_NUMERIC_MINIMIZE_H
#define LAM_CORE_NUMERIC_MINIMIZE_H

enum { LAM_MINIMIZE_MAX = 16 };

/* Moves x[count], count <= LAM_MINIMIZE_MAX, to a local minimum of value, which is INFINITY where
 * it has none; it must be finite at the start. Quasi-Newton steps (BFGS) with gradients by
 * differences of 2e-5: x should be scaled so that value changes smoothly over a unit. Stops after a
 * step shorter than 1e-8, when no step makes the value smaller, or after `steps` steps. Returns the
 * value at x. */
double lam_minimize(int count, double (*value)(void *data, const double *x), void *data, int steps,
                    double *x);

#endif
