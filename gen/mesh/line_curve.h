/* Smooth curves along the polylines of a net, which fab/workshop.c adds to the model for CAD
 * programs. */
#ifndef LAM_MESH_LINE_CURVE_H
#define LAM_MESH_LINE_CURVE_H

#include "core/arena.h"
#include "core/model.h"

/* The C2 cubic spline through the vertices of a polyline, with parameters from 0 to 1 proportional
 * to the lengths of its edges; a closed one comes back to its first vertex, C2 there too (to
 * 1e-12). With fewer than four vertices: the polynomial through them. Vertices that coincide with
 * the one before are passed once; count is 0 when there are no two different positions.
 *
 * positions  per vertex of the net
 *
 * Knots and points are owned by arena. */
lam_spline_curve lam_polyline_curve(lam_arena *arena, const lam_vec3 *positions,
                                    const lam_polyline *line);
/* The arc length of that curve at every vertex of the line, in meters, from 0 at the first; of a
 * closed line once more for the way back to it. To 1e-10; owned by arena. */
double *lam_polyline_lengths(lam_arena *arena, const lam_vec3 *positions, const lam_polyline *line);

#endif
