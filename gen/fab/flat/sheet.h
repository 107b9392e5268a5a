/* Flat parts on sheets of stock: split where they are too long, widened by the kerf, nested.
 * Called by design/parts_stage.c. */
#ifndef LAM_FAB_FLAT_SHEET_H
#define LAM_FAB_FLAT_SHEET_H

#include "core/error.h"
#include "core/model.h"

/* The keys of `sheets` in a design, in meters. */
typedef struct lam_sheet_options {
  double stock[2]; /* width and height of a sheet */
  double kerf;     /* width of the cut; 0: the outlines are drawn at their true size */
  double margin;   /* kept free along the sheet's edges */
  double spacing;  /* least distance between parts */
} lam_sheet_options;

/* In the order of materials and thicknesses; owned by the arena they were made in. */
typedef struct lam_sheets {
  int count;
  lam_sheet *sheets;
  int unplaced; /* pieces that lie on no sheet */
} lam_sheets;

/* Lays every instance of every part with a flat pattern on sheets, grouped by material and
 * thickness in the order of the parts, and the splice plates with them.
 *
 *   - Parts longer than the stock are split (fab/flat/splice.h).
 *   - Outlines are moved outward and holes inward by half the kerf.
 *   - Parts lie along the longer side of the stock; one that fits only when turned is turned.
 *   - Sheets are named sheet-01, sheet-02 ...
 *
 * Adds a message for every part that does not fit (location: of the stock in the design), and lays
 * the others. Everything is owned by arena. */
lam_sheets lam_sheets_make(lam_arena *arena, const lam_part *parts, int part_count,
                           lam_sheet_options options, lam_location location, lam_errors *errors);

#endif
