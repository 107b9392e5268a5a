/* Sparse Cholesky, multifrontal (Duff and Reid 1983): the matrix is eliminated in a tree of small
 * dense fronts. The same bits on every processor. Called through factor.h by solver_run.c and by
 * surf. */
#include "solve/factor.h"
#include "solve/factor/front_plan.h"

#include <amd.h>
#include <stdint.h>
#include <string.h>

struct lam_factor {
  lam_plan plan;
  const lam_front_kernels *kernels;
  double *factors, *updates, *panel; /* of all fronts; of those that live; of one */
  double *y, *w;                     /* solving: a number per unknown, per updated row */
  double *pivots, *sums;             /* solving: of one front */
  size_t *row;                       /* where a front's updated rows begin in w */
  lam_factor_stats stats;
};

/* Numbers at an address that vectors do not straddle cache lines from. */
static double *numbers(lam_arena *arena, size_t count) {
  enum { LINE = 64 };
  uintptr_t at = (uintptr_t)lam_arena_alloc(arena, count * sizeof(double) + LINE, 1);
  return (double *)((at + LINE - 1) / LINE * LINE);
}

static void free_scratch(void *scratch) { lam_arena_free(scratch); }

/* Symbolic: what is needed on the way is freed at its end, or with the arena. */
static lam_plan plan(lam_arena *arena, const lam_pattern *pattern) {
  lam_arena *scratch = lam_arena_new();
  if (!scratch) lam_arena_exhausted(arena);
  lam_arena_defer(arena, free_scratch, scratch);
  jmp_buf *point = lam_arena_recover(arena, NULL);
  lam_arena_recover(arena, point);
  lam_arena_recover(scratch, point);

  lam_arena_mark empty = lam_arena_mark_get(scratch);
  lam_plan made = lam_plan_make(arena, scratch, pattern);
  lam_arena_release(scratch, empty);
  return made;
}

lam_factor *lam_factor_analyze(lam_arena *arena, int n, const int *column_start, const int *row,
                               const int *order) {
  lam_factor *factor = LAM_NEW(arena, lam_factor, 1);
  lam_plan *p = &factor->plan;
  *p = plan(arena, &(lam_pattern){n, column_start, row, order});
  factor->kernels = lam_front_kernels_choose();

  size_t rows = 0;
  factor->row = LAM_NEW(arena, size_t, p->count);
  for (int i = 0; i < p->count; i++) {
    factor->row[i] = rows;
    rows += (size_t)p->fronts[i].mp;
  }
  factor->factors = numbers(arena, p->factor_size);
  factor->updates = numbers(arena, p->update_size);
  factor->panel = numbers(arena, p->panel_size);
  factor->y = numbers(arena, (size_t)n);
  factor->w = numbers(arena, rows);
  factor->pivots = numbers(arena, (size_t)p->most_pivots);
  factor->sums = numbers(arena, LANES * (size_t)p->most_pivots);

  factor->stats.flops = p->flops;
  factor->stats.entries = (double)p->factor_size;
  return factor;
}

/* ---- factorization ---- */

/* The panel of a front: zeros, values, and what children add to its pivots. */
static void fill_panel(lam_factor *factor, const lam_front *f, const double *values) {
  const lam_plan *p = &factor->plan;
  size_t rows = lam_panel_rows(f);
  double *panel = factor->panel;
  memset(panel, 0, sizeof(double) * rows * (size_t)f->k);

  for (int q = f->piece; q < f->piece_across; q++) {
    const lam_piece *piece = &p->pieces[q];
    double *to = panel + (size_t)piece->column * rows + piece->row;
    const double *from = values + piece->value;
    for (int i = 0; i < piece->count; i++) to[i] = from[i];
  }
  for (int q = f->piece_across; q < f->piece_end; q++) {
    const lam_piece *piece = &p->pieces[q];
    double *to = panel + (size_t)piece->column * rows + piece->row;
    const double *from = values + piece->value;
    for (int i = 0; i < piece->count; i++) to[(size_t)i * rows] = from[i];
  }
  for (int c = f->child; c >= 0; c = p->fronts[c].sibling)
    factor->kernels->add_child(&p->fronts[c], p->runs, factor->updates + p->fronts[c].update, f,
                               panel, NULL, 0, p->fronts[c].entering);
}

/* What a front leaves to its parent: its own product, and the rest of its children's. */
static void make_update(lam_factor *factor, const lam_front *f) {
  const lam_plan *p = &factor->plan;
  double *update = factor->updates + f->update;
  factor->kernels->multiply(f, factor->factors + f->factor, update);
  for (int c = f->child; c >= 0; c = p->fronts[c].sibling)
    factor->kernels->add_child(&p->fronts[c], p->runs, factor->updates + p->fronts[c].update, f,
                               NULL, update, p->fronts[c].entering, p->fronts[c].m);
}

bool lam_factor_refactor(lam_factor *factor, const double *values) {
  factor->stats.factorized++;
  for (int i = 0; i < factor->plan.count; i++) {
    const lam_front *f = &factor->plan.fronts[i];
    fill_panel(factor, f, values);
    if (!factor->kernels->eliminate(f, factor->panel, factor->factors + f->factor)) return false;
    if (f->m) make_update(factor, f);
  }
  return true;
}

/* ---- solution ---- */

/* The right side of a front's pivots, padded. */
static void take_pivots(const lam_factor *factor, const lam_front *f) {
  memset(factor->pivots + f->kp - LANES, 0, sizeof(double) * LANES);
  memcpy(factor->pivots, factor->y + f->first, sizeof(double) * (size_t)f->k);
}

static void give_pivots(const lam_factor *factor, const lam_front *f) {
  memcpy(factor->y + f->first, factor->pivots, sizeof(double) * (size_t)f->k);
}

/* Where a row of a front's panel stands while it is solved: w are its updated rows. */
static double *panel_row(const lam_factor *factor, const lam_front *f, double *w, int row) {
  return row < f->kp ? factor->pivots + row : w + (row - f->kp);
}

/* Children first: what they subtracted from rows of this front is added to its right side. */
static void solve_forward(lam_factor *factor, int i) {
  const lam_plan *p = &factor->plan;
  const lam_front *f = &p->fronts[i];
  double *w = factor->w + factor->row[i];
  memset(w, 0, sizeof(double) * (size_t)f->mp);
  take_pivots(factor, f);
  for (int c = f->child; c >= 0; c = p->fronts[c].sibling)
    for (int q = p->fronts[c].run; q < p->fronts[c].run_end; q++) {
      const lam_run *run = &p->runs[q];
      const double *from = factor->w + factor->row[c] + run->from;
      double *to = panel_row(factor, f, w, run->to);
      for (int e = 0; e < run->count; e++) to[e] += from[e];
    }
  factor->kernels->forward(f, factor->factors + f->factor, factor->pivots, w);
  give_pivots(factor, f);
}

/* Parents first: w of a front was filled by its parent with the solution; its children's is filled
 * now. */
static void solve_backward(lam_factor *factor, int i) {
  const lam_plan *p = &factor->plan;
  const lam_front *f = &p->fronts[i];
  double *w = factor->w + factor->row[i];
  take_pivots(factor, f);
  factor->kernels->backward(f, factor->factors + f->factor, factor->pivots, w, factor->sums);
  give_pivots(factor, f);
  for (int c = f->child; c >= 0; c = p->fronts[c].sibling) {
    const lam_front *child = &p->fronts[c];
    double *to = factor->w + factor->row[c];
    for (int q = child->run; q < child->run_end; q++) {
      const lam_run *run = &p->runs[q];
      memcpy(to + run->from, panel_row(factor, f, w, run->to), sizeof(double) * (size_t)run->count);
    }
    memset(to + child->m, 0, sizeof(double) * (size_t)(child->mp - child->m));
  }
}

void lam_factor_solve(lam_factor *factor, const double *b, double *x) {
  const lam_plan *p = &factor->plan;
  for (int k = 0; k < p->n; k++) factor->y[k] = b[p->unknown[k]];
  for (int i = 0; i < p->count; i++) solve_forward(factor, i);
  for (int i = p->count - 1; i >= 0; i--) solve_backward(factor, i);
  for (int k = 0; k < p->n; k++) x[p->unknown[k]] = factor->y[k];
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
