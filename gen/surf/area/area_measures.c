/* Measures of spline surfaces on evaluated jets, independent of the quadrature that areas are
 * minimized with. Called by least_area.c for the report, by area_patches.c, and by benchmark and
 * tests. */
#include "core/numeric/quadrature.h"
#include "surf/area/least_area.h"
#include "surf/spline/spline_surface.h"
#include <math.h>

/* The ends of the knot spans of direction d, each cut into `parts`: count intervals, count + 1
 * numbers. */
static double *breaks(lam_arena *arena, const lam_spline_surface *s, int d, int parts, int *count) {
  const double *knots = s->knots[d];
  double *at = LAM_NEW(arena, double, (s->count[d] - s->degree[d]) * parts + 1);
  *count = 0;
  for (int i = s->degree[d]; i < s->count[d]; i++)
    for (int k = 0; k < parts && knots[i + 1] > knots[i]; k++)
      at[(*count)++] = knots[i] + (knots[i + 1] - knots[i]) * k / parts;
  at[*count] = knots[s->count[d]];
  return at;
}

/* Each half of a span has a Gauss rule of its own, so the nodes are not those of the
 * minimization. */
double lam_surface_area(lam_arena *arena, const lam_spline_surface *surface, int count) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  const lam_nurbs *nurbs = lam_nurbs_make(arena, surface);
  int m, n;
  double *u = breaks(arena, surface, 0, 2, &m), *v = breaks(arena, surface, 1, 2, &n), sum = 0;
  double *at = LAM_NEW(arena, double, count), *weights = LAM_NEW(arena, double, count);

  lam_gauss_rule(count, at, weights);
  for (int i = 0; i < m * count; i++)
    for (int j = 0; j < n * count; j++) {
      int a = i / count, b = j / count, k = i % count, l = j % count;
      double hu = u[a + 1] - u[a], hv = v[b + 1] - v[b];

      lam_jet jet;
      lam_nurbs_eval(nurbs, u[a] + hu * at[k], v[b] + hv * at[l], &jet);
      sum += hu * weights[k] * hv * weights[l] * lam_length(lam_cross(jet.u, jet.v));
    }

  lam_arena_release(arena, mark);
  return sum;
}

/* The area of the triangles inscribed into a grid with `cells` cells per span and direction. Two
 * rows of points are kept, the current one and the one before. */
static double triangles(lam_arena *arena, const lam_spline_surface *surface, const lam_nurbs *nurbs,
                        int cells) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  int m, n;
  double *u = breaks(arena, surface, 0, cells, &m), *v = breaks(arena, surface, 1, cells, &n),
         sum = 0;

  lam_vec3 *row[2] = {LAM_NEW(arena, lam_vec3, n + 1), LAM_NEW(arena, lam_vec3, n + 1)};
  for (int i = 0; i <= m; i++) {
    lam_vec3 *now = row[i % 2], *last = row[1 - i % 2];
    for (int j = 0; j <= n; j++) {
      lam_jet jet;
      lam_nurbs_eval(nurbs, u[i], v[j], &jet);
      now[j] = jet.x;
    }

    for (int j = 0; i > 0 && j < n; j++) {
      lam_vec3 d = lam_sub(now[j + 1], last[j]);
      sum += (lam_length(lam_cross(d, lam_sub(now[j], last[j]))) +
              lam_length(lam_cross(d, lam_sub(last[j + 1], last[j])))) /
             2;
    }
  }

  lam_arena_release(arena, mark);
  return sum;
}

/* The error of inscribed triangles is a series in the squares of the edges: two steps of
 * Richardson's extrapolation. */
double lam_surface_area_triangles(lam_arena *arena, const lam_spline_surface *surface, int cells) {
  const lam_nurbs *nurbs = lam_nurbs_make(arena, surface);
  double a = triangles(arena, surface, nurbs, cells),
         b = triangles(arena, surface, nurbs, 2 * cells),
         c = triangles(arena, surface, nurbs, 4 * cells), ab = (4 * b - a) / 3,
         bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

/* At the middles of count x count cells of every span. */
void lam_surface_mean_curvature(lam_arena *arena, const lam_spline_surface *surface, double wanted,
                                int count, double *largest, double *rms, long *samples) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  const lam_nurbs *nurbs = lam_nurbs_make(arena, surface);
  int m, n;
  double *u = breaks(arena, surface, 0, 1, &m), *v = breaks(arena, surface, 1, 1, &n), sum = 0;

  *largest = 0;
  *samples = 0;
  for (int i = 0; i < m * count; i++)
    for (int j = 0; j < n * count; j++) {
      int a = i / count, b = j / count;
      lam_jet jet;
      lam_nurbs_eval(nurbs, u[a] + (u[a + 1] - u[a]) * (i % count + 0.5) / count,
                     v[b] + (v[b + 1] - v[b]) * (j % count + 0.5) / count, &jet);

      double off = fabs(lam_jet_curvature(&jet).H - wanted);
      *largest = fmax(*largest, off);
      sum += off * off;
      ++*samples;
    }

  *rms = sqrt(sum / (double)*samples);
  lam_arena_release(arena, mark);
}
