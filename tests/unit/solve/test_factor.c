/* The factorization on random matrices: against the matrix itself (A x = b), against CHOLMOD, and
 * bit by bit between instruction sets. */
#include "solve/factor.h"
#include "solve/factor/front.h"
#include "tests/unit/asserts.h"

#include <cholmod.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- random matrices ---- */

static unsigned seed;

static unsigned random_number(void) {
  seed = seed * 1664525u + 1013904223u;
  return seed >> 8;
}
static int below(int n) { return (int)(random_number() % (unsigned)n); }
static double uniform(void) { return random_number() / 8388608. - 1; }

/* A symmetric positive definite matrix as the solver has it: nodes of a few unknowns, whose blocks
 * are full where two nodes share an equation. */
typedef struct sample {
  int n, nodes, *first; /* first: nodes + 1 */
  double *dense;        /* n x n */
  int *start, *row, *order;
  double *values;
} sample;

/* Unknowns of some nodes in one equation: J' J is added, and the pattern gets full blocks. */
static void add_equation(sample *s, bool *pattern, const int *nodes, int count) {
  int unknown[64], size = 0;
  double J[64];
  for (int i = 0; i < count; i++)
    for (int c = s->first[nodes[i]]; c < s->first[nodes[i] + 1]; c++) {
      unknown[size] = c;
      J[size++] = uniform();
    }
  for (int a = 0; a < size; a++)
    for (int b = 0; b < size; b++) {
      s->dense[unknown[a] * s->n + unknown[b]] += J[a] * J[b];
      pattern[unknown[a] * s->n + unknown[b]] = true;
    }
}

static void list_columns(lam_arena *arena, sample *s, const bool *pattern) {
  s->start = LAM_NEW(arena, int, s->n + 1);
  s->row = LAM_NEW(arena, int, s->n * s->n);
  s->values = LAM_NEW(arena, double, s->n * s->n);
  for (int c = 0; c < s->n; c++) {
    s->start[c + 1] = s->start[c];
    for (int r = c; r < s->n; r++)
      if (pattern[c * s->n + r]) {
        s->row[s->start[c + 1]] = r;
        s->values[s->start[c + 1]++] = s->dense[c * s->n + r];
      }
  }
}

static void shuffle(int *list, int count) {
  for (int i = count - 1; i > 0; i--) {
    int j = below(i + 1), keep = list[i];
    list[i] = list[j];
    list[j] = keep;
  }
}

/* Nodes in a random order; now and then their unknowns are torn apart. */
static void make_order(lam_arena *arena, sample *s) {
  int *node = LAM_NEW(arena, int, s->nodes), count = 0;
  for (int v = 0; v < s->nodes; v++) node[v] = v;
  shuffle(node, s->nodes);
  s->order = LAM_NEW(arena, int, s->n);
  for (int v = 0; v < s->nodes; v++)
    for (int c = s->first[node[v]]; c < s->first[node[v] + 1]; c++) s->order[count++] = c;
  if (below(5) == 0) shuffle(s->order, s->n);
}

/* hub: the first node is in every equation. damping: on the diagonal. */
static sample make_sample(lam_arena *arena, int nodes, bool threes, bool hub, double damping) {
  sample s = {.nodes = nodes, .first = LAM_NEW(arena, int, nodes + 1)};
  for (int v = 0; v < nodes; v++)
    s.first[v + 1] = s.first[v] + (threes && !(hub && v == 0) ? 3 : 1 + below(5));
  s.n = s.first[nodes];
  s.dense = LAM_NEW(arena, double, s.n * s.n);
  bool *pattern = LAM_NEW(arena, bool, s.n * s.n);

  for (int e = 0; e < 2 * nodes; e++) {
    int a = below(nodes), b = (a + 1 + below(6)) % nodes, list[3] = {a, b, 0}, count = 2;
    if (a == b) count = 1;
    if (hub && a != 0 && b != 0) list[count++] = 0;
    add_equation(&s, pattern, list, count);
  }
  for (int v = 0; v < nodes; v++) add_equation(&s, pattern, &v, 1);
  for (int i = 0; i < s.n; i++) s.dense[i * s.n + i] += damping;
  list_columns(arena, &s, pattern);
  make_order(arena, &s);
  return s;
}

/* The k-th of a series: mostly small, every tenth larger. */
static sample sample_at(lam_arena *arena, int k) {
  seed = 7919u * (unsigned)k + 1;
  int nodes = 1 + below(k % 10 == 0 ? 200 : 60);
  bool threes = below(2) == 0, hub = below(3) == 0;
  return make_sample(arena, nodes, threes, hub, pow(10, -below(11)));
}

static double *right_side(lam_arena *arena, int n) {
  double *b = LAM_NEW(arena, double, n);
  for (int i = 0; i < n; i++) b[i] = uniform();
  return b;
}

/* |A x - b| against the size of what is added up in it, all in the maximum norm. */
static double backward_error(const sample *s, const double *x, const double *b) {
  double worst = 0, largest = 0, size = 0;
  for (int i = 0; i < s->n; i++) {
    double rest = b[i];
    for (int j = 0; j < s->n; j++) {
      rest -= s->dense[i * s->n + j] * x[j];
      largest = fmax(largest, fabs(s->dense[i * s->n + j]));
    }
    worst = fmax(worst, fabs(rest));
    size = fmax(size, fabs(x[i]));
  }
  return worst / (s->n * largest * size);
}

/* ---- tests ---- */

static int set_up(void **state) {
  *state = lam_arena_new();
  return *state ? 0 : -1;
}
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}
#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

static const char *const sets[] = {"avx512", "avx2", "neon", "plain"};

static lam_factor *analyze(lam_arena *arena, const sample *s) {
  return lam_factor_analyze(arena, s->n, s->start, s->row, s->order);
}

/* A Cholesky factorization is backward stable: |A x - b| is a small multiple of the rounding unit
 * 1.1e-16 times n |A| |x| (Higham, Accuracy and Stability, theorem 10.4). */
static void solutions_fulfill_equations_with_the_same_bits(void **state) {
  for (int k = 0; k < 120; k++) {
    lam_arena_mark mark = lam_arena_mark_get(*state);
    sample s = sample_at(*state, k);
    double *b = right_side(*state, s.n), *first = NULL;
    for (int i = 0; i < 4; i++) {
      if (!lam_front_kernels_named(sets[i])) continue;
      lam_front_kernels_force(lam_front_kernels_named(sets[i]));
      lam_factor *factor = analyze(*state, &s);
      assert_true(lam_factor_refactor(factor, s.values));
      double *x = LAM_NEW(*state, double, s.n);
      lam_factor_solve(factor, b, x);
      assert_below(backward_error(&s, x, b), 1e-15);
      if (!first) first = x;
      assert_memory_equal(x, first, sizeof(double) * (size_t)s.n);
    }
    lam_front_kernels_force(NULL);
    lam_arena_release(*state, mark);
  }
}

/* b may be x. A second factorization and solution give the first one's bits. */
static void factors_are_used_again(void **state) {
  for (int k = 0; k < 20; k++) {
    sample s = sample_at(*state, k);
    double *b = right_side(*state, s.n), *x = LAM_NEW(*state, double, s.n);
    lam_factor *factor = analyze(*state, &s);
    assert_true(lam_factor_refactor(factor, s.values));
    lam_factor_solve(factor, b, x);
    assert_true(lam_factor_refactor(factor, s.values));
    lam_factor_solve(factor, b, b);
    assert_memory_equal(x, b, sizeof(double) * (size_t)s.n);
    lam_factor_stats stats = lam_factor_get_stats(factor);
    assert_int_equal(stats.factorized, 2);
    assert_int_equal(stats.solved, 2);
  }
}

/* A negative number on the diagonal, zero, and what is not a number; afterwards the old bits. */
static void what_is_not_positive_definite_is_refused(void **state) {
  const double bad[] = {-1e-3, 0, NAN, INFINITY};
  for (int k = 0; k < 40; k++) {
    sample s = sample_at(*state, k);
    double *b = right_side(*state, s.n), *x = LAM_NEW(*state, double, s.n),
           *y = LAM_NEW(*state, double, s.n);
    lam_factor *factor = analyze(*state, &s);
    assert_true(lam_factor_refactor(factor, s.values));
    lam_factor_solve(factor, b, x);
    double *diagonal = &s.values[s.start[below(s.n)]], keep = *diagonal;
    for (int i = 0; i < 4; i++) {
      *diagonal = bad[i];
      assert_false(lam_factor_refactor(factor, s.values));
    }
    *diagonal = keep;
    assert_true(lam_factor_refactor(factor, s.values));
    lam_factor_solve(factor, b, y);
    assert_memory_equal(x, y, sizeof(double) * (size_t)s.n);
  }
}

/* A x = b by CHOLMOD, in the same order. */
static void solve_by_cholmod(const sample *s, const double *b, double *x) {
  cholmod_common common;
  cholmod_start(&common);
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  cholmod_sparse A = {.nrow = (size_t)s->n, .ncol = (size_t)s->n, .nzmax = (size_t)s->start[s->n],
                      .p = s->start, .i = s->row, .x = s->values, .stype = -1,
                      .itype = CHOLMOD_INT, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE,
                      .sorted = 1, .packed = 1};
  cholmod_factor *L = cholmod_analyze_p(&A, s->order, NULL, 0, &common);
  cholmod_factorize(&A, L, &common);
  cholmod_dense B = {.nrow = (size_t)s->n, .ncol = 1, .nzmax = (size_t)s->n, .d = (size_t)s->n,
                     .x = (void *)b, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE};
  cholmod_dense *X = cholmod_solve(CHOLMOD_A, L, &B, &common);
  memcpy(x, X->x, sizeof(double) * (size_t)s->n);
  cholmod_free_dense(&X, &common);
  cholmod_free_factor(&L, &common);
  cholmod_finish(&common);
}

/* Well-conditioned matrices (damping 1), where two backward stable solutions agree. */
static void solutions_agree_with_cholmod(void **state) {
  for (int k = 0; k < 20; k++) {
    seed = (unsigned)k;
    sample s = make_sample(*state, 100, k % 2, k % 3 == 0, 1);
    double *b = right_side(*state, s.n), *x = LAM_NEW(*state, double, s.n),
           *y = LAM_NEW(*state, double, s.n);
    lam_factor *factor = analyze(*state, &s);
    assert_true(lam_factor_refactor(factor, s.values));
    lam_factor_solve(factor, b, x);
    solve_by_cholmod(&s, b, y);
    for (int i = 0; i < s.n; i++) assert_near(x[i], y[i], 1e-10);
  }
}

/* A grid of n x n nodes of three unknowns, every node in an equation with its eight neighbors:
 * large enough for fronts of several blocks. Its residual is measured by columns. */
static void large_fronts(void **state) {
  enum { N = 40 };
  sample s = {.nodes = N * N, .n = 3 * N * N};
  s.start = LAM_NEW(*state, int, s.n + 1);
  s.row = LAM_NEW(*state, int, s.n * 15);
  s.values = LAM_NEW(*state, double, s.n * 15);
  s.order = LAM_NEW(*state, int, s.n);
  seed = 1;
  for (int v = 0, e = 0; v < N * N; v++)
    for (int c = 0; c < 3; c++) {
      /* nodes v, and those after it among its neighbors, ascending */
      static const int ahead[][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
      for (int d = c; d < 3; d++, e++) s.row[e] = 3 * v + d, s.values[e] = d == c ? 30 : uniform();
      for (int q = 0; q < 4; q++) {
        int i = v % N + ahead[q][0], j = v / N + ahead[q][1];
        if (i < 0 || i >= N || j >= N) continue;
        for (int d = 0; d < 3; d++, e++) s.row[e] = 3 * (j * N + i) + d, s.values[e] = uniform();
      }
      s.start[3 * v + c + 1] = e;
    }

  /* row by row: the fronts are as wide as the grid */
  for (int i = 0; i < s.n; i++) s.order[i] = i;
  double *b = right_side(*state, s.n), *first = NULL;
  for (int i = 0; i < 4; i++) {
    if (!lam_front_kernels_named(sets[i])) continue;
    lam_front_kernels_force(lam_front_kernels_named(sets[i]));
    lam_factor *factor = analyze(*state, &s);
    assert_true(lam_factor_refactor(factor, s.values));
    double *x = LAM_NEW(*state, double, s.n), *rest = LAM_NEW(*state, double, s.n);
    lam_factor_solve(factor, b, x);

    /* b - A x with the lower triangle and its mirror */
    memcpy(rest, b, sizeof(double) * (size_t)s.n);
    for (int c = 0; c < s.n; c++)
      for (int e = s.start[c]; e < s.start[c + 1]; e++) {
        rest[s.row[e]] -= s.values[e] * x[c];
        if (s.row[e] != c) rest[c] -= s.values[e] * x[s.row[e]];
      }
    for (int r = 0; r < s.n; r++) assert_near(rest[r], 0, 1e-13);
    if (!first) first = x;
    assert_memory_equal(x, first, sizeof(double) * (size_t)s.n);
  }
  lam_front_kernels_force(NULL);
}

/* A full matrix is one node and one front: n^3 / 3 operations, counted in squares of columns. */
static void a_full_matrix_is_one_front(void **state) {
  sample s = make_sample(*state, 1, false, false, 1);
  enum { N = 90 };
  s.n = N;
  s.dense = LAM_NEW(*state, double, N * N);
  bool *pattern = LAM_NEW(*state, bool, N * N);
  for (int i = 0; i < N * N; i++) pattern[i] = true, s.dense[i] = i % (N + 1) == 0 ? N : .5;
  list_columns(*state, &s, pattern);
  s.order = LAM_NEW(*state, int, N);
  for (int i = 0; i < N; i++) s.order[i] = i;
  double *b = right_side(*state, N), *x = LAM_NEW(*state, double, N);
  lam_factor *factor = analyze(*state, &s);
  assert_true(lam_factor_refactor(factor, s.values));
  lam_factor_solve(factor, b, x);
  assert_below(backward_error(&s, x, b), 1e-15);
  assert_near(lam_factor_get_stats(factor).flops, N * (N + 1) * (2 * N + 1) / 6., 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(solutions_fulfill_equations_with_the_same_bits),
      TEST(factors_are_used_again),
      TEST(what_is_not_positive_definite_is_refused),
      TEST(solutions_agree_with_cholmod),
      TEST(large_fronts),
      TEST(a_full_matrix_is_one_front),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
