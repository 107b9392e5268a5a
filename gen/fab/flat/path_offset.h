/* Polygons grown or shrunk by a distance, corners kept sharp: how fab/flat/sheet.c applies the
 * kerf. */
#ifndef LAM_FAB_FLAT_PATH_OFFSET_H
#define LAM_FAB_FLAT_PATH_OFFSET_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Moves the sides of a simple polygon (either orientation) outward by distance, inward when it is
 * negative; meters, exact to a nanometer. result has room for LAM_OFFSET_ROOM(count) points and
 * becomes counterclockwise. *result_count is 0 unless the status is LAM_OK.
 *
 *   LAM_BAD_INPUT  moving back would not give the polygon again: a slot closed up or a part of it
 *                  vanished
 *   LAM_NO_MEMORY, LAM_FAILED  of the library */
lam_status lam_offset_polygon(const lam_vec2 *points, int count, double distance, lam_vec2 *result,
                              int *result_count);

/* Room for the result: a corner sharper than 29 degrees is cut off and becomes two. */
#define LAM_OFFSET_ROOM(count) (2 * (count) + 8)

#ifdef __cplusplus
}
#endif

#endif
