/* Curves on spline surfaces by the chain rule. Part of the surface kernel; called by the unit
 * tests. */
#include "surf/spline/curve_on.h"
#include "surf/spline/spline_edit.h"

/* The data of the curve's eval. */
typedef struct lam_curve_on {
  const lam_spline_surface *surface;
  const lam_spline_curve *plane;
} lam_curve_on;

/* a + f x, short for the sums below. */
static lam_vec3 add(lam_vec3 a, double f, lam_vec3 x) { return lam_along(a, f, x); }

/* The chain rule, with p = (u, v) and x[4 a + b] the derivative a times by u and b times by v:
 *   x'   = x_u u' + x_v v'
 *   x''  = x_uu u'^2 + 2 x_uv u'v' + x_vv v'^2 + x_u u'' + x_v v''
 *   x''' = x_uuu u'^3 + 3 x_uuv u'^2 v' + 3 x_uvv u' v'^2 + x_vvv v'^3
 *          + 3 (x_uu u'u'' + x_uv (u'v'' + u''v') + x_vv v'v'') + x_u u''' + x_v v'''. */
static void eval(const void *data, double t, int order, lam_vec3 *values) {
  const lam_curve_on *c = data;
  lam_vec3 p[4], x[16];
  lam_spline_curve_eval(c->plane, t, 3, p);
  lam_spline_surface_derivatives(c->surface, p[0].x, p[0].y, 3, x);

  /* In all[k] the terms with the k-th derivatives of u and v come first. */
  double u1 = p[1].x, v1 = p[1].y, u2 = p[2].x, v2 = p[2].y;
  lam_vec3 all[4];
  all[0] = x[0];
  for (int k = 1; k <= 3; k++) all[k] = add(lam_scale(x[4], p[k].x), p[k].y, x[1]);

  all[2] = add(add(add(all[2], u1 * u1, x[8]), 2 * u1 * v1, x[5]), v1 * v1, x[2]);

  all[3] =
      add(add(add(all[3], 3 * u1 * u2, x[8]), 3 * (u1 * v2 + u2 * v1), x[5]), 3 * v1 * v2, x[2]);
  all[3] = add(add(all[3], u1 * u1 * u1, x[12]), 3 * u1 * u1 * v1, x[9]);
  all[3] = add(add(all[3], 3 * u1 * v1 * v1, x[6]), v1 * v1 * v1, x[3]);

  for (int k = 0; k <= order; k++) values[k] = all[k];
}

/* The parameters and breaks are those of the plane curve; only its eval is replaced. */
lam_curve lam_curve_on_surface(lam_arena *arena, const lam_spline_surface *surface,
                               const lam_spline_curve *plane) {
  lam_curve_on *data = LAM_NEW(arena, lam_curve_on, 1);
  *data = (lam_curve_on){surface, plane};
  lam_curve curve = lam_curve_of_spline(arena, plane);
  curve.eval = eval;
  curve.data = data;
  return curve;
}
