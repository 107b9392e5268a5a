/* Values of splines, and figures that the other files of this folder need. Called by
 * bspline_knots.c and bspline_degree.c, and by surf/spline. */
#include "curve/bspline/bspline.h"
#include "curve/bspline/basis.h"
#include <assert.h>
#include <math.h>

/* f^(k)(t) = sum over the degree + 1 functions of the piece of N_j^(k)(t) c_j. */
void lam_bspline_eval(const lam_bspline *f, double t, int order, double *result) {
  double basis[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  assert(order <= LAM_BASIS_MAX_DEGREE);
  int width = f->degree + 1, n = f->dimension;
  int span = lam_basis_span(f->degree, f->count, f->knots, t);
  lam_basis_eval(f->degree, f->knots, span, t, order, basis);

  const double *values = f->values + (size_t)(span - f->degree) * n;
  for (int k = 0; k <= order; k++)
    for (int d = 0; d < n; d++) {
      double sum = 0;
      for (int j = 0; j < width; j++) sum += basis[k * width + j] * values[j * n + d];
      result[k * n + d] = sum;
    }
}

int lam_bspline_multiplicity(const lam_bspline *f, double t) {
  int times = 0;
  for (int i = 0; i < f->count + f->degree + 1; i++) times += f->knots[i] == t;
  return times;
}

/* The largest Euclidean distance between coefficients of the same index. */
double lam_bspline_gap(const lam_bspline *f, const lam_bspline *g) {
  double most = 0;
  assert(f->degree == g->degree && f->count == g->count && f->dimension == g->dimension);

  for (int i = 0; i < f->count; i++) {
    double sum = 0;
    for (int d = 0; d < f->dimension; d++) {
      double apart = f->values[i * f->dimension + d] - g->values[i * f->dimension + d];
      sum += apart * apart;
    }
    most = fmax(most, sqrt(sum));
  }
  return most;
}
