/* Least squares between the points of equal parameters of two surfaces, on an exact boundary.
 * Called by area_paper.c; area_patches.c measures with it how far the patches move. */
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_paper.h"
#include "surf/spline/spline_surface.h"
#include <math.h>

/* The rational functions of the space that do not vanish at (u, v), v fastest, and the numbers
 * of their points in the net. Returns how many there are. */
static int functions_at(const lam_spline_surface *s, double u, double v, double *values,
                        int *index) {
  double f[2][LAM_BASIS_MAX_VALUES], at[2] = {u, v}, sum = 0;
  int first[2], count = 0;
  for (int d = 0; d < 2; d++) {
    int span = lam_basis_span(s->degree[d], s->count[d], s->knots[d], at[d]);
    lam_basis_eval(s->degree[d], s->knots[d], span, at[d], 0, f[d]);
    first[d] = span - s->degree[d];
  }

  for (int i = 0; i <= s->degree[0]; i++)
    for (int j = 0; j <= s->degree[1]; j++, count++) {
      index[count] = (first[0] + i) * s->count[1] + first[1] + j;
      sum += values[count] = f[0][i] * f[1][j] * (s->weights ? s->weights[index[count]] : 1);
    }

  for (int k = 0; k < count; k++) values[k] /= sum;
  return count;
}

/* The normal equations of a fit on the knots, weights and boundary of `space`. */
typedef struct fitting {
  const lam_spline_surface *space;
  int inner;    /* inner points of a row of the net */
  int unknowns; /* inner points */
  double *matrix,
      *right; /* fit: unknowns^2, 3 x unknowns; with weights: 4 times as many each way */
} fitting;

/* The inner point that is point `at` of the net, or -1 on the boundary. */
static int unknown_of(const fitting *f, int at) {
  int n = f->space->count[1], i = at / n - 1, j = at % n - 1;
  return i >= 0 && j >= 0 && i < f->space->count[0] - 2 && j < n - 2 ? i * f->inner + j : -1;
}

/* Adds a node (u, v) of the given weight, where the surface is to be near x, to the normal
 * equations. What the boundary gives is fixed and goes to the right side. */
static void add_node(fitting *f, double u, double v, double weight, lam_vec3 x) {
  double values[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  int index[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES],
      count = functions_at(f->space, u, v, values, index);
  for (int k = 0; k < count; k++)
    if (unknown_of(f, index[k]) < 0) x = lam_along(x, -values[k], f->space->points[index[k]]);

  for (int k = 0; k < count; k++) {
    int row = unknown_of(f, index[k]);
    if (row < 0) continue;
    for (int l = 0; l < count; l++)
      if (unknown_of(f, index[l]) >= 0)
        f->matrix[(size_t)row * (size_t)f->unknowns + (size_t)unknown_of(f, index[l])] +=
            weight * values[k] * values[l];
    for (int c = 0; c < 3; c++) f->right[c * f->unknowns + row] += weight * values[k] * (&x.x)[c];
  }
}

/* Calls act for every Gauss node of the spans of a surface: u, v and the weight. */
static void each_node(lam_arena *arena, const lam_spline_surface *s,
                      void (*act)(void *context, double u, double v, double weight),
                      void *context) {
  int count = (s->degree[0] > s->degree[1] ? s->degree[0] : s->degree[1]) + 5;
  lam_arena_mark mark = lam_arena_mark_get(arena);
  double *at = LAM_NEW(arena, double, count), *weights = LAM_NEW(arena, double, count);
  const double *a = s->knots[0], *b = s->knots[1];
  lam_gauss_rule(count, at, weights);

  for (int i = s->degree[0]; i < s->count[0]; i++)
    for (int j = s->degree[1]; j < s->count[1]; j++) {
      double hu = a[i + 1] - a[i], hv = b[j + 1] - b[j];
      for (int k = 0; hu > 0 && hv > 0 && k < count * count; k++)
        act(context, a[i] + hu * at[k / count], b[j] + hv * at[k % count],
            hu * hv * weights[k / count] * weights[k % count]);
    }
  lam_arena_release(arena, mark);
}

/* What a node is compared by; the functions below that are called for every node get it as
 * context. */
typedef struct pair {
  fitting fit;
  const lam_nurbs *a, *b;
  double sum;
} pair;

/* A node of the fit of inner points to the target b. */
static void fit_node(void *context, double u, double v, double weight) {
  pair *p = context;
  lam_jet jet;
  lam_nurbs_eval(p->b, u, v, &jet);
  add_node(&p->fit, u, v, weight, jet.x);
}

/* Inner points by the normal equations; the boundary is copied. */
lam_spline_surface lam_spline_surface_fit(lam_arena *arena, const lam_spline_surface *space,
                                          const lam_spline_surface *target) {
  int all = space->count[0] * space->count[1],
      unknowns = (space->count[0] - 2) * (space->count[1] - 2);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  lam_spline_surface result = *space;
  result.points = points;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  pair p = {.fit = {space, space->count[1] - 2, unknowns,
                    LAM_NEW(arena, double, (size_t)unknowns *(size_t)unknowns),
                    LAM_NEW(arena, double, 3 * unknowns)},
            .b = lam_nurbs_make(arena, target)};
  each_node(arena, target, fit_node, &p);

  /* The matrix is positive definite: the functions are independent. */
  lam_cholesky_factor(unknowns, p.fit.matrix);
  for (int c = 0; c < 3; c++)
    lam_cholesky_solve(unknowns, p.fit.matrix, p.fit.right + c * unknowns);

  for (int k = 0; k < all; k++) {
    int at = unknown_of(&p.fit, k);
    points[k] = at < 0 ? space->points[k]
                       : lam_v3(p.fit.right[at], p.fit.right[unknowns + at],
                                p.fit.right[2 * unknowns + at]);
  }
  lam_arena_release(arena, mark);
  return result;
}

/* ---- weights sought too ---- */

/* Adds ab times the products of (e_x, e_y, e_z, -y) to a 4 x 4 block in a matrix of n columns. */
static void add_block(double *block, size_t n, double ab, lam_vec3 y) {
  for (size_t c = 0; c < 3; c++) {
    block[c * n + c] += ab;
    block[c * n + 3] -= ab * (&y.x)[c];
    block[3 * n + c] -= ab * (&y.x)[c];
  }
  block[3 * n + 3] += ab * lam_dot(y, y);
}

/* Adds a node to the normal equations for X = w P and w, four unknowns per inner point. With them
 * the difference is (sum N X - y sum N w) / W. Its numerator is linear in X and w; W is taken from
 * the round before (Sanathanan & Koerner 1963). */
static void weigh_node(void *context, double u, double v, double weight) {
  pair *p = context;
  fitting *f = &p->fit;
  double values[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  int index[LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES],
      count = functions_at(f->space, u, v, values, index);
  size_t n = 4 * (size_t)f->unknowns;
  lam_jet jet;
  lam_nurbs_eval(p->b, u, v, &jet);

  /* What the points of the boundary leave over, and then the inner ones; values / w are N / W. */
  lam_vec3 y = jet.x, rest = {0};
  for (int k = 0; k < count; k++)
    if (unknown_of(f, index[k]) < 0)
      rest = lam_along(rest, values[k], lam_sub(y, f->space->points[index[k]]));
  for (int k = 0; k < count; k++) {
    int row = unknown_of(f, index[k]);
    if (row < 0) continue;

    double a = weight * values[k] / f->space->weights[index[k]];
    for (int l = 0; l < count; l++) {
      int column = unknown_of(f, index[l]);
      if (column < 0) continue;
      double ab = a * values[l] / f->space->weights[index[l]];
      add_block(f->matrix + 4 * (size_t)row * n + 4 * (size_t)column, n, ab, y);
    }

    for (int c = 0; c < 3; c++) f->right[4 * row + c] += a * (&rest.x)[c];
    f->right[4 * row + 3] -= a * lam_dot(rest, y);
  }
}

/* The weights in 20 rounds; inner points are fitted anew at the end, with the weights that were
 * found. */
lam_spline_surface lam_spline_surface_fit_weights(lam_arena *arena, const lam_spline_surface *space,
                                                  const lam_spline_surface *target, double low,
                                                  double high) {
  int all = space->count[0] * space->count[1],
      unknowns = (space->count[0] - 2) * (space->count[1] - 2);
  size_t n = 4 * (size_t)unknowns;
  double *weights = LAM_NEW(arena, double, all);
  for (int k = 0; k < all; k++) weights[k] = space->weights ? space->weights[k] : 1;
  lam_spline_surface result = *space;
  result.weights = weights;

  for (int round = 0; round < 20; round++) {
    lam_arena_mark mark = lam_arena_mark_get(arena);
    pair p = {.fit = {&result, space->count[1] - 2, unknowns, LAM_NEW(arena, double, n *n),
                      LAM_NEW(arena, double, n)},
              .b = lam_nurbs_make(arena, target)};
    each_node(arena, target, weigh_node, &p);

    bool found = lam_cholesky_factor((int)n, p.fit.matrix);
    if (found) lam_cholesky_solve((int)n, p.fit.matrix, p.fit.right);
    for (int k = 0; k < all && found; k++) {
      int at = unknown_of(&p.fit, k);
      if (at >= 0) weights[k] = fmin(fmax(p.fit.right[4 * at + 3], low), high);
    }

    lam_arena_release(arena, mark);
    if (!found) break;
  }
  return lam_spline_surface_fit(arena, &result, target);
}

/* Adds |a - b|^2 at a node to the sum. */
static void measure_node(void *context, double u, double v, double weight) {
  pair *p = context;
  lam_jet x, y;
  lam_nurbs_eval(p->a, u, v, &x);
  lam_nurbs_eval(p->b, u, v, &y);
  lam_vec3 d = lam_sub(x.x, y.x);
  p->sum += weight * lam_dot(d, d);
}

/* The root of the sum over Gauss nodes. */
double lam_spline_surface_distance(lam_arena *arena, const lam_spline_surface *a,
                                   const lam_spline_surface *b) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  pair p = {.a = lam_nurbs_make(arena, a), .b = lam_nurbs_make(arena, b)};
  each_node(arena, b, measure_node, &p);
  lam_arena_release(arena, mark);
  return sqrt(p.sum);
}
