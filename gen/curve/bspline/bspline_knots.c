/* Changes of the knots of a spline: insertion (W. Boehm 1980), removal (W. Tiller 1992; Piegl &
 * Tiller, The NURBS Book, 5.2 and 5.4), parts, reversal, and a move of the domain. Called by
 * curve/curve_edit.c and curve/curve_fairing.c for curves, and by surf/spline for surfaces. */
#include "curve/bspline/basis.h"
#include "curve/bspline/bspline.h"
#include <math.h>
#include <string.h>

/* A spline whose arrays have room for further knots. */
typedef struct growing_spline {
  int degree, count, dimension;
  double *knots, *values;
} growing_spline;

/* One more knot t, with k the last index of knots[k] <= t and t a knot s times already:
 *   Q_i = P_i                        for i <= k - p,
 *   Q_i = a_i P_i + (1 - a_i) P_i-1  for k - p < i <= k - s,  a_i = (t - t_i) / (t_i+p - t_i),
 *   Q_i = P_i-1                      for i > k - s.
 * In place from the last to the first, as Q_i needs nothing behind P_i. */
static void insert_once(growing_spline *f, double t) {
  int p = f->degree, n = f->dimension, total = f->count + p + 1, k = total - 1, s = 0;
  while (k > 0 && f->knots[k] > t) k--;
  while (s <= k && f->knots[k - s] == t) s++;

  memmove(f->values + (k - s + 1) * n, f->values + (k - s) * n,
          (size_t)((f->count - k + s) * n) * sizeof *f->values);
  for (int i = k - s; i > k - p; i--) {
    double a = (t - f->knots[i]) / (f->knots[i + p] - f->knots[i]);
    for (int d = 0; d < n; d++)
      f->values[i * n + d] = a * f->values[i * n + d] + (1 - a) * f->values[(i - 1) * n + d];
  }

  memmove(f->knots + k + 2, f->knots + k + 1, (size_t)(total - k - 1) * sizeof *f->knots);
  f->knots[k + 1] = t;
  f->count++;
}

/* Counts what is missing first, so that the arrays are made once in their final size. */
lam_bspline lam_bspline_insert_all(lam_arena *arena, lam_bspline f, int count, const double *t,
                                   int multiplicity) {
  int more = 0, total = f.count + f.degree + 1;
  for (int i = 0; i < count; i++) {
    int missing = multiplicity - lam_bspline_multiplicity(&f, t[i]);
    more += missing > 0 ? missing : 0;
  }
  if (more == 0) return f;

  growing_spline g = {f.degree, f.count, f.dimension, LAM_NEW(arena, double, total + more),
                      LAM_NEW(arena, double, (f.count + more) * f.dimension)};
  memcpy(g.knots, f.knots, (size_t)total * sizeof *g.knots);
  memcpy(g.values, f.values, (size_t)(f.count * f.dimension) * sizeof *g.values);

  for (int i = 0; i < count; i++)
    for (int s = lam_bspline_multiplicity(&f, t[i]); s < multiplicity; s++) insert_once(&g, t[i]);
  return (lam_bspline){g.degree, g.count, g.dimension, g.knots, g.values};
}

lam_bspline lam_bspline_insert(lam_arena *arena, lam_bspline f, double t, int multiplicity) {
  return lam_bspline_insert_all(arena, f, 1, &t, multiplicity);
}

/* With low and high standing p + 1 times, the functions between them are those of the part. */
lam_bspline lam_bspline_part(lam_arena *arena, lam_bspline f, double low, double high) {
  int p = f.degree, first = 0, end = 0;
  f = lam_bspline_insert(arena, lam_bspline_insert(arena, f, low, p + 1), high, p + 1);

  while (f.knots[first + p + 1] <= low) first++; /* knots[first] ... knots[first + p] are low */
  while (f.knots[end] < high) end++;
  int count = end - first;
  double *knots = LAM_NEW(arena, double, count + p + 1);
  double *values = LAM_NEW(arena, double, count *f.dimension);
  memcpy(knots, f.knots + first, (size_t)(count + p + 1) * sizeof *knots);
  memcpy(values, f.values + first * f.dimension, (size_t)(count * f.dimension) * sizeof *values);
  return (lam_bspline){p, count, f.dimension, knots, values};
}

lam_bspline lam_bspline_clamp(lam_arena *arena, lam_bspline f) {
  return lam_bspline_part(arena, f, f.knots[f.degree], f.knots[f.count]);
}

/* Knots are mirrored in the middle of the domain, coefficients change their order. The ends of
 * the domain stay exactly what they are. */
lam_bspline lam_bspline_reverse(lam_arena *arena, lam_bspline f) {
  int total = f.count + f.degree + 1, n = f.dimension;
  double low = f.knots[f.degree], high = f.knots[f.count];
  double *knots = LAM_NEW(arena, double, total), *values = LAM_NEW(arena, double, f.count *n);
  for (int i = 0; i < total; i++) {
    double t = f.knots[total - 1 - i];
    knots[i] = t == low ? high : t == high ? low : low + (high - t);
  }
  for (int i = 0; i < f.count; i++)
    memcpy(values + i * n, f.values + (f.count - 1 - i) * n, (size_t)n * sizeof *values);
  return (lam_bspline){f.degree, f.count, n, knots, values};
}

/* Knots that are the upper end become `high` itself, free of rounding. */
lam_bspline lam_bspline_move_domain(lam_arena *arena, lam_bspline f, double low, double high) {
  int total = f.count + f.degree + 1;
  double from = f.knots[f.degree], to = f.knots[f.count];
  if (from == low && to == high) return f;
  double *knots = LAM_NEW(arena, double, total);
  for (int i = 0; i < total; i++) {
    double s = (f.knots[i] - from) / (to - from);
    knots[i] = f.knots[i] == to ? high : low + s * (high - low);
  }
  return (lam_bspline){f.degree, f.count, f.dimension, knots, f.values};
}

/* With t = t_r the last of its s repetitions, the coefficients r - p ... r - s of f follow from
 * those of the spline g without the knot (see insert_once). These equations are solved for g from
 * both sides. Where the two chains meet, they give the middle coefficient twice, or one equation
 * is left that was not used: what is left over is the deviation (Piegl & Tiller, A5.8). */
static lam_bspline remove_once(lam_arena *arena, lam_bspline f, int r, int s) {
  int p = f.degree, n = f.dimension, total = f.count + p + 1, low = r - p, high = r - s;
  double t = f.knots[r];
  double *knots = LAM_NEW(arena, double, total - 1);
  double *left = LAM_NEW(arena, double, f.count *n), *right = LAM_NEW(arena, double, f.count *n);
  memcpy(knots, f.knots, (size_t)r * sizeof *knots);
  memcpy(knots + r, f.knots + r + 1, (size_t)(total - r - 1) * sizeof *knots);

  /* What does not change: left[i] = f[i] for i < low, and right[i - 1] = f[i] for i > high. */
  memcpy(left, f.values, (size_t)(f.count * n) * sizeof *left);
  for (int i = high + 1; i < f.count; i++)
    memcpy(right + (i - 1) * n, f.values + i * n, (size_t)n * sizeof *right);

  int i = low, j = high; /* equations not used yet */
  for (; i < j; i++, j--) {
    double a = (t - knots[i]) / (knots[i + p] - knots[i]),
           b = (t - knots[j]) / (knots[j + p] - knots[j]);
    for (int d = 0; d < n; d++) {
      left[i * n + d] = (f.values[i * n + d] - (i > 0 ? (1 - a) * left[(i - 1) * n + d] : 0)) / a;
      right[(j - 1) * n + d] =
          (f.values[j * n + d] - (j < f.count - 1 ? b * right[j * n + d] : 0)) / (1 - b);
    }
  }

  /* g[0 .. i - 1] are in left, g[j ..] in right. With i == j that is all of g; with i == j + 1,
   * both have g[j], and the average is taken. */
  double *values = LAM_NEW(arena, double, f.count *n);
  for (int k = 0; k < f.count - 1; k++)
    for (int d = 0; d < n; d++) {
      double from_left = left[k * n + d], from_right = right[k * n + d];
      values[k * n + d] = k < i && k >= j ? (from_left + from_right) / 2
                          : k < i         ? from_left
                                          : from_right;
    }

  return (lam_bspline){p, f.count - 1, n, knots, values};
}

/* Removes the knot and puts it back: the coefficients that differ then bound the change. */
bool lam_bspline_remove(lam_arena *arena, lam_bspline f, double t, double tolerance,
                        lam_bspline *result, double *deviation) {
  int r = f.count + f.degree, s = lam_bspline_multiplicity(&f, t);
  *result = f;
  if (deviation) *deviation = INFINITY;
  if (s == 0 || !(t > f.knots[f.degree] && t < f.knots[f.count])) return false;

  while (f.knots[r] > t) r--;
  lam_bspline less = remove_once(arena, f, r, s), again = lam_bspline_insert(arena, less, t, s);
  double moved = lam_bspline_gap(&f, &again);
  if (deviation) *deviation = moved;

  if (!(moved <= tolerance)) return false;
  *result = less;
  return true;
}
