/* Constraints in the form of thesis 3.7: auxiliary unknowns (unit edges, lengths, normals, sphere
 * centers, ...), so that every equation is at most quadratic. The start of an auxiliary unknown is
 * computed from problem->x: set the vertices first. All blocks are hard, of weight 1. Lengths are
 * in solver units. Called by the constrain_thesis of kinds of nets (net/kinds), for the solver's
 * method `thesis`. */
#ifndef LAM_CON_THESIS_THESIS_H
#define LAM_CON_THESIS_THESIS_H

#include "con/constraint.h"

/* ---- thesis_planar.c ---- */

/* Thesis 3.6.2: a normal n at every inner vertex of any valence, n . (v_k - v) = 0 and n^2 = 1.
 * With border, the border vertices of three and more edges too. Vertices with more than 12 edges
 * are left out; the inner ones are added to scope->skipped. */
void lam_thesis_planar_stars(lam_scope *scope, bool border);

/* Thesis 3.1: a normal n in every face, n . (v_(k+1) - v_k) = 0 and n^2 = 1. */
void lam_thesis_planar_faces(lam_scope *scope);

/* ---- thesis_angle.c ---- */

/* Thesis eq. 3.2, with unit edges as in 3.7.1: e1 - e3 = a1 T1, e2 - e4 = a2 T2, T1^2 = T2^2 = 1,
 * T1 . T2 = cos(angle) at every regular star; with border, at reentrant corners too. angle:
 * radians. */
void lam_thesis_angle(lam_scope *scope, double angle, bool border);

/* ---- thesis_edges.c ---- */

/* Thesis 3.7.2: <e_u, e_v> = <e_u, e_-v> for both u-edges of every regular star; with border, for
 * the u-edge of border vertices at the ends of the u-lines too. family: the one that holds the
 * geodesics (u). */
void lam_thesis_geodesic_parallel(lam_scope *scope, int family, bool border);

/* ---- thesis_sphere.c ---- */

/* Thesis eq. 3.3: every regular star on a sphere or plane of its own, w_k = v_k^2,
 * a w_k + b . v_k + e = 0, b^2 - 4 a e = 1. */
void lam_thesis_spherical_stars(lam_scope *scope);
/* Right or other angles between the tangents of def. 10, t = E1 |E3|^2 - E3 |E1|^2, which exist on
 * planes too, at every regular star. angle: radians. */
void lam_thesis_circle_angle(lam_scope *scope, double angle);

/* ---- thesis_radius.c ---- */

/* Thesis 3.2.3, centers m as unknowns: (v_k - m)^2 = r^2 for the five vertices of every regular
 * star. radius: positive when the sphere lies on the side of the normal, 0: one unknown radius for
 * all, which starts at the mean of the net. With an angle, the tangents of def. 9 too: B = E1 x E3,
 * T = B x (v - m), U = a T, U^2 = 1, U1 . U2 = cos(angle). angle: radians; NAN: none. */
void lam_thesis_equal_spheres(lam_scope *scope, double radius, double angle);

/* ---- shared by the files thesis_*.c ---- */

/* Unknowns of all half-edges (thesis 3.7.1): the unit vector e from a vertex to a neighbor, and the
 * length w, with (v_j - v_i) - w e = 0 and (v_j - v_i)^2 - w^2 = 0. Two half-edges of four unknowns
 * per edge: 8 |E|. */
typedef struct lam_half_edges {
  const lam_net *net;
  int first;   /* node of the half-edge from v to its k-th neighbor: first + ring_start[v] + k */
  int *family; /* by ring position */
} lam_half_edges;
/* Adds the nodes and their block. family is owned by the problem's arena. */
lam_half_edges lam_half_edges_add(lam_scope *scope);
/* Position in net->ring of the half-edge. Precondition: there is such an edge. */
int lam_half_edge_find(const lam_half_edges *edges, int from, int to);
/* Adds U1 . U2 = cos(angle); tangents: count pairs of nodes that begin with the unit vectors U and
 * have four unknowns. angle: radians. */
void lam_thesis_crossing(lam_scope *scope, int count, const int *tangents, double angle);
/* Adds U - a T = 0 and U^2 - 1 = 0 with nodes T (3) and (U, a) (4) per element; makes a node (U, a)
 * for every node of tangents (count), from the values there. Returns these nodes, count of them,
 * owned by the problem's arena. */
int *lam_thesis_units(lam_scope *scope, int count, const int *tangents);
/* A node of three unknowns; returns its index. */
int lam_thesis_vector_node(lam_problem *problem, lam_vec3 start);
/* Positions of the vertices and unit normals there, vertex_count each, owned by the problem's
 * arena. */
void lam_thesis_normals(lam_scope *scope, lam_vec3 **positions, lam_vec3 **normals);

#endif
