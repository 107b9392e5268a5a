/* Constraints: one kind per file; the list is con/constraints.c. A kind adds blocks of elements to
 * a problem and owns their kernel. The kinds of nets (net/kinds) are made of them, net/optimize.c
 * adds what guides and holds, and a design may list further ones. All lengths in a problem are in
 * units of the net's mean edge at the start. */
#ifndef LAM_CON_CONSTRAINT_H
#define LAM_CON_CONSTRAINT_H

#include "core/error.h"
#include "core/key.h"
#include "core/solid/solid.h"
#include "mesh/net.h"
#include "solve/problem.h"

/* What a constraint is put on. */
typedef struct lam_scope {
  lam_problem *problem;
  const lam_net *net;                /* connectivity; positions are those of problem->x */
  double unit;                       /* meters per solver unit */
  lam_vec3 origin;                   /* of positions, for places that keys name; meters */
  const lam_tree *reference;         /* NULL: none */
  const lam_trimesh *reference_mesh; /* in solver units */
  lam_errors *errors;
  long skipped; /* out: irregular vertices that a constraint on regular stars left out */
} lam_scope;

typedef struct lam_constraint_kind {
  lam_row_head head;
  /* Adds the blocks. params: the struct of head.keys, or NULL when it has none; kinds that take
   * lam_star_params, and fairness, accept NULL for their defaults. weight multiplies the residuals.
   * On wrong input adds to scope->errors, with the location, and no block. */
  void (*add)(lam_scope *scope, const void *params, double weight, lam_location location);
} lam_constraint_kind;

/* All kinds. */
extern const lam_registry lam_constraints;

/* ---- the kinds, each with its file and its parameters ---- */

/* Parameters of the constraints on stars that may reach the border, shared by planar-star,
 * orthogonal, opposite-angles and equal-angles. */
typedef struct lam_star_params {
  bool border;  /* vertices of the border take part; which ones, the kind says */
  int tangents; /* lam_tangents; of orthogonal only */
} lam_star_params;
extern const lam_key lam_star_keys[]; /* the key `border` of planar-star and equal-angles */

/* planar_star.c: every vertex in one plane with its neighbors. Takes lam_star_params. */
extern const lam_constraint_kind lam_con_planar_star;

/* planar_face.c: every quad is flat. */
extern const lam_constraint_kind lam_con_planar_face;

/* angle.c: the families cross at one angle, or (orthogonal, with lam_star_params) at 90 degrees.
 * Tangent of a polyline at a vertex: halfway between its unit edges, or of the circle through the
 * vertex and its two neighbors (thesis 3.2.3, def. 10). They agree where the two edges are equally
 * long. */
typedef enum lam_tangents { LAM_TANGENTS_BISECTOR, LAM_TANGENTS_CIRCLE } lam_tangents;
typedef struct lam_angle_params {
  double angle; /* radians */
  bool border;  /* reentrant corners of the border take part */
  int tangents; /* lam_tangents */
} lam_angle_params;
extern const lam_constraint_kind lam_con_angle, lam_con_orthogonal;

/* edge_length.c: edges of a length. */
typedef struct lam_edge_length_params {
  double length; /* meters; 0: every edge keeps its length at the start */
  bool boundary_only;
} lam_edge_length_params;
extern const lam_constraint_kind lam_con_edge_length;

/* boundary_length.c: every side of the boundary keeps its total length. */
extern const lam_constraint_kind lam_con_boundary_length;

/* fairness.c: small second differences along the polylines, of positions or of displacements. */
typedef enum lam_fair { LAM_FAIR_POSITION, LAM_FAIR_DISPLACEMENT } lam_fair;
typedef struct lam_fairness_params {
  int of; /* lam_fair */
} lam_fairness_params;
extern const char *const lam_fairness_choices[]; /* names of lam_fair, NULL-terminated */
extern const lam_constraint_kind lam_con_fairness;

/* closeness.c: vertices near where they start, or (handle) one vertex at a given position. */
typedef struct lam_handle_params {
  lam_list vertex; /* of int: the index comes first */
  double to[3];    /* meters */
} lam_handle_params;
extern const lam_constraint_kind lam_con_closeness, lam_con_handle;

/* proximity.c: vertices near the reference of the scope. */
extern const lam_constraint_kind lam_con_proximity;

/* glide.c: boundary vertices stay on the boundary curve of the start; corners become fixed. */
extern const lam_constraint_kind lam_con_glide;

/* opposite_edges.c: opposite edges of every quad are equally long. */
extern const lam_constraint_kind lam_con_opposite_edges;

/* spherical_star.c: every regular vertex on one sphere with its neighbors. */
typedef enum lam_spheres { LAM_SPHERES_OWN, LAM_SPHERES_COMMON } lam_spheres;
typedef struct lam_spherical_star_params {
  double radius; /* meters, signed: positive when the centers lie on the side of the normal;
                    INFINITY: planes; 0: it is found */
  int spheres;   /* lam_spheres, when the radius is found */
  bool border;   /* border vertices with one inner edge, and reentrant corners, take part */
} lam_spherical_star_params;
extern const lam_constraint_kind lam_con_spherical_star;

/* geodesic_parallel.c: one family of geodesics, the other at right angles to it. */
typedef struct lam_geodesic_params {
  int family;  /* of the geodesics, 0 or 1 */
  bool border; /* where geodesics end at the border they meet it at right angles too */
} lam_geodesic_params;
extern const lam_constraint_kind lam_con_geodesic_parallel;

/* opposite_angles.c: both families are geodesics. Takes lam_star_params. */
extern const lam_constraint_kind lam_con_opposite_angles;

/* equal_angles.c: both families are geodesics at right angles. Takes lam_star_params. */
extern const lam_constraint_kind lam_con_equal_angles;

/* equal_edges.c: the edges of a line have one length, on all lines of a family or on its middle
 * one. */
typedef enum lam_lines { LAM_LINES_ALL, LAM_LINES_MIDDLE } lam_lines;
typedef struct lam_equal_edges_params {
  int family; /* of the lines, 0 or 1 */
  int lines;  /* lam_lines */
} lam_equal_edges_params;
extern const lam_constraint_kind lam_con_equal_edges;

/* jacobi.c: the width of a strip between two geodesics changes linearly. */
typedef struct lam_family_params {
  int family; /* of the geodesics, 0 or 1 */
} lam_family_params;
extern const lam_constraint_kind lam_con_jacobi;

/* strip_widths.c: how the widths of the strips between geodesics go together. */
typedef enum lam_widths {
  LAM_WIDTHS_EQUAL,
  LAM_WIDTHS_PROPORTIONAL,
  LAM_WIDTHS_CONSTANT
} lam_widths;
typedef struct lam_strip_params {
  int family; /* of the lines along the strips, 0 or 1 */
  int widths; /* lam_widths */
} lam_strip_params;
extern const lam_constraint_kind lam_con_strip_widths;

/* circular.c, conical.c, isothermic.c, s_isothermic.c: discrete curvature lines. */
extern const lam_constraint_kind lam_con_circular, lam_con_conical, lam_con_isothermic,
    lam_con_s_isothermic;

/* ---- elements that several kinds are put on (elements.c) ---- */

/* Elements of all regular stars: nodes center, +u, +v, -u, -v (5 each). With border, reentrant
 * corners of the boundary (four edges) belong to them. Adds the irregular vertices to
 * scope->skipped. nodes: owned by the problem's arena. Returns the number of elements. */
int lam_scope_stars(lam_scope *scope, bool border, const int **nodes);
/* Border vertices with one inner edge: nodes center, then border, inner, border counterclockwise (4
 * each). nodes: owned by the problem's arena. Returns the number of elements. */
int lam_scope_half_stars(lam_scope *scope, const int **nodes);
/* The sides of the boundary, loop after loop: vertices from one corner (a boundary vertex with two
 * edges) to the next, both included. A loop without corners is one closed side. sides: owned by the
 * problem's arena. Returns their number. */
int lam_scope_sides(lam_scope *scope, const lam_polyline **sides);

/* A hard block of a kernel on the regular stars (nodes as above); border: reentrant corners of the
 * boundary take part. name: kept by pointer. */
void lam_star_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        bool border, double weight);
/* A hard block of a kernel on all faces, whose nodes are the four corners counterclockwise. */
void lam_face_block_add(lam_scope *scope, const char *name, lam_kernel kernel, int rows,
                        double weight);

/* ---- constraints on chosen vertices and edges, for programs rather than designs ---- */

/* A block that holds count chosen vertices at targets (solver units), closeness.c. vertices: kept
 * by pointer; targets are copied. */
void lam_closeness_add(lam_scope *scope, const char *name, lam_role role, double weight, int count,
                       const int *vertices, const lam_vec3 *targets);
/* Edges of the length that params ask for, edge_length.c. */
void lam_edge_length_add(lam_scope *scope, const char *name, lam_role role, double weight,
                         lam_edge_length_params params);

#endif
