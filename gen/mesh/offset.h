/* Offsets of circular and conical nets, and their Gauss images. Nothing here checks which of them a
 * net is: every function returns how well it fits. Used by fab/parts/support.c and
 * fab/parts/gauss_image.c, and measured by net/measures/cones_measures.c.
 *
 * positions: vertex_count of the net, in any unit. */
#ifndef LAM_MESH_OFFSET_H
#define LAM_MESH_OFFSET_H

#include "core/arena.h"
#include "mesh/net.h"

/* The faces around all vertices, parallel to net->ring: entry i is the face between neighbor
 * ring[i] and the next one counterclockwise; -1 after the last edge of a boundary vertex. Owned by
 * arena. */
int *lam_net_face_rings(lam_arena *arena, const lam_net *net);
/* Unit normals of the faces, perpendicular to both diagonals. normals: face_count. */
void lam_net_face_normals(const lam_net *net, const lam_vec3 *positions, lam_vec3 *normals);

/* Vertex offset of a circular net (thesis 3.5.1, definition 20): unit normals that are mirrored
 * into each other by the bisecting planes of the edges. All follow from one; that one is chosen so
 * that the sum of their products with the vertex normals of lam_net_normals is largest. The net of
 * positions + d normals has parallel edges, is circular, and every vertex has moved by d.
 *
 * normals  out: vertex_count
 *
 * Returns the largest mismatch |n_j - mirrored n_i| over the edges: 0 (rounding) on a circular net
 * without holes; round a hole the normals need not close up. Every connected piece is taken for
 * itself. */
double lam_net_mirrored_normals(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                                lam_vec3 *normals);

/* Face offset of a conical net (thesis 3.5.2): directions a along the axes of the cones with
 * n.a = 1 for the unit normals n of all faces around a vertex, so that positions + d axes has every
 * face plane moved by exactly d. Where the faces leave a choice (at the boundary, and where they
 * lie in one plane) the shortest a is taken.
 *
 * axes  out: vertex_count, of length 1 / cos(half the opening) and more than 1
 *
 * Returns the largest |n.a - 1|. Of a vertex with more than 64 faces the first 64 count. */
double lam_net_cone_axes(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                         lam_vec3 *axes);

/* The offset itself: positions + distance * directions, with normals or axes from above. out:
 * vertex_count, may be positions. For programs that use the library; the parts in fab offset single
 * vertices. */
void lam_net_offset(const lam_net *net, const lam_vec3 *positions, const lam_vec3 *directions,
                    double distance, lam_vec3 *out);

/* How far the quad between an edge and its offset is from flat: the sine of the angle between the
 * direction at the edge's second end and the plane of the edge and the direction at its first
 * end. directions: vertex_count. */
double lam_net_edge_twist(const lam_net *net, const lam_vec3 *positions, const lam_vec3 *directions,
                          int edge);

/* Gauss image of a net's faces: their normals as vertices on the unit sphere, in the order of the
 * faces, and a face for every inner vertex of valence 4, in the order of the vertices. The image of
 * a conical net is circular. Normals that belong to no such vertex are left out. (The Gauss image
 * of a net's vertices has the connectivity of the net, with the mirrored normals as vertices.)
 *
 * vertex_of_face  out: face_count, the vertex of a face in the image, or -1; may be NULL
 *
 * The image is owned by arena. */
lam_mesh lam_net_gauss_image(lam_arena *arena, const lam_net *net, const lam_vec3 *positions,
                             int *vertex_of_face);

#endif
