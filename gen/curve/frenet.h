/* The Frenet frame of a space curve. */
#ifndef LAM_CURVE_FRENET_H
#define LAM_CURVE_FRENET_H

#include "core/vec3.h"

typedef struct lam_frenet {
  lam_vec3 tangent, normal,
      binormal;     /* unit; normal and binormal are zero where the curvature is 0 */
  double speed;     /* |x'| */
  double curvature; /* 1/m, >= 0; NaN where the speed is 0 */
  double torsion;   /* 1/m, > 0 for a right-handed curve; NaN where the curvature is 0 */
} lam_frenet;

/* From x' , x'' , x''' by any parameter (derivatives[0 .. 2]):
 *   curvature = |x' x x''| / |x'|^3,  torsion = (x' x x'') . x''' / |x' x x''|^2. */
lam_frenet lam_frenet_frame(const lam_vec3 derivatives[3]);

#endif
