/* The operations on a front with vectors of eight numbers. Chosen by front_kernels.c; compiled with
 * -mavx512f -mfma, and empty where the compiler is not told so. */
#include "solve/factor/front_sets.h"

#ifdef __AVX512F__
#include <immintrin.h>

#define NAME lam_front_kernels_avx512
#define TEXT "avx512"
#define WIDTH 8
#define TILE 3
typedef __m512d vector;

static inline vector load(const double *from) { return _mm512_loadu_pd(from); }
static inline void store(double *to, vector a) { _mm512_storeu_pd(to, a); }
static inline vector spread(double a) { return _mm512_set1_pd(a); }
static inline vector product(vector a, vector b) { return _mm512_mul_pd(a, b); }
static inline vector minus_product(vector a, vector b, vector c) {
  return _mm512_fnmadd_pd(a, b, c);
}
static inline double minus_product_1(double a, double b, double c) {
  return __builtin_fma(-a, b, c);
}
static inline void add_run(double *to, const double *from, int count) {
  for (; count >= 8; count -= 8, to += 8, from += 8) store(to, load(to) + load(from));
  __mmask8 rest = (__mmask8)((1 << count) - 1);
  if (count)
    _mm512_mask_storeu_pd(
        to, rest, _mm512_maskz_loadu_pd(rest, to) + _mm512_maskz_loadu_pd(rest, from));
}

#include "solve/factor/front_kernel.inc"
#endif
