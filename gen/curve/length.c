#include "curve/length.h"
#include "core/numeric/quadrature.h"
#include <stdbool.h>

enum { RULE = 12, DEEPEST = 40 };

typedef struct lam_rule {
  double places[RULE], weights[RULE];
} lam_rule;

static double speed(const lam_curve *curve, double t) {
  lam_vec3 x[2];
  curve->eval(curve->data, t, 1, x);
  return lam_length(x[1]);
}

static double once(const lam_curve *curve, const lam_rule *rule, double a, double b) {
  double sum = 0;
  for (int i = 0; i < RULE; i++)
    sum += rule->weights[i] * speed(curve, a + (b - a) * rule->places[i]);
  return (b - a) * sum;
}

static double halve(const lam_curve *curve, const lam_rule *rule, double a, double b, double whole,
                    double tolerance, int depth) {
  double middle = a + (b - a) / 2, left = once(curve, rule, a, middle),
         right = once(curve, rule, middle, b);
  double sum = left + right;
  if (fabs(sum - whole) <= tolerance * fabs(sum) || depth == DEEPEST) return sum;
  return halve(curve, rule, a, middle, left, tolerance, depth + 1) +
         halve(curve, rule, middle, b, right, tolerance, depth + 1);
}

/* a < b: piece by piece between the breaks. */
static double ascending(const lam_curve *curve, const lam_rule *rule, double a, double b,
                        double tolerance) {
  double sum = 0;
  for (int i = 0; i <= curve->break_count && a < b; i++) {
    double end = i < curve->break_count && curve->breaks[i] < b ? curve->breaks[i] : b;
    if (end <= a) continue;
    sum += halve(curve, rule, a, end, once(curve, rule, a, end), tolerance, 0);
    a = end;
  }
  return sum;
}

double lam_curve_length(const lam_curve *curve, double t0, double t1, double tolerance) {
  lam_rule rule;
  lam_gauss_rule(RULE, rule.places, rule.weights);
  return t1 >= t0 ? ascending(curve, &rule, t0, t1, tolerance)
                  : -ascending(curve, &rule, t1, t0, tolerance);
}

/* Solves L(t) = length on the side of t0 where it lies; a and b bracket the parameter, `done` is
 * the length at a. */
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
