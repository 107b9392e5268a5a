/* Surfaces of least area on given boundaries, for the kind of surface in least_area.c, the
 * benchmark and the tests. Everything works on spline surfaces (lam_spline_surface): the outermost
 * ring of control points and weights and the knots are the boundary and stay as they are; the other
 * points are sought.
 *
 * Degrees are at most LAM_LEAST_AREA_MAX_DEGREE, knots are clamped, there are at least 3 x 3
 * points. Nothing here reads or writes files; results are owned by the arena.
 *
 * Sources: Wu & Wang, Designing approximate minimal NURBS surfaces with boundaries interpolation
 * (2010), with its misprints corrected; the second variation of area: Dierkes, Hildebrandt &
 * Sauvigny, Minimal Surfaces, 2.1. */
#ifndef LAM_SURF_AREA_LEAST_AREA_H
#define LAM_SURF_AREA_LEAST_AREA_H

#include "core/arena.h"
#include "core/model.h"
#include "surf/spline/sides.h"
#include "surf/spline/spline_edit.h"

enum { LAM_LEAST_AREA_MAX_DEGREE = 12 };

/* ---- refinement: the same surface with more freedom (single steps: surf/spline/spline_edit.h)
 * ---- */
/* Halves knot spans until none is longer than the domain / spans. Spaces for spans 1, 2, 4, 8 ...
 * are nested. */
lam_spline_surface lam_spline_surface_refine(lam_arena *arena, const lam_spline_surface *surface,
                                             int spans);
/* Repeats every inner knot until the surface consists of rational Bezier patches (Wu & Wang,
 * property 1). */
lam_spline_surface lam_spline_surface_pieces(lam_arena *arena, const lam_spline_surface *surface);

/* ---- boundaries ---- */
/* The surface with these sides (lam_sides_join), of common degrees, 3 at least, and common knots.
 * Inner points are at the origin, with weight 1. False when the weights at the corners cannot be
 * made equal by a factor for every side. */
bool lam_spline_surface_between(lam_arena *arena, const lam_sides *sides,
                                lam_spline_surface *surface);

/* ---- first surfaces ---- */
/* Weight 1 for all inner points (the weights of the boundary stay). Points are shared. */
lam_spline_surface lam_least_area_unit_weights(lam_arena *arena, const lam_spline_surface *surface);
/* Separable weights w_ij = w_i0 w_0j / w_00 of inner points: those of a product of two curves. */
lam_spline_surface lam_least_area_separable_weights(lam_arena *arena,
                                                    const lam_spline_surface *surface);
/* Inner points of least Dirichlet energy 1/2 integral x_u^2 + x_v^2, with the given weights. */
lam_spline_surface lam_least_area_dirichlet(lam_arena *arena, const lam_spline_surface *surface);

/* ---- minimization ---- */
typedef enum lam_least_area_method {
  LAM_LEAST_AREA_NEWTON,   /* damped Newton with the exact second variation */
  LAM_LEAST_AREA_MAJORIZE, /* minimizes I(x; x_k) again and again (Wu & Wang, step 5): the area
                              never rises */
  LAM_LEAST_AREA_LBFGS     /* limited memory BFGS, scaled by the Dirichlet energy; 10 pairs */
} lam_least_area_method;

typedef struct lam_least_area_options {
  lam_least_area_method method;
  double mean_curvature; /* 1/m, towards the normal x_u x x_v; 0: least area. Other methods than
                            Newton need 0. */
  double tolerance;      /* stops where the area falls by less than this part of it in one step */
  double enough;         /* stops at or below this area, m^2; 0: not */
  int most;              /* steps */
  bool accept_saddles;   /* does not look whether a stationary surface is a minimum; Newton alone
                            looks */
} lam_least_area_options;
/* Newton, no mean curvature, tolerance 1e-9, at most 100 steps; saddles are left. */
lam_least_area_options lam_least_area_defaults(void);

typedef struct lam_least_area_result {
  lam_spline_surface surface;  /* points owned by the arena */
  double area;                 /* m^2, by the quadrature that was minimized with: see
                                  lam_surface_area for one that was not */
  int iterations, evaluations; /* steps; evaluations of the area for them */
  int saddles;                 /* stationary surfaces that were no minimum and had to be left */
  double fall;                 /* of the area in the last eight steps, m^2; Newton alone; infinite
                                  when there were fewer */
  bool converged;
  const char *reason; /* why it stopped; static text */
} lam_least_area_result;

/* Minimizes from the surface's own inner points, weights fixed. */
lam_least_area_result lam_least_area_minimize(lam_arena *arena, const lam_spline_surface *start,
                                              const lam_least_area_options *options);
/* From coarse to fine: Dirichlet start on the surface's own knots, then 2, 4, ... up to `spans`,
 * each from the one before. Iterations are summed up. spans <= 1: on its own knots alone. */
lam_least_area_result lam_least_area_solve(lam_arena *arena, const lam_spline_surface *boundary,
                                           int spans, const lam_least_area_options *options);
/* Inner points and their weights, the weights between low and high: projected Newton, dense, for up
 * to some hundred inner points. Starts from the surface's own. */
lam_least_area_result lam_least_area_weights(lam_arena *arena, const lam_spline_surface *start,
                                             double low, double high,
                                             const lam_least_area_options *options);

/* ---- measures, by other means than the minimization ---- */
/* The area, m^2, by a rule with `count` Gauss nodes in each half of every knot span and direction,
 * on evaluated jets. */
double lam_surface_area(lam_arena *arena, const lam_spline_surface *surface, int count);
/* The area from inscribed triangles on n, 2n and 4n cells per knot span (n = cells), extrapolated.
 * The tests check lam_surface_area against it. */
double lam_surface_area_triangles(lam_arena *arena, const lam_spline_surface *surface, int cells);
/* An estimate of how far, m^2, the area is above the least one on the same boundary: what a Newton
 * step promises to save when every span is halved. NaN: not estimated (more than 32 spans along a
 * direction, or the surface is no minimum there). */
double lam_surface_area_excess(lam_arena *arena, const lam_spline_surface *surface);
/* |H - wanted|, 1/m, at count x count points inside of every knot span: the largest, the root of
 * the mean square, and the number of points. */
void lam_surface_mean_curvature(lam_arena *arena, const lam_spline_surface *surface, double wanted,
                                int count, double *largest, double *rms, long *samples);

#endif
