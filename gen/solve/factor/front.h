/* One dense front of the factorization: how its numbers lie in memory, and the operations on them,
 * once per instruction set. Used by front_plan.c, the kernels and solve/factor.c.
 *
 * A front eliminates k unknowns (pivots) and updates m more, which belong to fronts above it. Both
 * are padded with zeros to multiples of LANES. Three arrays:
 *
 *   panel   column-major, k columns of kp + mp rows: the matrix before elimination
 *   factor  row blocks of BLOCK rows (the last one shorter): first the pivots', block b with the
 *           columns up to its own diagonal, then the updated ones with all k columns. In a block of
 *           height h, entry (row r, column c) is at c h + r: products read both operands in a row.
 *           The diagonal holds reciprocals.
 *   update  what goes to the parent: columns in blocks of BLOCK, block b column-major from its
 *           first row on, mp - BLOCK b rows
 *
 * Every entry is one chain of operations, in an order that pattern and order of elimination alone
 * determine: value, what children add, products by ascending column with fused multiply-add. So the
 * same bits come out with every instruction set and every number of threads. */
#ifndef LAM_SOLVE_FACTOR_FRONT_H
#define LAM_SOLVE_FACTOR_FRONT_H

#include <stdbool.h>
#include <stddef.h>

enum {
  LANES = 8,  /* numbers of the longest vector */
  BLOCK = 24, /* rows of a block */
  GROUP = 6   /* columns that are eliminated at once */
};

/* Rows of a child's update matrix, and where they go in its parent's panel. Those that land in the
 * parent's pivots come first; rows of padding have no run. */
typedef struct lam_run {
  int from, to, count;
} lam_run;

/* Values of the matrix that follow each other in a column of it, and where they go in the panel:
 * down a column from the row, or along a row from the column. */
typedef struct lam_piece {
  int value, row, column, count;
} lam_piece;

typedef struct lam_front {
  int k, m;           /* pivots, updated */
  int kp, mp;         /* padded */
  int first;          /* pivots are the unknowns first .. first + k - 1 in order of elimination */
  int parent;         /* -1: none */
  int child, sibling; /* first child, next child of the same parent; -1: none */
  int run, run_end;   /* into lam_plan.runs: this front's rows in its parent */
  int entering;       /* leading update rows that land in the parent's pivots */
  int piece, piece_across, piece_end; /* into lam_plan.pieces: down columns, then along rows */
  size_t factor, update;              /* where they begin in the arrays of all fronts */
} lam_front;

/* ---- layout ---- */

static inline int lam_blocks(int rows) { return (rows + BLOCK - 1) / BLOCK; }

/* Rows of block b of an array with so many rows. */
static inline int lam_block_height(int rows, int b) {
  int left = rows - BLOCK * b;
  return left < BLOCK ? left : BLOCK;
}

/* Rows of the panel. */
static inline size_t lam_panel_rows(const lam_front *f) { return (size_t)(f->kp + f->mp); }

/* Where block b of the pivots begins in the factor. */
static inline size_t lam_pivot_block(int b) {
  return (size_t)(BLOCK * BLOCK / 2) * (size_t)b * (size_t)(b + 1);
}

/* Numbers of all blocks of pivots: where the updated rows begin. */
static inline size_t lam_pivots_size(const lam_front *f) {
  int b = lam_blocks(f->kp) - 1;
  return lam_pivot_block(b) + (size_t)(f->kp - BLOCK * b) * (size_t)f->k;
}

static inline size_t lam_factor_size(const lam_front *f) {
  return lam_pivots_size(f) + (size_t)f->mp * (size_t)f->k;
}

/* Where block b of columns begins in the update matrix. */
static inline size_t lam_update_block(const lam_front *f, int b) {
  return (size_t)BLOCK * (size_t)b * (size_t)f->mp -
         (size_t)(BLOCK * BLOCK / 2) * ((size_t)b * (size_t)b - (size_t)b);
}

static inline size_t lam_update_size(const lam_front *f) {
  if (f->m == 0) return 0;
  int b = lam_blocks(f->mp) - 1;
  return lam_update_block(f, b) + (size_t)(f->m - BLOCK * b) * (size_t)(f->mp - BLOCK * b);
}

/* ---- kernels ---- */

/* All arrays are those of one front, from their beginnings. */
typedef struct lam_front_kernels {
  const char *name;
  /* Eliminates: the factor from the panel, both padded. False: not positive definite. */
  bool (*eliminate)(const lam_front *f, const double *panel, double *factor);
  /* The update matrix without what children add: minus the product of the updated rows of the
   * factor with themselves. */
  void (*multiply)(const lam_front *f, const double *factor, double *update);
  /* Adds the columns begin .. end - 1 of a child's update matrix, to the panel as far as they enter
   * pivots, to the update matrix beyond. The one that no column goes to may be NULL. */
  void (*add_child)(const lam_front *child, const lam_run *runs, const double *child_update,
                    const lam_front *f, double *panel, double *update, int begin, int end);
  /* y: kp numbers, the right side of the pivots, which becomes their solution of the lower
   * triangle; w: mp numbers, from which its effect is subtracted. */
  void (*forward)(const lam_front *f, const double *factor, double *y, double *w);
  /* y: kp numbers from forward, which become the solution; w: mp numbers, the solution of the
   * updated rows; sums: LANES k numbers of room. */
  void (*backward)(const lam_front *f, const double *factor, double *y, const double *w,
                   double *sums);
} lam_front_kernels;

/* The best for this processor. All are bitwise the same. */
const lam_front_kernels *lam_front_kernels_choose(void);
/* By name ("avx512", "avx2", "neon", "plain"); NULL: not on this processor. */
const lam_front_kernels *lam_front_kernels_named(const char *name);
/* For tests: chooses these from now on, in all threads; NULL: the best again. */
void lam_front_kernels_force(const lam_front_kernels *kernels);

#endif
