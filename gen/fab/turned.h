/* Solids around the z axis: rings and balls, and any other whose horizontal sections are stars
 * about it. Closed and oriented outward. Lengths in meters; meshes are owned by arena. Used by
 * fab/parts (circles, gauss-image) and by fab/lamella/node_connector.c. */
#ifndef LAM_FAB_TURNED_H
#define LAM_FAB_TURNED_H

#include "core/arena.h"
#include "core/model.h"

enum { lam_turned_corners = 48 }; /* of every circle of a ring or a ball */

/* 0 < inner < outer, the radii; its middle lies in z = 0. thickness > 0, along the axis. It lies
 * inside the smooth ring, with its corners on it. */
lam_trimesh lam_ring(lam_arena *arena, double inner, double outer, double thickness);
/* radius > 0; its center is the origin. It lies inside the smooth ball, with its corners on it. */
lam_trimesh lam_ball(lam_arena *arena, double radius);

/* One closed line around the axis, at height z: corner k is radius[k] away from it. */
typedef struct lam_turned_line {
  double z;
  const double *radius;
} lam_turned_line;

/* The solid between consecutive lines around the z axis.
 *
 * angle   n directions, increasing over one turn, shared by all lines
 * lines   count of them. The section (radius, z) runs counterclockwise, seen with the radius to the
 *         right and z up
 * poles   heights of two points on the axis that close the solid below the first line and above the
 *         last; NULL: the last line is joined to the first (a solid with a hole) */
lam_trimesh lam_turned_solid(lam_arena *arena, const double *angle, int n,
                             const lam_turned_line *lines, int count, const double *poles);

#endif
