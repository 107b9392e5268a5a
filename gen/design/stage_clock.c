/* Stages of a build: each is named, timed and told to whoever watches, and may fail. Called by all
 * files *_stage.c. */
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

/* A message as one text: its place where it has a line, its key, its words. */
static const char *message_text(lam_arena *arena, const lam_error *error) {
  const char *text = error->text;
  if (error->key) text = lam_arena_printf(arena, "%s: %s", error->key, text);
  if (error->location.line > 0)
    text = lam_arena_printf(arena, "%s (line %d)", text, error->location.line);
  return text;
}

bool lam_build_stage_fail(const lam_build *build, lam_stage *stage, lam_error *last) {
  if (build->errors->status != LAM_OK) return false;
  const lam_error *error = lam_errors_take(build->errors, last);
  stage->converged = false;
  stage->reason = message_text(build->arena, error);
  for (error = error->next; error; error = error->next)
    lam_stage_note(build->arena, stage, "%s", message_text(build->arena, error));
  return true;
}
