/* The stage that makes the surface of a design, and its spline where the net stands. */
#include "design/stages.h"

static bool make_surface(lam_build *p) {
  const lam_row *row = &p->design->surface;
  int before = p->errors->count;

  lam_row filled = lam_surface_row_with(p->arena, row, &p->inputs->surface);
  p->surface = lam_surface_make(p->arena, &filled, p->errors);
  return p->errors->count == before;
}

static void report_surface(lam_build *p) {
  const lam_surface_kind *kind = p->surface.kind;
  if (!kind || !kind->report) return;
  lam_stage *stage = lam_build_stage(p, lam_arena_printf(p->arena, "surface: %s", kind->head.name));
  kind->report(p->arena, p->surface.data, stage);
}

bool lam_build_surface(lam_build *p) {
  if (!p->design->surface.head) return true;
  if (!make_surface(p)) return false;
  report_surface(p);
  return true;
}

/* The surface for parts and writers, where the net is. */
void lam_build_keep_surface(const lam_build *p, lam_workshop *workshop) {
  const lam_surface_kind *kind = p->surface.kind;
  const lam_spline_surface *from = kind && kind->spline ? kind->spline(p->surface.data) : NULL;
  if (!from || !p->net) return;
  lam_spline_surface to = *from;
  int count = to.count[0] * to.count[1];
  lam_vec3 *points = LAM_NEW(p->arena, lam_vec3, count);
  for (int i = 0; i < count; i++) points[i] = lam_placement_apply(&p->placement, from->points[i]);
  to.points = points;
  to.name = "surface";
  lam_workshop_surface(workshop, to);
}
