/* OpenBLAS and OpenMP: settings saved and restored, kernels named. Called by factor_cholmod.c,
 * library/host_kernels.c and bench/. */
#include "solve/kernels.h"

#include <omp.h>
#include <pthread.h>
#include <stddef.h>
#include <string.h>
#include <sys/mman.h>

/* From OpenBLAS; declared here because its header redefines the complex types of the C library. */
extern void dpotrf_(const char *half, const int *n, double *a, const int *stride, int *info);
extern char *openblas_get_corename(void);
extern int openblas_get_num_threads(void);
extern void openblas_set_num_threads(int threads);

static pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;

/* ---- workspace ---- */

/* More than the buffer that OpenBLAS maps for a thread on any processor (128 MB on x86-64). */
enum { WORKSPACE = 144 << 20 };

/* OpenBLAS maps its buffer at the first call that needs one and keeps it; where that fails it
 * tries again without end. So it is asked for only when there is room, and once. The turn is the
 * caller's. */
static bool hold_workspace(void) {
  static bool held = false;
  if (held) return true;
  void *room = mmap(NULL, WORKSPACE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return false;
  munmap(room, WORKSPACE);

  double one = 1;
  const int n = 1;
  int info;
  dpotrf_("L", &n, &one, &n, &info);
  return held = true;
}

/* ---- settings ---- */

/* The host's settings while it is this library's turn. */
static int host_threads, host_levels;

bool lam_kernels_begin(void) {
  pthread_mutex_lock(&turn);
  host_threads = openblas_get_num_threads();
  host_levels = omp_get_max_active_levels();

  /* CHOLMOD asks for four threads in loops of a few columns, which costs four times what the
   * factorization does; only without active levels does OpenMP leave those loops alone. */
  if (host_threads != 1) openblas_set_num_threads(1);
  omp_set_max_active_levels(0);

  if (hold_workspace()) return true;
  lam_kernels_end();
  return false;
}

void lam_kernels_end(void) {
  omp_set_max_active_levels(host_levels);
  if (host_threads != 1) openblas_set_num_threads(host_threads);
  pthread_mutex_unlock(&turn);
}

/* ---- names ---- */

const char *lam_blas_kernel(void) { return openblas_get_corename(); }

/* The kernels that an OpenBLAS takes for a processor that it does not know. */
static int is_fallback(const char *kernel) {
  static const char *const old[] = {"Prescott", "Core2",     "Penryn", "Dunnington",
                                    "Nehalem",  "Barcelona", "Generic"};
  for (size_t i = 0; i < sizeof old / sizeof *old; i++)
    if (strcmp(kernel, old[i]) == 0) return 1;
  return 0;
}

/* On x86-64 with AVX2 and FMA the kernels for Haswell are right; elsewhere none is known better. */
const char *lam_blas_better_kernel(void) {
#if defined(__x86_64__)
  if (is_fallback(openblas_get_corename()) && __builtin_cpu_supports("avx2") &&
      __builtin_cpu_supports("fma"))
    return "Haswell";
#else
  (void)is_fallback;
#endif
  return NULL;
}

const char *lam_blas_advice(void) {
  return lam_blas_better_kernel() ? "this OpenBLAS does not recognize the processor: set "
                                    "OPENBLAS_CORETYPE=Haswell for twice the speed"
                                  : NULL;
}
