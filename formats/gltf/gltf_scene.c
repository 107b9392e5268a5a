/* A model's data as the arrays that a scene takes, for the glTF writers of this folder. */
#include "formats/gltf/gltf_scene.h"

#include <string.h>

const double lam_gltf_y_up[16] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};

/* (x, y, z) goes to (x, z, -y). */
const double *lam_gltf_root(lam_arena *arena, const lam_model *model) {
  double *matrix = LAM_NEW(arena, double, 16);
  memcpy(matrix, lam_gltf_y_up, sizeof lam_gltf_y_up);
  matrix[12] = model->origin.x;
  matrix[13] = model->origin.z;
  matrix[14] = 0 - model->origin.y;
  return matrix;
}

void lam_gltf_vector(float *to, lam_vec3 v) {
  to[0] = (float)v.x + 0.f; /* -0 + 0 is 0 */
  to[1] = (float)v.y + 0.f;
  to[2] = (float)v.z + 0.f;
}

/* A closed polyline has as many edges as vertices, an open one an edge fewer. */
static int edges_of(const lam_polyline *line) { return line->count - (line->closed ? 0 : 1); }

/* Lines follow one another in the order of the polylines; each edge runs along its polyline. */
int *lam_gltf_lines(lam_arena *arena, const lam_model *model, int *index_count) {
  int edges = 0, n = 0;
  for (int l = 0; l < model->polyline_count; l++) edges += edges_of(&model->polylines[l]);

  int *indices = LAM_NEW(arena, int, edges > 0 ? 2 * edges : 0);
  for (int l = 0; l < model->polyline_count; l++) {
    const lam_polyline *line = &model->polylines[l];
    for (int k = 0; k < edges_of(line); k++) {
      indices[n++] = line->vertices[k];
      indices[n++] = line->vertices[(k + 1) % line->count];
    }
  }
  *index_count = n;
  return indices;
}
