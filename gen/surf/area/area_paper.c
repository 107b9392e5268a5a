/* The way of Wu & Wang from a boundary to their results, steps 1 to 6. Called by least_area.c
 * for the method `paper`; the steps are in hybrid.c, area_patches.c, area_fit.c and nearest.c. */
#include "surf/area/area_paper.h"

/* Step 6, with the exact boundary of the space. Points of equal parameters first, then the
 * distance alone: the former are a start, and settle what the latter leaves free. */
static lam_spline_surface refit(lam_arena *arena, const lam_spline_surface *space,
                                const lam_spline_surface *target) {
  lam_spline_surface start = lam_spline_surface_fit(arena, space, target);
  return lam_spline_surface_nearest(arena, &start, target);
}

/* Patches on approximated borders first; then three surfaces on the exact boundary near to them. */
lam_paper_result lam_least_area_paper(lam_arena *arena, const lam_spline_surface *boundary, int r,
                                      int p, double tolerance, int most) {
  lam_paper_result result;
  lam_spline_surface patches = lam_bezier_boundary(arena, boundary, r, p);
  patches = lam_bezier_borders(arena, &patches);
  patches = lam_bezier_fill(arena, &patches, LAM_BEZIER_DIRICHLET);
  result.patches = lam_bezier_iterate(arena, &patches, tolerance, most);

  const lam_spline_surface *target = &result.patches.surface;
  lam_spline_surface unit = lam_least_area_unit_weights(arena, boundary),
                     separable = lam_least_area_separable_weights(arena, boundary),
                     pieces = lam_spline_surface_pieces(arena, &unit);

  result.nurbs = refit(arena, &unit, target);
  result.separable = refit(arena, &separable, target);
  result.rational = refit(arena, &pieces, target);
  return result;
}

/* Two steps, as in refit. */
lam_spline_surface lam_least_area_paper_weights(lam_arena *arena,
                                                const lam_spline_surface *boundary,
                                                const lam_spline_surface *patches, double low,
                                                double high) {
  lam_spline_surface start = lam_spline_surface_fit_weights(arena, boundary, patches, low, high);
  return lam_spline_surface_nearest(arena, &start, patches);
}
