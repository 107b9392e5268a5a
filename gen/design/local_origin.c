/* What lies far from the origin of its coordinates is built about a local origin near it: meshes,
 * surfaces and references that were read. Called by surface_stage.c, net_stage.c and
 * pipeline_run.c. */
#include "core/origin.h"
#include "core/text.h"
#include "design/stages.h"
#include "surf/placement.h"

/* A copy of the points, moved so that the origin is in (0, 0, 0). */
static lam_vec3 *moved(lam_arena *arena, const lam_vec3 *points, int count, lam_vec3 origin) {
  lam_vec3 *to = LAM_NEW(arena, lam_vec3, count);
  for (int i = 0; i < count; i++) to[i] = lam_sub(points[i], origin);
  return to;
}

/* ---- surfaces ---- */

/* All points of what was read for the surface, in one list. */
static lam_vec3 *gather(lam_arena *arena, const lam_surface_inputs *inputs, int *count) {
  const lam_spline_surface *s = inputs->surface;
  int room = inputs->point_count + (s ? s->count[0] * s->count[1] : 0), n = 0;
  for (int i = 0; i < inputs->curve_count; i++) room += inputs->curves[i].spline.count;

  lam_vec3 *all = LAM_NEW(arena, lam_vec3, room);
  for (int i = 0; i < inputs->point_count; i++) all[n++] = inputs->points[i];
  for (int i = 0; s && i < s->count[0] * s->count[1]; i++) all[n++] = s->points[i];
  for (int k = 0; k < inputs->curve_count; k++)
    for (int i = 0; i < inputs->curves[k].spline.count; i++)
      all[n++] = inputs->curves[k].spline.points[i];
  *count = n;
  return all;
}

/* Splines are moved by their control points: knots and weights stay. */
lam_surface_inputs lam_build_local_surface(lam_build *build) {
  lam_surface_inputs inputs = build->inputs->surface;
  int count;
  const lam_vec3 *all = gather(build->arena, &inputs, &count);
  lam_vec3 origin = build->surface_origin = lam_local_origin(all, count);
  if (!lam_is_moved(origin)) return inputs;

  if (inputs.points) inputs.points = moved(build->arena, inputs.points, inputs.point_count, origin);
  if (inputs.surface) {
    lam_spline_surface *surface = LAM_NEW(build->arena, lam_spline_surface, 1);
    *surface = *inputs.surface;
    surface->points =
        moved(build->arena, surface->points, surface->count[0] * surface->count[1], origin);
    inputs.surface = surface;
  }

  lam_named_curve *curves = LAM_NEW(build->arena, lam_named_curve, inputs.curve_count);
  for (int i = 0; i < inputs.curve_count; i++) {
    curves[i] = inputs.curves[i];
    curves[i].spline.points =
        moved(build->arena, curves[i].spline.points, curves[i].spline.count, origin);
  }
  inputs.curves = inputs.curve_count ? curves : NULL;
  return inputs;
}

/* The surface's own origin, turned and scaled as the surface was. What is set on the ground has no
 * height of its own. */
void lam_build_origin_of_surface(lam_build *build) {
  const lam_placement_keys *placing = build->design->surface.common;
  lam_placement without_lift = build->placement;
  without_lift.lift = 0;
  if (!lam_is_moved(build->surface_origin)) return;

  build->model->origin = lam_placement_apply(&without_lift, build->surface_origin);
  if (placing->ground) build->model->origin.z = 0;
}

/* ---- meshes ---- */

void lam_build_local_mesh(lam_build *build, lam_mesh *mesh) {
  lam_vec3 origin = lam_local_origin(mesh->vertices, mesh->vertex_count);
  if (!lam_is_moved(origin)) return;
  build->model->origin = origin;
  mesh->vertices = moved(build->arena, mesh->vertices, mesh->vertex_count, origin);
}

const lam_trimesh *lam_build_local_reference(const lam_build *build) {
  const lam_trimesh *given = build->inputs->reference;
  lam_trimesh *local = LAM_NEW(build->arena, lam_trimesh, 1);
  if (!given || !lam_is_moved(build->model->origin)) return given;

  *local = *given;
  local->vertices = moved(build->arena, given->vertices, given->vertex_count, build->model->origin);
  return local;
}

/* ---- the report ---- */

void lam_build_note_origin(const lam_build *build, lam_stage *stage) {
  lam_vec3 o = build->model->origin;
  lam_text x = {.arena = build->arena}, y = x, z = x;
  if (!lam_is_moved(o)) return;

  lam_text_number(&x, o.x, 6);
  lam_text_number(&y, o.y, 6);
  lam_text_number(&z, o.z, 6);
  lam_stage_note(build->arena, stage,
                 "local origin: (%s, %s, %s) m. STL and pictures are about it, glTF carries it as "
                 "a translation, OpenSCAD as origin and in_place; OBJ, STEP, IGES, JSON and tables "
                 "are in place",
                 x.data, y.data, z.data);
}
