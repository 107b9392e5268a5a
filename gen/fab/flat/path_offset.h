/* Polygons grown or shrunk by a distance, corners kept sharp: how fab/flat/sheet.c applies the
 * kerf. */
#ifndef LAM_FAB_FLAT_PATH_OFFSET_H
#define LAM_FAB_FLAT_PATH_OFFSET_H

#include "core/arena.h"
#include "core/model.h"

/* Moves the sides of a simple polygon (either orientation) outward by distance, inward when it is
 * negative; meters. result has room for LAM_OFFSET_ROOM(count) points and becomes counterclockwise.
 * arena: scratch, which is given back. False, with *result_count 0: moving back would not give the
 * polygon again, as a slot closed up or a part of it vanished. */
bool lam_offset_polygon(lam_arena *arena, const lam_vec2 *points, int count, double distance,
                        lam_vec2 *result, int *result_count);

/* Room for the result: a corner sharper than 29 degrees is cut off and becomes two. */
#define LAM_OFFSET_ROOM(count) (2 * (count) + 8)

#endif
