/* The steps of an asymptotic quadrilateral, for the files of this folder only; see
 * asymptotic_quad.h. From bottom to top: corners.c (tables, checks), boundary_curve.c (curves),
 * boundary.c, quartic.c and rational.c (boundaries), tangents.c, patch.c, fair_patch.c and
 * rational_patch.c (surfaces), make_quad.c (chooses). */
#ifndef LAM_SURF_ASYMPTOTIC_QUAD_PARTS_H
#define LAM_SURF_ASYMPTOTIC_QUAD_PARTS_H

#include "curve/bspline/collocation.h"
#include "surf/asymptotic/asymptotic_quad.h"
#include "surf/spline/thin_plate.h"

/* Points of a boundary curve, in its own form or in that of the surface, at most. */
enum { LAM_QUAD_MAX_POINTS = 16 };

/* The end of another curve that meets end e of curve i. */
typedef struct lam_quad_end {
  int curve, end;
} lam_quad_end;
extern const lam_quad_end lam_quad_other[4][2];
/* The corner at end e of curve i. */
extern const int lam_quad_corner_of[4][2];
/* The ends that meet at a corner: of the curve along u, then of the curve along v. */
extern const lam_quad_end lam_quad_meeting[4][2];

/* The edge from the corner at an end of a curve to the control point next to it. */
static inline lam_vec3 lam_quad_edge(const lam_quad_curve *c, int end) {
  return lam_sub(c->points[end ? c->count - 2 : 1], c->points[end ? c->count - 1 : 0]);
}

/* What a form (lam_quad_form) is. */
typedef struct lam_quad_recipe {
  int degree;       /* of the boundary */
  int inner;        /* number of inner knots: 0 or 2 */
  int surface;      /* degree of the surface */
  int multiplicity; /* of the inner knots of the surface */
  bool free;        /* tangents of least energy; false: those of the thesis */
} lam_quad_recipe;
extern const lam_quad_recipe lam_quad_recipes[LAM_QUAD_FORM_COUNT];

/* Adds what is wrong with the corner data for the form; true when nothing is. */
bool lam_quad_corners_check(const lam_quad_corners *corners, lam_quad_form form,
                            lam_location location, lam_errors *errors);

/* Sets degree, knots and points of every curve: the first and the last two points from corners and
 * tangents; the others lie between, evenly. */
void lam_quad_boundary_start(lam_arena *arena, const lam_quad_corners *corners,
                             const lam_quad_recipe *recipe, lam_quad_boundary *boundary);

/* A Gauss rule for lam_quad_curve_bending: exact for the pieces of a polynomial curve, of 40 nodes
 * for a rational one. */
enum { LAM_QUAD_RULE_MAX = 40 };
typedef struct lam_quad_rule {
  int count;
  double nodes[LAM_QUAD_RULE_MAX], weights[LAM_QUAD_RULE_MAX];
} lam_quad_rule;
lam_quad_rule lam_quad_rule_make(const lam_quad_curve *curve);
/* Integral of |r''|^2 over the parameter, m^2. */
double lam_quad_curve_bending(const lam_quad_curve *curve, const lam_quad_rule *rule);
/* Fills slide, cross, curvature, torsion and energy from the curves. */
void lam_quad_boundary_measure(lam_quad_boundary *boundary);

/* The remaining points of a boundary that was started; false, with an error, when there are none.
 * Of least energy with given end curvatures: */
bool lam_quad_boundary_least(lam_arena *arena, const lam_quad_corners *corners,
                             lam_location location, lam_errors *errors,
                             lam_quad_boundary *boundary);
/* Quartics, whose end curvatures follow: */
bool lam_quad_boundary_quartic(lam_arena *arena, const lam_quad_corners *corners,
                               lam_location location, lam_errors *errors,
                               lam_quad_boundary *boundary);
/* Rational quartics with given end curvatures; weights are set, too: */
bool lam_quad_boundary_rational(lam_arena *arena, const lam_quad_corners *corners,
                                lam_location location, lam_errors *errors,
                                lam_quad_boundary *boundary);

/* For quartics, rational or not: the line point + s along on which the middle point of a curve
 * lies, with `along` as long as the chord; false when the end planes are parallel. */
bool lam_quad_middle_line(const lam_quad_boundary *boundary, int curve, lam_vec3 *point,
                          lam_vec3 *along);
/* The coordinate of that point along the other curve's edge at an end: cross[0] + s cross[1]. */
void lam_quad_middle_cross(const lam_quad_boundary *boundary, int curve, int end, lam_vec3 point,
                           lam_vec3 along, double cross[2]);
/* m.(far tangent point - corner), m = E_p x E_q at the corner with p along u and q along v, for
 * the corner at an end of a curve; m^3. */
double lam_quad_far_height(const lam_quad_boundary *boundary, int curve, int end);

/* Derivative across the boundary, T1 = x_v(u,0), T2 = x_u(0,v), T3 = x_v(u,1), T4 = x_u(1,v), at
 * any parameter. */
typedef struct lam_quad_tangents {
  const lam_quad_boundary *boundary;
  int x_degree, x_count; /* x is a spline of this degree over the breaks of the curve */
  const double *x_knots[4];
  double x[4][LAM_QUAD_MAX_POINTS]; /* x_count coefficients */
  double y[4][2];                   /* y is linear: its values at the ends */
  lam_vec3 hermite[4][4];           /* of straight curves: T(0), T'(0), T(1), T'(1) */
} lam_quad_tangents;
/* The tangents of the thesis for a boundary, which is kept by pointer. */
void lam_quad_tangents_make(lam_arena *arena, const lam_quad_boundary *boundary,
                            lam_quad_tangents *tangents);
/* T of a curve at t. */
lam_vec3 lam_quad_tangents_eval(const lam_quad_tangents *tangents, int curve, double t);

/* The spaces of the surface in u and v, and the boundary curves in them (zeros for rational
 * curves). */
typedef struct lam_quad_spaces {
  lam_collocation space[2];
  lam_vec3 *curve[4]; /* as many points as the space of their direction has */
} lam_quad_spaces;
void lam_quad_spaces_make(lam_arena *arena, const lam_quad_boundary *boundary,
                          const lam_quad_recipe *recipe, lam_quad_spaces *spaces);

/* ---- nets of points, count[0] x count[1] with v running fastest ---- */
/* The index of the k-th point along a curve, in the outer ring (0) or the second one (1). */
int lam_quad_ring_index(const lam_quad_spaces *spaces, int curve, int ring, int k);
/* A net with both rings, for tangents of zero; inner points 0. Owned by the arena. */
lam_vec3 *lam_quad_rings(lam_arena *arena, const lam_quad_spaces *spaces);
/* Adds tangents, given by their coefficients, to the second ring. The points in its corners belong
 * to r1 and r3. */
void lam_quad_ring_add(const lam_quad_spaces *spaces, int curve, const lam_vec3 *tangents,
                       lam_vec3 *net);
/* The thin-plate energy of nets over the spaces; false when it has no unique least value. */
bool lam_quad_plate(lam_arena *arena, const lam_quad_spaces *spaces, lam_thin_plate *plate);
/* Replaces the inner points of a net by those of least energy. */
void lam_quad_net_fill(lam_arena *arena, const lam_thin_plate *plate, lam_vec3 *net);
/* Half the gradient of the energy by the points of a net. */
lam_vec3 *lam_quad_net_gradient(lam_arena *arena, const lam_thin_plate *plate, const lam_vec3 *net);
/* The scalar product of two nets of `total` points. */
double lam_quad_net_product(int total, const lam_vec3 *a, const lam_vec3 *b);
/* The polynomial surface of a net, which is kept by pointer. */
void lam_quad_patch_finish(const lam_quad_spaces *spaces, const lam_vec3 *net,
                           lam_spline_surface *surface);

/* ---- the whole surface, over a boundary that may be patch->boundary; false: there is none ---- */
/* With the tangents of the thesis. */
bool lam_quad_patch_fixed(lam_arena *arena, const lam_quad_boundary *boundary,
                          const lam_quad_recipe *recipe, lam_asymptotic_patch *patch);
/* With tangents of least energy. */
bool lam_quad_patch_free(lam_arena *arena, const lam_quad_boundary *boundary,
                         const lam_quad_recipe *recipe, lam_location location, lam_errors *errors,
                         lam_asymptotic_patch *patch);
/* Rational, on a rational boundary. */
bool lam_quad_patch_rational(lam_arena *arena, const lam_quad_boundary *boundary,
                             const lam_quad_recipe *recipe, lam_location location,
                             lam_errors *errors, lam_asymptotic_patch *patch);

#endif
