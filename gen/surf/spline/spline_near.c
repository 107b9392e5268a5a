/* Spline surfaces near points, by least squares with the energy of a thin plate. Called by
 * surf/kinds/approximation.c. */
#include "surf/spline/spline_near.h"
#include "core/numeric/fit.h"
#include "curve/bspline/banded.h"
#include "curve/bspline/basis.h"
#include "curve/bspline/gram.h"
#include "curve/least_squares.h"
#include "surf/spline/closest_on_surface.h"
#include <stdlib.h>

/* The control point (i, j) is unknown i * count[1] + j; functions overlap within a degree of
 * each other. */
static int half_width(const lam_surface_space *s) {
  return s->degree[0] * s->count[1] + s->degree[1];
}

/* a += sum over the points of the products of functions / n, right += of function and
 * point / n. */
static void add_points(const lam_surface_space *s, const double *const knots[2], int n,
                       const lam_vec2 *t, const lam_vec3 *points, lam_banded *a, double *right) {
  for (int k = 0; k < n; k++) {
    double basis[2][LAM_BASIS_MAX_VALUES], at[2] = {t[k].x, t[k].y};
    int first[2], p = s->degree[0], q = s->degree[1];

    /* The functions of either direction that do not vanish at the point. */
    for (int d = 0; d < 2; d++) {
      int span = lam_basis_span(s->degree[d], s->count[d], knots[d], at[d]);
      lam_basis_eval(s->degree[d], knots[d], span, at[d], 0, basis[d]);
      first[d] = span - s->degree[d];
    }

    for (int i = 0; i < (p + 1) * (q + 1); i++) {
      int row = (first[0] + i / (q + 1)) * s->count[1] + first[1] + i % (q + 1);
      double f = basis[0][i / (q + 1)] * basis[1][i % (q + 1)] / n;
      for (int j = 0; j < (p + 1) * (q + 1); j++) {
        int column = (first[0] + j / (q + 1)) * s->count[1] + first[1] + j % (q + 1);
        *lam_banded_at(a, row, column) += f * basis[0][j / (q + 1)] * basis[1][j % (q + 1)];
      }
      right[3 * row] += f * points[k].x;
      right[3 * row + 1] += f * points[k].y;
      right[3 * row + 2] += f * points[k].z;
    }
  }
}

/* a += fairness times the matrix of the energy: sums of products of Gram matrices of the two
 * directions. */
static void add_energy(lam_arena *arena, const lam_surface_space *s, const double *const knots[2],
                       lam_banded *a) {
  double *gram[2][3], r = s->length[0] / s->length[1], factor[] = {r * r, 2, 1 / (r * r)};
  for (int d = 0; d < 2; d++)
    for (int k = 0; k < 3; k++)
      gram[d][k] = lam_spline_gram(arena, s->degree[d], s->count[d], knots[d], k);

  /* Points (i, j) and (k, l), for which the functions of both directions overlap. */
  int m = s->count[0], n = s->count[1];
  for (int i = 0; i < m; i++)
    for (int k = i - s->degree[0] > 0 ? i - s->degree[0] : 0; k < m && k <= i + s->degree[0]; k++)
      for (int j = 0; j < n; j++)
        for (int l = j - s->degree[1] > 0 ? j - s->degree[1] : 0; l < n && l <= j + s->degree[1];
             l++)
          for (int order = 0; order < 3; order++) /* in u; 2 - order in v */
            *lam_banded_at(a, i * n + j, k * n + l) += s->fairness * factor[order] *
                                                       gram[0][order][i * m + k] *
                                                       gram[1][2 - order][j * n + l];
}

/* The normal equations are banded; all three coordinates have the same matrix. */
bool lam_surface_near(lam_arena *arena, const lam_surface_space *space, int n, const lam_vec2 *t,
                      const lam_vec3 *points, lam_spline_surface *surface) {
  int total = space->count[0] * space->count[1];
  const double *knots[2];
  for (int d = 0; d < 2; d++) {
    double *even = LAM_NEW(arena, double, space->count[d] + space->degree[d] + 1);
    lam_knots_clamped(space->degree[d], space->count[d], even);
    knots[d] = space->knots[d] ? space->knots[d] : even;
  }

  lam_vec3 *net = LAM_NEW(arena, lam_vec3, total);
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_banded a = lam_banded_make(arena, total, half_width(space));
  double *right = LAM_NEW(arena, double, 3 * total);
  add_points(space, knots, n, t, points, &a, right);
  if (space->fairness > 0) add_energy(arena, space, knots, &a);

  bool found = lam_banded_factor(&a);
  if (found) lam_banded_solve(&a, 3, right);
  for (int i = 0; i < total && found; i++)
    net[i] = lam_v3(right[3 * i], right[3 * i + 1], right[3 * i + 2]);

  lam_arena_release(arena, mark);
  if (!found) return false;
  *surface = (lam_spline_surface){NULL,
                                  {space->degree[0], space->degree[1]},
                                  {space->count[0], space->count[1]},
                                  {knots[0], knots[1]},
                                  net,
                                  NULL};
  return true;
}

/* For qsort. */
static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The ends of the list are 0 and 1, whatever the parameters are. */
const double *lam_surface_knots(lam_arena *arena, int degree, int count, int n, const lam_vec2 *t,
                                int direction) {
  double *sorted = LAM_NEW(arena, double, n + 2),
         *even = LAM_NEW(arena, double, count + degree + 1);
  for (int k = 0; k < n; k++) sorted[k + 1] = direction ? t[k].y : t[k].x;
  qsort(sorted + 1, (size_t)n, sizeof *sorted, ascending);
  sorted[n + 1] = 1;

  lam_knots_clamped(degree, count, even);
  if (count > n) return even;
  const double *knots = lam_fit_knots(arena, degree, count, n + 2, sorted);
  return lam_knots_problem(degree, count, count + degree + 1, knots) ? even : knots;
}

/* Each foot is sought from the last one. */
double lam_surface_feet(const lam_spline_surface *surface, int n, const lam_vec3 *points,
                        lam_vec2 *t, double *mean) {
  double most = 0, sum = 0;
  for (int k = 0; k < n; k++) {
    lam_closest_on_surface foot = lam_spline_surface_closest_from(surface, points[k], t[k]);
    t[k] = (lam_vec2){foot.u, foot.v};
    most = fmax(most, foot.distance);
    sum += foot.distance;
  }
  if (mean) *mean = sum / n;
  return most;
}

/* The normal of the plane of best fit says along which world axis the cloud is seen. */
bool lam_cloud_parameters(int n, const lam_vec3 *points, lam_vec2 *t, double length[2]) {
  lam_vec3 center, low = {INFINITY, INFINITY, 0}, high = {-INFINITY, -INFINITY, 0};
  double spread[3];
  lam_vec3 normal = lam_fit_plane(points, n, &center, spread);
  if (!(spread[1] > 1e-9 * spread[2])) return false;

  bool flat = fabs(normal.z) >= fmax(fabs(normal.x), fabs(normal.y)),
       along_y = fabs(normal.x) > fabs(normal.y);
  for (int k = 0; k < n; k++) {
    lam_vec3 p = points[k];
    t[k] = (lam_vec2){!flat && along_y ? p.y : p.x, flat ? p.y : p.z};
    low = lam_v3(fmin(low.x, t[k].x), fmin(low.y, t[k].y), 0);
    high = lam_v3(fmax(high.x, t[k].x), fmax(high.y, t[k].y), 0);
  }

  length[0] = high.x - low.x;
  length[1] = high.y - low.y;
  for (int k = 0; k < n; k++)
    t[k] = (lam_vec2){(t[k].x - low.x) / length[0], (t[k].y - low.y) / length[1]};
  return length[0] > 0 && length[1] > 0;
}
