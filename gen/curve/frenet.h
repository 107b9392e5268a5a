/* The Frenet frame and the curvature vector of a space curve. */
#ifndef LAM_CURVE_FRENET_H
#define LAM_CURVE_FRENET_H

#include "core/vec3.h"

typedef struct lam_frenet {
  lam_vec3 tangent;
  lam_vec3 normal, binormal; /* unit; both zero where the curvature is 0 */
  double speed;              /* |x'| */
  double curvature;          /* 1/m, >= 0; NaN where the speed is 0 */
  double torsion;            /* 1/m, > 0 for a right-handed curve; NaN where the curvature is 0 */
} lam_frenet;

/* The curvature vector x'' - (x''.t) t over |x'|^2, t = x' / |x'|, from first = x' and second =
 * x'': points to the center of curvature, length = curvature, 1/m. Not a number where x' is 0. */
lam_vec3 lam_curvature_vector(lam_vec3 first, lam_vec3 second);

/* The frame from x', x'', x''' by any parameter (derivatives[0 .. 2]):
 *   curvature = |x' x x''| / |x'|^3,  torsion = (x' x x'') . x''' / |x' x x''|^2. */
lam_frenet lam_frenet_frame(const lam_vec3 derivatives[3]);

#endif
