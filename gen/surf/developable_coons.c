/* x(u,v) = (1-v) c0(u) + v c1(u) + (1-u) d0(v) + u d1(v) - (the bilinear patch of the corners). */
#include "surf/developable.h"

/* The coefficients of t, scaled to [0,1]: averages of `degree` following knots. */
static const double *linear(lam_arena *arena, int degree, int count, const double *knots) {
  double *average = LAM_NEW(arena, double, count), low = knots[degree], high = knots[count];
  for (int i = 0; i < count; i++) {
    for (int k = 1; k <= degree; k++) average[i] += knots[i + k] / degree;
    average[i] = (average[i] - low) / (high - low);
  }
  return average;
}

lam_spline_surface lam_coons_surface(lam_arena *arena, const lam_four_sides *b) {
  lam_spline_surface s = {
      .degree = {b->degree[0], b->degree[1]}, .count = {b->count[0], b->count[1]}, .knots = {b->knots[0], b->knots[1]}};
  const double *u = linear(arena, s.degree[0], s.count[0], s.knots[0]);
  const double *v = linear(arena, s.degree[1], s.count[1], s.knots[1]);
  const lam_vec3 *c0 = b->curve[0], *d0 = b->curve[1], *c1 = b->curve[2], *d1 = b->curve[3];
  int m = s.count[0] - 1, n = s.count[1] - 1;
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, (m + 1) * (n + 1));
  for (int i = 0; i <= m; i++)
    for (int j = 0; j <= n; j++) {
      lam_vec3 along = lam_mix(c0[i], c1[i], v[j]), across = lam_mix(d0[j], d1[j], u[i]);
      lam_vec3 corners = lam_mix(lam_mix(c0[0], c0[m], u[i]), lam_mix(c1[0], c1[m], u[i]), v[j]);
      x[i * (n + 1) + j] = lam_sub(lam_add(along, across), corners);
    }
  for (int i = 0; i <= m; i++) { /* the boundary as given, to the last digit */
    x[i * (n + 1)] = c0[i];
    x[i * (n + 1) + n] = c1[i];
  }
  for (int j = 1; j < n; j++) {
    x[j] = d0[j];
    x[m * (n + 1) + j] = d1[j];
  }
  s.points = x;
  return s;
}
