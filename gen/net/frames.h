/* Positions of a net on its way to the solution: the frames of an animation. */
#ifndef LAM_NET_FRAMES_H
#define LAM_NET_FRAMES_H

#include "core/arena.h"
#include "core/progress.h"
#include "solve/problem.h"

/* Keeps states evenly spread over a sequence whose length is not known before, without allocating: when its places are
 * full, it drops every other state and goes on with every other one. */
typedef struct lam_frames {
  int wanted, vertex_count;
  int count, capacity, stride, seen;
  lam_vec3 **states;          /* capacity + 1 places */
  double scale;               /* multiplies positions */
  const lam_problem *problem; /* being solved; NULL: progress is only passed on */
  const lam_progress *next;   /* whom progress is passed on to; may be NULL */
} lam_frames;

/* For `wanted` >= 1 frames; positions are multiplied by scale. Owned by arena. */
lam_frames lam_frames_new(lam_arena *arena, int wanted, int vertex_count, double scale);
void lam_frames_add(lam_frames *frames, const lam_vec3 *positions);
/* A progress that adds the vertices of frames->problem whenever it is told something, and passes it on. */
lam_progress lam_frames_progress(lam_frames *frames);
/* At most `wanted` of the states, evenly spread, the first one and `last` among them; count is the number. */
const lam_vec3 *const *lam_frames_finish(lam_arena *arena, lam_frames *frames, const lam_vec3 *last, int *count);

#endif
