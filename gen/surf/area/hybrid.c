/* Hybrid approximation of rational Bezier curves by polynomial ones (Wu & Wang, step 2), and the
 * borders of Bezier patches made of them. Called by area_paper.c.
 *
 * With n = r + p and weights w:
 *
 *   i < r:   H_0 = P_0,
 *            H_i = P_0 + sum_{k=1}^{min(m,i)} C(m,k) C(n,i-k) w_k (P_k - H_{i-k}) / (C(n,i) w_0)
 *   i > r:   H_n = P_m,
 *            H_i = P_m + sum_{k=max(0,i+m-n)}^{m-1} C(m,k) C(n,i+m-k) w_k (P_k - H_{i+m-k})
 *                        / (C(n,i) w_m)
 *   moving:  M_k = P_k + sum_{i != k} C(m,i) C(n,k+r-i) w_i (P_i - H_{k+r-i}) / (C(m,k) C(n,r) w_k)
 *
 * It is two-point Hermite interpolation and converges when every zero z of the denominator has
 * |z (1 - z)| > 1/4. */
#include "core/numbers.h"
#include "surf/area/area_paper.h"
#include <complex.h>
#include <math.h>

/* The binomial coefficient, 0 outside of 0 <= k <= n. */
static double choose(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; i++) value *= (double)(n - k + i) / i;
  return k < 0 || k > n ? 0 : value;
}

/* M_k, from the H that are known: all but H_r. */
static lam_vec3 moving_point(int m, const lam_vec3 *points, const double *w, int r, int p,
                             const lam_vec3 *h, int k) {
  lam_vec3 point = points[k];
  int n = r + p;
  for (int i = k > p ? k - p : 0; i <= k + r && i <= m; i++)
    if (i != k)
      point = lam_along(
          point, choose(m, i) * choose(n, k + r - i) * w[i] / (choose(m, k) * choose(n, r) * w[k]),
          lam_sub(points[i], h[k + r - i]));
  return point;
}

/* From both ends, then the moving point r as the mean of the M_k. */
void lam_hybrid_approximate(int m, const lam_vec3 *points, const double *w, int r, int p,
                            lam_vec3 *h) {
  int n = r + p;
  h[0] = points[0];
  h[n] = points[m];

  for (int i = 1; i < r; i++) {
    h[i] = points[0];
    for (int k = 1; k <= m && k <= i; k++)
      h[i] = lam_along(h[i], choose(m, k) * choose(n, i - k) * w[k] / (choose(n, i) * w[0]),
                       lam_sub(points[k], h[i - k]));
  }

  for (int i = n - 1; i > r; i--) {
    h[i] = points[m];
    for (int k = i + m > n ? i + m - n : 0; k < m; k++)
      h[i] = lam_along(h[i], choose(m, k) * choose(n, i + m - k) * w[k] / (choose(n, i) * w[m]),
                       lam_sub(points[k], h[i + m - k]));
  }

  lam_vec3 sum = {0};
  double total = 0;
  for (int k = 0; k <= m; k++) {
    lam_vec3 point = moving_point(m, points, w, r, p, h, k);
    sum = lam_along(sum, choose(m, k) * w[k], point);
    total += choose(m, k) * w[k];
  }
  h[r] = lam_scale(sum, 1 / total);
}

/* The zeros of sum C(m,k) w_k s^k with s = t / (1 - t), by Weierstrass' iteration from a circle
 * around all of them. s = infinity is no zero: w_m > 0. With t (1 - t) = s / (1 + s)^2 the ratio
 * is max |(1 + s)^2 / (4 s)|. */
double lam_hybrid_ratio(int m, const double *w) {
  double complex zero[LAM_LEAST_AREA_MAX_DEGREE];
  double ratio = 0, size = 0;
  for (int k = 0; k < m; k++) size = fmax(size, pow(choose(m, k) * w[k] / w[m], 1.0 / (m - k)));

  for (int k = 0; k < m; k++) zero[k] = size * cexp(I * (2 * LAM_PI * k / m + 0.4));

  for (int step = 0; step < 200; step++)
    for (int k = 0; k < m; k++) {
      double complex value = w[m], others = w[m];
      for (int i = m - 1; i >= 0; i--) value = value * zero[k] + choose(m, i) * w[i];
      for (int i = 0; i < m; i++)
        if (i != k) others *= zero[k] - zero[i];
      if (cabs(others) > 0) zero[k] -= value / others;
    }

  for (int k = 0; k < m; k++) /* s = -1 is t = infinity and counts 0 */
    ratio = fmax(ratio, cpow(1 + zero[k], 2) == 0 ? 0 : cabs(cpow(1 + zero[k], 2) / (4 * zero[k])));
  return ratio;
}

/* The number in the net of point i of a border curve along direction d, at the start (side 0) or
 * the end (side 1) of the other direction. */
static int border(const lam_spline_surface *s, int d, int side, int i) {
  int n = s->count[1], across = side ? s->count[1 - d] - 1 : 0;
  return d ? across * n + i : i * n + across;
}

/* Halves the first span of direction d on whose borders the approximation diverges, or nearly;
 * false: there is none. */
static bool halve_diverging(lam_arena *arena, lam_spline_surface *surface, int d) {
  lam_spline_surface pieces = lam_spline_surface_pieces(arena, surface);
  int degree = pieces.degree[d], spans = (pieces.count[d] - 1) / degree;

  for (int s = 0; s < spans; s++)
    for (int side = 0; side < 2; side++) {
      double w[LAM_LEAST_AREA_MAX_DEGREE + 1];
      for (int i = 0; i <= degree; i++)
        w[i] = pieces.weights ? pieces.weights[border(&pieces, d, side, s * degree + i)] : 1;
      if (lam_hybrid_ratio(degree, w) < 0.95) continue;

      const double *knots = pieces.knots[d] + degree + s * degree;
      *surface = lam_spline_surface_insert(arena, surface, d, (knots[0] + knots[1]) / 2);
      return true;
    }
  return false;
}

/* The space of Bezier patches of degree n on the spans of the pieces: degrees, counts and knots. */
static lam_spline_surface patch_space(lam_arena *arena, const lam_spline_surface *pieces, int n) {
  lam_spline_surface result = {.degree = {n, n}};
  for (int d = 0; d < 2; d++) {
    int spans = (pieces->count[d] - 1) / pieces->degree[d];
    result.count[d] = spans * n + 1;

    double *knots = LAM_NEW(arena, double, result.count[d] + n + 1);
    for (int i = 0; i < result.count[d] + n + 1; i++) {
      int at = i == 0 ? 0 : (i - 1) / n;
      knots[i] =
          pieces->knots[d][pieces->degree[d] + (at > spans ? spans : at) * pieces->degree[d]];
    }
    result.knots[d] = knots;
  }
  return result;
}

/* Sets the points of span s of a border in the space from the rational curve of the pieces. */
static void approximate_border(const lam_spline_surface *pieces, const lam_spline_surface *space,
                               int d, int side, int s, int r, int p, lam_vec3 *points) {
  lam_vec3 from[LAM_LEAST_AREA_MAX_DEGREE + 1], to[2 * LAM_LEAST_AREA_MAX_DEGREE + 1];
  double w[LAM_LEAST_AREA_MAX_DEGREE + 1];
  for (int i = 0; i <= pieces->degree[d]; i++) {
    int at = border(pieces, d, side, s * pieces->degree[d] + i);
    from[i] = pieces->points[at];
    w[i] = pieces->weights ? pieces->weights[at] : 1;
  }

  lam_hybrid_approximate(pieces->degree[d], from, w, r, p, to);
  for (int i = 0; i <= r + p; i++) points[border(space, d, side, s * (r + p) + i)] = to[i];
}

/* Spans are halved until all approximations converge, 64 times per direction at most. */
lam_spline_surface lam_bezier_boundary(lam_arena *arena, const lam_spline_surface *surface, int r,
                                       int p) {
  lam_spline_surface pieces = *surface;
  int n = r + p;
  for (int d = 0; d < 2; d++)
    for (int k = 0; k < 64 && halve_diverging(arena, &pieces, d);) k++;
  pieces = lam_spline_surface_pieces(arena, &pieces);

  lam_spline_surface result = patch_space(arena, &pieces, n);
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, result.count[0] * result.count[1]);
  for (int d = 0; d < 2; d++)
    for (int side = 0; side < 2; side++)
      for (int s = 0; s < (result.count[d] - 1) / n; s++)
        approximate_border(&pieces, &result, d, side, s, r, p, points);
  result.points = points;
  return result;
}
