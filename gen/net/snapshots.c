/* Snapshots of a net on its way to the solution. Called by net/optimize.c; the solver's progress
 * adds to them too. */
#include "net/snapshots.h"

#include <math.h>

/* Room for four times what is wanted: thinning out leaves twice as many states, from which an
 * even choice can be made. */
lam_snapshots lam_snapshots_new(lam_arena *arena, int wanted, int vertex_count, double scale) {
  lam_snapshots frames = {.wanted = wanted,
                          .vertex_count = vertex_count,
                          .capacity = 4 * wanted,
                          .stride = 1,
                          .states = LAM_NEW(arena, lam_vec3 *, 4 * wanted + 1),
                          .scale = scale};
  for (int k = 0; k <= frames.capacity; k++)
    frames.states[k] = LAM_NEW(arena, lam_vec3, vertex_count);
  return frames;
}

/* Keeps every other state and doubles the stride. States are exchanged, not overwritten, so that
 * every array stays in the list and is used again. */
static void thin_out(lam_snapshots *frames) {
  int kept = 0;
  for (int k = 0; k < frames->count; k += 2) {
    lam_vec3 *swap = frames->states[kept];
    frames->states[kept++] = frames->states[k];
    frames->states[k] = swap;
  }
  frames->count = kept;
  frames->stride *= 2;
}

/* Where the state that is seen now is to be written, vertex_count positions; NULL when it is left
 * out: only every stride-th one is kept. */
static lam_vec3 *next_state(lam_snapshots *frames) {
  if (frames->seen++ % frames->stride != 0) return NULL;
  if (frames->count == frames->capacity) {
    thin_out(frames);
    if ((frames->seen - 1) % frames->stride != 0) return NULL;
  }
  return frames->states[frames->count++];
}

void lam_snapshots_add(lam_snapshots *frames, const lam_vec3 *positions) {
  lam_vec3 *to = next_state(frames);
  for (int v = 0; to && v < frames->vertex_count; v++)
    to[v] = lam_scale(positions[v], frames->scale);
}

/* A lam_progress: keeps the vertices of the problem that is being solved, and passes the message
 * on. context: the lam_snapshots. */
static void tell(void *context, const char *stage, double fraction, const char *detail) {
  lam_snapshots *frames = context;
  lam_vec3 *to = frames->problem ? next_state(frames) : NULL;
  const double *x = to ? frames->problem->x : NULL;
  for (int v = 0; to && v < frames->vertex_count; v++)
    to[v] = lam_scale(lam_v3(x[3 * v], x[3 * v + 1], x[3 * v + 2]), frames->scale);
  lam_progress_tell(frames->next, stage, fraction, detail);
}

lam_progress lam_snapshots_progress(lam_snapshots *frames) { return (lam_progress){tell, frames}; }

/* Chooses evenly among the states kept and the end. */
const lam_vec3 *const *lam_snapshots_finish(lam_arena *arena, lam_snapshots *frames,
                                            const lam_vec3 *last, int *count) {
  lam_vec3 *end = frames->states[frames->capacity]; /* never one of those kept */
  for (int v = 0; v < frames->vertex_count; v++) end[v] = lam_scale(last[v], frames->scale);

  /* As a rule the last state kept is the end itself: it counts once. */
  bool same = frames->count > 0;
  for (int v = 0; same && v < frames->vertex_count; v++)
    same = lam_distance(frames->states[frames->count - 1][v], end[v]) == 0;
  int states = frames->count + !same;

  *count = states < frames->wanted ? states : frames->wanted;
  const lam_vec3 **chosen = LAM_NEW(arena, const lam_vec3 *, *count);
  for (int k = 0; k < *count; k++) {
    int state = *count > 1 ? (int)lround((double)k * (states - 1) / (*count - 1)) : states - 1;
    chosen[k] = state == frames->count ? end : frames->states[state];
  }
  return chosen;
}
