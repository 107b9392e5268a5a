/* The stages that make parts and nest them on sheets. Lines of the net stand in for axes of parts. */
#include "design/stages.h"
#include "fab/flat/sheet.h"
#include "fab/lamella/lamella_checks.h"

#include <math.h>

/* ---- parts and sheets ---- */

bool lam_build_parts(lam_build *p, lam_workshop *workshop) {
  const lam_list *parts = &p->design->parts;
  int before = p->errors->count;
  if (parts->count && !p->net) {
    lam_error_add(p->errors, ((const lam_row *)parts->items)->location, "parts",
                  "there is no net to make parts from");
    return false;
  }
  for (int i = 0; i < parts->count; i++) {
    const lam_row *row = (const lam_row *)parts->items + i;
    const lam_part_kind *kind = (const lam_part_kind *)row->head;
    lam_progress_tell(p->progress, kind->head.name, (double)i / parts->count, "");
    kind->make(workshop, row->params, row->location);
    if (p->errors->count > before) return false;
  }
  if (parts->count) lam_workshop_clash(workshop);
  return p->errors->count == before;
}

bool lam_build_sheets(lam_build *p, const lam_workshop *workshop) {
  const lam_sheet_keys *keys = &p->design->sheets;
  bool any = false;
  for (int i = 0; i < workshop->part_count; i++) any |= workshop->parts[i].flat != NULL;
  if (!any) return true;
  int before = p->errors->count;
  lam_stage *stage = lam_build_stage(p, "sheets");
  lam_sheet_options options = {
      {keys->stock[0], keys->stock[1]}, keys->kerf, keys->margin, keys->spacing};
  lam_sheets sheets = lam_sheets_make(p->arena, workshop->parts, workshop->part_count, options,
                                      (lam_location){.file = p->design->path}, p->errors);
  if (p->errors->count > before) return false;
  p->model->sheet_count = sheets.count;
  p->model->sheets = sheets.sheets;
  double used = 0, least = 1;
  for (int i = 0; i < sheets.count; i++) {
    used += sheets.sheets[i].used / sheets.count;
    least = fmin(least, sheets.sheets[i].used);
  }
  lam_stage_measure(p->arena, stage, "sheet_count", "", sheets.count, sheets.count, sheets.count);
  lam_stage_measure(p->arena, stage, "sheet_used", "", 1 - least, used, sheets.count);
  lam_build_stage_end(p, stage);
  return true;
}

/* The lines of the net as curves, where no part has given axes. They are named as lamellas would
 * be. */
void lam_build_keep_lines(const lam_build *p, lam_workshop *workshop) {
  int numbers[2] = {0};
  if (!p->net || !p->design->net.head || workshop->curve_count) return;
  for (int i = 0; i < p->net->polyline_count; i++) {
    const lam_polyline *line = &p->net->polylines[i];
    lam_workshop_curve(
        workshop, lam_arena_printf(p->arena, "%c%02d", 'A' + line->family, ++numbers[line->family]),
        line);
  }
}
