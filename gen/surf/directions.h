/* Directions on a surface: principal and asymptotic ones, and the Darboux frame of a curve that
 * lies on it. Part of the surface kernel; no stage of a design calls it, the unit tests do. */
#ifndef LAM_SURF_DIRECTIONS_H
#define LAM_SURF_DIRECTIONS_H

#include "surf/surface.h"

/* Tangent vectors are given twice: as unit vectors in space and as (du, dv) with
 * x_u du + x_v dv = the vector. */
typedef struct lam_directions {
  /* Of k1 and of k2, at right angles: principal[1] = normal x principal[0]. */
  lam_vec3 principal[2];
  lam_vec2 principal_uv[2];
  /* 2 where K < 0; 1 at a parabolic point (both entries are filled); 0 where K > 0 or flat. */
  int asymptotic_count;
  lam_vec3 asymptotic[2]; /* at the angles +-atan sqrt(-k1/k2) from principal[0] */
  lam_vec2 asymptotic_uv[2];
} lam_directions;

/* The directions at a point. All zero where the surface is singular. At an umbilic the
 * principal directions are those of x_u and its normal. */
lam_directions lam_jet_directions(const lam_jet *jet);

/* A curve (u(t), v(t)) on a surface: with t the unit tangent, n the surface's normal and
 * s = n x t,
 *   t' = geodesic s + normal n,  s' = -geodesic t + torsion n,  n' = -normal t - torsion s
 * where ' is the derivative by arc length. */
typedef struct lam_darboux {
  lam_vec3 tangent, side, normal;
  double normal_curvature, geodesic_curvature, geodesic_torsion; /* 1/m */
} lam_darboux;

/* The frame and the curvatures of a curve at the point of the jet, with first = (u', v') and
 * second = (u'', v'') by any parameter. Curvatures are NaN where the surface or the curve is
 * singular. */
lam_darboux lam_jet_darboux(const lam_jet *jet, lam_vec2 first, lam_vec2 second);

#endif
