/* The steps of Wu & Wang, Designing approximate minimal NURBS surfaces with boundaries
 * interpolation (2010), each of use by itself; for the method `paper` of least_area.c and for
 * the tests. Misprints are corrected. A surface of polynomial Bezier patches is a spline surface
 * of one degree in both directions whose inner knots are repeated `degree` times: neighbors
 * share their border points. Results are owned by the arena. */
#ifndef LAM_SURF_AREA_AREA_PAPER_H
#define LAM_SURF_AREA_AREA_PAPER_H

#include "surf/area/least_area.h"

/* ---- step 2: polynomials for rational curves ---- */
/* Hybrid approximation (algorithm 1): the Bezier curve of degree r + p that meets the rational
 * Bezier curve of `degree` with r - 1 derivatives at the start and p - 1 at the end; its moving
 * point r is replaced by the mean of the points it stays among, weighted with binomial * weight.
 *
 * points, weights  degree + 1; weights are positive
 * r, p             > 0, r + p >= degree
 * result           r + p + 1 points */
void lam_hybrid_approximate(int degree, const lam_vec3 *points, const double *weights, int r, int p,
                            lam_vec3 *result);
/* The factor by which the error shrinks when r = p grows by one: max over the zeros z of the
 * denominator of 1 / (4 |z (1 - z)|). 1 or more: the approximation diverges; subdivide the curve. 0
 * for equal weights. weights: degree + 1, positive; degree at most LAM_LEAST_AREA_MAX_DEGREE. */
double lam_hybrid_ratio(int degree, const double *weights);
/* Bezier patches of bidegree r + p whose outer borders approximate those of the surface; spans on
 * whose borders the approximation would diverge are halved before. Points inside of the outer
 * border are at the origin. */
lam_spline_surface lam_bezier_boundary(lam_arena *arena, const lam_spline_surface *surface, int r,
                                       int p);

/* ---- steps 3 and 4: a first surface ---- */
/* Sets the inner borders between patches: linear from outer border to outer border, corners by the
 * mean of both. */
lam_spline_surface lam_bezier_borders(lam_arena *arena, const lam_spline_surface *patches);
typedef enum lam_bezier_energy {
  LAM_BEZIER_DIRICHLET,  /* 1/2 integral x_u^2 + x_v^2 */
  LAM_BEZIER_BENDING,    /* 1/2 integral x_uu^2 + 2 x_uv^2 + x_vv^2 */
  LAM_BEZIER_HARMONIC,   /* integral (x_uu + x_vv)^2: the Laplace equation, as well as the borders
                            allow */
  LAM_BEZIER_BIHARMONIC, /* integral (x_uuuu + 2 x_uuvv + x_vvvv)^2, likewise; degree 4 or more */
} lam_bezier_energy;
/* Sets the inner points of every patch to least energy. */
lam_spline_surface lam_bezier_fill(lam_arena *arena, const lam_spline_surface *patches,
                                   lam_bezier_energy energy);

/* ---- step 5 ---- */
/* Moves the inner borders to the middle of the rows of points beside them, their corners to the
 * middle of four. */
lam_spline_surface lam_bezier_average(lam_arena *arena, const lam_spline_surface *patches);
/* Minimizes I(x; x0) for the inner points of every patch, once: the area of no patch rises. */
lam_spline_surface lam_bezier_improve(lam_arena *arena, const lam_spline_surface *patches);
/* Both in turn, until the surface changes by less than tolerance (root of the integral of the
 * squared distance over u and v). Averaging may raise the area: the surface of least area on the
 * way is the result, and the iteration ends unconverged when the area has grown by half. */
lam_least_area_result lam_bezier_iterate(lam_arena *arena, const lam_spline_surface *patches,
                                         double tolerance, int most);

/* ---- step 6: back to the exact boundary ---- */
/* The surface on the knots, weights and boundary of `space` nearest to `target` in the mean of
 * squared distances over u and v. Both have the same domain. */
lam_spline_surface lam_spline_surface_fit(lam_arena *arena, const lam_spline_surface *space,
                                          const lam_spline_surface *target);
/* The same with the inner weights sought too, between low and high. */
lam_spline_surface lam_spline_surface_fit_weights(lam_arena *arena, const lam_spline_surface *space,
                                                  const lam_spline_surface *target, double low,
                                                  double high);
/* The surface on the knots, weights and boundary of `start` whose distance along the normals of
 * `target` has the least mean of squares over u and v, found from start by Gauss-Newton steps.
 * Points of equal parameters need not be near one another: what the target's parameters and its
 * border miss is not copied. Both have the same domain. */
lam_spline_surface lam_spline_surface_nearest(lam_arena *arena, const lam_spline_surface *start,
                                              const lam_spline_surface *target);
/* root of integral |a - b|^2 du dv, over the spans of b. */
double lam_spline_surface_distance(lam_arena *arena, const lam_spline_surface *a,
                                   const lam_spline_surface *b);

/* ---- all of it ---- */
/* The results of the paper, and the nearest surface with weight 1 inside, which has less area than
 * that with separable weights. Those with the exact boundary are nearest to the patches
 * (lam_spline_surface_nearest). */
typedef struct lam_paper_result {
  lam_least_area_result patches; /* Bezier patches on approximated borders */
  lam_spline_surface rational;  /* rational Bezier patches, exact boundary, from weights 1 inside */
  lam_spline_surface separable; /* the knots of the boundary, exact boundary, separable weights */
  lam_spline_surface nurbs;     /* the knots of the boundary, exact boundary, weights 1 inside */
} lam_paper_result;
/* Steps 1 to 6 from Dirichlet energy; r, p: of the Hybrid approximation; tolerance (m), most: of
 * the iteration. boundary: inner points are not used. */
lam_paper_result lam_least_area_paper(lam_arena *arena, const lam_spline_surface *boundary, int r,
                                      int p, double tolerance, int most);
/* Step 6 with the inner weights sought too, between low and high: by equal parameters, then nearest
 * with these. */
lam_spline_surface lam_least_area_paper_weights(lam_arena *arena,
                                                const lam_spline_surface *boundary,
                                                const lam_spline_surface *patches, double low,
                                                double high);

#endif
