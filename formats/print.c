/* Normals of printed surfaces, for the glTF writer (formats/gltf/gltf.c) and the POV-Ray writer
 * (formats/pov/pov_print.c). */
#include "formats/print.h"

/* Vertices without a triangle, or whose triangles cancel each other, get the normal (0, 0, 1). */
const lam_vec3 *lam_print_normals(lam_arena *arena, const lam_trimesh *mesh) {
  lam_vec3 *normals = LAM_NEW(arena, lam_vec3, mesh->vertex_count);

  /* The cross product of two sides is as long as twice the triangle's area: that is the weight. */
  for (int t = 0; t < mesh->triangle_count; t++) {
    const int *c = mesh->triangles[t];
    const lam_vec3 *x = mesh->vertices;
    lam_vec3 area = lam_cross(lam_sub(x[c[1]], x[c[0]]), lam_sub(x[c[2]], x[c[0]]));
    for (int k = 0; k < 3; k++) normals[c[k]] = lam_add(normals[c[k]], area);
  }

  for (int v = 0; v < mesh->vertex_count; v++) {
    normals[v] = lam_unit(normals[v]);
    if (!(lam_length(normals[v]) > 0)) normals[v] = lam_v3(0, 0, 1);
  }
  return normals;
}
