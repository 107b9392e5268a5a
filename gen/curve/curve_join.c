/* How smoothly two curves join: every condition is measured, then the largest order is found up to
 * which all hold. Part of the curve kernel, called by its users only
 * (tests/unit/curve/test_curve_geometry.c). */
#include "curve/curve_join.h"
#include "curve/curve.h"
#include "curve/frenet.h"
#include <stdbool.h>
#include <stddef.h>

/* The orders of the join, their names, and what fails. holds: whether the conditions for C0, C1, C2
 * and for G0, G1, G2 are met. */
static void judge(bool holds[2][3], lam_join *join) {
  static const char *const names[2][4] = {{"none", "C0", "C1", "C2"}, {"none", "G0", "G1", "G2"}};
  static const char *const conditions[2][3] = {
      {"the end points differ", "the first derivatives differ", "the second derivatives differ"},
      {"the end points differ", "the tangents differ", "the curvature vectors differ"}};
  int *order[2] = {&join->parametric, &join->geometric};

  for (int kind = 0; kind < 2; kind++) {
    int n = 0;
    while (n < 3 && holds[kind][n]) n++;
    *order[kind] = n - 1;
    join->name[kind] = names[kind][n];
    join->fails[kind] = n < 3 ? conditions[kind][n] : NULL;
  }
}

/* alpha is the factor of Q' = alpha P' in the direction of P', beta that of Q'' - alpha^2 P''. */
lam_join lam_join_test(const lam_vec3 end[3], const lam_vec3 start[3], double size,
                       double tolerance) {
  const lam_vec3 *p = end, *q = start;
  double square = lam_dot(p[1], p[1]);
  lam_join join = {.gap = lam_distance(p[0], q[0]),
                   .kink = lam_angle(p[1], q[1]),
                   .alpha = lam_dot(q[1], p[1]) / square,
                   .derivative_gap = {lam_distance(p[1], q[1]), lam_distance(p[2], q[2])}};
  lam_vec3 rest = lam_along(q[2], -join.alpha * join.alpha, p[2]);
  join.beta = lam_dot(rest, p[1]) / square;
  lam_vec3 a = lam_curvature_vector(p[1], p[2]), b = lam_curvature_vector(q[1], q[2]);
  join.curvature_gap = lam_distance(a, b);

  /* The sizes to which the tolerance is relative. */
  double most = fmax(1 / size, fmax(lam_length(a), lam_length(b)));
  double first = fmax(lam_length(p[1]), lam_length(q[1])),
         second = fmax(lam_length(p[2]), lam_length(q[2]));

  bool holds[2][3] = {{join.gap <= tolerance * size, join.derivative_gap[0] <= tolerance * first,
                       join.derivative_gap[1] <= tolerance * fmax(first, second)},
                      {join.gap <= tolerance * size, join.kink <= tolerance && first > 0,
                       join.curvature_gap <= tolerance * most}};
  judge(holds, &join);
  return join;
}

/* Evaluates the first curve at its end and the second at its start. */
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
