/* Distance between a net and the mesh that it is to stay near. Rows of the list in
 * net/measures/measure.c, which calls them. */
#include "net/measures/measure.h"

#include <math.h>

/* Distance of every vertex to the nearest point of the reference; undefined without one. */
static void distance_to_reference(const lam_measuring *in, double *values) {
  for (int v = 0; in->reference && v < in->net->mesh.vertex_count; v++) {
    lam_vec3 closest;
    int triangle;
    lam_tree_closest(in->reference, in->positions[v], &closest, &triangle);
    values[v] = triangle < 0 ? NAN : lam_distance(in->positions[v], closest);
  }
  if (lam_tree_ran_out(in->reference)) lam_arena_exhausted(in->arena);
}

/* The net as triangles in in->arena, each face split along the diagonal from corner 0
 * to corner 2. */
static lam_trimesh split_faces(const lam_measuring *in) {
  const lam_mesh *mesh = &in->net->mesh;
  lam_trimesh out = {
      mesh->vertex_count, LAM_NEW(in->arena, lam_vec3, mesh->vertex_count), 2 * mesh->face_count,
      (int(*)[3])lam_arena_alloc(in->arena, 2 * (size_t)mesh->face_count, sizeof *out.triangles)};

  for (int v = 0; v < mesh->vertex_count; v++) out.vertices[v] = in->positions[v];
  for (int f = 0; f < mesh->face_count; f++)
    for (int k = 0; k < 3; k++) {
      out.triangles[2 * f][k] = mesh->faces[f][k];
      out.triangles[2 * f + 1][k] = mesh->faces[f][(k + 2) % 4];
    }
  return out;
}

/* Largest distance from the reference to the net: samples at most a mean edge apart. */
static void distance_from_reference(const lam_measuring *in, double *values) {
  if (!in->reference_mesh) return;
  lam_trimesh faces = split_faces(in);
  double there, back;
  lam_status status = lam_solid_hausdorff(in->reference_mesh, &faces, in->mean_edge, &there, &back);
  if (status == LAM_NO_MEMORY) lam_arena_exhausted(in->arena);
  values[0] = status == LAM_OK ? there : NAN;
}

const lam_measure_kind lam_measure_distance_to_reference = {
    "distance_to_reference", "m",
    "distance of the vertices to the reference mesh; undefined when none is given", LAM_ON_VERTICES,
    distance_to_reference};
const lam_measure_kind lam_measure_distance_from_reference = {
    "distance_from_reference", "m",
    "largest distance from the reference mesh (points at most a mean edge apart) to the net: with "
    "distance_to_reference, the Hausdorff distance",
    LAM_ON_NET, distance_from_reference};
