/* What the files of approximately developable surfaces share. The folder from bottom to top:
 * bending.c (K and its derivatives), curvature_norm.c (the norm), developing.c (steps of all
 * methods), developable_newton.c and developable_paper.c (methods), minimax.c (by Newton's
 * method), developable_solve.c (chooses), developable.c (the kind of surface). */
#ifndef LAM_SURF_DEVELOPABLE_DEVELOPABLE_PARTS_H
#define LAM_SURF_DEVELOPABLE_DEVELOPABLE_PARTS_H

#include "surf/developable/developable.h"

enum { LAM_TANGENTS = 5, LAM_GAUSS_VARIABLES = 15 };

/* The Gaussian curvature K (1/m^2) as a function of d = x_u, x_v, x_uu, x_uv, x_vv, in this order.
 *
 * stretch  set to |x_u x x_v|, which must not be 0
 * first    5: gradient of K; may be NULL
 * second   15 x 15: Hessian of K, both triangles; may be NULL
 *
 * Returns K. */
double lam_gauss_derivatives(const lam_vec3 d[LAM_TANGENTS], double *stretch, lam_vec3 *first,
                             double *second);

/* The norm as a function of the inner control points, with everything computed that stays the same.
 * The arrays belong to the arena. */
typedef struct lam_gauss_norm {
  int unknowns;          /* three per inner point */
  int nodes;             /* of the quadrature */
  const double *weights; /* nodes; those of lam_gauss_norm_make add up to 1 */
  int arity;             /* control points that act at a node */
  const int *points;     /* nodes x arity: their numbers in the net */
  const double *basis;   /* nodes x arity x 5: derivatives of the basis functions in the order of
                            the tangents */
  const int *unknown;    /* first unknown of a control point, -1 on the boundary */
  double *local;         /* room for the kernel: one evaluation at a time */
} lam_gauss_norm;

/* The norm by Gauss's rule with count points per span and direction. Only knots, degrees and counts
 * of the surface are read. */
lam_gauss_norm lam_gauss_norm_make(lam_arena *arena, const lam_spline_surface *surface, int count);

/* The norm over count >= 2 nodes per span and direction, denser towards its ends, with the edges
 * and all with the same weight: for the largest value, which often stands at an edge.
 *
 * x      control points, or NULL: all nodes are taken
 * share  with x only the nodes are taken where |K| at x is at least this share of its largest
 *        value: the others do not matter to a high power near x */
lam_gauss_norm lam_gauss_norm_closed(lam_arena *arena, const lam_spline_surface *surface, int count,
                                     const lam_vec3 *x, double share);

/* The norm over the nodes of both, which are norms of one surface. */
lam_gauss_norm lam_gauss_norm_join(lam_arena *arena, const lam_gauss_norm *a,
                                   const lam_gauss_norm *b);

/* What an evaluation computes; each includes those before it. */
typedef enum lam_order {
  LAM_ORDER_VALUE,
  LAM_ORDER_GRADIENT,
  LAM_ORDER_GAUSS_NEWTON, /* Hessian without the second derivatives of K */
  LAM_ORDER_NEWTON        /* exact Hessian */
} lam_order;

typedef struct lam_gauss_value {
  double power; /* sum of weight |K/scale|^p */
  double scale; /* as given */
  double max;   /* |K|, 1/m^2 */
  double area;  /* of the surface over that of its domain */
  double ratio; /* least |x_u x x_v| / greatest; 0 where the surface is singular */
} lam_gauss_value;

/* The p-th power of the norm of K/scale, p >= 2.
 *
 * x         all control points, those of the boundary included
 * gradient  unknowns; not used by LAM_ORDER_VALUE, may be NULL then
 * hessian   unknowns^2, the lower triangle is set; used from LAM_ORDER_GAUSS_NEWTON on */
lam_gauss_value lam_gauss_norm_eval(const lam_gauss_norm *norm, const lam_vec3 *x, double p,
                                    double scale, lam_order order, double *gradient,
                                    double *hessian);

/* The state of a minimization. */
typedef struct lam_developing {
  lam_arena *arena;
  const lam_gauss_norm *norm; /* what is minimized */
  int total;                  /* control points */
  lam_vec3 *x, *trial;        /* total: where the surface is, and where a step would take it */
  double size;                /* of the start: the diagonal of the box of its points, m */
  double area;                /* of the start */
  double power, scale;        /* p, and what K is divided by, 1/m^2 */
  bool logarithm;             /* the logarithm of the norm is minimized, not its p-th power */
  int max_iterations;
  lam_developable_result *result; /* counts, verdict and reason */
} lam_developing;

/* ---- steps that the methods share (developing.c) ---- */
/* Sets trial to x, moved by step (norm->unknowns numbers) at the inner points. */
void lam_developing_try(const lam_developing *d, const double *step);
/* The trial becomes x; what x was is lost with the next trial. */
void lam_developing_accept(lam_developing *d);
/* Whether a trial of this value is a surface to go on with: neither singular nor blown up. */
bool lam_developing_sound(const lam_developing *d, const lam_gauss_value *value);
/* Sets the scale to the largest |K| of x; false when the surface is developable to rounding. */
bool lam_developing_curved(lam_developing *d);
/* Spans of the direction that has more. */
int lam_spline_spans(const lam_spline_surface *surface);
/* Nodes per span: `each`, but never less than 2 degree + 4. */
int lam_developing_nodes(const lam_spline_surface *surface, int each);

/* ---- methods ---- */
/* Minimizes from d->x by Newton's method, the first gauss_newton_steps without the second
 * derivatives of K. Sets converged and reason of the result and adds to its counts. */
void lam_developable_newton(lam_developing *d, int gauss_newton_steps);
/* The same by algorithm 1 of Li & Deng (trust_region) or by algorithm 2. */
void lam_developable_paper(lam_developing *d, bool trust_region);
/* Makes the largest |K| least, from d->x. surface: for its knots and boundary. Sets result->norm,
 * too, to the largest |K| that was reached. */
void lam_developable_minimax(lam_developing *d, const lam_spline_surface *surface);

#endif
