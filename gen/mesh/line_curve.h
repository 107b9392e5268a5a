/* Smooth curves along the polylines of a net. */
#ifndef LAM_MESH_LINE_CURVE_H
#define LAM_MESH_LINE_CURVE_H

#include "core/arena.h"
#include "core/model.h"

/* The C2 cubic spline through the vertices of a polyline, with parameters from 0 to 1 like the
 * distances of the vertices; a closed one comes back to its first vertex, C2 there too (to 1e-12).
 * With fewer than four vertices: the polynomial through them. count is 0 when there are no two
 * different places. positions: per vertex of the net. The knots and points are owned by the arena.
 */
lam_spline_curve lam_polyline_curve(lam_arena *arena, const lam_vec3 *positions,
                                    const lam_polyline *line);

#endif
