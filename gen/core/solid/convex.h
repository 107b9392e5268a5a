/* Convex solids, cut by planes. */
#ifndef LAM_CORE_SOLID_CONVEX_H
#define LAM_CORE_SOLID_CONVEX_H

#include "core/arena.h"
#include "core/model.h"

/* Faces are counterclockwise seen from outside. */
typedef struct lam_convex {
  lam_arena *arena; /* owns what grows */
  double tolerance; /* a corner nearer to a plane than this lies on it */
  int vertex_count, vertex_capacity;
  lam_vec3 *vertices; /* corners that were cut off stay until lam_convex_mesh */
  int face_count, face_capacity;
  struct lam_convex_face {
    int count, *corners;
  } * faces;
} lam_convex;

/* The prism over a convex polygon, counterclockwise seen against `along`: from polygon to polygon +
 * along. */
lam_convex lam_convex_prism(lam_arena *arena, const lam_vec3 *polygon, int count, lam_vec3 along,
                            double tolerance);

/* Keeps the side of the plane through point that normal (unit) points to. What is left may be
 * empty: no faces. */
void lam_convex_cut(lam_convex *solid, lam_vec3 point, lam_vec3 normal);

/* Its triangles: closed, and oriented outward. */
lam_trimesh lam_convex_mesh(lam_arena *arena, const lam_convex *solid);

#endif
