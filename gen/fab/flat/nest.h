/* Placing rectangles on sheets: shelves, best fit, tallest first. Strips of equal height fill
 * their shelf end to end, and small rectangles fill what is left at the ends and above shorter
 * neighbors. Called by fab/flat/sheet.c. */
#ifndef LAM_FAB_FLAT_NEST_H
#define LAM_FAB_FLAT_NEST_H

#include "core/arena.h"

typedef struct lam_nest_item {
  double width, height; /* given: at most those of the sheet */
  int sheet;            /* found, from 0 */
  double x, y;          /* found: the lower left corner */
} lam_nest_item;

/* Places count items on sheets of width x height without overlap and without turning them.
 * Fills in sheet, x and y of every item; their order is kept. Precondition: every item fits an
 * empty sheet. Returns the number of sheets. arena is only used for scratch. */
int lam_nest(lam_arena *arena, lam_nest_item *items, int count, double width, double height);

#endif
