/* Surfaces over four boundary curves that are as developable as a tensor-product spline allows: the
 * inner control points minimize the L^p norm of the Gaussian curvature (Li & Deng, Construction and
 * application of approximate developable surfaces, sec. 2-4). Curvatures are in 1/m^2, the norm is
 * taken over the parameters, scaled to the unit square. */
#ifndef LAM_SURF_DEVELOPABLE_DEVELOPABLE_H
#define LAM_SURF_DEVELOPABLE_DEVELOPABLE_H

#include "core/arena.h"
#include "core/model.h"

typedef enum lam_developable_method {
  LAM_DEVELOPABLE_NEWTON, /* Levenberg-Marquardt, then Newton's method on the p-th power of the norm
                           */
  LAM_DEVELOPABLE_TRUST_REGION, /* Li & Deng, algorithm 1 */
  LAM_DEVELOPABLE_QUASI_NEWTON, /* Li & Deng, algorithm 2 */
  LAM_DEVELOPABLE_MINIMAX, /* the largest |K| is made least: Newton's method on ever higher powers,
                              edges included */
} lam_developable_method;

typedef struct lam_developable_options {
  lam_developable_method method;
  double power; /* p >= 2; above 2 the minima of smaller powers come first; not used by MINIMAX */
  int points;   /* Gauss points per knot span and direction of the last steps; 0: chosen from degree
                   and spans */
  int max_iterations; /* of one power; 0: 500 */
} lam_developable_options;

typedef struct lam_developable_result {
  bool converged;
  const char *reason;
  int iterations, evaluations; /* accepted and tried steps, over all powers */
  int escapes;                 /* saddle points that were left */
  double norm; /* ||K||_p by the rule that was minimized with; MINIMAX: the largest |K| of its
                  places */
} lam_developable_result;

/* Moves the inner control points of surface, for instance a Coons patch (surf/coons_patch.h;
 * weights NULL, knots sound) from where they are. Algorithms 1 and 2 start from a unit matrix and
 * depend on the unit of length; Newton's method does not. The boundary stays. The points are
 * replaced by an array of the arena. Not converging is a result. */
lam_developable_result lam_developable_solve(lam_arena *arena, lam_spline_surface *surface,
                                             lam_developable_options options);

/* What a surface over a boundary has, measured on the surface alone. */
typedef struct lam_developable_measures {
  double l2;        /* ||K||_2 by `points` Gauss points per span and direction */
  double max, mean; /* of |K| on a grid with the edges */
  double
      corner_bound; /* No surface over this boundary has a smaller max|K|: L and N at a corner are
                       fixed by the boundary, and K = (LN - M^2)/(EG - F^2) <= LN/(EG - F^2) */
  double area;
  double least_ratio; /* least |x_u x x_v| / greatest, on the grid: 0 is a singular point */
} lam_developable_measures;
lam_developable_measures lam_developable_measure(lam_arena *arena,
                                                 const lam_spline_surface *surface, int points,
                                                 int grid);
/* The corner bound alone. */
double lam_developable_bound(lam_arena *arena, const lam_spline_surface *surface);

#endif
