/* POV-Ray scenes (NAME.pov; listed in formats/list/formats.c). The parts (the net when there are
 * none) are triangle meshes with normals, in meters, z up; the model's bounds, its extreme points
 * and its supports are declared, and the setting (a file of templates/pov) brings ground, light,
 * people and camera.
 *
 * Nothing in the scene is mirrored: cameras of camera.inc are right-handed. */
#include "core/numbers.h"
#include "formats/format.h"

#include "core/solid/triangles.h"
#include "formats/identifier.h"
#include "formats/pov/pov_net.h"
#include "formats/pov/pov_print.h"
#include <string.h>

/* Faces whose normals differ by less than this are shaded as one smooth surface. */
static const double smooth_angle = 30 * LAM_PI / 180;

/* ---- pieces of scene language ---- */

/* Declares the mesh of a part as Part_NUMBER. */
static void add_part(lam_text *out, const lam_part *part, int number, int decimals) {
  lam_text_printf(out, "// %s: %s of %s\n", part->name, part->kind, part->material->name);
  lam_pov_mesh(out, lam_arena_printf(out->arena, "Part_%d", number), &part->solid, smooth_angle,
               decimals);
}

/* ---- extreme points ---- */

enum { direction_count = 26 };

/* Direction k of the 26 neighbors of a cube in a 3 x 3 x 3 grid; cell 13 is the cube itself. Not
 * of unit length. */
static lam_vec3 direction(int k) {
  int cell = k < 13 ? k : k + 1;
  return lam_v3(cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1);
}

/* The points found so far: per direction how far out they lie, and which they are. */
typedef struct extreme_search {
  double reach[direction_count];
  lam_vec3 *points;
} extreme_search;

/* A point of a part where its instance stands; pose NULL: where it is. */
static lam_vec3 placed(const lam_pose *pose, lam_vec3 x) {
  if (!pose) return x;
  return lam_along(lam_along(lam_along(pose->origin, x.x, pose->axis[0]), x.y, pose->axis[1]), x.z,
                   pose->axis[2]);
}

/* Points of a symmetric model lie equally far out but for rounding: the first one counts, so that
 * the camera does not depend on the last bit. Meters. */
static const double same_reach = 1e-6;

/* Takes a point into the search, in every direction in which it lies clearly further out. */
static void take_point(extreme_search *e, lam_vec3 x) {
  for (int k = 0; k < direction_count; k++) {
    double along = lam_dot(direction(k), x);
    if (along <= e->reach[k] + same_reach) continue;
    e->reach[k] = along;
    e->points[k] = x;
  }
}

/* The points of the parts and prints, or of the net when there are none, that lie furthest out in
 * 26 directions: what a camera must see. points: direction_count. */
static void find_extremes(const lam_model *model, lam_vec3 *points) {
  extreme_search e = {.points = points};
  for (int k = 0; k < direction_count; k++) e.reach[k] = -INFINITY;

  for (int i = 0; i < model->part_count; i++) {
    const lam_part *part = &model->parts[i];
    for (int j = 0; j < (part->instance_count ? part->instance_count : 1); j++) {
      const lam_pose *pose = part->instance_count ? &part->instances[j] : NULL;
      for (int v = 0; v < part->solid.vertex_count; v++)
        take_point(&e, placed(pose, part->solid.vertices[v]));
    }
  }

  for (int i = 0; model->print && i < model->print->count; i++) {
    const lam_trimesh *mesh = &model->print->sheets[i].mesh;
    for (int v = 0; v < mesh->vertex_count; v++) take_point(&e, mesh->vertices[v]);
  }

  bool net = !model->part_count && !model->print;
  for (int v = 0; net && v < model->net->vertex_count; v++) take_point(&e, model->net->vertices[v]);
}

/* Declares an array of vectors, four in a line. */
static void add_array(lam_text *out, const char *name, const lam_vec3 *points, int count,
                      int decimals) {
  lam_text_printf(out, "#declare %s = array[%d] {", name, count);
  for (int i = 0; i < count; i++) {
    lam_text_add(out, i ? (i % 4 ? ", " : ",\n  ") : "\n  ");
    lam_pov_vector(out, points[i], decimals);
  }
  lam_text_add(out, "\n}\n");
}

/* ---- the scene ---- */

/* What every scene declares for its setting: bounds, height of the ground (the lowest support, or
 * the lowest point), supports, extreme points, view. */
static void add_head(lam_text *out, const lam_model *model, int decimals) {
  lam_vec3 extremes[direction_count], min, max;
  find_extremes(model, extremes);
  lam_points_bounds(extremes, direction_count, &min, &max);

  double ground = min.z;
  for (int i = 0; i < model->support_count; i++) {
    if (i == 0 || model->supports[i].z < ground) ground = model->supports[i].z;
  }

  lam_text_printf(out, "// %s\n// Picture: povray \"render.ini[final]\" +I%s.pov +W%d +H%d\n",
                  model->title, model->name, model->picture.width, model->picture.height);
  lam_text_add(
      out,
      "// Part numbers as flat colors: \"render.ini[mask]\" instead. Meters, z up.\n#version 3.7;\n"
      "global_settings { assumed_gamma 1.0 }\n\n#declare Model_Min = ");
  lam_pov_vector(out, min, decimals);
  lam_text_add(out, ";\n#declare Model_Max = ");
  lam_pov_vector(out, max, decimals);
  lam_text_add(out, ";\n#declare Model_Ground = "); /* height of the ground it stands on */
  lam_text_number(out, ground, decimals);
  lam_text_printf(out, ";\n#declare Model_Support_Count = %d;\n", model->support_count);
  if (model->support_count) {
    add_array(out, "Model_Supports", model->supports, model->support_count, decimals);
  }

  lam_text_add(out, "// The points that lie furthest out in 26 directions.\n");
  add_array(out, "Model_Extremes", extremes, direction_count, decimals);
  lam_text_printf(out, "#declare View = \"%s\";\n\n#include \"materials.inc\"\n",
                  model->picture.view);
}

/* Materials that materials.inc does not know look as their row in fab/material.h says: each
 * material of a part is declared once, unless it is declared already. */
static void add_materials(lam_text *out, const lam_model *model) {
  for (int i = 0; i < model->part_count; i++) {
    const lam_material *material = model->parts[i].material;
    bool seen = false;
    for (int j = 0; j < i && !seen; j++) seen = model->parts[j].material == material;
    if (seen) continue;

    lam_text_add(out, "#ifndef (Material_");
    lam_identifier_add(out, material->name);
    lam_text_add(out, ") #declare Material_");
    lam_identifier_add(out, material->name);
    lam_text_add(out, " = texture { Plain_Material(");
    lam_pov_vector(out, lam_v3(material->color[0], material->color[1], material->color[2]), 4);
    for (int k = 0; k < 2; k++) {
      lam_text_add(out, ", ");
      lam_text_number(out, k ? material->roughness : material->metallic, 4);
    }
    lam_text_add(out, ") } #end\n");
  }
}

/* The transformation of an instance: its axes and its origin, four vectors in a row. */
static void add_matrix(lam_text *out, const lam_pose *pose) {
  const lam_vec3 rows[4] = {pose->axis[0], pose->axis[1], pose->axis[2], pose->origin};
  lam_text_add(out, " matrix ");
  for (int k = 0; k < 12; k++) {
    lam_vec3 row = rows[k / 3];
    lam_text_add(out, k ? "," : "<");
    lam_text_number(out, k % 3 == 0 ? row.x : k % 3 == 1 ? row.y : row.z, 7);
  }
  lam_text_add(out, ">");
}

/* A macro that puts everything into the scene. Every object has a running number: its color in
 * the part mask, and what shifts the pattern of its material. */
static void add_objects(lam_text *out, const lam_model *model) {
  int number = 0;
  lam_text_add(out, "\n// The setting calls this once.\n#macro Model_Parts()\n");

  for (int i = 0; i < model->part_count; i++) {
    const lam_part *part = &model->parts[i];
    for (int j = 0; j < (part->instance_count ? part->instance_count : 1); j++) {
      lam_text_printf(out, "object { Part_%d", i + 1);
      if (part->instance_count) add_matrix(out, &part->instances[j]);
      lam_text_printf(out, " Look(%d, Material_", ++number);
      lam_identifier_add(out, part->material->name);
      lam_text_add(out, ") }\n");
    }
  }

  if (model->print) lam_pov_print_objects(out, model->print, number);
  if (!model->part_count && !model->print)
    lam_text_add(out, "object { Net_Faces Look(1, Material_net_faces) }\n"
                      "object { Net_Lines Look(2, Material_net_lines) }\n");
  lam_text_add(out, "#end\n");
}

/* File 0 is the scene, file 1 the picture of the print. Declarations come before what uses them;
 * the setting, included last, builds the scene. */
static lam_status write_scene(const lam_model *model, int i, lam_text *out) {
  if (i == 1) return lam_pov_print_picture(out, model->print);

  lam_vec3 extremes[direction_count], min, max;
  find_extremes(model, extremes);
  lam_points_bounds(extremes, direction_count, &min, &max);
  int decimals = lam_distance(min, max) > 2 ? 5 : 7; /* 10 um on a roof, .1 um on a desk */

  add_head(out, model, decimals);
  add_materials(out, model);
  for (int k = 0; k < model->part_count; k++) add_part(out, &model->parts[k], k + 1, decimals);
  if (model->print) lam_pov_print_add(out, model->print, decimals);
  if (!model->part_count && !model->print) lam_pov_net_add(out, model->net, smooth_angle, decimals);
  add_objects(out, model);
  lam_text_printf(out, "\n#include \"%s.inc\"\n", model->picture.setting);
  return LAM_OK;
}

/* The scene, and the picture that is printed in it. */
static int count_scenes(const lam_model *model) {
  return model->part_count > 0 || model->net ? (model->print ? 2 : 1) : 0;
}

static void scene_path(const lam_model *model, int i, lam_text *path) {
  lam_text_printf(path, i ? "print.png" : "%s.pov", model->name);
}

/* ---- template files ---- */

/* What every setting may use, and the setting itself. */
static const char *const *scene_support(lam_arena *arena, const lam_model *model) {
  static const char *const shared[] = {"pov/render.ini", "pov/materials.inc", "pov/camera.inc",
                                       "pov/light.inc",  "pov/sky.inc",       "pov/ground.inc",
                                       "pov/people.inc", "pov/trees.inc"};
  enum { shared_count = sizeof shared / sizeof *shared };

  const char **files = LAM_NEW(arena, const char *, shared_count + 2);
  memcpy(files, shared, sizeof shared);
  files[shared_count] = lam_arena_printf(arena, "pov/%s.inc", model->picture.setting);
  return files;
}

const lam_format lam_format_pov = {
    .name = "pov",
    .doc = "POV-Ray scene of the parts, or of the net when there are none, in a setting.",
    .count = count_scenes,
    .path = scene_path,
    .write = write_scene,
    .support = scene_support};
