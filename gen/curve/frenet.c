/* Differential geometry of space curves at a point. The curvature vector is used by
 * curve/curve_fairness.c and curve/curve_join.c; the frame is part of the curve kernel and called
 * by its users only (tests/unit/curve/test_curve_geometry.c). */
#include "curve/frenet.h"
#include <float.h>

lam_vec3 lam_curvature_vector(lam_vec3 first, lam_vec3 second) {
  double square = lam_dot(first, first);
  return lam_scale(lam_along(second, -lam_dot(second, first) / square, first), 1 / square);
}

/* Where x' x x'' is zero to rounding, the curve is straight and has no normal. */
lam_frenet lam_frenet_frame(const lam_vec3 derivatives[3]) {
  lam_vec3 turn = lam_cross(derivatives[0], derivatives[1]);
  double speed = lam_length(derivatives[0]), size = lam_length(turn);
  lam_frenet f = {
      .tangent = lam_unit(derivatives[0]), .speed = speed, .curvature = NAN, .torsion = NAN};
  if (!(speed > 0)) return f;

  f.curvature = size / (speed * speed * speed);
  if (!(size > 4 * DBL_EPSILON * speed * lam_length(derivatives[1]))) return f;
  f.torsion = lam_dot(turn, derivatives[2]) / (size * size);
  f.binormal = lam_scale(turn, 1 / size);
  f.normal = lam_cross(f.binormal, f.tangent);
  return f;
}
