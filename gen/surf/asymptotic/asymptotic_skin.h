/* Smooth skins over nets whose mesh polylines are to become asymptotic curves: one bi-9 patch
 * per face. Patches that share an edge share its curve and the tangent planes along it, because
 * those are the osculating planes of the curve. For fab/parts/skin.c; the form over a grid
 * (lam_asymptotic_skin_make and _fit) is called by the tests alone and is for programs that have
 * tangents, curvatures and torsions, or want them from points. */
#ifndef LAM_SURF_ASYMPTOTIC_ASYMPTOTIC_SKIN_H
#define LAM_SURF_ASYMPTOTIC_ASYMPTOTIC_SKIN_H

#include "surf/asymptotic/asymptotic_quad.h"

/* A vertex where two asymptotic curves cross: along u (0) and along v (1). */
typedef struct lam_skin_vertex {
  lam_vec3 point;
  lam_vec3 tangent[2]; /* derivatives when every edge has the parameter length 1; not parallel */
  double curvature[2]; /* 1/m; positive where the curve bends towards the other tangent; may be 0 */
  double torsion;      /* 1/m, of the curve along u; that along v has the opposite one */
} lam_skin_vertex;

/* A face to be filled: its vertices at (u,v) = (0,0), (1,0), (1,1), (0,1), counterclockwise, and by
 * how many quarter turns (0 to 3) the tangents of each vertex are to be turned there so that they
 * point along u and v of the face: one turn makes the second tangent the first, and the opposite of
 * the first one the second. */
typedef struct lam_skin_cell {
  int vertex[4], turn[4];
} lam_skin_cell;

/* A vertex of a skin by its conormal nu = N / sqrt|tau| (m^(1/2)), N its normal and tau the torsion
 * of the asymptotic curves through it, and the derivatives of nu along u and v when every edge has
 * the parameter length 1. */
typedef struct lam_conormal_vertex {
  lam_vec3 point, conormal, slope[2];
} lam_conormal_vertex;

/* How the conormals of a skin were found. */
typedef struct lam_skin_fit {
  bool converged; /* every edge ends at its vertex to 1e-11 of the mean edge */
  int steps;
  double missed;      /* m: the largest distance of the end of an edge from its vertex */
  double tilt;        /* rad: the largest angle between a conormal and its start */
  int contradictions; /* edges of a net that has no torsion of one sign along a family */
  int made;           /* patches that do not fold over */
} lam_skin_fit;

/* One patch per cell. Cells that share two vertices share the curve between them; any number may
 * meet at a vertex. The curves have degree 7, are asymptotic curves of the patches, and may be
 * straight or bend to both sides. Conormals and slopes of the vertices are where the search starts,
 * to about a tenth, and are set to those that were found. Vertices in no cell are not used. Where a
 * patch would fold over its boundary, surface.points is NULL. */
lam_skin_fit lam_asymptotic_skin_fill(lam_arena *arena, int vertex_count,
                                      lam_conormal_vertex *vertices, int cell_count,
                                      const lam_skin_cell *cells, lam_asymptotic_patch *patches);
/* The patches over count[0] x count[1] vertices (v running fastest), (count[0] - 1) x (count[1] -
 * 1) of them in the same order. false, with an error, when some patch folds over its boundary or
 * tangents are parallel. */
bool lam_asymptotic_skin_make(lam_arena *arena, const int count[2], const lam_skin_vertex *vertices,
                              lam_location location, lam_errors *errors,
                              lam_asymptotic_patch *patches);

/* Chooses tangents, curvatures and torsions of all vertices, whose points are given (2 x 2 or
 * more), for the least sum of the integrals of |r'''|^2 over the edges: the tangent planes tilt a
 * little from the planes of the vertex stars of a discrete asymptotic net, until the curves are
 * calm. On coarse nets the border may curl, which nothing there holds. Gauss-Newton steps from
 * central differences. Returns the sum; start is that of the differences. NAN, with an error, when
 * the steps break down. */
double lam_asymptotic_skin_fit(lam_arena *arena, const int count[2], lam_skin_vertex *vertices,
                               lam_location location, lam_errors *errors, double *start);

/* For asymptotic_skin.c and skin_fit.c: the 8 control points of the edge between two vertices,
 * along u (family 0) or v (1). gram: 8 x 8, of the third derivatives of Bezier curves of degree
 * 7. */
enum { LAM_SKIN_DEGREE = 7, LAM_SKIN_POINTS = 8 };
void lam_skin_edge(lam_arena *arena, const double *gram, const lam_skin_vertex *from,
                   const lam_skin_vertex *to, int family, lam_vec3 points[LAM_SKIN_POINTS]);

#endif
