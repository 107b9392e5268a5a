/* B-spline basis functions of any degree over any knots. Nothing here allocates. The floor of the
 * kernel: called by everything that evaluates, fits or checks a spline (curve, surf,
 * net/handles.c).
 *
 * A basis of degree p has `count` functions over count + p + 1 knots that do not decrease. Its
 * domain is [knots[p], knots[count]]. Outside of the domain the polynomial of the nearest piece
 * continues. */
#ifndef LAM_CURVE_BSPLINE_BASIS_H
#define LAM_CURVE_BSPLINE_BASIS_H

/* The highest degree that is accepted, and the number of functions on one piece then: the size of
 * arrays on the stack. */
enum { LAM_BASIS_MAX_DEGREE = 24, LAM_BASIS_MAX_VALUES = LAM_BASIS_MAX_DEGREE + 1 };

/* The index s of the non-empty piece knots[s] <= t < knots[s + 1] with degree <= s < count; at
 * the upper end of the domain and beyond it the last such piece, below the domain the first.
 * Precondition: lam_knots_problem returns NULL. */
int lam_basis_span(int degree, int count, const double *knots, double t);

/* The functions that do not vanish on the piece `span`, with derivatives up to `order` >= 0 (of
 * any size: derivatives above the degree are zero). values has (order + 1) * (degree + 1)
 * entries: values[k * (degree + 1) + j] is the k-th derivative of function span - degree + j at
 * t. Precondition: 0 <= degree <= LAM_BASIS_MAX_DEGREE. Piegl & Tiller, The NURBS Book, A2.3. */
void lam_basis_eval(int degree, const double *knots, int span, double t, int order, double *values);

/* Fills count + degree + 1 knots: degree + 1 times 0, evenly spaced inside, degree + 1 times 1.
 * Precondition: count > degree. */
void lam_knots_clamped(int degree, int count, double *knots);

/* What is wrong with knot_count knots for `count` functions of this degree, as the end of a
 * sentence ("must not decrease"; a static text); NULL when they are sound: the right number of
 * finite values that do not decrease, a domain that is not empty, and no inner knot repeated more
 * than `degree` times (more than once for degree 0; the surface would come apart there). */
const char *lam_knots_problem(int degree, int count, int knot_count, const double *knots);

#endif
