/* Bicubic patches in their two forms: geometric (Ferguson, Hermite) and Bezier; over [0,1]^2. */
#ifndef LAM_SURF_SPLINE_FERGUSON_H
#define LAM_SURF_SPLINE_FERGUSON_H

#include "core/vec3.h"

/* [i][j] is at u = i, v = j: points, derivatives by u, by v and by both (twists; zero in Ferguson's
 * own patch). */
typedef struct lam_ferguson {
  lam_vec3 x[2][2], u[2][2], v[2][2], uv[2][2];
} lam_ferguson;

/* The Bezier points b[4 i + j] of the patch, and back. Exact. */
void lam_ferguson_to_bezier(const lam_ferguson *patch, lam_vec3 b[16]);
lam_ferguson lam_ferguson_from_bezier(const lam_vec3 b[16]);

#endif
