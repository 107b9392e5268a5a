/* Solids and pictures as files: inspecting one, comparing two. */
#ifndef LAMELLA_SOLID_H
#define LAMELLA_SOLID_H

#include <lamella/session.h>
#include <stdint.h>

LAM_BEGIN_DECLS

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
                              -1: not asked */
  double volume, area;     /* m^3, m^2; volume: 0 when not closed */
  lam_vec3 centroid;       /* of the volume (closed) or of the area */
  double inertia[6];       /* xx, yy, zz, xy, yz, zx about the centroid, density 1; 0 when open */
  lam_vec3 min, max;
} lam_solid_facts;

/* Measures an STL (millimeters) or OBJ (meters) file as a solid; vertices at exactly one place are
 * merged first. self_intersections: whether to look for them. LAM_BAD_INPUT, LAM_IO, LAM_NO_MEMORY. */
LAM_API lam_status lam_inspect(lam_session *session, const char *path, bool self_intersections,
                               lam_solid_facts *facts);

/* Two meshes. Distances from points sampled on one (vertices, and an even pattern `spacing` apart)
 * to the other, both ways; meters. */
typedef struct lam_mesh_comparison {
  lam_solid_facts facts[2];
  double spacing, a_to_b, b_to_a;
} lam_mesh_comparison;
LAM_API lam_status lam_compare_meshes(lam_session *session, const char *a, const char *b,
                                      lam_mesh_comparison *comparison);

/* Two PNG pictures. A pixel differs when a channel does by more than LAM_PIXEL_STEP of 255. */
enum { LAM_PIXEL_STEP = 4 };
typedef struct lam_picture_comparison {
  int width[2], height[2];
  uint64_t hash[2]; /* FNV-1a of size and decoded pixels: equal for the same picture */
  bool same_size;   /* what follows is meaningful then */
  double share;     /* of the pixels that differ, 0 to 1 */
  int largest;      /* difference of a channel, 0 to 255 */
  double psnr;      /* dB; infinite when equal */
} lam_picture_comparison;
/* mask: NULL, or where to write a picture with the differing pixels in red. */
LAM_API lam_status lam_compare_pictures(lam_session *session, const char *a, const char *b,
                                        const char *mask, lam_picture_comparison *comparison);

LAM_END_DECLS

#endif
