/* A look at the solids as files will have them: STL and glTF have coordinates of 32 bits, with
 * about seven digits, in which small parts far from the origin lose their shape. Called by
 * parts_stage.c. */
#include "core/solid/triangles.h"
#include "design/stages.h"

/* The share of its volume by which a solid may change in its file: sheets are as thick as they are
 * meant to be within this. */
static const double volume_lost = .02;

/* A coordinate in meters, as it is read back from a file of millimeters. */
static double read_back(double meters) { return (double)(float)(1000 * meters) / 1000; }

/* Whether the solid is sound and keeps its volume when it is read back from STL, where vertices at
 * the same place are one. */
static bool is_sound_in_file(lam_arena *arena, const lam_trimesh *solid) {
  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_trimesh read = *solid;
  read.vertices = LAM_NEW(arena, lam_vec3, solid->vertex_count);
  for (int v = 0; v < solid->vertex_count; v++) {
    lam_vec3 x = solid->vertices[v];
    read.vertices[v] = lam_v3(read_back(x.x), read_back(x.y), read_back(x.z));
  }

  lam_part part = {.solid = lam_trimesh_weld(arena, &read, 0)};
  double volume = lam_trimesh_volume(solid), kept = lam_trimesh_volume(&part.solid);
  bool sound = lam_part_is_sound(arena, &part) && fabs(kept - volume) <= volume_lost * volume;
  lam_arena_release(arena, mark);
  return sound;
}

/* The instance of a part that lies furthest from the origin. */
static const lam_pose *furthest(const lam_part *part) {
  const lam_pose *found = part->instances;
  for (int i = 1; i < part->instance_count; i++)
    if (lam_length(part->instances[i].origin) > lam_length(found->origin))
      found = &part->instances[i];
  return found;
}

/* Whether the part is sound, but not as it is written. What is unsound anyway is told by the row
 * that made it. */
static bool is_broken_by_writing(lam_arena *arena, const lam_part *part) {
  if (!lam_part_is_sound(arena, part)) return false;
  if (!is_sound_in_file(arena, &part->solid)) return true;
  if (!part->instance_count) return false;

  lam_arena_mark mark = lam_arena_mark_get(arena);
  lam_trimesh placed = lam_trimesh_placed(arena, &part->solid, furthest(part));
  bool broken = !is_sound_in_file(arena, &placed);
  lam_arena_release(arena, mark);
  return broken;
}

/* A stage of the report, for the case that something is lost alone. */
void lam_build_check_written(lam_workshop *workshop) {
  long broken = 0;
  const char *first = NULL;
  for (int i = 0; i < workshop->part_count; i++) {
    const lam_part *part = &workshop->parts[i];
    if (part->drawn || !is_broken_by_writing(workshop->arena, part)) continue;
    broken++;
    if (!first) first = part->name;
  }
  if (!broken) return;

  lam_stage *stage = lam_workshop_stage(workshop, "files");
  stage->converged = false;
  stage->reason = "solids lose their shape in 32-bit coordinates";
  lam_stage_count(workshop->arena, stage, "parts_broken_by_writing", broken);
  lam_stage_note(workshop->arena, stage,
                 "read back from STL, %s is not the closed solid that it was: its details are too "
                 "small for its distance from the origin",
                 first);
}
