/* The order of lines on a sheet: marks are made while the sheet lies still as a whole, and a piece
 * is cut free only when nothing is left to be done inside it. Called by dxf.c and svg.c. */
#include "formats/sheets/sheet_order.h"

#include "core/flat_shape.h"

#include <math.h>
#include <stdlib.h>

/* A line with what it is sorted by. */
typedef struct entry {
  lam_sheet_line line;
  double piece_area, area; /* m^2; the line's own one only for holes */
  int place;               /* where it stands in the model */
} entry;

static int by_number(double a, double b) { return (a > b) - (a < b); }

/* Step, size of the piece, piece, size of the hole; equal ones as in the model. */
static int compare(const void *one, const void *other) {
  const entry *a = one, *b = other;
  if (a->line.step != b->line.step) return (int)a->line.step - (int)b->line.step;
  int order = by_number(a->piece_area, b->piece_area);
  if (!order) order = a->line.piece - b->line.piece;
  if (!order) order = by_number(a->area, b->area);
  return order ? order : a->place - b->place;
}

static lam_sheet_step step_of(const lam_path *path) {
  if (path->layer == LAM_LAYER_ENGRAVE) return LAM_STEP_ENGRAVE;
  if (path->layer == LAM_LAYER_LABEL) return LAM_STEP_LABEL;
  return path->hole || !path->closed ? LAM_STEP_HOLE : LAM_STEP_OUTLINE;
}

/* How much of the sheet the outlines of a piece take. */
static double outline_area(const lam_sheet_piece *piece) {
  double area = 0;
  for (int i = 0; i < piece->path_count; i++) {
    const lam_path *path = &piece->paths[i];
    if (step_of(path) == LAM_STEP_OUTLINE) area += fabs(lam_path_area(path));
  }
  return area;
}

int lam_sheet_order(lam_arena *arena, const lam_sheet *sheet, lam_sheet_line **lines) {
  int most = 0, count = 0;
  for (int p = 0; p < sheet->piece_count; p++) most += sheet->placed[p].path_count;
  entry *entries = LAM_NEW(arena, entry, most);

  for (int p = 0; p < sheet->piece_count; p++) {
    const lam_sheet_piece *piece = &sheet->placed[p];
    double area = outline_area(piece);
    for (int i = 0; i < piece->path_count; i++) {
      const lam_path *path = &piece->paths[i];
      lam_sheet_step step = step_of(path);
      if (i && path->joined) {
        entries[count - 1].line.count++;
        continue;
      }
      entries[count] = (entry){{step, p, i, 1}, area, 0, count};
      if (step == LAM_STEP_HOLE) entries[count].area = fabs(lam_path_area(path));
      count++;
    }
  }

  if (count) qsort(entries, (size_t)count, sizeof *entries, compare);
  *lines = LAM_NEW(arena, lam_sheet_line, count);
  for (int i = 0; i < count; i++) (*lines)[i] = entries[i].line;
  return count;
}
