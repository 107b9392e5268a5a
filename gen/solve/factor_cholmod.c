#include "solve/factor.h"

#include <amd.h>
#include <cholmod.h>
#include <omp.h>
#include <string.h>

/* From OpenBLAS; declared here because its header redefines the complex types of the C library. */
extern char *openblas_get_corename(void);
extern void openblas_set_num_threads(int threads);

struct lam_factor {
  cholmod_common common;
  cholmod_factor *L;
  cholmod_sparse A; /* borrows the caller's pattern and values */
  cholmod_dense *X, *work_y, *work_e;
  lam_arena *arena;
  lam_factor_stats stats;
};

static void close_factor(void *handle) {
  lam_factor *factor = handle;
  cholmod_free_factor(&factor->L, &factor->common);
  cholmod_free_dense(&factor->X, &factor->common);
  cholmod_free_dense(&factor->work_y, &factor->common);
  cholmod_free_dense(&factor->work_e, &factor->common);
  cholmod_finish(&factor->common);
}

/* CHOLMOD counts in ints here: a factor that is too large for them is one that does not fit. */
static void check_memory(lam_factor *factor) {
  if (factor->common.status == CHOLMOD_OUT_OF_MEMORY || factor->common.status == CHOLMOD_TOO_LARGE)
    lam_arena_exhausted(factor->arena);
}

lam_factor *lam_factor_analyze(lam_arena *arena, int n, const int *column_start, const int *row,
                               const int *order) {
  /* One thread: the same bytes on any machine. CHOLMOD asks for four threads in loops of a few
   * columns, which costs four times what the factorization does; only without active levels does
   * OpenMP leave those loops alone. */
  openblas_set_num_threads(1);
  omp_set_max_active_levels(0);
  lam_factor *factor = LAM_NEW(arena, lam_factor, 1);
  factor->arena = arena;
  cholmod_start(&factor->common);
  lam_arena_defer(arena, close_factor, factor);
  cholmod_common *common = &factor->common;
  common->print = 0;
  common->nmethods = 1;
  common->method[0].ordering = CHOLMOD_GIVEN;
  common->postorder = 1;
  common->supernodal = CHOLMOD_AUTO;
  common->final_ll = 1; /* LL': L D L' of small systems would accept an indefinite matrix */
  common->quick_return_if_not_posdef = 1;
  factor->A = (cholmod_sparse){.nrow = (size_t)n,
                               .ncol = (size_t)n,
                               .nzmax = (size_t)column_start[n],
                               .p = (void *)column_start,
                               .i = (void *)row,
                               .stype = -1,
                               .itype = CHOLMOD_INT,
                               .xtype = CHOLMOD_REAL,
                               .dtype = CHOLMOD_DOUBLE,
                               .sorted = 1,
                               .packed = 1};
  factor->A.xtype = CHOLMOD_PATTERN;
  factor->L = cholmod_analyze_p(&factor->A, (int *)order, NULL, 0, common);
  check_memory(factor);
  factor->A.xtype = CHOLMOD_REAL;
  factor->stats.flops = common->fl;
  factor->stats.entries = common->lnz;
  return factor;
}

bool lam_factor_refactor(lam_factor *factor, const double *values) {
  factor->A.x = (void *)values;
  cholmod_factorize(&factor->A, factor->L, &factor->common);
  check_memory(factor);
  factor->stats.factorized++;
  return factor->common.status == CHOLMOD_OK && factor->L->minor == factor->L->n;
}

void lam_factor_solve(lam_factor *factor, const double *b, double *x) {
  cholmod_dense B = {.nrow = factor->L->n,
                     .ncol = 1,
                     .nzmax = factor->L->n,
                     .d = factor->L->n,
                     .x = (void *)b,
                     .xtype = CHOLMOD_REAL,
                     .dtype = CHOLMOD_DOUBLE};
  cholmod_solve2(CHOLMOD_A, factor->L, &B, NULL, &factor->X, NULL, &factor->work_y, &factor->work_e,
                 &factor->common);
  check_memory(factor);
  memcpy(x, factor->X->x, sizeof(double) * factor->L->n);
  factor->stats.solved++;
}

lam_factor_stats lam_factor_get_stats(const lam_factor *factor) { return factor->stats; }

void lam_factor_order(lam_arena *arena, int n, const int *start, const int *neighbor, int *order) {
  double control[AMD_CONTROL], info[AMD_INFO];
  amd_defaults(control);
  if (n && amd_order(n, start, neighbor, order, control, info) == AMD_OUT_OF_MEMORY)
    lam_arena_exhausted(arena);
}

const char *lam_blas_kernel(void) { return openblas_get_corename(); }

const char *lam_blas_better_kernel(void) {
  const char *kernel = openblas_get_corename();
  static const char *const old[] = {"Prescott", "Core2",     "Penryn", "Dunnington",
                                    "Nehalem",  "Barcelona", "Generic"};
  for (size_t i = 0; i < sizeof old / sizeof *old; i++)
    if (strcmp(kernel, old[i]) == 0)
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? "Haswell" : NULL;
  return NULL;
}

const char *lam_blas_advice(void) {
  return lam_blas_better_kernel() ? "this OpenBLAS does not recognize the processor: set "
                                    "OPENBLAS_CORETYPE=Haswell for twice the speed"
                                  : NULL;
}
