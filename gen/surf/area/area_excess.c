/* How far a surface is above the least area on its boundary, estimated by what it would gain with
 * finer knots. Called by least_area.c for the report, and by the tests.
 *
 * On the surface with every span halved, which has the same points and more freedom, the second
 * variation promises that one Newton step saves 1/2 g A''^-1 g of the area, g the first variation.
 * What is left after halving is a small part of what was there, so that the estimate is a little
 * low: by 3 to 23 % on boundaries whose least area is known, from four spans on. */
#include "surf/area/area_parts.h"

#include <math.h>

enum {
  most_spans = 32, /* a finer surface is not halved: that would take longer than its solution */
  along = 48       /* nodes of the quadrature along a direction, at least */
};

/* Knot spans of direction d that are not empty. */
static int spans_of(const lam_spline_surface *s, int d) {
  int count = 0;
  for (int i = s->degree[d]; i < s->count[d]; i++) count += s->knots[d][i + 1] > s->knots[d][i];
  return count;
}

/* Movements within the surface cost nothing, and may even seem to gain: as much damping as makes
 * the second variation definite. More than a tenth would hide most of the gain. */
double lam_surface_area_excess(lam_arena *arena, const lam_spline_surface *surface) {
  int u = spans_of(surface, 0), v = spans_of(surface, 1), most = u > v ? u : v;
  if (most > most_spans) return NAN;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_spline_surface finer = lam_spline_surface_refine(arena, surface, 2 * most);
  lam_area_form *form = lam_area_form_make(arena, &finer, 0, lam_area_node_count(&finer, along));
  lam_area_form_coarsen(arena, form);
  lam_area_system system = lam_area_system_make(arena, form, 3);
  int inner = form->inner[0] * form->inner[1];
  lam_vec3 *step = LAM_NEW(arena, lam_vec3, inner);

  lam_area_slope(form, finer.points);
  lam_area_blocks(form, finer.points);
  double excess = NAN;
  for (double damping = 1e-6; damping < .2 && isnan(excess); damping *= 10)
    if (lam_area_system_factor(&system, form, damping)) {
      lam_area_system_step(arena, &system, form->gradient, step);
      excess = -lam_area_product(inner, form->gradient, step) / 2;
    }
  lam_arena_release(arena, mark);
  return excess;
}
