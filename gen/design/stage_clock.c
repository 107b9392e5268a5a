/* Stages of a build: each is named, timed and told to whoever watches. Called by all files
 * *_stage.c. */
#include "core/clock.h"
#include "design/stages.h"

/* The room for stages is in lam_build itself: a stage stays where it is. */
lam_stage *lam_build_stage(lam_build *build, const char *name) {
  lam_progress_tell(build->progress, name, 0, "");
  build->since = lam_clock_seconds();
  lam_stage *stage = &build->stages[build->stage_count++];
  *stage = lam_stage_begin(name);
  return stage;
}

void lam_build_stage_end(const lam_build *build, lam_stage *stage) {
  stage->seconds = lam_clock_seconds() - build->since;
}
