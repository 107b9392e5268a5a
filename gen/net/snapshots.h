/* Positions of a net on its way to the solution: the frames of an animation. */
#ifndef LAM_NET_SNAPSHOTS_H
#define LAM_NET_SNAPSHOTS_H

#include "core/arena.h"
#include "core/progress.h"
#include "solve/problem.h"

/* Keeps states evenly spread over a sequence whose length is not known before, without allocating:
 * when its places are full, it drops every other state and goes on with every other one. */
typedef struct lam_snapshots {
  int wanted, vertex_count;
  int count, capacity, stride, seen;
  lam_vec3 **states;          /* capacity + 1 places */
  double scale;               /* multiplies positions */
  const lam_problem *problem; /* being solved; NULL: progress is only passed on */
  const lam_progress *next;   /* whom progress is passed on to; may be NULL */
} lam_snapshots;

/* For `wanted` >= 1 frames; positions are multiplied by scale. Owned by arena. */
lam_snapshots lam_snapshots_new(lam_arena *arena, int wanted, int vertex_count, double scale);
void lam_snapshots_add(lam_snapshots *frames, const lam_vec3 *positions);
/* A progress that adds the vertices of frames->problem whenever it is told something, and passes it
 * on. */
lam_progress lam_snapshots_progress(lam_snapshots *frames);
/* At most `wanted` of the states, evenly spread, the first one and `last` among them; count is the
 * number. */
const lam_vec3 *const *lam_snapshots_finish(lam_arena *arena, lam_snapshots *frames,
                                            const lam_vec3 *last, int *count);

#endif
