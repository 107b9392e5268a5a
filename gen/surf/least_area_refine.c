/* Exact refinement of spline surfaces for coarse-to-fine solving. */
#include "surf/least_area.h"

lam_spline_surface lam_spline_surface_refine(lam_arena *arena, const lam_spline_surface *surface, int spans) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d], count = surface->count[d];
    const double *knots = surface->knots[d];
    double longest = (knots[count] - knots[p]) / spans * (1 + 1e-9);
    lam_bspline net = lam_spline_surface_net(arena, &result, d);
    for (int i = p; i < count; i++) {
      int parts = 1;
      while ((knots[i + 1] - knots[i]) / parts > longest) parts *= 2;
      for (int k = 1; k < parts; k++)
        net = lam_bspline_insert(arena, net, knots[i] + (knots[i + 1] - knots[i]) * k / parts, 1);
    }
    result = lam_spline_surface_from_net(arena, &result, d, net);
  }
  return result;
}

lam_spline_surface lam_spline_surface_pieces(lam_arena *arena, const lam_spline_surface *surface) {
  lam_spline_surface result = *surface;
  for (int d = 0; d < 2; d++) {
    int p = surface->degree[d];
    lam_bspline net = lam_spline_surface_net(arena, &result, d);
    for (int i = p + 1; i < surface->count[d]; i++) net = lam_bspline_insert(arena, net, surface->knots[d][i], p);
    result = lam_spline_surface_from_net(arena, &result, d, net);
  }
  return result;
}
