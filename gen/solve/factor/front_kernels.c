/* Which instruction set fronts are computed with on this processor. Called by solve/factor.c and
 * library/host_kernels.c. */
#include "solve/factor/front_sets.h"

#include <stdatomic.h>
#include <string.h>

/* Best first; plain always runs. */
static int list_sets(const lam_front_kernels *sets[3]) {
  int count = 0;
#if defined __x86_64__
  if (__builtin_cpu_supports("avx512f")) sets[count++] = &lam_front_kernels_avx512;
  if (__builtin_cpu_supports("avx") && __builtin_cpu_supports("fma"))
    sets[count++] = &lam_front_kernels_avx2;
#elif defined __aarch64__
  sets[count++] = &lam_front_kernels_neon;
#endif
  sets[count++] = &lam_front_kernels_plain;
  return count;
}

static const lam_front_kernels *_Atomic forced;

const lam_front_kernels *lam_front_kernels_choose(void) {
  const lam_front_kernels *sets[3], *chosen = atomic_load(&forced);
  if (chosen) return chosen;
  list_sets(sets);
  return sets[0];
}

const lam_front_kernels *lam_front_kernels_named(const char *name) {
  const lam_front_kernels *sets[3];
  int count = list_sets(sets);
  for (int i = 0; i < count; i++)
    if (strcmp(sets[i]->name, name) == 0) return sets[i];
  return NULL;
}

void lam_front_kernels_force(const lam_front_kernels *kernels) { atomic_store(&forced, kernels); }
