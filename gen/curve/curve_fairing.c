/* Fairing of curves: by an energy, and by removing and reinserting knots. The report of both is
 * measured by curve_fairness.c. Part of the curve kernel, called by its users only
 * (tests/unit/curve/test_curve_fit.c). */
#include "core/numeric/dense.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/gram.h"
#include "curve/curve_fairness.h"
#include <string.h>

enum {
  SAMPLES = 32, /* intervals per part on which fairness is measured */
  HALVINGS = 50 /* of the interval of the energy's share */
};

/* The largest distance between points of the same index. */
static double farthest(int count, const lam_vec3 *a, const lam_vec3 *b) {
  double most = 0;
  for (int i = 0; i < count; i++) most = fmax(most, lam_distance(a[i], b[i]));
  return most;
}

/* The report of a fairing. */
static lam_fairing compare(lam_arena *arena, const lam_spline_curve *before,
                           const lam_spline_curve *after) {
  lam_curve a = lam_curve_of_spline(arena, before), b = lam_curve_of_spline(arena, after);
  return (lam_fairing){lam_curve_fairness(arena, &a, SAMPLES),
                       lam_curve_fairness(arena, &b, SAMPLES),
                       farthest(before->count, before->points, after->points)};
}

typedef struct energy_problem {
  const lam_spline_curve *curve;
  int ends;
  const double *energy, *mass; /* Gram matrices of derivatives and functions, of trace 1 */
} energy_problem;

/* The control points of least s x'E x + (1 - s) (x - x0)'M (x - x0), with E and M the matrices of
 * the problem, x0 its curve, and the first and last `ends` points fixed. With A = s E + (1 - s)
 * M, the move y of the free points solves A y = -s (E x0)_free. False when A is not positive
 * definite to rounding. */
static bool solve(lam_arena *arena, const energy_problem *problem, double s, lam_vec3 *points) {
  int count = problem->curve->count, ends = problem->ends, n = count - 2 * ends;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *a = LAM_NEW(arena, double, n *n), *b[3];
  for (int c = 0; c < 3; c++) b[c] = LAM_NEW(arena, double, n);

  for (int i = 0; i < n; i++) {
    const double *row = problem->energy + (size_t)(i + ends) * count,
                 *mass = problem->mass + (size_t)(i + ends) * count;
    lam_vec3 pull = lam_v3(0, 0, 0);
    for (int j = 0; j < n; j++) a[i * n + j] = s * row[j + ends] + (1 - s) * mass[j + ends];
    for (int j = 0; j < count; j++) pull = lam_along(pull, -s * row[j], problem->curve->points[j]);
    b[0][i] = pull.x;
    b[1][i] = pull.y;
    b[2][i] = pull.z;
  }

  bool found = lam_cholesky_factor(n, a);
  memcpy(points, problem->curve->points, (size_t)count * sizeof *points);
  for (int c = 0; found && c < 3; c++) lam_cholesky_solve(n, a, b[c]);
  for (int i = 0; found && i < n; i++)
    points[i + ends] = lam_add(points[i + ends], lam_v3(b[0][i], b[1][i], b[2][i]));

  lam_arena_release(arena, mark);
  return found;
}

/* The Gram matrix of this derivative, scaled to trace 1: so energy and closeness have the same
 * size. */
static const double *scaled_gram(lam_arena *arena, const lam_spline_curve *c, int order) {
  double *gram = lam_spline_gram(arena, c->degree, c->count, c->knots, order), trace = 0;
  for (int i = 0; i < c->count; i++) trace += gram[i * c->count + i];
  for (int i = 0; i < c->count * c->count; i++) gram[i] /= trace;
  return gram;
}

/* Bisection for the largest share s of the energy whose solution stays within tolerance. It runs
 * over log(s / (1 - s)), because that share may lie anywhere in many orders of magnitude. */
lam_spline_curve lam_fair_by_energy(lam_arena *arena, lam_spline_curve curve, int order, int ends,
                                    double tolerance, lam_fairing *report) {
  energy_problem problem = {&curve, ends, scaled_gram(arena, &curve, order),
                            scaled_gram(arena, &curve, 0)};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, curve.count),
           *trial = LAM_NEW(arena, lam_vec3, curve.count);
  memcpy(points, curve.points, (size_t)curve.count * sizeof *points);

  /* The first trial is all energy: where that fits, it is the answer. */
  double low = -40, high = 40; /* of log(s / (1 - s)) */
  for (int k = 0; k < HALVINGS; k++) {
    double middle = k == 0 ? high : (low + high) / 2;
    bool fits = solve(arena, &problem, 1 / (1 + exp(-middle)), trial) &&
                farthest(curve.count, curve.points, trial) <= tolerance;

    if (fits) memcpy(points, trial, (size_t)curve.count * sizeof *points);
    if (fits)
      low = middle;
    else
      high = middle;
    if (low == high) break;
  }

  lam_spline_curve fair = {curve.degree, curve.count, curve.knots, points, NULL};
  if (report) *report = compare(arena, &curve, &fair);
  return fair;
}

/* The jump of the highest derivative at a knot, m per parameter^degree. */
static double jump_at(const lam_spline_curve *c, double t) {
  lam_vec3 after[LAM_BASIS_MAX_VALUES], before[LAM_BASIS_MAX_VALUES];
  lam_spline_curve_eval(c, t, c->degree, after);
  lam_spline_curve_eval(c, nextafter(t, -INFINITY), c->degree, before);
  return lam_distance(after[c->degree], before[c->degree]);
}

/* Removes the single knot t and reinserts it; moved points are drawn back to within tolerance of
 * the original ones, and the end points stay. */
static lam_spline_curve reinsert(lam_arena *arena, const lam_spline_curve *c, double t,
                                 const lam_vec3 *original, double tolerance) {
  lam_bspline less;
  lam_bspline_remove(arena, lam_spline_curve_net(arena, c, false), t, INFINITY, &less, NULL);
  lam_spline_curve again = lam_spline_curve_from_net(arena, lam_bspline_insert(arena, less, t, 1));

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, c->count);
  for (int i = 0; i < c->count; i++) {
    double apart = lam_distance(again.points[i], original[i]);
    points[i] = apart > tolerance ? lam_mix(original[i], again.points[i], tolerance / apart)
                                  : again.points[i];
  }

  points[0] = original[0];
  points[c->count - 1] = original[c->count - 1];
  return (lam_spline_curve){c->degree, c->count, c->knots, points, NULL};
}

/* Whether inner knot i stands once. */
static bool is_single(const lam_spline_curve *c, int i) {
  return c->knots[i] > c->knots[i - 1] && c->knots[i] < c->knots[i + 1];
}

/* The figure that fairing by knots lowers. */
static double sum_of_jumps(const lam_spline_curve *c) {
  double sum = 0;
  for (int i = c->degree + 1; i < c->count; i++)
    if (is_single(c, i)) sum += jump_at(c, c->knots[i]);
  return sum;
}

/* The single inner knot with the largest jump among those not tried yet; -1: none. */
static int worst_knot(const lam_spline_curve *c, const bool *tried) {
  int worst = -1;
  double most = 0;
  for (int i = c->degree + 1; i < c->count; i++) {
    double jump = is_single(c, i) && !tried[i] ? jump_at(c, c->knots[i]) : 0;
    if (jump > most) {
      most = jump;
      worst = i;
    }
  }
  return worst;
}

/* Fairs at one knot: of those with the largest jumps, the first whose reinsertion lowers the sum
 * of all jumps. False when there is none; *fair is unchanged then. */
static bool fair_one(lam_arena *arena, lam_spline_curve *fair, const lam_vec3 *original,
                     double tolerance) {
  bool *tried = LAM_NEW(arena, bool, fair->count);
  double before = sum_of_jumps(fair);

  for (int i = worst_knot(fair, tried); i >= 0; i = worst_knot(fair, tried)) {
    tried[i] = true;
    lam_spline_curve next = reinsert(arena, fair, fair->knots[i], original, tolerance);
    if (!(sum_of_jumps(&next) < before * (1 - 1e-9))) continue;
    *fair = next;
    return true;
  }

  return false;
}

/* Every step is measured against the curve that was given, so the moves do not add up. */
lam_spline_curve lam_fair_by_knots(lam_arena *arena, lam_spline_curve curve, int steps,
                                   double tolerance, lam_fairing *report) {
  lam_spline_curve fair = curve;
  for (int step = 0; step < steps; step++)
    if (!fair_one(arena, &fair, curve.points, tolerance)) break;
  if (report) *report = compare(arena, &curve, &fair);
  return fair;
}
