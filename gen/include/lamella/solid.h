/* Solids and pictures as files: inspecting one, comparing two. */
#ifndef LAMELLA_SOLID_H
#define LAMELLA_SOLID_H

#include <lamella/session.h>
#include <stdint.h>

LAM_BEGIN_DECLS

/* ---- one mesh ---- */

/* What a triangle mesh is as a solid. Meters. */
typedef struct lam_solid_facts {
  int vertices, triangles;
  bool closed;   /* every edge has exactly two triangles */
  bool oriented; /* neighbors agree, and a closed component's outside is outside */
  bool manifold; /* no edge with more than two triangles, no vertex with two fans */
  int boundary_edges, nonmanifold_edges;
  int components;
  int euler;               /* V - E + F */
  int genus;               /* sum over the components; -1 when not closed or not manifold */
  long self_intersections; /* pairs of triangles that meet outside their shared vertices and edges;
                              -1: not asked, or too many to wait for */
  double volume, area;     /* m^3, m^2; volume: 0 when not closed */
  lam_vec3 centroid;       /* of the volume (closed) or of the area */
  double inertia[6];       /* of the tensor about the centroid, density 1, m^5: xx, yy, zz, xy, yz,
                              zx; 0 when open */
  lam_vec3 min, max;
} lam_solid_facts;

/* Measures an STL (millimeters) or OBJ (meters) file as a solid. Vertices at exactly the same
 * coordinates are merged first, and triangles that lose a corner so are dropped.
 *
 *   self_intersections  whether to look for them, which takes the longest
 *   facts               meaningful with LAM_OK; holds no pointers
 *
 *   LAM_BAD_INPUT  the file is no mesh, has no triangle, or cannot be measured
 *   LAM_IO         it cannot be read
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_inspect(lam_session *session, const char *path, bool self_intersections,
                               lam_solid_facts *facts);

/* ---- two meshes ---- */

/* Distances, in meters, are the largest ones from points sampled on one mesh (vertices, and an even
 * pattern `spacing` apart) to the other. */
typedef struct lam_mesh_comparison {
  lam_solid_facts facts[2]; /* of a and b, without self-intersections */
  double spacing, a_to_b, b_to_a;
} lam_mesh_comparison;

/* Compares two files as in lam_inspect; what counts as the same is the caller's to say. comparison
 * is meaningful with LAM_OK. Statuses as lam_inspect, and
 *
 *   LAM_FAILED  the distance cannot be measured: a mesh without a triangle that has an area */
LAM_API lam_status lam_compare_meshes(lam_session *session, const char *a, const char *b,
                                      lam_mesh_comparison *comparison);

/* ---- two pictures ---- */

/* A pixel differs when a channel does by more than this, of 255. */
enum { LAM_PIXEL_STEP = 4 };

typedef struct lam_picture_comparison {
  int width[2], height[2]; /* of a and b, pixels */
  uint64_t hash[2];        /* FNV-1a of size and decoded pixels: equal for the same picture */
  bool same_size;          /* what follows is meaningful then, and 0 otherwise */
  double share;            /* of the pixels that differ, 0 to 1 */
  int largest;             /* difference of a channel, 0 to 255 */
  double psnr;             /* dB; infinite when equal */
} lam_picture_comparison;

/* Compares two PNG files; what is transparent is laid on white. comparison is meaningful with
 * LAM_OK.
 *
 * mask  where to write a picture (PNG) with the differing pixels in red, if the sizes are the same;
 *       not a or b; NULL: nowhere
 *
 *   LAM_BAD_INPUT  a file is no PNG picture, or too large
 *   LAM_IO         a file cannot be read, or the mask not be written
 *   LAM_FAILED     libpng cannot encode the mask
 *   LAM_NO_MEMORY */
LAM_API lam_status lam_compare_pictures(lam_session *session, const char *a, const char *b,
                                        const char *mask, lam_picture_comparison *comparison);

LAM_END_DECLS

#endif
