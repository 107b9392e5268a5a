/* Arc length by adaptive quadrature, and its inverse. Part of the curve kernel, called by its
 * users only (tests/unit/curve/test_curve_geometry.c, test_surface_fairing.c). */
#include "curve/length.h"
#include "core/numeric/quadrature.h"
#include <stdbool.h>

enum { RULE = 12, DEEPEST = 40 };

typedef struct gauss_rule {
  double nodes[RULE], weights[RULE];
} gauss_rule;

/* |x'(t)|, m per parameter. */
static double speed(const lam_curve *curve, double t) {
  lam_vec3 x[2];
  curve->eval(curve->data, t, 1, x);
  return lam_length(x[1]);
}

/* The integral of the speed over [a, b] by one rule. */
static double gauss_length(const lam_curve *curve, const gauss_rule *rule, double a, double b) {
  double sum = 0;
  for (int i = 0; i < RULE; i++)
    sum += rule->weights[i] * speed(curve, a + (b - a) * rule->nodes[i]);
  return (b - a) * sum;
}

/* The same, with [a, b] halved until two halves agree with their whole to `tolerance` of their
 * sum, at most DEEPEST times. */
static double adaptive_length(const lam_curve *curve, const gauss_rule *rule, double a, double b,
                              double whole, double tolerance, int depth) {
  double middle = a + (b - a) / 2, left = gauss_length(curve, rule, a, middle),
         right = gauss_length(curve, rule, middle, b);

  double sum = left + right;
  if (fabs(sum - whole) <= tolerance * fabs(sum) || depth == DEEPEST) return sum;
  return adaptive_length(curve, rule, a, middle, left, tolerance, depth + 1) +
         adaptive_length(curve, rule, middle, b, right, tolerance, depth + 1);
}

/* The length from a to b, a < b: part by part between the breaks, where the integrand is smooth. */
static double length_between(const lam_curve *curve, const gauss_rule *rule, double a, double b,
                             double tolerance) {
  double sum = 0;
  for (int i = 0; i <= curve->break_count && a < b; i++) {
    double end = i < curve->break_count && curve->breaks[i] < b ? curve->breaks[i] : b;
    if (end <= a) continue;
    sum += adaptive_length(curve, rule, a, end, gauss_length(curve, rule, a, end), tolerance, 0);
    a = end;
  }
  return sum;
}

/* One rule for all intervals. */
double lam_curve_length(const lam_curve *curve, double t0, double t1, double tolerance) {
  gauss_rule rule;
  lam_gauss_rule(RULE, rule.nodes, rule.weights);
  return t1 >= t0 ? length_between(curve, &rule, t0, t1, tolerance)
                  : -length_between(curve, &rule, t1, t0, tolerance);
}

/* Solves L(t) = |length| on the side of t0 where the sign of `length` points: Newton's method, L'
 * = |x'|, with bisection where a step leaves the bracket from a to b. done is the length at a. */
double lam_curve_at_length(const lam_curve *curve, double t0, double length, double tolerance) {
  double end = length < 0 ? curve->from : curve->to, wanted = fabs(length), done = 0, a = t0,
         b = end;
  if (wanted == 0 || end == t0) return t0;

  double total = fabs(lam_curve_length(curve, t0, end, tolerance));
  if (wanted >= total) return end;
  double t = a + (b - a) * wanted / total;

  for (int step = 0; step < 100; step++) {
    double here = done + fabs(lam_curve_length(curve, a, t, tolerance)), miss = here - wanted,
           v = speed(curve, t);

    if (fabs(miss) <= tolerance * total) return t;

    double sign = length < 0 ? -1 : 1, next = v > 0 ? t - sign * miss / v : NAN;
    if (miss < 0) {
      a = t;
      done = here;
    } else {
      b = t;
    }

    bool inside = next > fmin(a, b) && next < fmax(a, b);
    t = inside ? next : a + (b - a) / 2;
    if (t == a || t == b) return t;
  }
  return t;
}
