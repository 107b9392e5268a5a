/* The dense kernels behind factorizations: which ones are in use, and the host's settings of them
 * kept as they are. The one place that knows OpenBLAS and OpenMP. Called by factor_cholmod.c, and
 * through library/host_kernels.c by programs. */
#ifndef LAM_SOLVE_KERNELS_H
#define LAM_SOLVE_KERNELS_H

#include <stdbool.h>

/* Around every call that may run dense kernels: one thread, so that results are the same bytes on
 * any number of processors. The settings are the whole process's: they are saved, and restored by
 * the end; calls of other threads of this library wait meanwhile. Nothing in between may jump.
 * False when there is no memory for the kernels' workspace: then nothing is to be ended. */
bool lam_kernels_begin(void);
void lam_kernels_end(void);

/* The kernels in use ("Zen", "Haswell", ...), and one line of advice when they do not suit this
 * processor (NULL: they do). Static texts. */
const char *lam_blas_kernel(void);
const char *lam_blas_advice(void);
/* A kernel name to put into OPENBLAS_CORETYPE before the program starts anew, or NULL. */
const char *lam_blas_better_kernel(void);

#endif
