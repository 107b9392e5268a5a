/* Fairing of spline surfaces: by energy (all control points at once, within a tolerance), and
 * by knots (one knot at a time, as Farin does for curves). Part of the surface kernel; called
 * by the unit tests. */
#include "curve/bspline/banded.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/gram.h"
#include "surf/spline/spline_edit.h"
#include "surf/spline/surface_fairness.h"
#include <string.h>

/* Samples of each span when fairness is measured; halvings of the interval of the energy's
 * share. */
enum { SAMPLES = 16, HALVINGS = 30 };

/* The largest distance of corresponding points, m. */
static double farthest(int count, const lam_vec3 *a, const lam_vec3 *b) {
  double most = 0;
  for (int i = 0; i < count; i++) most = fmax(most, lam_distance(a[i], b[i]));
  return most;
}

/* The report: fairness before and after, and how far control points have moved. */
static lam_surface_fairing compare(lam_arena *arena, const lam_spline_surface *before,
                                   const lam_spline_surface *after) {
  return (lam_surface_fairing){
      lam_spline_surface_fairness(arena, before, SAMPLES),
      lam_spline_surface_fairness(arena, after, SAMPLES),
      farthest(before->count[0] * before->count[1], before->points, after->points)};
}

/* ---- by energy ---- */

/* What the linear systems of all shares s have in common. */
typedef struct lam_energy_problem {
  const lam_spline_surface *surface;
  int ends;
  const double *gram[2][3];
  double factor[3];    /* of the orders 0, 1, 2 in u: r^2, 2, r^-2 */
  double energy, mass; /* traces, which the two are divided by */
} lam_energy_problem;

/* The entries of energy and mass for control points (i, j) and (k, l). */
static void entries(const lam_energy_problem *p, int i, int j, int k, int l, double *energy,
                    double *mass) {
  int m = p->surface->count[0], n = p->surface->count[1];
  *energy = 0;
  for (int order = 0; order < 3; order++)
    *energy += p->factor[order] * p->gram[0][order][i * m + k] * p->gram[1][2 - order][j * n + l];
  *mass = p->gram[0][0][i * m + k] * p->gram[1][0][j * n + l];
}

/* Row `at` of A = s E + (1 - s) M, for the free point of this number, goes to a; returns its
 * right side, -s (E x). rows, columns: of the free points. */
static lam_vec3 fill_row(const lam_energy_problem *p, double s, int at, int rows, int columns,
                         lam_banded *a) {
  const lam_spline_surface *f = p->surface;
  int n = f->count[1], i = at / columns + p->ends, j = at % columns + p->ends;
  lam_vec3 pull = {0, 0, 0};
  for (int k = i > f->degree[0] ? i - f->degree[0] : 0; k < f->count[0] && k <= i + f->degree[0];
       k++)
    for (int l = j > f->degree[1] ? j - f->degree[1] : 0; l < n && l <= j + f->degree[1]; l++) {
      double energy, mass;
      entries(p, i, j, k, l, &energy, &mass);
      pull = lam_along(pull, -s * energy / p->energy, f->points[k * n + l]);

      /* Points of the outer rings stay: they pull, but have no column. */
      int row = k - p->ends, column = l - p->ends;
      if (row >= 0 && row < rows && column >= 0 && column < columns)
        *lam_banded_at(a, at, row * columns + column) =
            s * energy / p->energy + (1 - s) * mass / p->mass;
    }
  return pull;
}

/* The free points of least s energy + (1 - s) mass-weighted move; false when that has no
 * minimum to rounding. With A = s E + (1 - s) M, the move y of the free points solves A y = -s
 * (E x)_free. */
static bool solve(lam_arena *arena, const lam_energy_problem *p, double s, lam_vec3 *points) {
  const lam_spline_surface *f = p->surface;
  int rows = f->count[0] - 2 * p->ends, columns = f->count[1] - 2 * p->ends, n = f->count[1];
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_banded a = lam_banded_make(arena, rows * columns, f->degree[0] * columns + f->degree[1]);

  double *right = LAM_NEW(arena, double, 3 * rows * columns);
  for (int at = 0; at < rows * columns; at++) {
    lam_vec3 pull = fill_row(p, s, at, rows, columns, &a);
    right[3 * at] = pull.x;
    right[3 * at + 1] = pull.y;
    right[3 * at + 2] = pull.z;
  }

  bool found = lam_banded_factor(&a);
  memcpy(points, f->points, (size_t)(f->count[0] * n) * sizeof *points);
  if (found) lam_banded_solve(&a, 3, right);

  for (int at = 0; found && at < rows * columns; at++) {
    int to = (at / columns + p->ends) * n + at % columns + p->ends;
    points[to] = lam_add(points[to], lam_v3(right[3 * at], right[3 * at + 1], right[3 * at + 2]));
  }

  lam_arena_release(arena, mark);
  return found;
}

/* The mean length of the control net along direction d. */
static double mean_length(const lam_spline_surface *s, int d) {
  double sum = 0;
  for (int i = d ? 0 : 1; i < s->count[0]; i++)
    for (int j = d ? 1 : 0; j < s->count[1]; j++)
      sum += lam_distance(s->points[i * s->count[1] + j],
                          s->points[d ? i * s->count[1] + j - 1 : (i - 1) * s->count[1] + j]);
  return sum / s->count[1 - d];
}

/* Gram matrices, factors of a thin plate as long and wide as the surface, and traces. */
static lam_energy_problem problem_of(lam_arena *arena, const lam_spline_surface *s, int ends) {
  lam_energy_problem p = {.surface = s, .ends = ends};
  double length[2];
  for (int d = 0; d < 2; d++) {
    const double *knots = s->knots[d];
    length[d] = mean_length(s, d) / (knots[s->count[d]] - knots[s->degree[d]]);
    for (int k = 0; k < 3; k++)
      p.gram[d][k] = lam_spline_gram(arena, s->degree[d], s->count[d], knots, k);
  }

  double r = length[0] / length[1];
  p.factor[0] = r * r;
  p.factor[1] = 2;
  p.factor[2] = 1 / (r * r);

  for (int i = 0; i < s->count[0]; i++)
    for (int j = 0; j < s->count[1]; j++) {
      double energy, mass;
      entries(&p, i, j, i, j, &energy, &mass);
      p.energy += energy;
      p.mass += mass;
    }
  return p;
}

/* The share of the energy is found by bisection; as it grows the points move farther. */
lam_spline_surface lam_surface_fair_by_energy(lam_arena *arena, const lam_spline_surface *surface,
                                              int ends, double tolerance,
                                              lam_surface_fairing *report) {
  int total = surface->count[0] * surface->count[1];
  lam_spline_surface fair = *surface;
  if (surface->count[0] > 2 * ends && surface->count[1] > 2 * ends) {
    lam_energy_problem p = problem_of(arena, surface, ends);
    lam_vec3 *points = LAM_NEW(arena, lam_vec3, total), *trial = LAM_NEW(arena, lam_vec3, total);
    memcpy(points, surface->points, (size_t)total * sizeof *points);

    double low = -40, high = 40; /* of log(s / (1 - s)): the moves grow with it */
    for (int k = 0; k < HALVINGS && low < high; k++) {
      double middle = k == 0 ? high : (low + high) / 2; /* first: all energy */

      bool fits = solve(arena, &p, 1 / (1 + exp(-middle)), trial) &&
                  farthest(total, surface->points, trial) <= tolerance;
      if (fits) memcpy(points, trial, (size_t)total * sizeof *points);
      if (fits)
        low = middle;
      else
        high = middle;
    }
    fair.points = points;
  }

  if (report) *report = compare(arena, surface, &fair);
  return fair;
}

/* ---- by knots ---- */

/* The largest jump of the highest derivative across knot t of direction d, times the mean span
 * to that power: m. */
static double jump_at(lam_arena *arena, const lam_spline_surface *s, int d, double t) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_bspline net = lam_spline_surface_net(arena, s, d);
  int p = net.degree, n = net.dimension;
  double *after = LAM_NEW(arena, double, (p + 1) * n),
         *before = LAM_NEW(arena, double, (p + 1) * n), most = 0;

  lam_bspline_eval(&net, t, p, after);
  lam_bspline_eval(&net, nextafter(t, -INFINITY), p, before);
  for (int i = p * n; i < (p + 1) * n; i += 3)
    most = fmax(most, hypot(hypot(after[i] - before[i], after[i + 1] - before[i + 1]),
                            after[i + 2] - before[i + 2]));

  lam_arena_release(arena, mark);
  return most * pow((net.knots[net.count] - net.knots[p]) / (net.count - p), p);
}

/* Whether knot i of direction d stands alone. */
static bool is_single(const lam_spline_surface *s, int d, int i) {
  return s->knots[d][i] > s->knots[d][i - 1] && s->knots[d][i] < s->knots[d][i + 1];
}

/* Over all single inner knots of both directions. */
static double sum_of_jumps(lam_arena *arena, const lam_spline_surface *s) {
  double sum = 0;
  for (int d = 0; d < 2; d++)
    for (int i = s->degree[d] + 1; i < s->count[d]; i++)
      if (is_single(s, d, i)) sum += jump_at(arena, s, d, s->knots[d][i]);
  return sum;
}

/* Removes and reinserts t; moved points are drawn back to within tolerance of the original
 * ones. The outer ring stays. */
static lam_spline_surface reinsert(lam_arena *arena, const lam_spline_surface *s, int d, double t,
                                   const lam_vec3 *original, double tolerance) {
  lam_bspline less;
  lam_bspline_remove(arena, lam_spline_surface_net(arena, s, d), t, INFINITY, &less, NULL);
  lam_spline_surface again =
      lam_spline_surface_from_net(arena, s, d, lam_bspline_insert(arena, less, t, 1));
  int m = s->count[0], n = s->count[1];

  lam_vec3 *points = LAM_NEW(arena, lam_vec3, m * n);
  for (int i = 0; i < m * n; i++) {
    double apart = lam_distance(again.points[i], original[i]);
    bool outer = i / n == 0 || i / n == m - 1 || i % n == 0 || i % n == n - 1;
    points[i] = outer               ? original[i]
                : apart > tolerance ? lam_mix(original[i], again.points[i], tolerance / apart)
                                    : again.points[i];
  }

  again = *s;
  again.points = points;
  return again;
}

/* One knot, the worst that helps; false: none does. tried[d * most + i]: knot i of direction d
 * has been tried. */
static bool fair_one(lam_arena *arena, lam_spline_surface *fair, const lam_vec3 *original,
                     double tolerance) {
  int most = fair->count[0] > fair->count[1] ? fair->count[0] : fair->count[1];
  bool *tried = LAM_NEW(arena, bool, 2 * most);
  double before = sum_of_jumps(arena, fair);

  for (;;) {
    int worst = -1;
    double largest = 0;
    for (int d = 0; d < 2; d++)
      for (int i = fair->degree[d] + 1; i < fair->count[d]; i++) {
        if (tried[d * most + i] || !is_single(fair, d, i)) continue;
        double jump = jump_at(arena, fair, d, fair->knots[d][i]);
        if (jump > largest) {
          largest = jump;
          worst = d * most + i;
        }
      }

    if (worst < 0) return false;
    tried[worst] = true;

    int d = worst / most;
    lam_spline_surface next =
        reinsert(arena, fair, d, fair->knots[d][worst % most], original, tolerance);
    if (!(sum_of_jumps(arena, &next) < before * (1 - 1e-9))) continue;
    *fair = next;
    return true;
  }
}

/* One knot a step. */
lam_spline_surface lam_surface_fair_by_knots(lam_arena *arena, const lam_spline_surface *surface,
                                             int steps, double tolerance,
                                             lam_surface_fairing *report) {
  lam_spline_surface fair = *surface;
  for (int step = 0; step < steps; step++)
    if (!fair_one(arena, &fair, surface->points, tolerance)) break;
  if (report) *report = compare(arena, surface, &fair);
  return fair;
}
