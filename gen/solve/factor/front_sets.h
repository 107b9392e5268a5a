/* The instruction sets that fronts are computed with: one file each, all with the same bits. Used
 * by front_kernels.c and those files. */
#ifndef LAM_SOLVE_FACTOR_FRONT_SETS_H
#define LAM_SOLVE_FACTOR_FRONT_SETS_H

#include "solve/factor/front.h"

extern const lam_front_kernels lam_front_kernels_avx512, lam_front_kernels_avx2; /* x86-64 */
extern const lam_front_kernels lam_front_kernels_neon;                     /* arm64 */
extern const lam_front_kernels lam_front_kernels_plain;

#endif
