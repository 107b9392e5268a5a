/* What solid.c asks of solid_shim.cc. */
#ifndef LAM_CORE_SOLID_SOLID_EXACT_H
#define LAM_CORE_SOLID_SOLID_EXACT_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The number of pairs of triangles that meet outside their shared vertices and edges. Exact; the
 * mesh may be open and need not be a manifold. Triangles without area are left out: their edges
 * belong to their neighbors. */
lam_status lam_solid_self_intersections(const lam_trimesh *mesh, long *count);

#ifdef __cplusplus
}
#endif

#endif
