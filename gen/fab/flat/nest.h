/* Placing rectangles on sheets: shelves, best fit, tallest first. Strips of equal height fill their
 * shelf end to end, and small rectangles fill what is left at the ends and above shorter neighbors.
 */
#ifndef LAM_FAB_FLAT_NEST_H
#define LAM_FAB_FLAT_NEST_H

#include "core/arena.h"

typedef struct lam_nest_item {
  double width, height; /* given: at most those of the sheet */
  int sheet;            /* found, from 0 */
  double x, y;          /* found: the lower left corner */
} lam_nest_item;

/* Places all items on sheets of width x height without overlap. Returns the number of sheets. The
 * order of items is kept. */
int lam_nest(lam_arena *arena, lam_nest_item *items, int count, double width, double height);

#endif
