/* What the files of approximately developable surfaces share. */
#ifndef LAM_SURF_DEVELOPABLE_DEVELOPABLE_PARTS_H
#define LAM_SURF_DEVELOPABLE_DEVELOPABLE_PARTS_H

#include "surf/developable/developable.h"

enum { LAM_TANGENTS = 5, LAM_GAUSS_VARIABLES = 15 };

/* The Gaussian curvature as a function of x_u, x_v, x_uu, x_uv, x_vv, in this order. first[5]: its
 * gradient; second: its 15 x 15 Hessian, both triangles; either may be NULL. Returns K; *stretch is
 * |x_u x x_v|. */
double lam_gauss_derivatives(const lam_vec3 d[LAM_TANGENTS], double *stretch, lam_vec3 *first,
                             double *second);

/* The norm as a function of the inner control points, with everything computed that stays the same.
 */
typedef struct lam_gauss_norm {
  int unknowns;          /* three per inner point */
  int places;            /* of the quadrature */
  const double *weights; /* places */
  int arity;             /* control points that act at a place */
  const int *points;     /* places x arity */
  const double *basis; /* places x arity x 5: derivatives of the basis functions in the order of the
                          tangents */
  const int *unknown;  /* first unknown of a control point, -1 on the boundary */
  double *local;       /* room for the kernel */
} lam_gauss_norm;

/* count points per span and direction by Gauss's rule. */
lam_gauss_norm lam_gauss_norm_make(lam_arena *arena, const lam_spline_surface *surface, int count);
/* count >= 2 places per span and direction, denser towards its ends, with the edges and all with
 * the same weight: for the largest value, which often stands at an edge. With x only those where
 * |K| at these control points is at least the share of its largest value: the others do not matter
 * to a high power near them. NULL: all. */
lam_gauss_norm lam_gauss_norm_closed(lam_arena *arena, const lam_spline_surface *surface, int count,
                                     const lam_vec3 *x, double share);

/* The places of both, of one surface. */
lam_gauss_norm lam_gauss_norm_join(lam_arena *arena, const lam_gauss_norm *a,
                                   const lam_gauss_norm *b);

typedef enum lam_order {
  LAM_ORDER_VALUE,
  LAM_ORDER_GRADIENT,
  LAM_ORDER_GAUSS_NEWTON,
  LAM_ORDER_NEWTON
} lam_order;

typedef struct lam_gauss_value {
  double power; /* sum of weight |K/scale|^p */
  double scale; /* as given */
  double max;   /* |K| */
  double area;
  double ratio; /* least |x_u x x_v| / greatest; 0 where the surface is singular */
} lam_gauss_value;

/* The p-th power of the norm of K/scale at control points x, with gradient[unknowns] and the lower
 * triangle of hessian[unknowns^2] as far as order asks. Gauss-Newton leaves out the second
 * derivatives of K. */
lam_gauss_value lam_gauss_norm_eval(const lam_gauss_norm *norm, const lam_vec3 *x, double p,
                                    double scale, lam_order order, double *gradient,
                                    double *hessian);

/* The state of a minimization. */
typedef struct lam_developing {
  lam_arena *arena;
  const lam_gauss_norm *norm;
  int total; /* control points */
  lam_vec3 *x, *trial;
  double size; /* of the boundary: the diagonal of its box */
  double area; /* of the start */
  double power, scale;
  bool logarithm; /* of the norm is minimized, not its p-th power */
  int max_iterations;
  lam_developable_result *result;
} lam_developing;

/* x + step at the unknowns goes to trial. */
void lam_developing_try(const lam_developing *d, const double *step);
/* Whether a trial is a surface to go on with: neither singular nor blown up. */
bool lam_developing_sound(const lam_developing *d, const lam_gauss_value *value);

/* Sets the scale to the largest |K|; false when the surface is developable to rounding. */
bool lam_developing_curved(lam_developing *d);

/* Minimize from d->x. Both set result->converged and reason and add to its counts. */
void lam_developable_newton(lam_developing *d, int gauss_newton_steps);
void lam_developable_paper(lam_developing *d, bool trust_region);
/* Makes the largest |K| least. surface: for its knots and boundary. Sets result->norm too. */
void lam_developable_minimax(lam_developing *d, const lam_spline_surface *surface);

/* Spans of the direction that has more. */
int lam_spline_spans(const lam_spline_surface *surface);

#endif
