/* The operations on a front with vectors of four numbers. Chosen by front_kernels.c; compiled with
 * -mavx -mfma, and empty where the compiler is not told so. */
#include "solve/factor/front_sets.h"

#if defined __AVX__ && defined __FMA__
#include <immintrin.h>

#define NAME lam_front_kernels_avx2
#define TEXT "avx2"
#define WIDTH 4
#define TILE 2
typedef __m256d vector;

static inline vector load(const double *from) { return _mm256_loadu_pd(from); }
static inline void store(double *to, vector a) { _mm256_storeu_pd(to, a); }
static inline vector spread(double a) { return _mm256_set1_pd(a); }
static inline vector product(vector a, vector b) { return _mm256_mul_pd(a, b); }
static inline vector minus_product(vector a, vector b, vector c) {
  return _mm256_fnmadd_pd(a, b, c);
}
static inline double minus_product_1(double a, double b, double c) {
  return __builtin_fma(-a, b, c);
}
static inline void add_run(double *to, const double *from, int count) {
  for (; count >= 4; count -= 4, to += 4, from += 4) store(to, load(to) + load(from));
  for (int i = 0; i < count; i++) to[i] += from[i];
}

#include "solve/factor/front_kernel.inc"
#endif
