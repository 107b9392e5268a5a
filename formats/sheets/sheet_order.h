/* In which order the lines of a sheet stand in its file: that in which a machine should make them.
 * Called by dxf.c and svg.c. */
#ifndef LAM_FORMATS_SHEETS_SHEET_ORDER_H
#define LAM_FORMATS_SHEETS_SHEET_ORDER_H

#include "core/arena.h"
#include "core/model.h"

/* What is done to a sheet, in this order. */
typedef enum lam_sheet_step {
  LAM_STEP_ENGRAVE,
  LAM_STEP_LABEL,
  LAM_STEP_HOLE,    /* cuts inside outlines, and open ones */
  LAM_STEP_OUTLINE, /* the piece is loose afterwards */
} lam_sheet_step;

/* An object of the drawing: paths[first .. first + count - 1] of a piece; more than one are the
 * strokes of a word. */
typedef struct lam_sheet_line {
  lam_sheet_step step;
  int piece, first, count;
} lam_sheet_line;

/* All objects of a sheet: marks before cuts, holes before outlines, small pieces before large ones,
 * and small holes of a piece before large ones. Returns how many there are; *lines is in arena. */
int lam_sheet_order(lam_arena *arena, const lam_sheet *sheet, lam_sheet_line **lines);

#endif
