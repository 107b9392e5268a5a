/* The stages that make parts and nest them on sheets; lines of the net stand in for axes of parts.
 * Called by pipeline_run.c. */
#include "design/stages.h"
#include "fab/flat/lettering.h"
#include "fab/flat/sheet.h"
#include "fab/lamella/lamella_checks.h"
#include "fab/part_names.h"

#include <math.h>
#include <string.h>

/* What a row that failed has added to the workshop goes: half of a row is not to be made. Its stage
 * stays, with what was measured until then; one is opened when there is none. */
static bool fail_row(const lam_build *build, lam_workshop *workshop, const lam_workshop *before,
                     const char *kind, lam_error *last) {
  workshop->part_count = before->part_count;
  workshop->crossing_count = before->crossing_count;
  workshop->record_kind_count = before->record_kind_count;
  workshop->surface_count = before->surface_count;
  workshop->curve_count = before->curve_count;
  workshop->lamella_grid = before->lamella_grid;

  lam_stage *stage = workshop->stage_count > before->stage_count
                         ? &workshop->stages[workshop->stage_count - 1]
                         : lam_workshop_stage(workshop, kind);
  return lam_build_stage_fail(build, stage, last);
}

/* Makes row i of the parts. */
static bool make_row(const lam_build *build, lam_workshop *workshop, int i) {
  const lam_list *parts = &build->design->parts;
  const lam_row *row = (const lam_row *)parts->items + i;
  const lam_part_kind *kind = (const lam_part_kind *)row->head;
  lam_error *last = build->errors->last;
  lam_workshop before = *workshop;
  lam_progress_tell(build->progress, kind->head.name, (double)i / parts->count, "");

  kind->make(workshop, row->params, row->location);
  const char *twice = lam_part_name_twice(workshop);
  if (twice)
    lam_error_add(build->errors, row->location, "kind", "%s is the name of two parts", twice);
  if (build->errors->last == last) return true;
  lam_errors_prefix(build->errors, last, lam_arena_printf(build->arena, "parts[%d]", i));
  return fail_row(build, workshop, &before, kind->head.name, last);
}

/* The rows of parts in the order of the design: later ones may read what earlier ones made. One
 * that does not go together with the net fails, and the others are made. */
bool lam_build_parts(lam_build *build, lam_workshop *workshop) {
  const lam_list *parts = &build->design->parts;
  if (parts->count && !build->net) {
    lam_error_add(build->errors, ((const lam_row *)parts->items)->location, "parts",
                  "there is no net to make parts from");
    return false;
  }

  for (int i = 0; i < parts->count; i++)
    if (!make_row(build, workshop, i)) return false;

  int before = build->errors->count;
  if (workshop->part_count) lam_workshop_clash(workshop);
  lam_build_check_written(workshop);
  return build->errors->count == before;
}

/* The number of sheets in the report, and the used share of the emptiest, a mean and the fullest
 * one. */
static void report_sheets(const lam_build *build, lam_stage *stage, const lam_sheets *sheets) {
  double used = 0, least = INFINITY, most = 0;
  for (int i = 0; i < sheets->count; i++) {
    used += sheets->sheets[i].used / sheets->count;
    least = fmin(least, sheets->sheets[i].used);
    most = fmax(most, sheets->sheets[i].used);
  }

  int count = sheets->count;
  lam_stage_count(build->arena, stage, "sheet_count", count);
  if (count)
    lam_stage_measure_add(build->arena, stage,
                          (lam_measure){"sheet_used", "", least, most, used, count});
}

/* A word on every sheet, on the layer of its edge, when parts overlap: they do not go together as
 * they are drawn. It stands in the upper margin, as far as that is wide enough for letters. */
static void warn_of_clashes(const lam_build *build, const lam_workshop *workshop,
                            lam_sheets *sheets) {
  static const char text[] = "DO NOT CUT: PARTS OVERLAP - SEE REPORT";
  bool clash = false;
  for (int i = 0; i < workshop->stage_count; i++)
    clash |= strcmp(workshop->stages[i].name, "clash") == 0 && !workshop->stages[i].converged;

  double margin = build->design->sheets.margin, height = fmax(3e-3, .6 * margin);
  for (int i = 0; clash && i < sheets->count; i++) {
    lam_sheet *sheet = &sheets->sheets[i];
    lam_paths paths = {.arena = build->arena};
    lam_lettering_add(&paths, LAM_LAYER_SHEET, text,
                      lam_v2(margin, sheet->height - .2 * margin - height), 0, height);
    sheet->warning_count = paths.count;
    sheet->warnings = paths.items;
  }
}

/* Nothing to do when no part has a flat pattern. */
bool lam_build_sheets(lam_build *build, const lam_workshop *workshop) {
  const lam_sheet_keys *keys = &build->design->sheets;
  bool any = false;
  for (int i = 0; i < workshop->part_count; i++) any |= workshop->parts[i].flat != NULL;
  if (!any) return true;

  lam_error *last = build->errors->last;
  lam_stage *stage = lam_build_stage(build, "sheets");
  lam_sheet_options options = {
      {keys->stock[0], keys->stock[1]}, keys->kerf, keys->margin, keys->spacing};
  lam_sheets sheets = lam_sheets_make(build->arena, workshop->parts, workshop->part_count, options,
                                      (lam_location){.file = build->design->path}, build->errors);
  bool sound = build->errors->last == last || lam_build_stage_fail(build, stage, last);
  if (sheets.unplaced)
    lam_stage_note(build->arena, stage, "%d pieces lie on no sheet", sheets.unplaced);

  warn_of_clashes(build, workshop, &sheets);

  build->model->sheet_count = sheets.count;
  build->model->sheets = sheets.sheets;
  report_sheets(build, stage, &sheets);
  lam_build_stage_end(build, stage);
  return sound;
}

/* Lines are named as lamellas would be: A01, A02, ... of family 0, B01, ... of family 1. */
void lam_build_keep_lines(const lam_build *build, lam_workshop *workshop) {
  int numbers[2] = {0};
  if (!build->net || !build->design->net.head || workshop->curve_count) return;

  for (int i = 0; i < build->net->polyline_count; i++) {
    const lam_polyline *line = &build->net->polylines[i];
    lam_workshop_curve(
        workshop,
        lam_arena_printf(build->arena, "%c%02d", 'A' + line->family, ++numbers[line->family]),
        line);
  }
}
