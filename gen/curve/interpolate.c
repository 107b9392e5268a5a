/* Interpolation: C2 cubics with conditions at the ends, splines of any degree, and the local C1
 * cubic. Called by least_squares.c, mesh/line_curve.c and surf/spline/spline_through.c. */
#include "curve/interpolate.h"
#include "curve/bspline/banded.h"
#include "curve/bspline/basis.h"
#include <string.h>

/* Clamped knots over [t[0], t[count - 1]] with `inner` inner ones. */
static double *clamped(lam_arena *arena, int degree, int count, const double *t, int inner,
                       const double *knots) {
  double *all = LAM_NEW(arena, double, inner + 2 * degree + 2);
  for (int i = 0; i <= degree; i++) {
    all[i] = t[0];
    all[degree + 1 + inner + i] = t[count - 1];
  }
  memcpy(all + degree + 1, knots, (size_t)inner * sizeof *all);
  return all;
}

/* Inner knots that are averages of `degree` parameters each (Piegl & Tiller, eq. 9.8). */
static double *averages(lam_arena *arena, int degree, int count, const double *t) {
  int inner = count - degree - 1;
  double *knots = LAM_NEW(arena, double, count);
  for (int j = 0; j < inner; j++)
    for (int i = 1; i <= degree; i++) knots[j] += t[j + i] / degree;
  return clamped(arena, degree, count, t, inner, knots);
}

/* One row of the system: the derivative of this order at t. Rows of positions keep |i - j| <=
 * degree, because t lies in the support of function i (Schoenberg & Whitney). Zeros are not
 * written: at a knot, the function that begins there may lie outside the band. */
static void set_row(lam_banded *a, const lam_bspline *f, int row, double t, int order) {
  double basis[3 * LAM_BASIS_MAX_VALUES];
  int span = lam_basis_span(f->degree, f->count, f->knots, t), width = f->degree + 1;
  lam_basis_eval(f->degree, f->knots, span, t, order, basis);

  for (int j = 0; j < width; j++) {
    int column = span - f->degree + j;
    if (basis[order * width + j] != 0) *lam_banded_at(a, row, column) = basis[order * width + j];
  }
}

/* The C2 cubic with knots at the parameters and a derivative of this order given at both ends
 * (slopes: 2 x n; NULL: zero). Points at rows 0, 2, ..., count - 1, count + 1, end derivatives at
 * rows 1 and count. */
static lam_bspline with_derivatives(lam_arena *arena, int order, int count, const double *t, int n,
                                    const double *values, const double *slopes) {
  int total = count + 2;
  double *right = LAM_NEW(arena, double, total *n);
  lam_bspline f = {3, total, n, clamped(arena, 3, count, t, count - 2, t + 1), right};
  lam_banded a = lam_banded_make(arena, total, 3);

  for (int i = 0; i < count; i++) {
    int row = i == 0 ? 0 : i == count - 1 ? total - 1 : i + 1;
    set_row(&a, &f, row, t[i], 0);
    memcpy(right + row * n, values + i * n, (size_t)n * sizeof *right);
  }

  for (int e = 0; e < 2; e++) {
    set_row(&a, &f, e ? total - 2 : 1, e ? t[count - 1] : t[0], order);
    for (int d = 0; slopes && d < n; d++) right[(e ? total - 2 : 1) * n + d] = slopes[e * n + d];
  }

  /* Regular: the problem has one solution. */
  lam_banded_factor(&a);
  lam_banded_solve(&a, n, right);
  return f;
}

/* Ends with conditions give two more coefficients than points; the others as many. */
lam_bspline lam_interpolate(lam_arena *arena, lam_ends ends, int degree, int count, const double *t,
                            int dimension, const double *values, const double *slopes) {
  if (ends == LAM_ENDS_NATURAL)
    return with_derivatives(arena, 2, count, t, dimension, values, NULL);
  if (ends == LAM_ENDS_TANGENTS)
    return with_derivatives(arena, 1, count, t, dimension, values, slopes);

  if (ends == LAM_ENDS_NOT_A_KNOT) degree = 3;
  if (degree > count - 1) degree = count - 1;

  double *right = LAM_NEW(arena, double, count *dimension);
  const double *knots = ends == LAM_ENDS_NOT_A_KNOT && count > 4
                            ? clamped(arena, 3, count, t, count - 4, t + 2)
                            : averages(arena, degree, count, t);
  lam_bspline f = {degree, count, dimension, knots, right};

  lam_banded a = lam_banded_make(arena, count, degree);
  for (int i = 0; i < count; i++) set_row(&a, &f, i, t[i], 0);
  memcpy(right, values, (size_t)(count * dimension) * sizeof *right);
  lam_banded_factor(&a);
  lam_banded_solve(&a, dimension, right);
  return f;
}

/* Bessel's tangents: at an inner point the derivative of the parabola through it and its neighbors,
 * at an end that of the same parabola there. */
static void bessel_tangents(int count, const double *t, const lam_vec3 *points,
                            lam_vec3 *tangents) {
  lam_vec3 before = lam_scale(lam_sub(points[1], points[0]), 1 / (t[1] - t[0]));
  lam_vec3 first = before;
  tangents[0] = tangents[1] = before;

  for (int i = 1; i + 1 < count; i++) {
    double h = t[i] - t[i - 1], k = t[i + 1] - t[i];
    lam_vec3 after = lam_scale(lam_sub(points[i + 1], points[i]), 1 / k);
    tangents[i] = lam_scale(lam_along(lam_scale(before, k), h, after), 1 / (h + k));
    before = after;
  }

  if (count == 2) return;
  tangents[0] = lam_sub(lam_scale(first, 2), tangents[1]);
  tangents[count - 1] = lam_sub(lam_scale(before, 2), tangents[count - 2]);
}

/* The tangents are used by LAM_ENDS_TANGENTS only. */
lam_spline_curve lam_interpolate_points(lam_arena *arena, lam_ends ends, int degree,
                                        lam_parameters parameters, int count,
                                        const lam_vec3 *points) {
  double *t = LAM_NEW(arena, double, count);
  lam_vec3 *tangents = LAM_NEW(arena, lam_vec3, count);
  lam_parameters_choose(parameters, count, points, t);
  bessel_tangents(count, t, points, tangents);

  lam_vec3 a = tangents[0], b = tangents[count - 1];
  const double slopes[] = {a.x, a.y, a.z, b.x, b.y, b.z};

  lam_bspline data =
      lam_spline_curve_net(arena, &(lam_spline_curve){.count = count, .points = points}, false);
  return lam_spline_curve_from_net(
      arena, lam_interpolate(arena, ends, degree, count, t, 3, data.values, slopes));
}

/* Per piece the inner Bezier points lie a third of its end derivatives away from its ends; inner
 * knots stand twice, so the points at them need not be coefficients. */
lam_spline_curve lam_interpolate_local(lam_arena *arena, int count, const double *t,
                                       const lam_vec3 *points, const lam_vec3 *tangents) {
  int total = 2 * count, at = 0;
  double *knots = LAM_NEW(arena, double, total + 4);
  lam_vec3 *net = LAM_NEW(arena, lam_vec3, total), *slopes = LAM_NEW(arena, lam_vec3, count);
  bessel_tangents(count, t, points, slopes);
  if (tangents) memcpy(slopes, tangents, (size_t)count * sizeof *slopes);

  for (int i = 0; i < count; i++)
    for (int k = 0; k < (i == 0 || i == count - 1 ? 4 : 2); k++) knots[at++] = t[i];

  net[0] = points[0];
  net[total - 1] = points[count - 1];
  for (int i = 0; i + 1 < count; i++) {
    double third = (t[i + 1] - t[i]) / 3;
    net[2 * i + 1] = lam_along(points[i], third, slopes[i]);
    net[2 * i + 2] = lam_along(points[i + 1], -third, slopes[i + 1]);
  }
  return (lam_spline_curve){3, total, knots, net, NULL};
}
