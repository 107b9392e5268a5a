/* The way of a net from the start to the result as a glTF animation (NAME-animation.glb; listed
 * in formats/list/formats.c): faces and lines are morphed from state to state, there and back, so
 * that viewers can repeat it. Meters, y up. */
#include "formats/format.h"
#include "formats/gltf/gltf_scene.h"

#include <math.h>

static const double length_of_a_run = 4; /* seconds, one way */

static int count(const lam_model *model) { return model->net && model->frame_count > 1 ? 1 : 0; }

static void path(const lam_model *model, int i, lam_text *out) {
  (void)i;
  lam_text_printf(out, "%s-animation.glb", model->name);
}

/* n vectors as floats, three each; with a base, as displacements from it. */
static const float *floats(lam_arena *arena, const lam_vec3 *values, const lam_vec3 *base, int n) {
  float *out = LAM_NEW(arena, float, 3 * n);
  for (int v = 0; v < n; v++) {
    lam_vec3 x = base ? lam_sub(values[v], base[v]) : values[v];
    lam_gltf_vector(out + 3 * v, x);
  }
  return out;
}

/* Unit normals of the vertices at positions x: the sum of the cross products of the diagonals of
 * the faces around each, or (0, 0, 1) where that is zero. */
static lam_vec3 *normals_of(lam_arena *arena, const lam_mesh *net, const lam_vec3 *x) {
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, net->vertex_count);
  for (int f = 0; f < net->face_count; f++) {
    const int *c = net->faces[f];
    lam_vec3 n = lam_cross(lam_sub(x[c[2]], x[c[0]]), lam_sub(x[c[3]], x[c[1]]));
    for (int k = 0; k < 4; k++) normals[c[k]] = lam_add(normals[c[k]], n);
  }

  for (int v = 0; v < net->vertex_count; v++) {
    normals[v] = lam_unit(normals[v]);
    if (!(lam_length(normals[v]) > 0)) normals[v] = lam_v3(0, 0, 1);
  }
  return normals;
}

/* Morph targets: the states from the second on as displacements from the first, n vectors each. */
static const float *const *targets(lam_arena *arena, const lam_vec3 *const *states, int count_of,
                                   int n) {
  const float **out = LAM_NEW(arena, const float *, count_of);
  for (int k = 1; k < count_of; k++) out[k - 1] = floats(arena, states[k], states[0], n);
  return out;
}

/* The faces as triangles, two per quad, in the first state; the others are its morph targets. */
static lam_gltf_mesh faces(lam_arena *arena, const lam_model *model) {
  const lam_mesh *net = model->net;
  int n = net->vertex_count, states = model->frame_count;
  const lam_vec3 **normals = LAM_NEW(arena, const lam_vec3 *, states);
  for (int k = 0; k < states; k++) normals[k] = normals_of(arena, net, model->frames[k]);

  int *indices = LAM_NEW(arena, int, 6 * net->face_count);
  for (int f = 0; f < net->face_count; f++) {
    static const int corner[6] = {0, 1, 2, 0, 2, 3};
    for (int k = 0; k < 6; k++) indices[6 * f + k] = net->faces[f][corner[k]];
  }

  return (lam_gltf_mesh){.name = "faces",
                         .material = 0,
                         .vertex_count = n,
                         .positions = floats(arena, model->frames[0], NULL, n),
                         .normals = floats(arena, normals[0], NULL, n),
                         .index_count = 6 * net->face_count,
                         .indices = indices,
                         .target_count = states - 1,
                         .position_targets = targets(arena, model->frames, states, n),
                         .normal_targets = targets(arena, normals, states, n)};
}

/* The polylines as lines, which share the vertices and morph targets of the surface. */
static lam_gltf_mesh lines(lam_arena *arena, const lam_model *model, const lam_gltf_mesh *surface) {
  int count, *indices = lam_gltf_lines(arena, model, &count);
  return (lam_gltf_mesh){.name = "lines",
                         .material = 1,
                         .vertex_count = surface->vertex_count,
                         .positions = surface->positions,
                         .index_count = count,
                         .indices = indices,
                         .target_count = surface->target_count,
                         .position_targets = surface->position_targets};
}

/* Faces and lines below one root; without lines their material, mesh and node, the last ones, are
 * left out. */
static lam_status write(const lam_model *model, int i, lam_text *out) {
  (void)i;
  static const lam_gltf_material materials[2] = {{"faces", {.75, .75, .72}, 0, .8, true},
                                                 {"lines", {.1, .1, .1}, 0, 1, false}};
  lam_gltf_mesh meshes[2] = {faces(out->arena, model)};
  meshes[1] = lines(out->arena, model, &meshes[0]);

  lam_gltf_node nodes[3] = {
      {.name = model->name, .parent = -1, .mesh = -1, .matrix = lam_gltf_root(out->arena, model)},
      {.name = "faces", .parent = 0, .mesh = 0},
      {.name = "lines", .parent = 0, .mesh = 1}};

  bool has_lines = meshes[1].index_count > 0;
  lam_gltf_scene scene = {.name = model->title ? model->title : model->name,
                          .material_count = 1 + has_lines,
                          .mesh_count = 1 + has_lines,
                          .node_count = 2 + has_lines,
                          .materials = materials,
                          .meshes = meshes,
                          .nodes = nodes,
                          .animation = {"deformation", length_of_a_run / (model->frame_count - 1)}};
  return lam_glb_write(&scene, out);
}

const lam_format lam_format_animation = {
    .name = "animation",
    .doc = "The states of the net that `animate` keeps, as a glTF 2.0 animation that goes there "
           "and back.",
    .count = count,
    .path = path,
    .write = write,
};
