/* Evaluation of spline curves, and the two ways between a curve and its homogeneous spline.
 * Called by the other files of this folder, by mesh/line_curve.c, and by surf/kinds, surf/spline
 * and surf/area. */
#include "curve/curve.h"
#include "curve/bspline/basis.h"
#include <assert.h>

/* Derivatives of x = A / W, with A the sum of w P and W the sum of w (Piegl & Tiller, eq. 4.8):
 *   x^(k) = (A^(k) - sum_{i=1..k} C(k,i) W^(i) x^(k-i)) / W. */
void lam_spline_curve_eval(const lam_spline_curve *c, double t, int order, lam_vec3 *values) {
  double basis[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES], weight[LAM_BASIS_MAX_VALUES];
  assert(order <= LAM_BASIS_MAX_DEGREE);
  int span = lam_basis_span(c->degree, c->count, c->knots, t);
  int first = span - c->degree, width = c->degree + 1;
  lam_basis_eval(c->degree, c->knots, span, t, order, basis);

  /* A and W with their derivatives: the numerator goes to values. */
  for (int k = 0; k <= order; k++) {
    values[k] = lam_v3(0, 0, 0);
    weight[k] = 0;
    for (int j = 0; j < width; j++) {
      double w = basis[k * width + j] * (c->weights ? c->weights[first + j] : 1);
      values[k] = lam_along(values[k], w, c->points[first + j]);
      weight[k] += w;
    }
  }

  /* The quotient, from the lowest derivative up. */
  for (int k = 0; c->weights && k <= order; k++) {
    double binomial = 1;
    for (int i = 1; i <= k; i++) {
      binomial = binomial * (k - i + 1) / i;
      values[k] = lam_along(values[k], -binomial * weight[i], values[k - i]);
    }
    values[k] = lam_scale(values[k], 1 / weight[0]);
  }
}

/* lam_curve.eval of a spline curve. */
static void eval_spline(const void *data, double t, int order, lam_vec3 *values) {
  lam_spline_curve_eval(data, t, order, values);
}

/* Repeated knots give one break; the ends of the domain are none. */
lam_curve lam_curve_of_spline(lam_arena *arena, const lam_spline_curve *spline) {
  double *breaks = LAM_NEW(arena, double, spline->count), high = spline->knots[spline->count];
  int count = 0;
  for (int i = spline->degree + 1; i < spline->count; i++)
    if (spline->knots[i] > spline->knots[i - 1] &&
        spline->knots[i] > spline->knots[spline->degree] && spline->knots[i] < high)
      breaks[count++] = spline->knots[i];
  return (lam_curve){eval_spline, spline, spline->knots[spline->degree], high, count, breaks};
}

/* The list that integration and sampling go along, part by part. */
const double *lam_curve_breakpoints(lam_arena *arena, const lam_curve *curve) {
  double *breakpoints = LAM_NEW(arena, double, curve->break_count + 2);
  breakpoints[0] = curve->from;
  for (int i = 0; i < curve->break_count; i++) breakpoints[i + 1] = curve->breaks[i];
  breakpoints[curve->break_count + 1] = curve->to;
  return breakpoints;
}

/* Degree and count first: the test of the knots needs them. */
const char *lam_spline_curve_problem(const lam_spline_curve *curve) {
  if (curve->degree < 1 || curve->degree > LAM_BASIS_MAX_DEGREE) return "has a degree out of range";
  if (curve->count <= curve->degree) return "has too few points for its degree";
  for (int i = 0; curve->weights && i < curve->count; i++)
    if (!(curve->weights[i] > 0)) return "has a weight that is not positive";
  return lam_knots_problem(curve->degree, curve->count, curve->count + curve->degree + 1,
                           curve->knots);
}

/* (w x, w y, w z, w) per point, without w when the curve is polynomial. */
lam_bspline lam_spline_curve_net(lam_arena *arena, const lam_spline_curve *curve, bool rational) {
  int n = rational || curve->weights ? 4 : 3;
  double *values = LAM_NEW(arena, double, curve->count *n);
  for (int i = 0; i < curve->count; i++) {
    double w = curve->weights ? curve->weights[i] : 1;
    values[i * n] = w * curve->points[i].x;
    values[i * n + 1] = w * curve->points[i].y;
    values[i * n + 2] = w * curve->points[i].z;
    if (n == 4) values[i * n + 3] = w;
  }
  return (lam_bspline){curve->degree, curve->count, n, curve->knots, values};
}

/* Divides by w where there is one. */
lam_spline_curve lam_spline_curve_from_net(lam_arena *arena, lam_bspline net) {
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, net.count);
  double *weights = net.dimension == 4 ? LAM_NEW(arena, double, net.count) : NULL;
  for (int i = 0; i < net.count; i++) {
    const double *p = net.values + i * net.dimension;
    if (weights) weights[i] = p[3];
    points[i] = lam_scale(lam_v3(p[0], p[1], p[2]), weights ? 1 / p[3] : 1);
  }
  return (lam_spline_curve){net.degree, net.count, net.knots, points, weights};
}
