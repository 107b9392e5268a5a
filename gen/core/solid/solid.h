/* Exact questions about triangle meshes: facts of a solid (solid.c), closest points and overlaps
 * (CGAL behind a C face; the only file that includes CGAL is solid_shim.cc), distances
 * (distance.c). Used by the checks of fab, the measures of nets, con/proximity.c, and library.
 * Every function catches everything and returns a status; no function keeps a pointer to its
 * input. Thread-safe. */
#ifndef LAM_CORE_SOLID_SOLID_H
#define LAM_CORE_SOLID_SOLID_H

#include "core/error.h"
#include "core/model.h"
#include <lamella/solid.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Measures a mesh. Vertices at the same coordinates must have been merged (lam_trimesh_weld).
 * self_intersections: whether to look for them, which takes the longest. LAM_BAD_INPUT: an index
 * out of range, a coordinate that is not finite, a triangle that uses a vertex twice.
 * LAM_NO_MEMORY, LAM_FAILED. */
lam_status lam_solid_measure(const lam_trimesh *mesh, bool self_intersections,
                             lam_solid_facts *facts);

/* Closest points on a triangle mesh. */
typedef struct lam_tree lam_tree;
/* A search tree of a copy of the mesh. NULL on failure, with *status (which may be NULL):
 * LAM_BAD_INPUT: bad indices or coordinates, or no triangle with an area; LAM_NO_MEMORY,
 * LAM_FAILED. Free with lam_tree_free (the signature fits lam_arena_defer; NULL is allowed). */
lam_tree *lam_tree_new(const lam_trimesh *mesh, lam_status *status);
void lam_tree_free(void *tree);
/* The point of the mesh nearest to query, and the index of the triangle it lies on. On failure (a
 * query that is not finite, or no memory for exact numbers), the point is the query and the
 * triangle -1. */
void lam_tree_closest(const lam_tree *tree, lam_vec3 query, lam_vec3 *closest, int *triangle);
/* Whether memory ran out in one of the calls of lam_tree_closest: asked once after many of them.
 * NULL has not. */
bool lam_tree_ran_out(const lam_tree *tree);

/* Overlaps of closed solids. A set keeps exact search trees of the solids that were added. */
typedef struct lam_solid_set lam_solid_set;
/* An empty set, or NULL without memory. Free with lam_solid_set_free (NULL is allowed). */
lam_solid_set *lam_solid_set_new(void);
void lam_solid_set_free(void *set);
/* Adds a copy of a solid, placed by frame (NULL: where it stands). Returns its index in the set,
 * -1 when it is not closed and oriented or encloses no volume, -2 without memory. */
int lam_solid_set_add(lam_solid_set *set, const lam_trimesh *solid, const lam_pose *frame);
/* All pairs i < j whose bounding boxes overlap, in increasing order: (*pairs)[0 .. *count - 1],
 * freed by the caller with free(). LAM_NO_MEMORY, LAM_FAILED; *pairs is NULL then. */
lam_status lam_solid_set_candidates(const lam_solid_set *set, int (**pairs)[2], int *count);
/* The volume (m^3) of the intersection of solids i and j of the set. Exactly 0 when the surfaces
 * do not meet and neither contains the other (exact predicates); otherwise the volume of the
 * exact boolean intersection, or the integral of prism.h where that is refused or takes too long.
 * Solids that touch without overlapping have volume 0. LAM_BAD_INPUT: an index out of range, or i
 * == j. LAM_NO_MEMORY, LAM_FAILED; the volume is 0 then. */
lam_status lam_solid_set_overlap(const lam_solid_set *set, int i, int j, double *volume);

/* Distances (m) between two meshes: the largest distance from points sampled on one (vertices and
 * an even pattern on every triangle, spaced by at most `spacing`) to the other, both ways.
 * Deterministic. LAM_BAD_INPUT: spacing is not positive. LAM_FAILED: a mesh is refused by
 * lam_tree_new. LAM_NO_MEMORY. The distances are meaningful only with LAM_OK. */
lam_status lam_solid_hausdorff(const lam_trimesh *a, const lam_trimesh *b, double spacing,
                               double *a_to_b, double *b_to_a);

#ifdef __cplusplus
}
#endif

#endif
