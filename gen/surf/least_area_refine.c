/* Exact refinement of spline surfaces, in homogeneous coordinates (w x, w y, w z, w). */
#include "curve/basis.h"
#include "curve/collocation.h"
#include "surf/least_area.h"
#include <math.h>

/* A family of curves in four coordinates: `lines` of them, point i of line k at 4 (i lines + k). */
typedef struct sheaf {
  int degree, count, lines;
  const double *knots;
  double *points;
} sheaf;

/* The lines of the net along direction d. */
static sheaf take(lam_arena *arena, const lam_spline_surface *surface, int d) {
  int m = surface->count[0], n = surface->count[1];
  sheaf s = {surface->degree[d], surface->count[d], surface->count[1 - d], surface->knots[d],
             LAM_NEW(arena, double, 4 * m * n)};
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      double w = surface->weights ? surface->weights[i * n + j] : 1;
      lam_vec3 p = lam_scale(surface->points[i * n + j], w);
      double *to = s.points + 4 * (d ? j * m + i : i * n + j);
      to[0] = p.x;
      to[1] = p.y;
      to[2] = p.z;
      to[3] = w;
    }
  return s;
}

static lam_spline_surface give(lam_arena *arena, const lam_spline_surface *surface, int d, const sheaf *s) {
  lam_spline_surface result = *surface;
  result.degree[d] = s->degree;
  result.count[d] = s->count;
  result.knots[d] = s->knots;
  int m = result.count[0], n = result.count[1];
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, m * n);
  double *weights = surface->weights ? LAM_NEW(arena, double, m *n) : NULL;
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      const double *from = s->points + 4 * (d ? j * m + i : i * n + j);
      points[i * n + j] = lam_scale(lam_v3(from[0], from[1], from[2]), 1 / from[3]);
      if (weights) weights[i * n + j] = from[3];
    }
  result.points = points;
  result.weights = weights;
  return result;
}

/* With knots[k] <= t < knots[k+1]: Q_i = P_i up to k - p, a_i P_i + (1 - a_i) P_{i-1} for k - p < i <= k, P_{i-1}
 * beyond, where a_i = (t - t_i) / (t_{i+p} - t_i). The ends of the range that a knot of multiplicity l leaves alone
 * come out with a_i = 1 or 0. */
static sheaf insert(lam_arena *arena, const sheaf *s, double t) {
  int p = s->degree, k = lam_basis_span(p, s->count, s->knots, t), line = 4 * s->lines;
  sheaf r = {p, s->count + 1, s->lines, NULL, LAM_NEW(arena, double, line *(s->count + 1))};
  double *knots = LAM_NEW(arena, double, r.count + p + 1);
  for (int i = 0; i < r.count + p + 1; i++) knots[i] = i <= k ? s->knots[i] : i == k + 1 ? t : s->knots[i - 1];
  r.knots = knots;
  for (int i = 0; i < r.count; i++) {
    double a = i <= k - p ? 1 : i > k ? 0 : (t - s->knots[i]) / (s->knots[i + p] - s->knots[i]);
    for (int c = 0; c < line; c++) {
      double own = i < s->count ? s->points[i * line + c] : 0, before = i > 0 ? s->points[(i - 1) * line + c] : 0;
      r.points[i * line + c] = a == 1 ? own : a == 0 ? before : a * own + (1 - a) * before;
    }
  }
  return r;
}

lam_spline_surface lam_spline_surface_insert(lam_arena *arena, const lam_spline_surface *surface, int d, double knot) {
  sheaf s = take(arena, surface, d);
  s = insert(arena, &s, knot);
  return give(arena, surface, d, &s);
}

/* The spline of the higher degree takes the same values at as many places as it has coefficients. */
static sheaf elevate(lam_arena *arena, const sheaf *s, int degree) {
  int raise = degree - s->degree, total = s->count + s->degree + 1, kept = 0;
  double *knots = LAM_NEW(arena, double, total *(raise + 1));
  for (int i = 0; i < total; i++) {
    knots[kept++] = s->knots[i];
    for (int k = 0; k < raise && (i + 1 == total || s->knots[i + 1] > s->knots[i]); k++) knots[kept++] = s->knots[i];
  }
  sheaf r = {degree, kept - degree - 1, s->lines, knots, NULL};
  lam_collocation space = lam_collocation_make(arena, degree, r.count, knots);
  r.points = LAM_NEW(arena, double, 4 * s->lines * r.count);
  for (int i = 0; i < r.count; i++) {
    double values[LAM_BASIS_MAX_VALUES];
    int span = lam_basis_span(s->degree, s->count, s->knots, space.places[i]);
    lam_basis_eval(s->degree, s->knots, span, space.places[i], 0, values);
    for (int j = 0; j <= s->degree; j++)
      for (int c = 0; c < 4 * s->lines; c++)
        r.points[i * 4 * s->lines + c] += values[j] * s->points[(span - s->degree + j) * 4 * s->lines + c];
  }
  lam_collocation_solve(arena, &space, 4 * s->lines, r.points);
  return r;
}

lam_spline_surface lam_spline_surface_elevate(lam_arena *arena, const lam_spline_surface *surface,
                                              const int degree[2]) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++)
    if (degree[d] > surface->degree[d]) {
      sheaf s = take(arena, &result, d);
      s = elevate(arena, &s, degree[d]);
      result = give(arena, &result, d, &s);
    }
  return result;
}

lam_spline_surface lam_spline_surface_refine(lam_arena *arena, const lam_spline_surface *surface, int spans) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d], count = surface->count[d];
    const double *knots = surface->knots[d];
    double longest = (knots[count] - knots[p]) / spans * (1 + 1e-9);
    sheaf s = take(arena, &result, d);
    for (int i = p; i < count; i++) {
      int parts = 1;
      while ((knots[i + 1] - knots[i]) / parts > longest) parts *= 2;
      for (int k = 1; k < parts; k++) s = insert(arena, &s, knots[i] + (knots[i + 1] - knots[i]) * k / parts);
    }
    result = give(arena, &result, d, &s);
  }
  return result;
}

lam_spline_surface lam_spline_surface_pieces(lam_arena *arena, const lam_spline_surface *surface) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d], count = surface->count[d];
    const double *knots = surface->knots[d];
    sheaf s = take(arena, &result, d);
    for (int i = p + 1, repeated = 1; i < count; i += repeated) {
      for (repeated = 1; i + repeated < count && knots[i + repeated] == knots[i];) repeated++;
      for (int k = repeated; k < p; k++) s = insert(arena, &s, knots[i]);
    }
    result = give(arena, &result, d, &s);
  }
  return result;
}
