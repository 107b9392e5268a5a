/* Changes of the degree: elevation piece by piece, then back into one spline; reduction by least
 * squares in the space of one degree less. And what needs several splines on common knots. Called
 * by curve/curve_edit.c, and by surf/spline and surf/area for surfaces. */
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/bspline.h"
#include "curve/bspline/collocation.h"
#include <assert.h>
#include <math.h>
#include <string.h>

/* A knot of multiplicity m becomes one of multiplicity m + more: as smooth as before. */
lam_bspline lam_bspline_elevate(lam_arena *arena, lam_bspline f, int target) {
  int more = target - f.degree, n = f.dimension;
  assert(more >= 0 && target <= LAM_BASIS_MAX_DEGREE);
  if (more == 0) return lam_bspline_clamp(arena, f);

  lam_pieces pieces = lam_bspline_pieces(arena, f, 0, NULL);
  double *values = LAM_NEW(arena, double, pieces.count *(target + 1) * n);
  int *times = LAM_NEW(arena, int, pieces.count + 1);
  for (int k = 0; k < pieces.count; k++) {
    double *piece = values + (size_t)k * (target + 1) * n;
    memcpy(piece, pieces.values + (size_t)k * (f.degree + 1) * n,
           (size_t)((f.degree + 1) * n) * sizeof *piece);
    lam_bezier_elevate(f.degree, target, n, piece);
    times[k] = pieces.multiplicity[k] + more;
  }

  return lam_bspline_from_pieces(
      arena, &(lam_pieces){target, pieces.count, n, pieces.breaks, values, times});
}

/* The distinct inner knots of all splines, ascending, into knots; returns how many. All have the
 * same domain. */
static int merge_inner_knots(int count, const lam_bspline *list, double *knots) {
  int total = 0;
  for (;;) {
    /* The smallest knot above the last one that was found. */
    double next = INFINITY;
    for (int k = 0; k < count; k++)
      for (int i = list[k].degree + 1; i < list[k].count; i++) {
        double t = list[k].knots[i];
        if (t < next && t > (total ? knots[total - 1] : list[k].knots[list[k].degree])) next = t;
      }

    if (!(next < list[0].knots[list[0].count])) return total;
    knots[total++] = next;
  }
}

/* Replaces inner knots of list[k] by those of the splines before it that are the same to
 * rounding. Where several are near, that of the earliest spline is taken: it is compared last. */
static void snap(lam_arena *arena, int k, lam_bspline *list) {
  int total = list[k].count + list[k].degree + 1;
  double near = 1e-12 * (list[k].knots[list[k].count] - list[k].knots[list[k].degree]);
  double *knots = LAM_NEW(arena, double, total);
  memcpy(knots, list[k].knots, (size_t)total * sizeof *knots);

  for (int b = k - 1; b >= 0; b--)
    for (int i = list[k].degree + 1; i < list[k].count; i++)
      for (int j = list[b].degree + 1; j < list[b].count; j++)
        if (fabs(list[b].knots[j] - knots[i]) <= near) knots[i] = list[b].knots[j];

  list[k].knots = knots;
}

void lam_bspline_snap(lam_arena *arena, int count, lam_bspline *list) {
  for (int k = 1; k < count; k++) snap(arena, k, list);
}

/* Degree first, since elevation changes multiplicities; then every knot in the largest
 * multiplicity that any of the splines has. */
void lam_bspline_match(lam_arena *arena, int count, lam_bspline *list) {
  int degree = 0, size = 0;
  for (int k = 0; k < count; k++) degree = list[k].degree > degree ? list[k].degree : degree;
  for (int k = 0; k < count; k++) {
    list[k] = lam_bspline_elevate(arena, list[k], degree);
    size += list[k].count;
    snap(arena, k, list);
  }

  double *knots = LAM_NEW(arena, double, size);
  int total = merge_inner_knots(count, list, knots);

  for (int i = 0; i < total; i++) {
    int times = 0;
    for (int k = 0; k < count; k++) {
      int here = lam_bspline_multiplicity(&list[k], knots[i]);
      times = here > times ? here : times;
    }
    for (int k = 0; k < count; k++) list[k] = lam_bspline_insert(arena, list[k], knots[i], times);
  }

  for (int k = 1; k < count; k++) list[k].knots = list[0].knots;
}

/* The normal equations of the best approximation g of f. Adds to
 *   h[i][j] = integral N_i N_j    and    right[i] = integral N_i f,
 * with N_i the functions of g, q their degree. Per piece of g, Gauss' rule with q + 2 nodes is
 * exact: the integrands have degree 2 q + 1 at most. */
static void integrate(const lam_bspline *f, const lam_bspline *g, double *h, double *right) {
  int q = g->degree, n = f->dimension, rule = q + 2;
  double nodes[LAM_BASIS_MAX_VALUES + 1], weights[LAM_BASIS_MAX_VALUES + 1];
  lam_gauss_rule(rule, nodes, weights);

  for (int s = q; s < g->count; s++) {
    double size = g->knots[s + 1] - g->knots[s];
    for (int k = 0; size > 0 && k < rule; k++) {
      double t = g->knots[s] + size * nodes[k];
      double basis[LAM_BASIS_MAX_VALUES], basis_of_f[LAM_BASIS_MAX_VALUES];
      int span = lam_basis_span(f->degree, f->count, f->knots, t);
      lam_basis_eval(q, g->knots, s, t, 0, basis);
      lam_basis_eval(f->degree, f->knots, span, t, 0, basis_of_f);

      for (int i = 0; i <= q; i++) {
        double w = weights[k] * size * basis[i];
        for (int j = 0; j <= q; j++) h[(s - q + i) * g->count + s - q + j] += w * basis[j];
        for (int j = 0; j <= f->degree; j++)
          for (int d = 0; d < n; d++)
            right[(s - q + i) * n + d] +=
                w * basis_of_f[j] * f->values[(span - f->degree + j) * n + d];
      }
    }
  }
}

/* Conditions that g has the derivatives of f below order `ends` at both ends.
 *
 * rows    2 ends x count of g, zero: becomes the derivatives of the functions of g, scaled to a
 *         largest entry of 1
 * wanted  dimension x 2 ends: the derivatives of f, scaled likewise */
static void fix_ends(const lam_bspline *f, const lam_bspline *g, int ends, double *rows,
                     double *wanted) {
  double basis[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES],
      basis_of_f[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  int q = g->degree, n = f->dimension;
  for (int side = 0; side < 2; side++) {
    double t = side ? g->knots[g->count] : g->knots[q];
    int at = lam_basis_span(q, g->count, g->knots, t),
        from = lam_basis_span(f->degree, f->count, f->knots, t);
    lam_basis_eval(q, g->knots, at, t, ends, basis);
    lam_basis_eval(f->degree, f->knots, from, t, ends, basis_of_f);

    for (int k = 0; k < ends; k++) {
      int row = side * ends + k;
      double most = 0;
      for (int j = 0; j <= q; j++) most = fmax(most, fabs(basis[k * (q + 1) + j]));
      for (int j = 0; j <= q; j++)
        rows[row * g->count + at - q + j] = basis[k * (q + 1) + j] / most;

      for (int d = 0; d < n; d++) {
        double sum = 0;
        for (int j = 0; j <= f->degree; j++)
          sum += basis_of_f[k * (f->degree + 1) + j] * f->values[(from - f->degree + j) * n + d];
        wanted[d * 2 * ends + row] = sum / most;
      }
    }
  }
}

/* The knots of degree f->degree - 1 over which f is approximated: of every knot that is not single,
 * one repetition goes. Sets count to the number of functions. */
static double *reduced_knots(lam_arena *arena, const lam_bspline *f, int *count) {
  int total = f->count + f->degree + 1, kept = 0;
  double *knots = LAM_NEW(arena, double, total);
  for (int i = 1; i < total; i++) {
    bool single = i < total - 1 && f->knots[i] > f->knots[i - 1] && f->knots[i] < f->knots[i + 1];
    if (single || f->knots[i] == f->knots[i - 1]) knots[kept++] = f->knots[i];
  }
  *count = kept - f->degree;
  return knots;
}

/* One problem of least squares with equality constraints per coordinate; all share h and rows. */
lam_bspline lam_bspline_reduce(lam_arena *arena, lam_bspline f, int ends, double *deviation) {
  f = lam_bspline_clamp(arena, f);
  int n = f.dimension, count;
  double *knots = reduced_knots(arena, &f, &count);
  double *values = LAM_NEW(arena, double, count *n), *h = LAM_NEW(arena, double, count *count);
  double *right = LAM_NEW(arena, double, count *n), *gradient = LAM_NEW(arena, double, count);
  double *rows = LAM_NEW(arena, double, 2 * ends * count);
  double *wanted = LAM_NEW(arena, double, 2 * ends * n), *x = LAM_NEW(arena, double, count);

  lam_bspline g = {f.degree - 1, count, n, knots, values};
  integrate(&f, &g, h, right);
  fix_ends(&f, &g, ends, rows, wanted);
  for (int d = 0; d < n; d++) {
    for (int i = 0; i < count; i++) gradient[i] = -right[i * n + d];
    lam_least_energy(arena, count, h, gradient, 2 * ends, rows, wanted + d * 2 * ends, 1e-13, x);
    for (int i = 0; i < count; i++) values[i * n + d] = x[i];
  }

  if (deviation) {
    lam_bspline both[2] = {f, g};
    lam_bspline_match(arena, 2, both);
    *deviation = lam_bspline_gap(&both[0], &both[1]);
  }
  return g;
}
