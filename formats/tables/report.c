/* report.json (listed in formats/list/formats.c): what was measured, one entry per stage. Numbers
 * have 10 significant digits, null stands for what is undefined or not known; times only when
 * asked for. */
#include "formats/format.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A number of 10 significant digits, null when it is not finite. The caller owns it. */
static json_t *number(double value) {
  char digits[32];
  if (!isfinite(value)) return json_null();
  snprintf(digits, sizeof digits, "%.10g", value);
  return json_real(strtod(digits, NULL));
}

/* A count has one value; the caller owns the entry. */
static json_t *measure_entry(const lam_measure *m) {
  if (strcmp(m->unit, LAM_UNIT_COUNT) == 0)
    return json_pack("{s:o, s:s}", "value",
                     isfinite(m->max) ? json_integer((json_int_t)m->max) : json_null(), "unit",
                     m->unit);
  return json_pack("{s:o, s:o, s:o, s:s, s:I}", "min", number(m->min), "mean", number(m->mean),
                   "max", number(m->max), "unit", m->unit, "count", (json_int_t)m->count);
}

/* The measures of a stage, by name. The caller owns them. */
static json_t *stage_measures(const lam_stage *stage) {
  json_t *measures = json_object();
  for (int i = 0; i < stage->measure_count; i++) {
    const lam_measure *m = &stage->measures[i];
    json_object_set_new(measures, m->name, measure_entry(m));
  }
  return measures;
}

/* The entry of a stage; the caller owns it. Keys that would say nothing are left out. */
static json_t *stage_entry(const lam_stage *stage) {
  json_t *entry = json_object();
  json_object_set_new(entry, "stage", json_string(stage->name));
  json_object_set_new(entry, "converged", json_boolean(stage->converged));
  json_object_set_new(entry, "reason", json_string(stage->reason));
  if (stage->iterations >= 0) {
    json_object_set_new(entry, "iterations", json_integer(stage->iterations));
    json_object_set_new(entry, "residual", number(stage->residual));
  }
  json_object_set_new(entry, "measures", stage_measures(stage));

  if (stage->note_count) {
    json_t *notes = json_array();
    for (int i = 0; i < stage->note_count; i++)
      json_array_append_new(notes, json_string(stage->notes[i]));
    json_object_set_new(entry, "notes", notes);
  }

  if (stage->seconds > 0) json_object_set_new(entry, "seconds", number(stage->seconds));
  return entry;
}

static int count(const lam_model *model) { return model->report != NULL; }

static void path(const lam_model *model, int i, lam_text *name) {
  (void)model, (void)i;
  lam_text_add(name, "report.json");
}

/* jansson owns nothing of the model: texts are copied into the tree, which becomes one text. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  json_t *stages = json_array();
  for (int s = 0; s < model->report->stage_count; s++)
    json_array_append_new(stages, stage_entry(&model->report->stages[s]));

  json_t *root =
      json_pack("{s:s, s:s, s:s, s:s, s:o}", "name", model->name, "title", model->title, "source",
                model->source ? model->source : "", "lamella", model->version, "stages", stages);
  char *text = root ? json_dumps(root, JSON_INDENT(2) | JSON_REAL_PRECISION(10)) : NULL;
  json_decref(root);

  if (!text) return LAM_FAILED;
  lam_arena_defer(out->arena, free, text); /* also when adding to out runs out of memory */
  lam_text_add(out, text);
  lam_text_add(out, "\n");
  return LAM_OK;
}

const lam_format lam_format_report = {
    .name = "report",
    .doc = "report.json: convergence and independent measures of every stage.",
    .count = count,
    .path = path,
    .write = write,
    .last = true};
