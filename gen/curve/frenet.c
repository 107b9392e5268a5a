#include "curve/frenet.h"
#include <float.h>

lam_frenet lam_frenet_frame(const lam_vec3 derivatives[3]) {
  lam_vec3 turn = lam_cross(derivatives[0], derivatives[1]);
  double speed = lam_length(derivatives[0]), size = lam_length(turn);
  lam_frenet f = {
      .tangent = lam_unit(derivatives[0]), .speed = speed, .curvature = NAN, .torsion = NAN};
  if (!(speed > 0)) return f;
  f.curvature = size / (speed * speed * speed);
  if (!(size > 4 * DBL_EPSILON * speed * lam_length(derivatives[1])))
    return f; /* straight here, to rounding */
  f.torsion = lam_dot(turn, derivatives[2]) / (size * size);
  f.binormal = lam_scale(turn, 1 / size);
  f.normal = lam_cross(f.binormal, f.tangent);
  return f;
}
