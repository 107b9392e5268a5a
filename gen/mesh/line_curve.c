#include "mesh/line_curve.h"
#include "curve/interpolate.h"

/* What the ends of an interpolating cubic are like changes it n points further in by a factor of
 * about (2 - sqrt 3)^n: a closed curve is cut out of one that goes on around for so many points at
 * both ends. */
enum { far_enough = 24 };

lam_spline_curve lam_polyline_curve(lam_arena *arena, const lam_vec3 *positions,
                                    const lam_polyline *line) {
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, line->count + 1);
  int n = 0;
  for (int i = 0; i < line->count + line->closed; i++) {
    lam_vec3 p = positions[line->vertices[i % line->count]];
    if (n == 0 || lam_distance(p, x[n - 1]) > 0) x[n++] = p;
  }
  if (n < 2) return (lam_spline_curve){0};
  if (!line->closed || n < 4)
    return lam_interpolate_points(arena, LAM_ENDS_NOT_A_KNOT, 3, LAM_PARAMETERS_CHORD, n, x);
  int around = n - 1, total = around + 2 * far_enough + 1;
  lam_vec3 *longer = LAM_NEW(arena, lam_vec3, total);
  for (int i = 0; i < total; i++) longer[i] = x[(i + far_enough * (around - 1)) % around];
  double *t = LAM_NEW(arena, double, total);
  lam_parameters_choose(LAM_PARAMETERS_CHORD, total, longer, t);
  double start = t[far_enough], length = t[far_enough + around] - start;
  for (int i = 0; i < total; i++) t[i] = (t[i] - start) / length;
  t[far_enough] = 0, t[far_enough + around] = 1;
  lam_bspline values =
      lam_spline_curve_net(arena, &(lam_spline_curve){.count = total, .points = longer}, false);
  lam_bspline all =
      lam_interpolate(arena, LAM_ENDS_NOT_A_KNOT, 3, total, t, 3, values.values, NULL);
  return lam_spline_curve_part(arena, lam_spline_curve_from_net(arena, all), 0, 1);
}
