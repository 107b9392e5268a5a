/* Stages of a report. Called by surf, fab and design. */
#include "core/stage.h"
#include "core/grow.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

lam_stage lam_stage_begin(const char *name) {
  return (lam_stage){.name = name, .converged = true, .reason = "done", .iterations = -1};
}

/* The model's stages keep no capacity. They have few measures and notes: the array is copied for
 * each. */
void lam_stage_measure_add(lam_arena *arena, lam_stage *stage, lam_measure measure) {
  int capacity = stage->measure_count;
  LAM_APPEND(arena, stage->measures, stage->measure_count, capacity, measure);
}

void lam_stage_measure(lam_arena *arena, lam_stage *stage, const char *name, const char *unit,
                       double max, double mean, long count) {
  lam_stage_measure_add(arena, stage, (lam_measure){name, unit, NAN, max, mean, count});
}

void lam_stage_count(lam_arena *arena, lam_stage *stage, const char *name, double value) {
  lam_stage_measure_add(arena, stage, (lam_measure){name, LAM_UNIT_COUNT, value, value, value, 1});
}

/* Copied into the arena after formatting: as long as the sentence, not as the buffer. */
void lam_stage_note(lam_arena *arena, lam_stage *stage, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);

  int capacity = stage->note_count;
  LAM_APPEND(arena, stage->notes, stage->note_count, capacity, lam_arena_copy(arena, text));
}
