/* Handles: vertices and whole sides of a net that have to come to given positions. Used by
 * design/parse.c for what a design says, and by net/optimize.c. */
#ifndef LAM_NET_HANDLES_H
#define LAM_NET_HANDLES_H

#include "net/net_kind.h"

extern const lam_key lam_handle_keys[]; /* of lam_handle */

/* Adds to errors what only shows when the keys of a handle are taken together: neither or
 * both of `to` and `by`, a number of coordinates that makes no points, ... location: of the
 * net in the design. */
void lam_handles_check(const lam_net_common *common, lam_location location, lam_errors *errors);

/* The handles with the places that they name (at, to) about an origin, meters: copies, owned by
 * arena. */
lam_list lam_handles_moved(lam_arena *arena, lam_list handles, lam_vec3 origin);

/* Handles on single vertices {index, -1} with targets in meters, one per vertex of a side: a list
 * of lam_handle, owned by arena.
 *
 *   common     handles that lam_handles_check finds nothing wrong with, or plain ones (vertex, to)
 *   positions  the start, vertex_count, meters
 *   errors     vertices that are not there or lie on a fixed boundary, sides that the net does not
 *              have: the list must not be used then */
lam_list lam_handles_resolve(lam_arena *arena, const lam_net_common *common, const lam_net *net,
                             const lam_vec3 *positions, lam_location location, lam_errors *errors);

#endif
