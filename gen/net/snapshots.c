#include "net/snapshots.h"

#include <math.h>

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

/* The place for the state that is told now; NULL when it is left out. */
static lam_vec3 *next_place(lam_snapshots *frames) {
  if (frames->seen++ % frames->stride != 0) return NULL;
  if (frames->count == frames->capacity) {
    int kept = 0;
    for (int k = 0; k < frames->count;
         k += 2) { /* exchanged, so that every place stays in the list */
      lam_vec3 *swap = frames->states[kept];
      frames->states[kept++] = frames->states[k];
      frames->states[k] = swap;
    }
    frames->count = kept;
    frames->stride *= 2;
    if ((frames->seen - 1) % frames->stride != 0) return NULL;
  }
  return frames->states[frames->count++];
}

void lam_snapshots_add(lam_snapshots *frames, const lam_vec3 *positions) {
  lam_vec3 *to = next_place(frames);
  for (int v = 0; to && v < frames->vertex_count; v++)
    to[v] = lam_scale(positions[v], frames->scale);
}

static void tell(void *context, const char *stage, double fraction, const char *detail) {
  lam_snapshots *frames = context;
  lam_vec3 *to = frames->problem ? next_place(frames) : NULL;
  const double *x = to ? frames->problem->x : NULL;
  for (int v = 0; to && v < frames->vertex_count; v++)
    to[v] = lam_scale(lam_v3(x[3 * v], x[3 * v + 1], x[3 * v + 2]), frames->scale);
  lam_progress_tell(frames->next, stage, fraction, detail);
}

lam_progress lam_snapshots_progress(lam_snapshots *frames) { return (lam_progress){tell, frames}; }

const lam_vec3 *const *lam_snapshots_finish(lam_arena *arena, lam_snapshots *frames,
                                            const lam_vec3 *last, int *count) {
  lam_vec3 *end = frames->states[frames->capacity];
  for (int v = 0; v < frames->vertex_count; v++) end[v] = lam_scale(last[v], frames->scale);
  /* the last state told is the end itself as a rule */
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
