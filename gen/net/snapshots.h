/* Positions of a net on its way to the solution: the frames of an animation. Used by
 * net/optimize.c for the key `animate`. */
#ifndef LAM_NET_SNAPSHOTS_H
#define LAM_NET_SNAPSHOTS_H

#include "core/arena.h"
#include "core/progress.h"
#include "solve/problem.h"

/* Keeps states evenly spread over a sequence whose length is not known before, without
 * allocating: when it is full, it drops every other state and from then on keeps half as many of
 * those that come. */
typedef struct lam_snapshots {
  int wanted, vertex_count;
  int count, capacity;        /* states kept; most states that fit */
  int stride, seen;           /* every stride-th of the states seen is kept */
  lam_vec3 **states;          /* capacity + 1 arrays; the last one is for the end */
  double scale;               /* multiplies positions */
  const lam_problem *problem; /* being solved; NULL: progress is only passed on */
  const lam_progress *next;   /* whom progress is passed on to; may be NULL */
} lam_snapshots;

/* For `wanted` >= 1 frames of vertex_count positions each, which are multiplied by scale.
 * Owned by arena. */
lam_snapshots lam_snapshots_new(lam_arena *arena, int wanted, int vertex_count, double scale);
/* Shows a state: it is copied, or left out. positions: vertex_count, before the scale. */
void lam_snapshots_add(lam_snapshots *frames, const lam_vec3 *positions);
/* A progress that shows the vertices of frames->problem whenever it is told something, and passes
 * the message on to frames->next. It points to frames. */
lam_progress lam_snapshots_progress(lam_snapshots *frames);
/* At most `wanted` of the states kept, evenly spread, the first one and `last` (vertex_count,
 * before the scale) among them; with one wanted, `last` alone. count: out, their number. Owned by
 * arena and by that of lam_snapshots_new. */
const lam_vec3 *const *lam_snapshots_finish(lam_arena *arena, lam_snapshots *frames,
                                            const lam_vec3 *last, int *count);

#endif
