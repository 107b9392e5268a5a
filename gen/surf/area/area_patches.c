/* Surfaces of Bezier patches: first borders and inner points, and the iteration (Wu & Wang, steps 3
 * to 5). Patch (s, t) of degree n has the points s n .. (s + 1) n by t n .. (t + 1) n. */
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_paper.h"
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

static lam_vec3 *copy_points(lam_arena *arena, const lam_spline_surface *s,
                             lam_spline_surface *result) {
  int all = s->count[0] * s->count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  memcpy(points, s->points, (size_t)all * sizeof *points);
  *result = *s;
  result->points = points;
  return points;
}

lam_spline_surface lam_bezier_borders(lam_arena *arena, const lam_spline_surface *patches) {
  lam_spline_surface result;
  lam_vec3 *x = copy_points(arena, patches, &result);
  int n = patches->degree[0], rows = patches->count[0], columns = patches->count[1];
  for (int i = 1; i < rows - 1; i++)
    for (int j = 1; j < columns - 1; j++) {
      lam_vec3 by_u =
          lam_mix(x[j], x[(rows - 1) * columns + j], (double)(i / n) / ((rows - 1) / n));
      lam_vec3 by_v = lam_mix(x[i * columns], x[i * columns + columns - 1],
                              (double)(j / n) / ((columns - 1) / n));
      if (i % n == 0 && j % n == 0)
        x[i * columns + j] = lam_mix(by_u, by_v, 0.5);
      else if (i % n == 0 || j % n == 0)
        x[i * columns + j] = i % n == 0 ? by_u : by_v;
    }
  return result;
}

lam_spline_surface lam_bezier_average(lam_arena *arena, const lam_spline_surface *patches) {
  lam_spline_surface result;
  lam_vec3 *x = copy_points(arena, patches, &result);
  const lam_vec3 *old = patches->points;
  int n = patches->degree[0], rows = patches->count[0], columns = patches->count[1];
  for (int i = 1; i < rows - 1; i++)
    for (int j = 1; j < columns - 1; j++) {
      int at = i * columns + j;
      if (i % n == 0 && j % n == 0)
        x[at] = lam_mix(lam_mix(old[at - columns - 1], old[at + columns - 1], 0.5),
                        lam_mix(old[at - columns + 1], old[at + columns + 1], 0.5), 0.5);
      else if (i % n == 0)
        x[at] = lam_mix(old[at - columns], old[at + columns], 0.5);
      else if (j % n == 0)
        x[at] = lam_mix(old[at - 1], old[at + 1], 0.5);
    }
  return result;
}

/* Calls act for a copy of every patch, which then replaces the inner points. */
static lam_spline_surface each_patch(lam_arena *arena, const lam_spline_surface *patches,
                                     void (*act)(lam_arena *, const lam_spline_surface *,
                                                 lam_vec3 *, const void *),
                                     const void *context) {
  lam_spline_surface result;
  lam_vec3 *x = copy_points(arena, patches, &result);
  int n = patches->degree[0], columns = patches->count[1];
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, (n + 1) * (n + 1));
  for (int s = 0; s < (patches->count[0] - 1) / n; s++)
    for (int t = 0; t < (columns - 1) / n; t++) {
      double *knots[2];
      for (int d = 0; d < 2; d++) {
        const double *from = patches->knots[d] + (d ? t : s) * n + n;
        knots[d] = LAM_NEW(arena, double, 2 * n + 2);
        for (int i = 0; i < 2 * n + 2; i++) knots[d][i] = from[i > n];
      }
      lam_spline_surface patch = {NULL, {n, n}, {n + 1, n + 1}, {knots[0], knots[1]}, points, NULL};
      for (int k = 0; k < (n + 1) * (n + 1); k++)
        points[k] = x[(s * n + k / (n + 1)) * columns + t * n + k % (n + 1)];
      act(arena, &patch, points, context);
      for (int k = 0; k < (n + 1) * (n + 1); k++)
        x[(s * n + k / (n + 1)) * columns + t * n + k % (n + 1)] = points[k];
    }
  lam_arena_release(arena, mark);
  return result;
}

/* ---- energies ---- */
/* The linear forms whose squares are integrated: factor and derivatives by u and v, summed within a
 * form. */
typedef struct term {
  int form, u, v;
  double factor;
} term;
static const term energies[4][4] = {
    [LAM_BEZIER_DIRICHLET] = {{0, 1, 0, 1}, {1, 0, 1, 1}},
    [LAM_BEZIER_BENDING] = {{0, 2, 0, 1}, {1, 1, 1, M_SQRT2}, {2, 0, 2, 1}},
    [LAM_BEZIER_HARMONIC] = {{0, 2, 0, 1}, {0, 0, 2, 1}},
    [LAM_BEZIER_BIHARMONIC] = {{0, 4, 0, 1}, {0, 2, 2, 2}, {0, 0, 4, 1}}};

static void fill_patch(lam_arena *arena, const lam_spline_surface *patch, lam_vec3 *points,
                       const void *context) {
  const term *terms = context;
  int n = patch->degree[0], width = n + 1, inner = n - 1, unknowns = inner * inner;
  double places[LAM_BASIS_MAX_VALUES], weights[LAM_BASIS_MAX_VALUES], *values[2],
      form[3][LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  double *matrix = LAM_NEW(arena, double, unknowns *unknowns),
         *right = LAM_NEW(arena, double, 3 * unknowns);
  lam_gauss_rule(width, places, weights);
  for (int d = 0; d < 2; d++) {
    values[d] = LAM_NEW(arena, double, 5 * width * width);
    const double *knots = patch->knots[d];
    for (int k = 0; k < width; k++)
      lam_basis_eval(n, knots, n, knots[0] + (knots[width] - knots[0]) * places[k], 4,
                     values[d] + 5 * width * k);
  }
  for (int k = 0; k < width * width; k++) {
    double w = weights[k / width] * weights[k % width];
    const double *f = values[0] + 5 * width * (k / width), *g = values[1] + 5 * width * (k % width);
    memset(form, 0, sizeof form);
    for (int t = 0; t < 4 && terms[t].factor > 0; t++)
      for (int a = 0; a < width * width; a++)
        form[terms[t].form][a] +=
            terms[t].factor * f[terms[t].u * width + a / width] * g[terms[t].v * width + a % width];
    for (int q = 0; q < 3; q++)
      for (int i = 0; i < unknowns; i++) {
        double own = w * form[q][(i / inner + 1) * width + i % inner + 1];
        for (int b = 0; b < width * width; b++) {
          int row = b / width - 1, column = b % width - 1;
          double value = own * form[q][b];
          if (row >= 0 && row < inner && column >= 0 && column < inner)
            matrix[i * unknowns + row * inner + column] += value;
          else
            for (int c = 0; c < 3; c++) right[c * unknowns + i] -= value * (&points[b].x)[c];
        }
      }
  }
  if (!lam_cholesky_factor(unknowns, matrix)) return; /* no unique minimum: the points stay */
  for (int c = 0; c < 3; c++) {
    lam_cholesky_solve(unknowns, matrix, right + c * unknowns);
    for (int i = 0; i < unknowns; i++)
      (&points[(i / inner + 1) * width + i % inner + 1].x)[c] = right[c * unknowns + i];
  }
}

lam_spline_surface lam_bezier_fill(lam_arena *arena, const lam_spline_surface *patches,
                                   lam_bezier_energy energy) {
  return each_patch(arena, patches, fill_patch, energies[energy]);
}

/* ---- the iteration ---- */
static void improve_patch(lam_arena *arena, const lam_spline_surface *patch, lam_vec3 *points,
                          const void *context) {
  lam_least_area_options options = lam_least_area_defaults();
  lam_area_form *form = lam_area_form_make(arena, patch, 0, *(const int *)context);
  lam_least_area_result result = {.area = 1};
  options.most = 1;
  lam_area_majorize(arena, form, &options, points, &result);
}

lam_spline_surface lam_bezier_improve(lam_arena *arena, const lam_spline_surface *patches) {
  int places = patches->degree[0] + 3 > 16 ? patches->degree[0] + 3 : 16;
  return each_patch(arena, patches, improve_patch, &places);
}

lam_least_area_result lam_bezier_iterate(lam_arena *arena, const lam_spline_surface *patches,
                                         double tolerance, int most) {
  lam_spline_surface now = *patches;
  double first = lam_surface_area(arena, patches, patches->degree[0] + 3);
  lam_least_area_result best = {
      .surface = now, .area = first, .reason = "as many steps as allowed"};
  for (; best.iterations < most; best.iterations++) {
    lam_spline_surface next = lam_bezier_average(arena, &now);
    next = lam_bezier_improve(arena, &next);
    double change = lam_spline_surface_distance(arena, &now, &next),
           area = lam_surface_area(arena, &next, next.degree[0] + 3);
    best.evaluations++;
    now = next;
    best.converged = change < tolerance;
    if (area < best.area || best.converged) {
      best.area = area;
      best.surface = now;
    }
    if (best.converged) {
      best.reason = "the surface moves no more";
      best.iterations++;
      break;
    }
    if (!(area < 1.5 * first)) {
      best.reason = "averaging the borders lets the area grow";
      break;
    }
  }
  return best;
}
