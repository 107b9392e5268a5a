/* Stages of a report: every step of the pipeline opens one and adds what it measured and what it
 * has to say. */
#ifndef LAM_CORE_STAGE_H
#define LAM_CORE_STAGE_H

#include "core/arena.h"
#include "core/model.h"

/* A stage that is done and did not iterate. name is kept by pointer. */
lam_stage lam_stage_begin(const char *name);
/* Adds a measure; its name and unit are kept by pointer. */
void lam_stage_measure_add(lam_arena *arena, lam_stage *stage, lam_measure measure);
/* The same for a measure whose minimum nobody asks for. */
void lam_stage_measure(lam_arena *arena, lam_stage *stage, const char *name, const char *unit,
                       double max, double mean, long count);
/* Adds a sentence. */
void lam_stage_note(lam_arena *arena, lam_stage *stage, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
