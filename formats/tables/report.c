/* report.json (listed in formats/list/formats.c): what was measured, one entry per stage. Numbers
 * have 10 significant digits, null stands for what is undefined or not known; times only when
 * asked for. */
#include "formats/format.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sets a key of a map, or (key NULL) appends to a list, and hands over the value. Whatever could
 * not be made (no memory, no UTF-8) is NULL, and *lost is true from then on. */
static void put(bool *lost, json_t *to, const char *key, json_t *value) {
  if ((key ? json_object_set_new(to, key, value) : json_array_append_new(to, value)) != 0)
    *lost = true;
}

/* A number of 10 significant digits, null when it is not finite. The caller owns it. */
static json_t *number(double value) {
  char digits[32];
  if (!isfinite(value)) return json_null();
  snprintf(digits, sizeof digits, "%.10g", value);
  return json_real(strtod(digits, NULL));
}

/* A count has one value; the caller owns the entry. */
static json_t *measure_entry(bool *lost, const lam_measure *m) {
  json_t *one = json_object();
  if (strcmp(m->unit, LAM_UNIT_COUNT) == 0) {
    put(lost, one, "value", isfinite(m->max) ? json_integer((json_int_t)m->max) : json_null());
    put(lost, one, "unit", json_string(m->unit));
    return one;
  }
  put(lost, one, "min", number(m->min));
  put(lost, one, "mean", number(m->mean));
  put(lost, one, "max", number(m->max));
  put(lost, one, "unit", json_string(m->unit));
  put(lost, one, "count", json_integer((json_int_t)m->count));
  return one;
}

/* The measures of a stage, by name. The caller owns them. */
static json_t *stage_measures(bool *lost, const lam_stage *stage) {
  json_t *measures = json_object();
  for (int i = 0; i < stage->measure_count; i++) {
    const lam_measure *m = &stage->measures[i];
    put(lost, measures, m->name, measure_entry(lost, m));
  }
  return measures;
}

/* The entry of a stage; the caller owns it. Keys that would say nothing are left out. */
static json_t *stage_entry(bool *lost, const lam_stage *stage) {
  json_t *entry = json_object();
  put(lost, entry, "stage", json_string(stage->name));
  put(lost, entry, "converged", json_boolean(stage->converged));
  if (stage->reason) put(lost, entry, "reason", json_string(stage->reason));
  if (stage->iterations >= 0) {
    put(lost, entry, "iterations", json_integer(stage->iterations));
    put(lost, entry, "residual", number(stage->residual));
  }
  put(lost, entry, "measures", stage_measures(lost, stage));

  if (stage->note_count) {
    json_t *notes = json_array();
    for (int i = 0; i < stage->note_count; i++)
      put(lost, notes, NULL, json_string(stage->notes[i]));
    put(lost, entry, "notes", notes);
  }

  if (stage->seconds > 0) put(lost, entry, "seconds", number(stage->seconds));
  return entry;
}

static int count(const lam_model *model) { return model->report != NULL; }

static void path(const lam_model *model, int i, lam_text *name) {
  (void)model, (void)i;
  lam_text_add(name, "report.json");
}

/* The whole report; the caller owns it. */
static json_t *report_of(bool *lost, const lam_model *model) {
  json_t *stages = json_array(), *root = json_object();
  for (int s = 0; s < model->report->stage_count; s++)
    put(lost, stages, NULL, stage_entry(lost, &model->report->stages[s]));

  put(lost, root, "name", json_string(model->name));
  put(lost, root, "title", json_string(model->title));
  put(lost, root, "source", json_string(model->source ? model->source : ""));
  put(lost, root, "lamella", json_string(model->version));
  put(lost, root, "stages", stages);
  return root;
}

/* jansson owns nothing of the model: texts are copied into the tree, which becomes one text.
 * LAM_FAILED for texts that are no UTF-8. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  bool lost = false;
  errno = 0;
  json_t *root = report_of(&lost, model);
  char *text = lost ? NULL : json_dumps(root, JSON_INDENT(2) | JSON_REAL_PRECISION(10));
  bool ran_out = errno == ENOMEM; /* a text may be there all the same, with gaps */
  json_decref(root);

  lam_arena_defer(out->arena, free, text); /* also when adding to out runs out of memory */
  if (ran_out) lam_arena_exhausted(out->arena);
  if (!text) return LAM_FAILED;
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
