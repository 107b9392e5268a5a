/* Solids of revolution about the z axis: rings and balls. They are polyhedra inside the smooth
 * body, with their corners on it; closed and oriented outward. Lengths in meters; the mesh is owned
 * by arena. */
#ifndef LAM_FAB_TURNED_H
#define LAM_FAB_TURNED_H

#include "core/arena.h"
#include "core/model.h"

enum { lam_turned_corners = 48 }; /* of every circle around the axis */

/* 0 < inner < outer, the radii; its middle lies in z = 0. thickness > 0, along the axis. */
lam_trimesh lam_ring(lam_arena *arena, double inner, double outer, double thickness);
/* radius > 0; its center is the origin. */
lam_trimesh lam_ball(lam_arena *arena, double radius);

#endif
