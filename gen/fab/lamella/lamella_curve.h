/* The smooth curve on which a sheet stands, through its places on the net: the one source of
 * lengths along a lamella. lamella_grid.c takes from it the arc length, the developed heading and
 * the stations between nodes; solids, OpenSCAD records, flat patterns, tables and the bill of
 * materials follow from these. Meters and radians. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_CURVE_H
#define LAM_FAB_LAMELLA_LAMELLA_CURVE_H

#include "core/arena.h"
#include "fab/lamella/lamella.h"

/* Through count places x, with unit height directions m, in order; s, tangent, bend and turn have
 * one entry per place. Everything is owned by the arena it was made in. */
typedef struct lam_strip_curve {
  int count;
  lam_vec3 *x, *m;
  double *s;         /* arc length from x[0] */
  lam_vec3 *tangent; /* unit */
  lam_vec3 *bend;    /* curvature vector, 1/m */
  lam_vec3 *turn;    /* derivative of m, 1/m */
  double *flat;      /* curvature of the developed curve, 1/m; positive towards m */
  double *heading;   /* direction of the developed curve, from 0 at x[0] */
} lam_strip_curve;

/* x and m are copied. Precondition: count >= 1, and no place coincides with the next.
 *
 * The curve has a piece of degree five between neighboring places, with the tangents and the
 * curvatures of the polynomial through five places (fewer on short lines, three at kinks), by arc
 * length; lengths are exact to fourth order in the spacing. It develops to the plane curve with
 * the normal curvatures of the net as curvatures, linear in between. These are taken from the
 * spheres that touch the net at a place and pass through the places before and after it: exact on
 * spheres and on nets with planar or spherical stars. */
lam_strip_curve lam_strip_curve_make(lam_arena *arena, int count, const lam_vec3 *x,
                                     const lam_vec3 *m);

/* The station at the arc length s, in [0, length]: x, t, m and heading are those of the curve, s as
 * given; it has no crossing, and vertex is -1. */
lam_station lam_strip_curve_station(const lam_strip_curve *curve, double s);

/* How many equal steps from a to b (0 <= a < b <= length, between two neighboring places) keep the
 * chords of both edges, height/2 off the curve, within `sag` of them; at least 1. */
int lam_strip_curve_steps(const lam_strip_curve *curve, double a, double b, double height,
                          double sag);

#endif
