/* Exact questions about triangle meshes (CGAL behind a C face; the only file that includes CGAL is
 * solid_shim.cc). Every function catches everything and returns a status; no function keeps a
 * pointer to its input. Thread-safe. */
#ifndef LAM_CORE_SOLID_SOLID_H
#define LAM_CORE_SOLID_SOLID_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lam_solid_facts {
  int vertices, triangles;
  bool closed; /* every edge has exactly two triangles */
  bool
      oriented; /* neighbors agree, and a closed component's outside is outside (positive volume) */
  bool manifold; /* no edge with more than two triangles, no vertex with two fans */
  int boundary_edges, nonmanifold_edges;
  int components;
  int euler;               /* V - E + F */
  int genus;               /* sum over the components; -1 when not closed or not manifold */
  long self_intersections; /* pairs of triangles that meet outside their shared vertices and edges;
                              -1: not asked */
  double volume, area;     /* volume: 0 when not closed */
  lam_vec3 centroid;       /* of the volume (closed) or of the area */
  double inertia[6]; /* xx, yy, zz, xy, yz, zx about the centroid, density 1; 0 when not closed */
  lam_vec3 min, max;
} lam_solid_facts;

/* Measures a mesh. Vertices at the same coordinates must have been merged (lam_trimesh_weld). */
lam_status lam_solid_measure(const lam_trimesh *mesh, bool self_intersections,
                             lam_solid_facts *facts);

/* Closest points on a triangle mesh. */
typedef struct lam_tree lam_tree;
/* NULL on failure. Free with lam_tree_free (the signature fits lam_arena_defer). */
lam_tree *lam_tree_new(const lam_trimesh *mesh);
void lam_tree_free(void *tree);
/* The point of the mesh nearest to query, and the triangle it lies on. */
void lam_tree_closest(const lam_tree *tree, lam_vec3 query, lam_vec3 *closest, int *triangle);

/* Overlaps of closed solids. A set keeps exact search trees of the solids that were added. */
typedef struct lam_solid_set lam_solid_set;
lam_solid_set *lam_solid_set_new(void);
void lam_solid_set_free(void *set);
/* Adds a solid, placed by frame (NULL: where it stands). Returns its index in the set, or -1 on
 * failure. */
int lam_solid_set_add(lam_solid_set *set, const lam_trimesh *solid, const lam_pose *frame);
/* All pairs i < j whose bounding boxes overlap, in increasing order: *pairs is freed with free().
 */
lam_status lam_solid_set_candidates(const lam_solid_set *set, int (**pairs)[2], int *count);
/* The volume of the intersection of solids i and j. Exactly 0 when the surfaces do not meet and
 * neither contains the other (exact predicates); otherwise the volume of the exact boolean
 * intersection. Solids that touch without overlapping have volume 0. */
lam_status lam_solid_set_overlap(const lam_solid_set *set, int i, int j, double *volume);

/* Distance between two meshes: the largest distance from points sampled on one (vertices and an
 * even pattern on every triangle, spaced by at most `spacing`) to the other, both ways.
 * Deterministic. */
lam_status lam_solid_hausdorff(const lam_trimesh *a, const lam_trimesh *b, double spacing,
                               double *a_to_b, double *b_to_a);

#ifdef __cplusplus
}
#endif

#endif
