/* Turning a piece so that it fits a sheet. Called by fab/flat/sheet.c. */
#ifndef LAM_FAB_FLAT_TURN_H
#define LAM_FAB_FLAT_TURN_H

#include "fab/flat/path.h"

/* Finds how a piece fits into a rectangle: as it lies, turned by a quarter, or turned to the box of
 * least area that fits.
 *
 *   paths  count of them, all of the piece
 *   room   width and height of the rectangle, meters
 *   turn   out: a rotation about the origin
 *
 * False, with *turn as the piece lies, when it fits in no such way. arena is only used for
 * scratch. */
bool lam_turn_to_fit(lam_arena *arena, const lam_path *paths, int count, const double room[2],
                     lam_motion *turn);

#endif
