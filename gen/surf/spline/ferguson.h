/* Bicubic patches over [0,1]^2 in their two forms, geometric (Ferguson, Hermite) and Bezier.
 * Part of the surface kernel; no stage of a design calls it, the unit tests do. */
#ifndef LAM_SURF_SPLINE_FERGUSON_H
#define LAM_SURF_SPLINE_FERGUSON_H

#include "core/vec3.h"

/* [i][j] is at u = i, v = j: points, derivatives by u, by v and by both (twists; zero in
 * Ferguson's own patch). */
typedef struct lam_ferguson {
  lam_vec3 x[2][2], u[2][2], v[2][2], uv[2][2];
} lam_ferguson;

/* The Bezier points b[4 i + j] of the patch, i along u. Exact. */
void lam_ferguson_to_bezier(const lam_ferguson *patch, lam_vec3 b[16]);

/* The patch of the Bezier points b[4 i + j]. Exact. */
lam_ferguson lam_ferguson_from_bezier(const lam_vec3 b[16]);

#endif
