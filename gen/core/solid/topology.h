/* How the triangles of a mesh hang together. Used by solid.c for its facts, by solid_shim.cc to
 * split solids into manifold components, and by fab/workshop.c. */
#ifndef LAM_CORE_SOLID_TOPOLOGY_H
#define LAM_CORE_SOLID_TOPOLOGY_H

#include "core/error.h"
#include "core/model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Counts and properties of the whole mesh. */
typedef struct lam_topology {
  int vertices; /* that triangles use */
  int edges, boundary_edges, nonmanifold_edges;
  bool closed;    /* every edge has exactly two triangles */
  bool oriented;  /* every edge inside is run through as often in one direction as in the other */
  int components; /* of triangles joined across edges, see below */
  int fans;       /* of triangles around vertices; as many as vertices when no vertex has two */
} lam_topology;

/* Joins triangles across edges. At an edge with more than two triangles, where as many run one
 * way as the other, the two that bound the same wedge of material are joined: solids that touch
 * along an edge or a face stay apart, and the result is a manifold whose vertices are the fans.
 *
 * component  per triangle: 0 to components - 1, in order of first appearance
 * fan        per corner: 0 to fans - 1, in order of first appearance
 *
 * Both arrays belong to the caller. LAM_BAD_INPUT: an index is out of range, a coordinate is not
 * finite, or a triangle uses a vertex twice. LAM_NO_MEMORY. Never jumps: C++ may call it. */
lam_status lam_topology_make(const lam_trimesh *mesh, int *component, int (*fan)[3],
                             lam_topology *topology);

#ifdef __cplusplus
}
#endif

#endif
