/* Vertices and faces of any number of corners, as the readers of OBJ, OFF and PLY gather them, and
 * the meshes that they become. Called by obj.c, off.c and ply.c. */
#ifndef LAM_FORMATS_MESH_POLYGONS_H
#define LAM_FORMATS_MESH_POLYGONS_H

#include "core/error.h"
#include "core/model.h"

/* A growing list of numbers. */
typedef struct lam_int_list {
  int count, capacity;
  int *items;
} lam_int_list;

/* What was read so far. Zeroed but for arena and most_corners it is empty. */
typedef struct lam_polygons {
  lam_arena *arena;
  int most_corners; /* of a face: 4 for meshes of quads, INT_MAX for triangles */
  int vertex_count, vertex_capacity;
  lam_vec3 *vertices;
  lam_int_list corners;       /* of all faces, counted from 0 */
  lam_int_list starts, lines; /* per face: its first corner, where it stands in the file (0: no
                                 text) */
} lam_polygons;

void lam_polygons_vertex(lam_polygons *polygons, lam_vec3 vertex);
void lam_polygons_corner(lam_polygons *polygons, int vertex);
/* Makes a face of the corners from `start` on (the number of corners before the first was added).
 * Too few or too many are a message at location, and no face. */
void lam_polygons_face(lam_polygons *polygons, int start, lam_location location,
                       lam_errors *errors);
/* To be called at the end: whether there are faces, and all their corners are vertices. A message
 * for each of the first faces that are wrong, with `base` added to the numbers of vertices. */
bool lam_polygons_check(lam_polygons *polygons, int base, lam_location location,
                        lam_errors *errors);

/* The faces as a mesh; none has more than four corners (most_corners). Vertices are shared with the
 * polygons. Needs lam_polygons_check to be true. */
lam_mesh lam_polygons_mesh(const lam_polygons *polygons);
/* The faces as triangles: a face is cut into the fan of triangles at its first corner. */
lam_trimesh lam_polygons_triangles(const lam_polygons *polygons);

#endif
