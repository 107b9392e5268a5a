/* The operations on a front with vectors of two numbers. Chosen by front_kernels.c; empty on other
 * processors than arm64. */
#include "solve/factor/front_sets.h"

#ifdef __aarch64__
#include <arm_neon.h>

#define NAME lam_front_kernels_neon
#define TEXT "neon"
#define WIDTH 2
#define TILE 4
typedef float64x2_t vector;

static inline vector load(const double *from) { return vld1q_f64(from); }
static inline void store(double *to, vector a) { vst1q_f64(to, a); }
static inline vector spread(double a) { return vdupq_n_f64(a); }
static inline vector product(vector a, vector b) { return vmulq_f64(a, b); }
static inline vector minus_product(vector a, vector b, vector c) { return vfmsq_f64(c, a, b); }
static inline double minus_product_1(double a, double b, double c) {
  return __builtin_fma(-a, b, c);
}
static inline void add_run(double *to, const double *from, int count) {
  for (; count >= 2; count -= 2, to += 2, from += 2) store(to, vaddq_f64(load(to), load(from)));
  if (count) *to += *from;
}

#include "solve/factor/front_kernel.inc"
#endif
