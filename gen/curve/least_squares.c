#include "curve/least_squares.h"
#include "curve/bspline/banded.h"
#include "curve/bspline/basis.h"
#include "curve/interpolate.h"

/* Inner knot j at the place j n / (count - degree) of the list of parameters (Piegl & Tiller,
 * eq. 9.68 and 9.69). */
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

/* Normal equations of the inner control points; the end points are the first and the last point. */
bool lam_fit_curve(lam_arena *arena, int degree, int count, const double *knots, int n,
                   const double *t, const lam_vec3 *points, lam_spline_curve *curve,
                   lam_fit_error *error) {
  if (!knots) knots = lam_fit_knots(arena, degree, count, n, t);
  lam_vec3 *net = LAM_NEW(arena, lam_vec3, count);
  lam_spline_curve fit = {degree, count, knots, net, NULL};
  int unknowns = count - 2;
  lam_banded a = lam_banded_make(arena, unknowns, degree);
  double *right = LAM_NEW(arena, double, 3 * unknowns);
  for (int i = 0; i < n; i++) {
    double basis[LAM_BASIS_MAX_VALUES];
    int span = lam_basis_span(degree, count, knots, t[i]), first = span - degree;
    lam_basis_eval(degree, knots, span, t[i], 0, basis);
    lam_vec3 rest = points[i];
    if (first == 0) rest = lam_along(rest, -basis[0], points[0]);
    if (span == count - 1) rest = lam_along(rest, -basis[degree], points[n - 1]);
    for (int j = 0; j <= degree; j++) {
      int row = first + j - 1;
      if (row < 0 || row >= unknowns) continue;
      for (int k = 0; k <= degree; k++)
        if (first + k > 0 && first + k < count - 1)
          *lam_banded_at(&a, row, first + k - 1) += basis[j] * basis[k];
      right[3 * row] += basis[j] * rest.x;
      right[3 * row + 1] += basis[j] * rest.y;
      right[3 * row + 2] += basis[j] * rest.z;
    }
  }
  if (!lam_banded_factor(&a)) return false;
  lam_banded_solve(&a, 3, right);
  net[0] = points[0];
  net[count - 1] = points[n - 1];
  for (int i = 0; i < unknowns; i++)
    net[i + 1] = lam_v3(right[3 * i], right[3 * i + 1], right[3 * i + 2]);
  *curve = fit;
  if (error) *error = measure(&fit, n, t, points);
  return true;
}

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
