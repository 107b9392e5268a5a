/* Stages of a build: each is named, timed and told to whoever watches. Called by all stages. */
#include "design/stages.h"

#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

lam_stage *lam_build_stage(lam_build *p, const char *name) {
  lam_progress_tell(p->progress, name, 0, "");
  p->since = now();
  lam_stage *stage = &p->stages[p->stage_count++];
  *stage = lam_stage_begin(name);
  return stage;
}

void lam_build_stage_end(const lam_build *p, lam_stage *stage) {
  stage->seconds = now() - p->since;
}
