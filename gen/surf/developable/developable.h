/* Surfaces over four boundary curves that are as developable as a tensor-product spline allows:
 * the inner control points minimize the L^p norm of the Gaussian curvature (Li & Deng,
 * Construction and application of approximate developable surfaces, sec. 2-4). Curvatures are in
 * 1/m^2, the norm is taken over the parameters, scaled to the unit square. Used by the kind of
 * surface in developable.c and by the benchmark. */
#ifndef LAM_SURF_DEVELOPABLE_DEVELOPABLE_H
#define LAM_SURF_DEVELOPABLE_DEVELOPABLE_H

#include "core/arena.h"
#include "core/model.h"

typedef enum lam_developable_method {
  LAM_DEVELOPABLE_NEWTON,       /* Levenberg-Marquardt, then Newton's method */
  LAM_DEVELOPABLE_TRUST_REGION, /* Li & Deng, algorithm 1 */
  LAM_DEVELOPABLE_QUASI_NEWTON, /* Li & Deng, algorithm 2 */
  LAM_DEVELOPABLE_MINIMAX,      /* the largest |K| is made least: Newton's method on ever higher
                                   powers, edges included */
} lam_developable_method;

typedef struct lam_developable_options {
  lam_developable_method method;
  double power;       /* p >= 2; above 2 the minima of smaller powers come first; not used by
                         MINIMAX */
  int points;         /* Gauss points per knot span and direction of the last steps; 0: chosen
                         from degree and spans */
  int max_iterations; /* of one power; 0: 500 */
} lam_developable_options;

typedef struct lam_developable_result {
  bool converged;
  const char *reason;          /* why it stopped; static text */
  int iterations, evaluations; /* accepted steps, and evaluations of the norm, over all powers */
  int escapes;                 /* saddle points that were left */
  double norm;                 /* ||K||_p by the rule that was minimized with; MINIMAX: the largest
                                  |K| of its nodes; 1/m^2 */
} lam_developable_result;

/* Moves the inner control points of surface from where they are, for instance those of a Coons
 * patch (surf/spline/coons_patch.h). Its weights are NULL, its knots sound. The boundary stays. The
 * points are replaced by an array of the arena. Algorithms 1 and 2 start from a unit matrix and
 * depend on the unit of length; Newton's method does not. Not converging is a result. */
lam_developable_result lam_developable_solve(lam_arena *arena, lam_spline_surface *surface,
                                             lam_developable_options options);

/* What a surface over a boundary has, measured on the surface alone. */
typedef struct lam_developable_measures {
  double l2;           /* ||K||_2 by `points` Gauss points per span and direction, 1/m^2 */
  double max, mean;    /* of |K| on a grid with the edges, 1/m^2 */
  double corner_bound; /* No surface over this boundary has a smaller max |K|: L and N at a corner
                          are fixed by the boundary, and K = (LN - M^2)/(EG - F^2) <=
                          LN/(EG - F^2). 0: the corners set no bound */
  double area;         /* m^2 */
  double least_ratio;  /* least |x_u x x_v| / greatest, on the grid: 0 is a singular point */
} lam_developable_measures;

/* Measures a surface: points per span and direction for l2 and area, (grid + 1)^2 points of the
 * domain for the rest. Scratch memory is given back to the arena. */
lam_developable_measures lam_developable_measure(lam_arena *arena,
                                                 const lam_spline_surface *surface, int points,
                                                 int grid);
/* The corner bound alone, 1/m^2. */
double lam_developable_bound(lam_arena *arena, const lam_spline_surface *surface);

#endif
