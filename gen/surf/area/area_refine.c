/* Exact refinement of spline surfaces for coarse-to-fine solving. Called by area_solve.c and,
 * for Bezier patches, by area_paper.c and hybrid.c. */
#include "surf/area/least_area.h"

/* Spans are cut into 2, 4, 8 ... equal parts, so that the knots of a coarser refinement stay. */
lam_spline_surface lam_spline_surface_refine(lam_arena *arena, const lam_spline_surface *surface,
                                             int spans) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d], count = surface->count[d];
    const double *knots = surface->knots[d];
    double longest = (knots[count] - knots[p]) / spans * (1 + 1e-9);
    lam_bspline net = lam_spline_surface_net(arena, &result, d);
    double *more = LAM_NEW(arena, double, 2 * spans + count);

    int total = 0;
    for (int i = p; i < count; i++) {
      int parts = 1;
      while ((knots[i + 1] - knots[i]) / parts > longest) parts *= 2;
      for (int k = 1; k < parts; k++)
        more[total++] = knots[i] + (knots[i + 1] - knots[i]) * k / parts;
    }

    net = lam_bspline_insert_all(arena, net, total, more, 1);
    result = lam_spline_surface_from_net(arena, &result, d, net);
  }
  return result;
}

/* Every inner knot is inserted until it stands as often as the degree. */
lam_spline_surface lam_spline_surface_pieces(lam_arena *arena, const lam_spline_surface *surface) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d];
    lam_bspline net = lam_spline_surface_net(arena, &result, d);
    lam_pieces pieces = lam_bspline_pieces(arena, net, 0, NULL);
    net = lam_bspline_insert_all(arena, net, pieces.count - 1, pieces.breaks + 1, p);
    result = lam_spline_surface_from_net(arena, &result, d, net);
  }
  return result;
}
