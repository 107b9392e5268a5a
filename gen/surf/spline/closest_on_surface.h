/* The point of a spline surface nearest to a given point. Called by spline_near.c and
 * surf/area/nearest.c. */
#ifndef LAM_SURF_SPLINE_CLOSEST_ON_SURFACE_H
#define LAM_SURF_SPLINE_CLOSEST_ON_SURFACE_H

#include "core/arena.h"
#include "core/model.h"

/* A point of the surface, its parameters and its distance. */
typedef struct lam_closest_on_surface {
  double u, v, distance; /* m */
  lam_vec3 point;
} lam_closest_on_surface;

/* The nearest of all points: Bezier patches are halved, down to a thirty-second of their size,
 * as long as the box of their control points is nearer than the best point so far, and Newton's
 * method finishes. Of several nearest points one is returned. The arena is released to where it
 * was. Part of the surface kernel; called by the unit tests. */
lam_closest_on_surface lam_spline_surface_closest(lam_arena *arena,
                                                  const lam_spline_surface *surface,
                                                  lam_vec3 point);

/* The nearest point around the parameters in from, by Newton's method inside the domain: much
 * faster, for a start that is near. Allocates nothing. */
lam_closest_on_surface lam_spline_surface_closest_from(const lam_spline_surface *surface,
                                                       lam_vec3 point, lam_vec2 from);

#endif
