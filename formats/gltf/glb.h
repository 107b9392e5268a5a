/* Scenes, and glTF 2.0 binaries of them: written by glb.c, called by the glTF writers beside it. A
 * scene is plain constant data that the caller owns; nothing of it is changed or kept. */
#ifndef LAM_FORMATS_GLTF_GLB_H
#define LAM_FORMATS_GLTF_GLB_H

#include "core/error.h"
#include "core/text.h"
#include <stdbool.h>

typedef struct lam_gltf_material {
  const char *name;
  double color[3]; /* linear RGB */
  double metallic, roughness;
  bool double_sided;
} lam_gltf_material;

/* Triangles with normals, or lines when normals is NULL. Colors multiply the material's. */
typedef struct lam_gltf_mesh {
  const char *name;
  int material;
  int vertex_count;
  const float *positions; /* 3 per vertex */
  const float *normals;   /* 3 per vertex, unit; or NULL */
  const float *colors;    /* 3 per vertex, linear RGB; or NULL */
  /* 2 per vertex, 0 to 1 from the upper left corner of the scene's picture; NULL: no texture. */
  const float *texture;
  int index_count;
  const int *indices; /* index_count, of vertices: three per triangle, two per line */
  /* Morph targets: displacements of positions and, with normals, of normals; 3 per vertex. May be
   * none. */
  int target_count;
  const float *const *position_targets, *const *normal_targets;
} lam_gltf_mesh;

/* Every node whose mesh has morph targets runs through them: the mesh itself at time 0, target k
 * (from 0) at (k + 1) seconds_per_state, changing evenly in between, then back to the beginning. */
typedef struct lam_gltf_animation {
  const char *name; /* NULL: no animation */
  double seconds_per_state;
} lam_gltf_animation;

/* A text, or a number when text is NULL. */
typedef struct lam_gltf_extra {
  const char *name, *text;
  double number; /* finite */
} lam_gltf_extra;

typedef struct lam_gltf_node {
  const char *name;
  int parent;           /* an earlier node; -1 for a root */
  int mesh;             /* -1: none */
  const double *matrix; /* 4 x 4, column-major; NULL: identity */
  int extra_count;
  const lam_gltf_extra *extras;
} lam_gltf_node;

typedef struct lam_gltf_scene {
  const char *name;
  int material_count, mesh_count, node_count;
  const lam_gltf_material *materials;
  const lam_gltf_mesh *meshes;
  const lam_gltf_node *nodes;
  lam_gltf_animation animation;
  /* A PNG file, the texture of the materials of meshes with texture coordinates; NULL: none. */
  const unsigned char *picture;
  size_t picture_size; /* bytes */
} lam_gltf_scene;

/* Adds the bytes of the .glb file of a scene to out. The same scene gives the same bytes. When
 * memory runs out, control goes to the arena's recovery point. LAM_OK, or LAM_FAILED when the file
 * would be larger than the 4 GB that its format can tell. */
lam_status lam_glb_write(const lam_gltf_scene *scene, lam_text *out);

#endif
