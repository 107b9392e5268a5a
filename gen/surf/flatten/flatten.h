/* Laying triangulated surfaces flat with edges as long as they are in space: exact for
 * developable surfaces, with the least sum of squared errors for others (Li & Deng,
 * Construction and application of approximate developable surfaces, eq. 5.1). Called by
 * texture.c, surf/developable, fab/parts/flat_pattern.c and
 * net/measures/distortion_measures.c. */
#ifndef LAM_SURF_FLATTEN_FLATTEN_H
#define LAM_SURF_FLATTEN_FLATTEN_H

#include "core/arena.h"
#include "core/model.h"

/* A disk of triangles. Edges run from the lower to the higher vertex. Arrays are kept by
 * pointer. */
typedef struct lam_flat_mesh {
  int vertex_count;
  const lam_vec3 *vertices;
  int triangle_count;
  const int (*triangles)[3]; /* counterclockwise on the side that faces up when it lies flat */
  int edge_count;
  const int (*edges)[2];
  const double *lengths; /* the wanted ones, m */
  const lam_vec2 *start; /* where the vertices lie at first: no triangle turned over */
} lam_flat_mesh;

/* What an edge in the plane shall be as long as. */
typedef enum lam_flat_length {
  LAM_FLAT_CHORDS, /* the edges of the triangles */
  /* The surface's own length over an edge: a chord L over normal curvature k stands for L (1 + k^2
   * L^2 / 24), to fourth order. A developable surface is then laid flat with an error of the fourth
   * power of the edges, not the square. */
  LAM_FLAT_GEODESICS
} lam_flat_length;

/* cells x cells squares of parameters of a spline surface, split by the diagonals
 * (i,j)-(i+1,j+1); vertex (i,j) has index i (cells + 1) + j, i along u. The start is the
 * rectangle with the mean lengths of opposite sides. Owned by the arena. */
lam_flat_mesh lam_flat_grid(lam_arena *arena, const lam_spline_surface *surface, int cells,
                            lam_flat_length length);

/* Any disk of triangles, with the unit normals of its vertices (NULL: chords). The start has
 * the boundary on a circle and every other vertex in the middle of its neighbors. Vertices and
 * triangles are kept by pointer; the rest is owned by the arena. false: the triangles form no
 * disk. */
bool lam_flat_disk(lam_arena *arena, int vertex_count, const lam_vec3 *vertices,
                   const lam_vec3 *normals, int triangle_count, const int (*triangles)[3],
                   lam_flat_mesh *mesh);

/* The vertices of the disk's boundary, counterclockwise, in an array of the arena; returns
 * their number, 0 when there is more than one loop. */
int lam_flat_boundary(lam_arena *arena, const lam_flat_mesh *mesh, int **loop);

/* A mesh in the plane, and how well its edges have the wanted lengths. */
typedef struct lam_flattening {
  const lam_vec2 *points; /* per vertex, m */
  double energy;          /* sum of (length - wanted length)^2, m^2 */

  /* Largest and root mean square of |length - wanted length| / wanted length. */
  double max_strain, rms_strain;
  int flips; /* triangles turned over */
  int iterations;
  bool converged;
} lam_flattening;

/* Unfolding, twenty steps of local rotations and one linear system (Liu et al., A local/global
 * approach to mesh parameterization, 2008), then Gauss-Newton on the energy. Points are owned
 * by the arena. */
lam_flattening lam_flatten(lam_arena *arena, const lam_flat_mesh *mesh);

/* Conjugate gradients from the start, as in the paper: for comparison with lam_flatten, in the
 * unit tests. */
lam_flattening lam_flatten_conjugate(lam_arena *arena, const lam_flat_mesh *mesh,
                                     int max_iterations);

/* Turns and moves points to lie on target as well as can be (least squares, no mirroring, no
 * scaling); returns the root mean square distance that remains. */
double lam_flat_align(int count, const lam_vec2 *target, lam_vec2 *points);

/* The singular values x >= y of the linear map that takes p to a and q to b: how much a small
 * circle there is drawn out along and across. Not finite when p and q are parallel. */
lam_vec2 lam_flat_stretch(lam_vec2 p, lam_vec2 q, lam_vec3 a, lam_vec3 b);

/* The same of every triangle, from the plane into space. stretch: triangle_count. */
void lam_flat_stretches(const lam_flat_mesh *mesh, const lam_vec2 *flat, lam_vec2 *stretch);

/* The ratio of the singular values of the map from a flat triangle to the one in space, >= 1:
 * how much a texture is drawn out. ratios: triangle_count, or NULL; returns the largest. */
double lam_flat_anisotropy(const lam_flat_mesh *mesh, const lam_vec2 *flat, double *ratios);

#endif
