/* Stages of a report: every step of a build opens one and adds what it measured and what it has to
 * say. Called by surf (reports of surfaces), fab (parts) and design (net, prints, sheets). */
#ifndef LAM_CORE_STAGE_H
#define LAM_CORE_STAGE_H

#include "core/arena.h"
#include "core/model.h"

/* A stage that is done and did not iterate: converged, iterations -1, no measures and no notes.
 * name is kept by pointer. */
lam_stage lam_stage_begin(const char *name);

/* Adds a measure; its name and unit are kept by pointer. The array of measures is owned by
 * arena. */
void lam_stage_measure_add(lam_arena *arena, lam_stage *stage, lam_measure measure);
/* The same for a measure whose minimum nobody asks for (it is NaN). max and mean are in unit,
 * count is the number of elements that were measured. */
void lam_stage_measure(lam_arena *arena, lam_stage *stage, const char *name, const char *unit,
                       double max, double mean, long count);

/* Adds a count (model.h): of things, such as parts or sheets that are wrong. */
void lam_stage_count(lam_arena *arena, lam_stage *stage, const char *name, double value);

/* Adds a sentence, formatted as by printf and cut off after 511 bytes. The text and the array of
 * notes are owned by arena. */
void lam_stage_note(lam_arena *arena, lam_stage *stage, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
