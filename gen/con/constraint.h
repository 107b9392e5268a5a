/* Constraints: one kind per file; the list is con/registry.c. A kind adds blocks of elements to a
 * problem and owns their kernel. All lengths in a problem are in units of the net's mean edge at
 * the start. */
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
  const lam_tree *reference;         /* NULL: none */
  const lam_trimesh *reference_mesh; /* in solver units */
  lam_errors *errors;
  long skipped; /* out: irregular vertices that a constraint on regular stars left out */
} lam_scope;

typedef struct lam_constraint_kind {
  lam_row_head head;
  /* Adds the blocks. params: the struct of head.keys, or NULL when it has none. weight multiplies
   * the residuals. On wrong input adds to scope->errors. */
  void (*add)(lam_scope *scope, const void *params, double weight, lam_location location);
} lam_constraint_kind;

extern const lam_registry lam_constraints;

/* The kinds, for nets that are made of them. */
extern const lam_constraint_kind lam_con_planar_star, lam_con_planar_face, lam_con_orthogonal,
    lam_con_angle, lam_con_fairness, lam_con_closeness, lam_con_handle, lam_con_proximity,
    lam_con_edge_length, lam_con_boundary_length, lam_con_glide;
extern const lam_constraint_kind lam_con_opposite_edges, lam_con_spherical_star;
extern const lam_constraint_kind lam_con_geodesic_parallel, lam_con_opposite_angles,
    lam_con_equal_angles, lam_con_equal_edges, lam_con_jacobi, lam_con_strip_widths;
extern const lam_constraint_kind lam_con_circular, lam_con_conical, lam_con_isothermic,
    lam_con_s_isothermic;

/* Tangent of a polyline at a vertex: halfway between its unit edges, or of the circle through the
 * vertex and its two neighbors (thesis 3.2.3, def. 10). They agree where the two edges are equally
 * long. */
typedef enum lam_tangents { LAM_TANGENTS_BISECTOR, LAM_TANGENTS_CIRCLE } lam_tangents;
typedef struct lam_star_params {
  bool border;
  int tangents; /* lam_tangents; of angles only */
} lam_star_params;
typedef struct lam_angle_params {
  double angle;
  bool border;
  int tangents; /* lam_tangents */
} lam_angle_params;
typedef enum lam_spheres { LAM_SPHERES_OWN, LAM_SPHERES_COMMON } lam_spheres;
typedef struct lam_spherical_star_params {
  double radius; /* meters, signed: positive when the centers lie on the side of the normal;
                    INFINITY: planes; 0: it is found */
  int spheres;   /* lam_spheres, when the radius is found */
} lam_spherical_star_params;
extern const lam_key lam_star_keys[]; /* of lam_star_params */
typedef struct lam_edge_length_params {
  double length; /* meters; 0: every edge keeps its length at the start */
  bool boundary_only;
} lam_edge_length_params;
typedef struct lam_family_params {
  int family;
} lam_family_params;
typedef struct lam_geodesic_params {
  int family; /* of the geodesics */
  bool border;
} lam_geodesic_params;
typedef enum lam_lines { LAM_LINES_ALL, LAM_LINES_MIDDLE } lam_lines;
typedef struct lam_equal_edges_params {
  int family;
  int lines; /* lam_lines */
} lam_equal_edges_params;
typedef enum lam_widths {
  LAM_WIDTHS_EQUAL,
  LAM_WIDTHS_PROPORTIONAL,
  LAM_WIDTHS_CONSTANT
} lam_widths;
typedef struct lam_strip_params {
  int family; /* of the lines along the strips */
  int widths; /* lam_widths */
} lam_strip_params;
typedef enum lam_fair { LAM_FAIR_POSITION, LAM_FAIR_DISPLACEMENT } lam_fair;
extern const char *const lam_fairness_choices[]; /* names of lam_fair, NULL-terminated */
typedef struct lam_fairness_params {
  int of; /* lam_fair */
} lam_fairness_params;
typedef struct lam_handle_params {
  lam_list vertex; /* of int: the index comes first */
  double to[3];    /* meters */
} lam_handle_params;

/* Elements of all regular stars: nodes center, +u, +v, -u, -v (5 each). With border, reentrant
 * corners of the boundary (four edges) belong to them. Counts irregular vertices in scope->skipped.
 */
int lam_scope_stars(lam_scope *scope, bool border, const int **nodes);
/* Border vertices with one inner edge: nodes center, then border, inner, border counterclockwise (4
 * each). */
int lam_scope_half_stars(lam_scope *scope, const int **nodes);
/* A closeness block of chosen vertices to chosen targets (solver units). */
void lam_closeness_add(lam_scope *scope, const char *name, lam_role role, double weight, int count,
                       const int *vertices, const lam_vec3 *targets);
/* Edges of the length that params ask for. */
void lam_edge_length_add(lam_scope *scope, const char *name, lam_role role, double weight,
                         lam_edge_length_params params);
/* Vertices glide on straight lines through point along direction (solver units). */
void lam_glide_add(lam_scope *scope, double weight, int count, const int *vertices,
                   const lam_vec3 *points, const lam_vec3 *directions);

#endif
