/* The dense kernels behind the factorization, as the face shows them. Called through
 * lamella/session.h, by cli/main.c. */
#include "solve/kernels.h"
#include <lamella/session.h>

#include <stdlib.h>
#include <unistd.h>

const char *lam_kernels(void) { return lam_blas_kernel(); }
const char *lam_kernels_advice(void) { return lam_blas_advice(); }

/* The variable that is set keeps the program from starting anew for ever. execv returns when it
 * fails, and the program goes on as it is. */
void lam_kernels_restart(char **argv) {
  const char *better = lam_blas_better_kernel();
  if (!better || getenv("OPENBLAS_CORETYPE")) return;

  setenv("OPENBLAS_CORETYPE", better, 1);
  execv("/proc/self/exe", argv);
}
