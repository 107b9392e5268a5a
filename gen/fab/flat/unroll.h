/* Developing a strip into the plane: the flat middle line of a strip that stands on a polyline
 * along given directions. Used by fab/lamella for flat patterns and for measures of straightness.
 *
 * In all functions points and m have n >= 2 entries, m are unit vectors (the height direction at
 * every point), and flat receives n points: the first at the origin, travel towards +x, m
 * upwards. Meters. No memory is kept. */
#ifndef LAM_FAB_FLAT_UNROLL_H
#define LAM_FAB_FLAT_UNROLL_H

#include "core/model.h"

/* The strip of planes: through every edge the plane spanned by the edge and the mean of m at its
 * ends; neighboring planes meet in a ruling through the common point. Such a strip is developable,
 * and this is its exact development (thesis 3.2.4). */
void lam_unroll(const lam_vec3 *points, const lam_vec3 *m, int n, lam_vec2 *flat);
/* Only the angles between the edges and m at every point: the polyline turns by pi - (angle
 * back) - (angle ahead). On a net with planar stars and their normals as m this is exactly
 * straight. Not called by the program: the tests hold it against lam_unroll
 * (tests/unit/fab/test_unroll.c). */
void lam_unroll_angles(const lam_vec3 *points, const lam_vec3 *m, int n, lam_vec2 *flat);
/* The strip between points -+ height/2 m, every quad split along the diagonal from lower start to
 * upper end: its triangles laid side by side; flat are the middles of the sections. */
void lam_unroll_triangles(const lam_vec3 *points, const lam_vec3 *m, double height, int n,
                          lam_vec2 *flat);

/* The largest distance of flat points from the chord of the first and the last, divided by the
 * length of the flat line; 0 when the line has no length. */
double lam_straightness(const lam_vec2 *flat, int n);

#endif
