/* Surfaces of Bezier patches: first borders and inner points, and the iteration (Wu & Wang,
 * steps 3 to 5). Called by area_paper.c. Patch (s, t) of degree n has the points s n .. (s + 1)
 * n by t n .. (t + 1) n. */
#include "core/numeric/dense.h"
#include "core/numeric/quadrature.h"
#include "curve/bspline/basis.h"
#include "surf/area/area_paper.h"
#include "surf/area/area_parts.h"
#include <math.h>
#include <string.h>

/* Sets result to a copy of s with points of its own, which are returned. */
static lam_vec3 *copy_points(lam_arena *arena, const lam_spline_surface *s,
                             lam_spline_surface *result) {
  int all = s->count[0] * s->count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, all);
  memcpy(points, s->points, (size_t)all * sizeof *points);
  *result = *s;
  result->points = points;
  return points;
}

/* Points on borders along u by linear interpolation in v, and the other way round. */
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

/* Corners of patches are those points whose row and column are both borders. */
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

/* Calls act for a copy of every patch, which then replaces the inner points. act gets the patch,
 * its points to be changed and the context. */
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

/* An energy is the integral of a sum of squares of linear forms; a form is a sum of terms, each a
 * factor times a derivative of the surface. */
typedef struct term {
  int form, u, v; /* which form; the orders of the derivative */
  double factor;
} term;

/* Those of Wu & Wang, step 4; a factor of 0 ends a list. */
static const term energies[4][4] = {
    [LAM_BEZIER_DIRICHLET] = {{0, 1, 0, 1}, {1, 0, 1, 1}},
    [LAM_BEZIER_BENDING] = {{0, 2, 0, 1}, {1, 1, 1, M_SQRT2}, {2, 0, 2, 1}},
    [LAM_BEZIER_HARMONIC] = {{0, 2, 0, 1}, {0, 0, 2, 1}},
    [LAM_BEZIER_BIHARMONIC] = {{0, 4, 0, 1}, {0, 2, 2, 2}, {0, 0, 4, 1}}};

/* The three forms at a node, as coefficients of the width^2 points of the patch; f, g: the basis
 * functions in u and v and their derivatives, 5 x width. */
static void eval_forms(const term *terms, int width, const double *f, const double *g,
                       double form[3][LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES]) {
  memset(form, 0, 3 * sizeof *form);

  for (int t = 0; t < 4 && terms[t].factor > 0; t++)
    for (int a = 0; a < width * width; a++)
      form[terms[t].form][a] +=
          terms[t].factor * f[terms[t].u * width + a / width] * g[terms[t].v * width + a % width];
}

/* Adds w times the square of a form to the normal equations of the inner points. What the borders
 * give is fixed and goes to the right side: x, y, z one after the other. */
static void add_form(int width, const double *form, double w, const lam_vec3 *points,
                     double *matrix, double *right) {
  int inner = width - 2, unknowns = inner * inner;
  for (int i = 0; i < unknowns; i++) {
    double own = w * form[(i / inner + 1) * width + i % inner + 1];

    for (int b = 0; b < width * width; b++) {
      int row = b / width - 1, column = b % width - 1;
      double value = own * form[b];
      if (row >= 0 && row < inner && column >= 0 && column < inner)
        matrix[i * unknowns + row * inner + column] += value;
      else
        for (int c = 0; c < 3; c++) right[c * unknowns + i] -= value * (&points[b].x)[c];
    }
  }
}

/* The basis functions of direction d of a patch at n + 1 nodes on [0,1], with their derivatives of
 * order 0 to 4: (n + 1) x 5 x (n + 1). */
static double *tabulate(lam_arena *arena, const lam_spline_surface *patch, int d,
                        const double *nodes) {
  int n = patch->degree[d], width = n + 1;
  const double *knots = patch->knots[d];
  double *values = LAM_NEW(arena, double, 5 * width * width);
  for (int k = 0; k < width; k++)
    lam_basis_eval(n, knots, n, knots[0] + (knots[width] - knots[0]) * nodes[k], 4,
                   values + 5 * width * k);
  return values;
}

/* Sets the inner points of a patch to least energy; context: the terms of the energy. */
static void fill_patch(lam_arena *arena, const lam_spline_surface *patch, lam_vec3 *points,
                       const void *context) {
  const term *terms = context;
  int n = patch->degree[0], width = n + 1, inner = n - 1, unknowns = inner * inner;
  double nodes[LAM_BASIS_MAX_VALUES], weights[LAM_BASIS_MAX_VALUES], *values[2],
      form[3][LAM_BASIS_MAX_VALUES * LAM_BASIS_MAX_VALUES];
  double *matrix = LAM_NEW(arena, double, unknowns *unknowns),
         *right = LAM_NEW(arena, double, 3 * unknowns);

  /* n + 1 nodes are exact for the squares of polynomials of degree n. */
  lam_gauss_rule(width, nodes, weights);
  for (int d = 0; d < 2; d++) values[d] = tabulate(arena, patch, d, nodes);

  for (int k = 0; k < width * width; k++) {
    double w = weights[k / width] * weights[k % width];
    const double *f = values[0] + 5 * width * (k / width), *g = values[1] + 5 * width * (k % width);
    eval_forms(terms, width, f, g, form);
    for (int q = 0; q < 3; q++) add_form(width, form[q], w, points, matrix, right);
  }

  if (!lam_cholesky_factor(unknowns, matrix)) return; /* no unique minimum: the points stay */
  for (int c = 0; c < 3; c++) {
    lam_cholesky_solve(unknowns, matrix, right + c * unknowns);
    for (int i = 0; i < unknowns; i++)
      (&points[(i / inner + 1) * width + i % inner + 1].x)[c] = right[c * unknowns + i];
  }
}

/* Patch by patch: the energy of the whole is the sum of theirs, as all borders are fixed. */
lam_spline_surface lam_bezier_fill(lam_arena *arena, const lam_spline_surface *patches,
                                   lam_bezier_energy energy) {
  return each_patch(arena, patches, fill_patch, energies[energy]);
}

/* ---- the iteration ---- */
/* One step of lam_area_majorize on a patch; context: the nodes of the quadrature per direction. */
static void improve_patch(lam_arena *arena, const lam_spline_surface *patch, lam_vec3 *points,
                          const void *context) {
  lam_least_area_options options = lam_least_area_defaults();
  lam_area_form *form = lam_area_form_make(arena, patch, 0, *(const int *)context);
  lam_least_area_result result = {.area = 1};
  options.most = 1;
  lam_area_majorize(arena, form, &options, points, &result);
}

/* With at least 16 nodes along a direction of a patch. */
lam_spline_surface lam_bezier_improve(lam_arena *arena, const lam_spline_surface *patches) {
  int nodes = patches->degree[0] + 3 > 16 ? patches->degree[0] + 3 : 16;
  return each_patch(arena, patches, improve_patch, &nodes);
}

/* Steps are counted in iterations; every step is evaluated once. */
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
