/* Minima of smooth functions of a few variables. Used by surf/asymptotic for the free parameters
 * of patches. */
#ifndef LAM_CORE_NUMERIC_MINIMIZE_H
#define LAM_CORE_NUMERIC_MINIMIZE_H

enum { LAM_MINIMIZE_MAX = 16 }; /* variables */

/* Moves x[count] to a local minimum of value by quasi-Newton steps (BFGS). Returns the value
 * there.
 *
 * count  1 to LAM_MINIMIZE_MAX
 * value  INFINITY where it has none; finite at the start. Scale x so that it changes smoothly over
 *        a unit: gradients are differences of 2e-5
 * data   handed to value
 * steps  at most so many; it also stops after a step shorter than 1e-8, and when no step makes the
 *        value smaller */
double lam_minimize(int count, double (*value)(void *data, const double *x), void *data, int steps,
                    double *x);

#endif
