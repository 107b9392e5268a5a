/* The stage that makes the surface of a design, and its spline where the net stands. Called by
 * pipeline_run.c. */
#include "design/stages.h"

/* The surface of the design's row, with what was read of its file put in. False when its keys do
 * not go together. */
static bool make_surface(lam_build *build) {
  const lam_row *row = &build->design->surface;
  int before = build->errors->count;

  lam_surface_inputs inputs = lam_build_local_surface(build);
  lam_row filled = lam_surface_row_with(build->arena, row, &inputs);
  build->surface = lam_surface_make(build->arena, &filled, build->errors);
  return build->errors->count == before;
}

/* A stage of the report for surfaces that have something to tell: that they were computed, and how
 * well. */
static void report_surface(lam_build *build) {
  const lam_surface_kind *kind = build->surface.kind;
  if (!kind || !kind->report) return;

  lam_stage *stage =
      lam_build_stage(build, lam_arena_printf(build->arena, "surface: %s", kind->head.name));
  kind->report(build->arena, build->surface.data, stage);
}

/* Nothing to do for a design without a surface. */
bool lam_build_surface(lam_build *build) {
  if (!build->design->surface.head) return true;
  if (!make_surface(build)) return false;
  report_surface(build);
  return true;
}

/* A spline is placed by its control points: the placement is affine. Knots and weights stay. */
void lam_build_keep_surface(const lam_build *build, lam_workshop *workshop) {
  const lam_surface_kind *kind = build->surface.kind;
  const lam_spline_surface *from = kind && kind->spline ? kind->spline(build->surface.data) : NULL;
  if (!from || !build->net) return;

  lam_spline_surface to = *from;
  int count = to.count[0] * to.count[1];
  lam_vec3 *points = LAM_NEW(build->arena, lam_vec3, count);
  for (int i = 0; i < count; i++)
    points[i] = lam_placement_apply(&build->placement, from->points[i]);
  to.points = points;
  to.name = "surface";
  lam_workshop_surface(workshop, to);
}
