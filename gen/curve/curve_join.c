#include "curve/curve_join.h"
#include "curve/curve.h"
#include <stdbool.h>
#include <stddef.h>

/* The curvature vector (x'' - x'' along the tangent) / |x'|^2. */
static lam_vec3 curvature_vector(const lam_vec3 x[3]) {
  double square = lam_dot(x[1], x[1]);
  return lam_scale(lam_along(x[2], -lam_dot(x[2], x[1]) / square, x[1]), 1 / square);
}

lam_join lam_join_test(const lam_vec3 end[3], const lam_vec3 start[3], double size,
                       double tolerance) {
  static const char *const names[2][4] = {{"none", "C0", "C1", "C2"}, {"none", "G0", "G1", "G2"}};
  static const char *const conditions[2][3] = {
      {"the end points differ", "the first derivatives differ", "the second derivatives differ"},
      {"the end points differ", "the tangents differ", "the curvature vectors differ"}};
  const lam_vec3 *p = end, *q = start;
  double square = lam_dot(p[1], p[1]);
  lam_join join = {.gap = lam_distance(p[0], q[0]),
                   .kink = lam_angle(p[1], q[1]),
                   .alpha = lam_dot(q[1], p[1]) / square,
                   .derivative_gap = {lam_distance(p[1], q[1]), lam_distance(p[2], q[2])}};
  lam_vec3 rest = lam_along(q[2], -join.alpha * join.alpha, p[2]);
  join.beta = lam_dot(rest, p[1]) / square;
  lam_vec3 a = curvature_vector(p), b = curvature_vector(q);
  join.curvature_gap = lam_distance(a, b);
  double most = fmax(1 / size, fmax(lam_length(a), lam_length(b)));
  double first = fmax(lam_length(p[1]), lam_length(q[1])),
         second = fmax(lam_length(p[2]), lam_length(q[2]));
  bool holds[2][3] = {{join.gap <= tolerance * size, join.derivative_gap[0] <= tolerance * first,
                       join.derivative_gap[1] <= tolerance * fmax(first, second)},
                      {join.gap <= tolerance * size, join.kink <= tolerance && first > 0,
                       join.curvature_gap <= tolerance * most}};
  int *order[2] = {&join.parametric, &join.geometric};
  for (int kind = 0; kind < 2; kind++) {
    int n = 0;
    while (n < 3 && holds[kind][n]) n++;
    *order[kind] = n - 1;
    join.name[kind] = names[kind][n];
    join.fails[kind] = n < 3 ? conditions[kind][n] : NULL;
  }
  return join;
}

lam_join lam_join_curves(const lam_spline_curve *first, const lam_spline_curve *second,
                         double tolerance) {
  const lam_spline_curve *curves[] = {first, second};
  lam_vec3 x[2][3];
  double size = 0;
  for (int k = 0; k < 2; k++) {
    const lam_spline_curve *c = curves[k];
    lam_spline_curve_eval(c, c->knots[k ? c->degree : c->count], 2, x[k]);
    for (int i = 0; i < c->count; i++) size = fmax(size, lam_distance(c->points[i], x[k][0]));
  }
  return lam_join_test(x[0], x[1], size, tolerance);
}
