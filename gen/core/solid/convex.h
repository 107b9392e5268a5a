/* Convex solids, cut by planes. Used by fab/parts/bars.c for bars whose ends are mitered. */
#ifndef LAM_CORE_SOLID_CONVEX_H
#define LAM_CORE_SOLID_CONVEX_H

#include "core/arena.h"
#include "core/model.h"

/* Faces are counterclockwise seen from outside. */
typedef struct lam_convex {
  lam_arena *arena; /* owns what grows */
  double tolerance; /* a corner nearer to a plane than this lies on it */
  int vertex_count, vertex_capacity;
  /* Corners that were cut off stay until lam_convex_mesh. */
  lam_vec3 *vertices;
  int face_count, face_capacity;
  struct lam_convex_face {
    int count, *corners; /* count >= 3 */
  } * faces;
} lam_convex;

/* The prism over a convex polygon of `count` points, counterclockwise seen against `along`: from
 * polygon to polygon + along. tolerance: m. arena owns what the solid becomes. */
lam_convex lam_convex_prism(lam_arena *arena, const lam_vec3 *polygon, int count, lam_vec3 along,
                            double tolerance);

/* Keeps the side of the plane through point that normal (unit) points to. What is left may be
 * empty: no faces. */
void lam_convex_cut(lam_convex *solid, lam_vec3 point, lam_vec3 normal);

/* Its triangles: closed, and oriented outward; vertices are those that faces use. Owned by arena,
 * which may be another than the solid's. */
lam_trimesh lam_convex_mesh(lam_arena *arena, const lam_convex *solid);

#endif
