/* Spline surfaces through a grid of points, by interpolation in one direction and then in the
 * other. Called by surf/kinds/interpolation.c; its parameters by approximation.c, too. */
#include "surf/spline/spline_through.h"
#include "surf/spline/spline_edit.h"

/* The parameters of one direction: the mean of those of all polylines that run in it, but for
 * polylines of length 0. NULL when they do not increase. */
static const double *mean_parameters(lam_arena *arena, lam_parameters kind, const int count[2],
                                     const lam_vec3 *points, int direction) {
  int along = count[direction], across = count[1 - direction], rows = 0;
  double *mean = LAM_NEW(arena, double, along), *t = LAM_NEW(arena, double, along);
  lam_vec3 *row = LAM_NEW(arena, lam_vec3, along);

  for (int j = 0; j < across; j++) {
    double length = 0;
    for (int i = 0; i < along; i++) {
      row[i] = points[direction ? j * count[1] + i : i * count[1] + j];
      if (i > 0) length += lam_distance(row[i], row[i - 1]);
    }

    if (!(length > 0)) continue;
    lam_parameters_choose(kind, along, row, t);
    for (int i = 0; i < along; i++) mean[i] += t[i];
    rows++;
  }

  for (int i = 0; i < along; i++) mean[i] = i == along - 1 ? 1 : mean[i] / rows;
  for (int i = 1; i < along; i++)
    if (!(mean[i] > mean[i - 1])) return NULL;
  return mean;
}

/* See mean_parameters. */
void lam_grid_parameters(lam_arena *arena, lam_parameters kind, const int count[2],
                         const lam_vec3 *points, const double *t[2]) {
  for (int d = 0; d < 2; d++) t[d] = mean_parameters(arena, kind, count, points, d);
}

/* Piegl & Tiller, The NURBS Book, 9.2.5: all rows at once, as one spline of high dimension. */
lam_spline_surface lam_surface_through(lam_arena *arena, lam_ends ends, const int degree[2],
                                       const int count[2], const double *const t[2],
                                       const lam_vec3 *points) {
  lam_spline_surface s = {.count = {count[0], count[1]}, .points = points};
  for (int d = 0; d < 2; d++) {
    lam_bspline rows = lam_spline_surface_net(arena, &s, d);
    s = lam_spline_surface_from_net(
        arena, &s, d,
        lam_interpolate(arena, ends, degree[d], count[d], t[d], rows.dimension, rows.values, NULL));
  }
  return s;
}

/* The local interpolation is linear in the points, so doing it in one direction and then in the
 * other gives the tensor product: twists are Bessel's tangents of Bessel's tangents. */
lam_spline_surface lam_surface_through_local(lam_arena *arena, const int count[2],
                                             const double *const t[2], const lam_vec3 *points) {
  lam_spline_surface s = {.degree = {3, 3}, .count = {count[0], count[1]}, .points = points};
  for (int d = 0; d < 2; d++) {
    int along = s.count[d], across = s.count[1 - d];
    lam_vec3 *row = LAM_NEW(arena, lam_vec3, along),
             *net = LAM_NEW(arena, lam_vec3, 2 * along * across);

    /* Every point becomes two control points. */
    for (int j = 0; j < across; j++) {
      for (int i = 0; i < along; i++) row[i] = s.points[d ? j * along + i : i * across + j];
      lam_spline_curve curve = lam_interpolate_local(arena, along, t[d], row, NULL);
      for (int i = 0; i < 2 * along; i++)
        net[d ? j * 2 * along + i : i * across + j] = curve.points[i];
      s.knots[d] = curve.knots;
    }

    s.count[d] = 2 * along;
    s.points = net;
  }
  return s;
}
