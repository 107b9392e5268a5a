/* Sparse Cholesky by CHOLMOD, ordering by AMD. The only file that includes them. Called through
 * factor.h by solver_run.c and by surf. */
#include "solve/factor.h"
#include "solve/kernels.h"

#include <amd.h>
#include <cholmod.h>
#include <string.h>

/* CHOLMOD's workspace is kept between solves: it is made once by cholmod_solve2. */
struct lam_factor {
  cholmod_common common;
  cholmod_factor *L;
  cholmod_sparse A; /* borrows the caller's pattern and values */
  cholmod_dense *X, *work_y, *work_e;
  lam_arena *arena;
  lam_factor_stats stats;
};

/* Deferred to the arena: what CHOLMOD allocated is not the arena's. */
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

/* The dense kernels' turn, in which nothing may jump. */
static void begin(lam_factor *factor) {
  if (!lam_kernels_begin()) lam_arena_exhausted(factor->arena);
}

/* One order only, the caller's; and LL': the L D L' that CHOLMOD takes for small systems would
 * accept an indefinite matrix. */
static void configure(cholmod_common *common) {
  common->print = 0;
  common->nmethods = 1;
  common->method[0].ordering = CHOLMOD_GIVEN;
  common->postorder = 1;
  common->supernodal = CHOLMOD_AUTO;
  common->final_ll = 1;
  common->quick_return_if_not_posdef = 1;
}

/* Symbolic analysis needs the pattern alone: the values come with lam_factor_refactor. */
lam_factor *lam_factor_analyze(lam_arena *arena, int n, const int *column_start, const int *row,
                               const int *order) {
  lam_factor *factor = LAM_NEW(arena, lam_factor, 1);
  factor->arena = arena;
  cholmod_start(&factor->common);
  lam_arena_defer(arena, close_factor, factor);
  configure(&factor->common);

  factor->A = (cholmod_sparse){.nrow = (size_t)n,
                               .ncol = (size_t)n,
                               .nzmax = (size_t)column_start[n],
                               .p = (void *)column_start,
                               .i = (void *)row,
                               .stype = -1, /* the lower triangle */
                               .itype = CHOLMOD_INT,
                               .xtype = CHOLMOD_PATTERN,
                               .dtype = CHOLMOD_DOUBLE,
                               .sorted = 1,
                               .packed = 1};
  begin(factor);
  factor->L = cholmod_analyze_p(&factor->A, (int *)order, NULL, 0, &factor->common);
  lam_kernels_end();
  check_memory(factor);
  factor->A.xtype = CHOLMOD_REAL;

  factor->stats.flops = factor->common.fl;
  factor->stats.entries = factor->common.lnz;
  return factor;
}

/* CHOLMOD reports an indefinite matrix by the column where it stopped (minor < n). */
bool lam_factor_refactor(lam_factor *factor, const double *values) {
  factor->A.x = (void *)values;
  begin(factor);
  cholmod_factorize(&factor->A, factor->L, &factor->common);
  lam_kernels_end();
  check_memory(factor);
  factor->stats.factorized++;
  return factor->common.status == CHOLMOD_OK && factor->L->minor == factor->L->n;
}

/* b is borrowed by a dense matrix of one column. */
void lam_factor_solve(lam_factor *factor, const double *b, double *x) {
  cholmod_dense B = {.nrow = factor->L->n,
                     .ncol = 1,
                     .nzmax = factor->L->n,
                     .d = factor->L->n,
                     .x = (void *)b,
                     .xtype = CHOLMOD_REAL,
                     .dtype = CHOLMOD_DOUBLE};
  begin(factor);
  cholmod_solve2(CHOLMOD_A, factor->L, &B, NULL, &factor->X, NULL, &factor->work_y, &factor->work_e,
                 &factor->common);
  lam_kernels_end();
  check_memory(factor);

  memcpy(x, factor->X->x, sizeof(double) * factor->L->n);
  factor->stats.solved++;
}

lam_factor_stats lam_factor_get_stats(const lam_factor *factor) { return factor->stats; }

/* AMD with its default settings; the empty graph has nothing to order. */
void lam_factor_order(lam_arena *arena, int n, const int *start, const int *neighbor, int *order) {
  double control[AMD_CONTROL], info[AMD_INFO];
  amd_defaults(control);
  if (n && amd_order(n, start, neighbor, order, control, info) == AMD_OUT_OF_MEMORY)
    lam_arena_exhausted(arena);
}
