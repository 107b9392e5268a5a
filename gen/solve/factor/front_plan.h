/* What a factorization needs to know about its pattern: made once, before any values. Used by
 * solve/factor.c. */
#ifndef LAM_SOLVE_FACTOR_FRONT_PLAN_H
#define LAM_SOLVE_FACTOR_FRONT_PLAN_H

#include "solve/factor/elimination.h"
#include "solve/factor/front.h"

typedef struct lam_plan {
  int n;
  int *unknown; /* n: the unknown eliminated k-th, fronts in a row */
  lam_front *fronts;
  int count; /* children before parents */
  lam_run *runs;
  lam_piece *pieces;
  size_t factor_size; /* numbers of all factors */
  size_t update_size; /* numbers of the update matrices that live at the same time */
  size_t panel_size;  /* numbers of the largest panel */
  int most_pivots;    /* padded, of one front */
  double flops;       /* of one factorization, with the zeros that merging brings in */
} lam_plan;

/* The plan belongs to the arena; the pattern is not needed any more. scratch is left with what was
 * needed on the way. Running out of memory jumps to the recovery point of either. */
lam_plan lam_plan_make(lam_arena *arena, lam_arena *scratch, const lam_pattern *pattern);

#endif
