/* The local geometry of lamellas at one vertex of the net: where sheets beside the polylines
 * pass, and where they cross. Called by lamella_grid.c. */
#ifndef LAM_FAB_LAMELLA_LAMELLA_PATCH_H
#define LAM_FAB_LAMELLA_LAMELLA_PATCH_H

#include "fab/lamella/lamella_make.h"

/* The surface around a vertex to second order, in skew coordinates along its two polylines:
 *   q(A,B) = x + A t0 + B t1 + (h00 A^2 + 2 h01 A B + h11 B^2)/2 N
 *   m(A,B) = unit(N + A N0' + B N1')
 *   h_ij = -(<Ni',tj> + <Nj',ti>)/2
 * t are unit and perpendicular to N; Ni' is the derivative of the normals along polyline i, from
 * differences. */
typedef struct lam_patch {
  lam_vec3 x, n, t[2], dn[2];
  double angle;        /* between the polylines, in [0, pi] */
  double sine, cosine; /* of the angle from t0 to t1, signed about n */
} lam_patch;

/* line: a polyline per family through vertex v, or NULL (not both); index: of v in it; normals:
 * unit, one per vertex of the net. Where a line is missing or nearly parallel to the other, its
 * tangent is taken perpendicular to that of `family`. */
lam_patch lam_patch_make(const lam_net *net, const lam_vec3 *normals, int v,
                         const lam_polyline *const line[2], const int index[2], int family);

/* The station where a sheet of the family at the signed distance own (meters) from its polyline
 * passes the vertex: at the foot of the perpendicular to the sheet. Distances are along b = N x
 * t. partner and crossing are -1. */
lam_station lam_patch_station(const lam_patch *patch, int family, double own);

/* The station where it crosses the sheet of the other family at the signed distance other: both
 * sheets get the same point and the same m. angle, slot_low, slot_high and slot_angle are set for
 * the scissor angle (lam_slot_sweep); partner and crossing are -1. */
lam_station lam_patch_crossing(const lam_patch *patch, int family, double own, double other,
                               double scissor);

#endif
