/* What solid.c asks of solid_shim.cc: the question about a solid that needs exact predicates. */
#ifndef LAM_CORE_SOLID_SOLID_EXACT_H
#define LAM_CORE_SOLID_SOLID_EXACT_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { LAM_SOLID_MOST_PAIRS = 5000000 };

/* The number of pairs of triangles that meet outside their shared vertices and edges. Exact; the
 * mesh may be open and need not be a manifold. Triangles without area are left out: their edges
 * belong to their neighbors. -1 when nobody would wait for the end: more pairs than
 * LAM_SOLID_MOST_PAIRS and 200 for each triangle have boxes that overlap. LAM_BAD_INPUT: an index
 * out of range or a coordinate that is not finite. LAM_NO_MEMORY, LAM_FAILED. */
lam_status lam_solid_self_intersections(const lam_trimesh *mesh, long *count);

#ifdef __cplusplus
}
#endif

#endif
