/* Polygons grown or shrunk by a distance, corners kept sharp. */
#ifndef LAM_FAB_OFFSET_H
#define LAM_FAB_OFFSET_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Moves the sides of a simple polygon (either orientation) outward by distance, inward when it is negative; exact to a
 * nanometre. *result is counterclockwise and freed with free(). LAM_BAD_INPUT when moving back would not
 * give the polygon again: a slot closed up or a part of it vanished; LAM_NO_MEMORY, LAM_FAILED; *result is then NULL.
 */
lam_status lam_offset_polygon(const lam_vec2 *points, int count, double distance, lam_vec2 **result, int *result_count);

#ifdef __cplusplus
}
#endif

#endif
