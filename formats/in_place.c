/* Models about (0, 0, 0) instead of their local origin. Called by library/write. */
#include "formats/in_place.h"
#include "core/origin.h"

/* A copy of the points, moved by the origin. */
static lam_vec3 *moved(lam_arena *arena, const lam_vec3 *points, int count, lam_vec3 origin) {
  lam_vec3 *to = LAM_NEW(arena, lam_vec3, count);
  for (int i = 0; i < count; i++) to[i] = lam_add(points[i], origin);
  return to;
}

/* The net and its states. */
static void move_net(lam_arena *arena, lam_model *model, lam_vec3 origin) {
  lam_mesh *net = LAM_NEW(arena, lam_mesh, 1);
  const lam_vec3 **frames = LAM_NEW(arena, const lam_vec3 *, model->frame_count);
  if (!model->net) return;

  *net = *model->net;
  net->vertices = moved(arena, net->vertices, net->vertex_count, origin);
  for (int i = 0; i < model->frame_count; i++)
    frames[i] = moved(arena, model->frames[i], net->vertex_count, origin);
  model->net = net;
  model->frames = frames;
}

/* Splines are moved by their control points. */
static void move_splines(lam_arena *arena, lam_model *model, lam_vec3 origin) {
  lam_spline_surface *surfaces = LAM_NEW(arena, lam_spline_surface, model->surface_count);
  for (int i = 0; i < model->surface_count; i++) {
    surfaces[i] = model->surfaces[i];
    surfaces[i].points =
        moved(arena, surfaces[i].points, surfaces[i].count[0] * surfaces[i].count[1], origin);
  }

  lam_named_curve *curves = LAM_NEW(arena, lam_named_curve, model->curve_count);
  for (int i = 0; i < model->curve_count; i++) {
    curves[i] = model->curves[i];
    curves[i].spline.points = moved(arena, curves[i].spline.points, curves[i].spline.count, origin);
  }
  model->surfaces = surfaces;
  model->curves = curves;
}

/* A part with instances is moved by them: its solid stays. */
static void move_part(lam_arena *arena, lam_part *part, lam_vec3 origin) {
  if (!part->instance_count) {
    part->solid.vertices = moved(arena, part->solid.vertices, part->solid.vertex_count, origin);
    return;
  }
  lam_pose *instances = LAM_NEW(arena, lam_pose, part->instance_count);
  for (int i = 0; i < part->instance_count; i++) {
    instances[i] = part->instances[i];
    instances[i].origin = lam_add(instances[i].origin, origin);
  }
  part->instances = instances;
}

static void move_parts(lam_arena *arena, lam_model *model, lam_vec3 origin) {
  lam_part *parts = LAM_NEW(arena, lam_part, model->part_count);
  for (int i = 0; i < model->part_count; i++) {
    parts[i] = model->parts[i];
    move_part(arena, &parts[i], origin);
  }

  lam_crossing *crossings = LAM_NEW(arena, lam_crossing, model->crossing_count);
  for (int i = 0; i < model->crossing_count; i++) {
    crossings[i] = model->crossings[i];
    crossings[i].position = lam_add(crossings[i].position, origin);
  }
  model->parts = parts;
  model->crossings = crossings;
  model->supports = moved(arena, model->supports, model->support_count, origin);
}

const lam_model *lam_model_in_place(lam_arena *arena, const lam_model *model) {
  lam_vec3 origin = model->origin;
  if (!lam_is_moved(origin)) return model;

  lam_model *copy = LAM_NEW(arena, lam_model, 1);
  *copy = *model;
  copy->origin = lam_v3(0, 0, 0);
  move_net(arena, copy, origin);
  move_splines(arena, copy, origin);
  move_parts(arena, copy, origin);
  return copy;
}
