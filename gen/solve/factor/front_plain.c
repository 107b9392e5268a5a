/* The operations on a front without vectors, for any processor. Where a fused multiply-add is not
 * an instruction, it is computed exactly by others, which is right and slow. Chosen by
 * front_kernels.c. */
#include "solve/factor/front_sets.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* a b as a sum p + e without error (Dekker 1971). */
static inline double product_error(double a, double b, double p) {
  double t = 134217729. * a, a1 = t - (t - a), a0 = a - a1;
  t = 134217729. * b;
  double b1 = t - (t - b), b0 = b - b1;
  return ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0;
}

/* What a + b = s lost to rounding (Knuth). */
static inline double sum_error(double a, double b, double s) {
  double z = s - a;
  return (a - (s - z)) + (b - z);
}

/* a + b rounded to odd: to the neighbor with an odd last digit unless it is exact. */
static inline double sum_to_odd(double a, double b) {
  double r = a + b, error = sum_error(a, b, r);
  if (error == 0) return r;
  int64_t digits;
  memcpy(&digits, &r, sizeof r);
  if (!(digits & 1)) digits += (error > 0) == (r > 0) ? 1 : -1;
  memcpy(&r, &digits, sizeof r);
  return r;
}

/* Whether nothing above can leave the range of numbers. */
static inline int is_moderate(double a) { return fabs(a) > 0x1p-450 && fabs(a) < 0x1p450; }

/* a b + c, rounded once (Boldo and Melquiond 2008): the last sum is of a number that was rounded to
 * odd. */
static double fused(double a, double b, double c) {
  if (a == 0 || b == 0) return a * b + c;
  if (!is_moderate(a) || !is_moderate(b) || !is_moderate(c)) return fma(a, b, c);
  double p = a * b, e = product_error(a, b, p);
  double low = c + e, low_error = sum_error(c, e, low);
  double high = p + low, high_error = sum_error(p, low, high);
  return high + sum_to_odd(high_error, low_error);
}

#define NAME lam_front_kernels_plain
#define TEXT "plain"
#define WIDTH 1
#define TILE 2
typedef double vector;

static inline vector load(const double *from) { return *from; }
static inline void store(double *to, vector a) { *to = a; }
static inline vector spread(double a) { return a; }
static inline vector product(vector a, vector b) { return a * b; }
static inline vector minus_product(vector a, vector b, vector c) { return fused(-a, b, c); }
static inline double minus_product_1(double a, double b, double c) { return fused(-a, b, c); }
static inline void add_run(double *to, const double *from, int count) {
  for (int i = 0; i < count; i++) to[i] += from[i];
}

#include "solve/factor/front_kernel.inc"
