/* Complex numbers from their parts: C11's CMPLX, which not every compiler knows. Used in surf/kinds
 * and net/measures. */
#ifndef LAM_CORE_COMPLEX_NUMBER_H
#define LAM_CORE_COMPLEX_NUMBER_H

#include <complex.h>

/* real + imaginary i, signs of zeros included. A complex number is stored as an array of its two
 * parts (C11 6.2.5). */
static inline double complex lam_complex(double real, double imaginary) {
  union {
    double parts[2];
    double complex number;
  } made = {{real, imaginary}};
  return made.number;
}

#endif
