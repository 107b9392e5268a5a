/* Smooth curves along the lines of a net: the curves that fab/workshop.c adds to the model. */
#include "mesh/line_curve.h"
#include "curve/interpolate.h"
#include "curve/length.h"

/* The conditions at the ends of an interpolating cubic change it n points further in by a factor of
 * about (2 - sqrt 3)^n, 1e-14 for n = 24. A closed curve is therefore cut out of an open one that
 * runs on around for so many points at both ends. */
enum { far_enough = 24 };

/* The vertices of the line, without repetitions of the one before; a closed line ends with its
 * first vertex. points: room for count + 1. Returns their number. */
static int different_points(const lam_vec3 *positions, const lam_polyline *line, lam_vec3 *points) {
  int n = 0;
  for (int i = 0; i < line->count + line->closed; i++) {
    lam_vec3 p = positions[line->vertices[i % line->count]];
    if (n == 0 || lam_distance(p, points[n - 1]) > 0) points[n++] = p;
  }
  return n;
}

/* The closed cubic through x[0 .. around - 1] and back to x[0]. */
static lam_spline_curve closed_curve(lam_arena *arena, const lam_vec3 *x, int around) {
  int total = around + 2 * far_enough + 1;
  lam_vec3 *longer = LAM_NEW(arena, lam_vec3, total);
  for (int i = 0; i < total; i++) /* x[(i - far_enough) mod around], kept positive */
    longer[i] = x[(i + far_enough * (around - 1)) % around];

  /* parameters by chord length, moved so that one time around goes from 0 to 1 */
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

/* A closed line with fewer than three different vertices is drawn as an open one. */
lam_spline_curve lam_polyline_curve(lam_arena *arena, const lam_vec3 *positions,
                                    const lam_polyline *line) {
  lam_vec3 *x = LAM_NEW(arena, lam_vec3, line->count + 1);
  int n = different_points(positions, line, x);
  if (n < 2) return (lam_spline_curve){0};
  if (line->closed && n >= 4) return closed_curve(arena, x, n - 1);
  return lam_interpolate_points(arena, LAM_ENDS_NOT_A_KNOT, 3, LAM_PARAMETERS_CHORD, n, x);
}

/* Parameters go by the lengths of edges; the length is summed from vertex to vertex. */
double *lam_polyline_lengths(lam_arena *arena, const lam_vec3 *positions,
                             const lam_polyline *line) {
  int count = line->count + line->closed;
  double *length = LAM_NEW(arena, double, count), *t = LAM_NEW(arena, double, count);
  for (int k = 1; k < count; k++)
    t[k] = t[k - 1] + lam_distance(positions[line->vertices[k - 1]],
                                   positions[line->vertices[k % line->count]]);
  if (!(t[count - 1] > 0)) return length;

  lam_spline_curve spline = lam_polyline_curve(arena, positions, line);
  lam_curve curve = lam_curve_of_spline(arena, &spline);
  for (int k = 1; k < count; k++)
    length[k] = length[k - 1] + lam_curve_length(&curve, t[k - 1] / t[count - 1],
                                                 fmin(1, t[k] / t[count - 1]), 1e-10);
  return length;
}
