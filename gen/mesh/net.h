/* Quad nets: a mesh with its connectivity. Any topology: open, closed in one or both directions,
 * several boundaries, irregular vertices. Built once; positions may change afterwards. Everything
 * above works on it: con, net, fab and design. Positions are in meters, or in the solver's unit
 * where con and solve pass their own. */
#ifndef LAM_MESH_NET_H
#define LAM_MESH_NET_H

#include "core/error.h"
#include "core/model.h"

/* A regular interior vertex (valence 4) with its neighbors in the order +u, +v, -u, -v:
 * counterclockwise around the normal. Family 0 runs along u, family 1 along v. */
typedef struct lam_star {
  int center;
  int neighbor[4];
} lam_star;

typedef struct lam_edge {
  int vertex[2];
  int face[2]; /* left and right of vertex[0] -> vertex[1]; -1 outside */
  int family;  /* 0 or 1 */
} lam_edge;

typedef struct lam_net {
  lam_mesh mesh; /* positions are the net's own copy */
  int edge_count;
  lam_edge *edges;
  int star_count;
  lam_star *stars;     /* in the order of their centers */
  int *star_of_vertex; /* index into stars, or -1 */
  bool *boundary;      /* per vertex */
  /* One-rings of all vertices in compressed form, counterclockwise: the neighbors of v are
   * ring[ring_start[v] .. ring_start[v+1]-1]; on the boundary from the first boundary edge to the
   * last. */
  int *ring_start, *ring;
  /* Polylines through regular vertices (opposite edges of a star continue each other), ends at the
   * boundary or at irregular vertices; through a reentrant corner of the boundary lines run on.
   * Boundary lines belong to them too where they follow a family. */
  int polyline_count;
  lam_polyline *polylines;
  int loop_count;
  lam_polyline *loops;  /* boundary loops, the surface on their left */
  int irregular_count;  /* interior vertices of valence other than 4 */
  int family_conflicts; /* edges at which the two-coloring of families cannot be continued (0 on
                           all even nets) */
} lam_net;

/* Builds connectivity. The mesh is copied; the net is owned by arena. Errors (non-manifold edges,
 * triangles, inconsistent orientation, repeated vertices in a face, unused vertices) are added to
 * errors with the location; returns false then, and net must not be used. */
bool lam_net_build(lam_arena *arena, const lam_mesh *mesh, lam_location location,
                   lam_errors *errors, lam_net *net);

/* A rectangular grid of n x m vertices, vertex (i,j) at index i * m + j, i along family 0; closed
 * in either direction when asked (then the last row is joined to the first: pass each vertex
 * once). Positions are zero. Precondition: n, m >= 2, and >= 3 where closed. Owned by arena. */
lam_mesh lam_mesh_grid(lam_arena *arena, int n, int m, bool closed_u, bool closed_v);

/* The number of edges at vertex v. A boundary vertex has one face less than edges. */
static inline int lam_net_valence(const lam_net *net, int v) {
  return net->ring_start[v + 1] - net->ring_start[v];
}

/* Whether the edge joins vertices a and b, in either direction. */
static inline bool lam_edge_joins(const lam_edge *edge, int a, int b) {
  return (edge->vertex[0] == a && edge->vertex[1] == b) ||
         (edge->vertex[0] == b && edge->vertex[1] == a);
}

/* Unit normal of every vertex, from positions alone: the sum over the one-ring of e_k x e_{k+1}
 * (unit edges). At a planar star this is exactly the normal of its plane up to rounding.
 * positions, normals: vertex_count each. */
void lam_net_normals(const lam_net *net, const lam_vec3 *positions, lam_vec3 *normals);
/* Mean length of the edges, in the unit of positions (vertex_count); 0 without edges. */
double lam_net_mean_edge(const lam_net *net, const lam_vec3 *positions);

/* Catmull-Clark subdivision (Catmull & Clark 1978): new vertices in the order vertices, edges,
 * faces of net. Border vertices follow the cubic B-spline rule, corners stay. Part of the surface
 * kernel for programs that use the library. Owned by arena. */
lam_mesh lam_net_catmull_clark(lam_arena *arena, const lam_net *net);
/* Interpolating subdivision along polylines (the 4-point rule; 3-point at ends), midpoints of
 * faces from both families averaged. Old vertices keep their index and position; new ones follow
 * in the order edges, faces. Owned by arena. */
lam_mesh lam_net_four_point(lam_arena *arena, const lam_net *net);

#endif
