/* Handles: vertices and whole sides of a net that have to come to given places. */
#ifndef LAM_NET_HANDLES_H
#define LAM_NET_HANDLES_H

#include "net/net_kind.h"

extern const lam_key lam_handle_keys[]; /* of lam_handle */

/* Adds what only shows when the keys of a handle are taken together: neither or both of `to` and
 * `by`, a number of coordinates that makes no points, ... */
void lam_handles_check(const lam_net_common *common, lam_location location, lam_errors *errors);

/* Handles on single vertices {index, -1} with targets in meters, one per vertex of a side.
 * positions: the start, in meters. Vertices that are not there and sides that the net does not have
 * are added to errors. Owned by arena. */
lam_list lam_handles_resolve(lam_arena *arena, const lam_net_common *common, const lam_net *net,
                             const lam_vec3 *positions, lam_location location, lam_errors *errors);

#endif
