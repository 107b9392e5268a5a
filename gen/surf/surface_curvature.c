/* Fundamental forms and curvatures of a jet (do Carmo, Differential Geometry of Curves and
 * Surfaces, 3-2 and 3-3), for whoever evaluates a surface: net/trace, net/measures, fab, the
 * files of surf.
 *
 *   E = <x_u,x_u>,  F = <x_u,x_v>,  G = <x_v,x_v>,  L = <x_uu,n>,  M = <x_uv,n>,  N = <x_vv,n>.
 * The curvatures come from the second form in the orthonormal basis e1 = x_u/|x_u|,
 * e2 = n x e1:
 *   x_u = |x_u| e1,  x_v = f e1 + g e2  with f = F/|x_u|, g = |x_u x x_v|/|x_u|,
 *   a = II(e1,e1),  b = II(e1,e2),  c = II(e2,e2),
 *   H = (a + c)/2,  K = a c - b^2,  k = H +- hypot((a - c)/2, b),
 * and this k does not cancel near umbilics as sqrt(H^2 - K) does. */
#include "surf/surface.h"
#include <float.h>

/* Singular, to rounding: |x_u x x_v| is no more than an epsilon of |x_u| |x_v|. */
lam_curvature lam_jet_curvature(const lam_jet *jet) {
  lam_curvature result = {
      .E = lam_dot(jet->u, jet->u), .F = lam_dot(jet->u, jet->v), .G = lam_dot(jet->v, jet->v)};

  lam_vec3 cross = lam_cross(jet->u, jet->v);
  double area = lam_length(cross), length = sqrt(result.E);
  if (!(area > DBL_EPSILON * length * sqrt(result.G))) {
    result.K = result.H = result.k1 = result.k2 = NAN;
    return result;
  }

  result.normal = lam_scale(cross, 1 / area);
  result.L = lam_dot(jet->uu, result.normal);
  result.M = lam_dot(jet->uv, result.normal);
  result.N = lam_dot(jet->vv, result.normal);

  /* The second form in the orthonormal basis. */
  double f = result.F / length, g = area / length;
  double a = result.L / result.E;
  double b = (result.M / length - f * a) / g;
  double c = (result.N - f * (f * a + 2 * g * b)) / (g * g);
  double spread = hypot((a - c) / 2, b);

  result.K = a * c - b * b;
  result.H = (a + c) / 2;
  result.k1 = result.H + spread;
  result.k2 = result.H - spread;
  return result;
}
