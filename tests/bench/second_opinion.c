/* Our factorization against CHOLMOD, on the same matrices in one run, alternating: `make bench`.
 * Every instruction set of this processor. CHOLMOD runs with one thread on the BLAS that it finds;
 * OPENBLAS_CORETYPE chooses kernels of an OpenBLAS. */
#include "bench/bench.h"
#include "solve/factor/front.h"

#include <cholmod.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 15 };

/* Least seconds of factorizing and of solving. */
typedef struct times {
  double factor, solve;
} times;

static void keep_least(double *least, double seconds) {
  if (seconds < *least) *least = seconds;
}

/* ---- ours ---- */

static void run_ours(lam_factor *factor, const lam_bench_equations *e, times *t) {
  double since = lam_bench_clock();
  lam_factor_refactor(factor, e->values);
  keep_least(&t->factor, lam_bench_clock() - since);
  since = lam_bench_clock();
  lam_factor_solve(factor, e->gradient, e->step);
  keep_least(&t->solve, lam_bench_clock() - since);
}

/* ---- CHOLMOD ---- */

typedef struct other {
  cholmod_common common;
  cholmod_sparse A;
  cholmod_factor *L;
} other;

/* In the same order, on the same pattern. */
static void open_other(other *o, const lam_bench_equations *e) {
  int n = lam_system_size(e->system);
  const int *columns = lam_system_columns(e->system);
  cholmod_start(&o->common);
  o->common.nmethods = 1;
  o->common.method[0].ordering = CHOLMOD_GIVEN;
  o->common.final_ll = 1;
  o->A = (cholmod_sparse){.nrow = (size_t)n,
                          .ncol = (size_t)n,
                          .nzmax = (size_t)columns[n],
                          .p = (void *)columns,
                          .i = (void *)lam_system_rows(e->system),
                          .x = e->values,
                          .stype = -1,
                          .itype = CHOLMOD_INT,
                          .xtype = CHOLMOD_REAL,
                          .dtype = CHOLMOD_DOUBLE,
                          .sorted = 1,
                          .packed = 1};
  o->L = cholmod_analyze_p(&o->A, (int *)lam_system_order(e->system), NULL, 0, &o->common);
}

static void run_other(other *o, const lam_bench_equations *e, times *t) {
  size_t n = o->A.nrow;
  cholmod_dense b = {.nrow = n,
                     .ncol = 1,
                     .nzmax = n,
                     .d = n,
                     .x = e->gradient,
                     .xtype = CHOLMOD_REAL,
                     .dtype = CHOLMOD_DOUBLE};
  double since = lam_bench_clock();
  cholmod_factorize(&o->A, o->L, &o->common);
  keep_least(&t->factor, lam_bench_clock() - since);
  since = lam_bench_clock();
  cholmod_dense *x = cholmod_solve(CHOLMOD_A, o->L, &b, &o->common);
  keep_least(&t->solve, lam_bench_clock() - since);
  cholmod_free_dense(&x, &o->common);
}

static void close_other(other *o) {
  cholmod_free_factor(&o->L, &o->common);
  cholmod_finish(&o->common);
}

/* ---- both ---- */

/* One net: a line per instruction set. False with errors. */
static bool compare(lam_bench *bench, int cells) {
  lam_bench_equations e;
  int vertices;
  if (!lam_bench_asymptotic(bench, cells, &e, &vertices)) return false;
  lam_bench_assemble(&e);
  other o;
  open_other(&o, &e);

  static const char *const sets[] = {"avx512", "avx2", "neon", "plain"};
  for (int i = 0; i < 4; i++) {
    const lam_front_kernels *kernels = lam_front_kernels_named(sets[i]);
    bool slow = i == 3 && lam_front_kernels_choose() != kernels;
    if (!kernels || slow) continue;

    lam_front_kernels_force(kernels);
    lam_factor *factor = lam_factor_analyze(bench->arena, lam_system_size(e.system),
                                            lam_system_columns(e.system), lam_system_rows(e.system),
                                            lam_system_order(e.system));
    lam_front_kernels_force(NULL);
    times ours = {1e9, 1e9}, others = {1e9, 1e9};
    for (int k = 0; k < REPEATS; k++) {
      run_ours(factor, &e, &ours);
      run_other(&o, &e, &others);
    }
    lam_factor_stats stats = lam_factor_get_stats(factor);
    printf("%8d  %-7s %9.2f %9.2f %7.2f %9.2f %9.2f %7.1f\n", vertices, kernels->name,
           ours.factor * 1e3, others.factor * 1e3, others.factor / ours.factor, ours.solve * 1e3,
           others.solve * 1e3, stats.flops / ours.factor * 1e-9);
  }
  close_other(&o);
  return true;
}

int main(void) {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  setenv("OMP_NUM_THREADS", "1", 1);
  lam_arena *arena = lam_arena_new();
  lam_errors errors = {.arena = arena};
  lam_bench bench = {.arena = arena, .errors = &errors, .out = stdout};
  jmp_buf point;
  if (!arena || !LAM_ARENA_TRY(arena, point)) return 1;

  printf("factorization, ms of one thread (least of %d)\n"
         "vertices  with       ours   CHOLMOD   ratio  solve: ours   CHOLMOD  Gflop/s\n",
         REPEATS);
  bool good = compare(&bench, 20) && compare(&bench, 40) && compare(&bench, 68);
  lam_arena_free(arena);
  return good ? 0 : 1;
}
