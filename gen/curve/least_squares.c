/* Least squares with splines. lam_fit_knots is called by surf/spline/spline_near.c; the fits of
 * curves are part of the curve kernel, called by its users only
 * (tests/unit/curve/test_curve_fit.c). */
#include "curve/least_squares.h"
#include "curve/bspline/banded.h"
#include "curve/bspline/basis.h"
#include "curve/interpolate.h"

/* Inner knot j at the position j n / (count - degree) in the list of parameters, between two of
 * them by linear interpolation (Piegl & Tiller, eq. 9.68 and 9.69). */
double *lam_fit_knots(lam_arena *arena, int degree, int count, int n, const double *t) {
  double *knots = LAM_NEW(arena, double, count + degree + 1), step = (double)n / (count - degree);
  for (int i = 0; i <= degree; i++) {
    knots[i] = t[0];
    knots[count + i] = t[n - 1];
  }
  for (int j = 1; j < count - degree; j++) {
    int i = (int)(j * step);
    double a = j * step - i;
    knots[degree + j] = (1 - a) * t[i - 1] + a * t[i];
  }
  return knots;
}

/* The distances of the points from the curve at their parameters, not from its nearest points. */
static lam_fit_error measure(const lam_spline_curve *curve, int n, const double *t,
                             const lam_vec3 *points) {
  lam_fit_error e = {0, 0};
  for (int i = 0; i < n; i++) {
    lam_vec3 x;
    lam_spline_curve_eval(curve, t[i], 0, &x);
    double d = lam_distance(x, points[i]);
    e.max = fmax(e.max, d);
    e.rms += d * d / n;
  }
  e.rms = sqrt(e.rms);
  return e;
}

/* Adds a point x at parameter t to the normal equations of the inner control points of the fit:
 * N_j N_k to a, and N_j (x - N_first P_first - N_last P_last) to right, 3 numbers per row. The end
 * points are known, so row i belongs to control point i + 1. */
static void add_point(const lam_spline_curve *fit, double t, lam_vec3 x, lam_banded *a,
                      double *right) {
  int degree = fit->degree, count = fit->count;
  double basis[LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(degree, count, fit->knots, t), first = span - degree;
  lam_basis_eval(degree, fit->knots, span, t, 0, basis);
  if (first == 0) x = lam_along(x, -basis[0], fit->points[0]);
  if (span == count - 1) x = lam_along(x, -basis[degree], fit->points[count - 1]);

  for (int j = 0; j <= degree; j++) {
    int row = first + j - 1;
    if (row < 0 || row >= count - 2) continue;
    for (int k = 0; k <= degree; k++)
      if (first + k > 0 && first + k < count - 1)
        *lam_banded_at(a, row, first + k - 1) += basis[j] * basis[k];
    right[3 * row] += basis[j] * x.x;
    right[3 * row + 1] += basis[j] * x.y;
    right[3 * row + 2] += basis[j] * x.z;
  }
}

/* The ends are the first and the last point, the inner control points solve the normal equations.
 * A function without points makes these singular. */
bool lam_fit_curve(lam_arena *arena, int degree, int count, const double *knots, int n,
                   const double *t, const lam_vec3 *points, lam_spline_curve *curve,
                   lam_fit_error *error) {
  if (!knots) knots = lam_fit_knots(arena, degree, count, n, t);
  lam_vec3 *net = LAM_NEW(arena, lam_vec3, count);
  net[0] = points[0];
  net[count - 1] = points[n - 1];
  lam_spline_curve fit = {degree, count, knots, net, NULL};

  int unknowns = count - 2;
  lam_banded a = lam_banded_make(arena, unknowns, degree);
  double *right = LAM_NEW(arena, double, 3 * unknowns);
  for (int i = 0; i < n; i++) add_point(&fit, t[i], points[i], &a, right);
  if (!lam_banded_factor(&a)) return false;
  lam_banded_solve(&a, 3, right);

  for (int i = 0; i < unknowns; i++)
    net[i + 1] = lam_v3(right[3 * i], right[3 * i + 1], right[3 * i + 2]);
  *curve = fit;
  if (error) *error = measure(&fit, n, t, points);
  return true;
}

/* One control point more at a time, up to n - 1; with n the curve interpolates. */
lam_spline_curve lam_fit_curve_within(lam_arena *arena, int degree, double tolerance, int n,
                                      const double *t, const lam_vec3 *points,
                                      lam_fit_error *error) {
  lam_spline_curve curve;
  lam_fit_error e;
  for (int count = degree + 1; count < n; count++)
    if (lam_fit_curve(arena, degree, count, NULL, n, t, points, &curve, &e) && e.max <= tolerance) {
      if (error) *error = e;
      return curve;
    }

  lam_bspline data =
      lam_spline_curve_net(arena, &(lam_spline_curve){.count = n, .points = points}, false);
  data = lam_interpolate(arena, LAM_ENDS_AVERAGE, degree, n, t, 3, data.values, NULL);
  curve = lam_spline_curve_from_net(arena, data);
  if (error) *error = measure(&curve, n, t, points);
  return curve;
}
