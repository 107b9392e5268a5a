/* Spline surfaces: derivatives of higher order and exact changes, in either direction (0: u,
 * 1: v). All of it happens on homogeneous points, so rational surfaces stay what they are. Called
 * by surf/area and the files of surf/spline; what neither calls is part of the surface kernel
 * and called by the unit tests. Results are owned by the arena; preconditions as in
 * curve/bspline/bspline.h. */
#ifndef LAM_SURF_SPLINE_SPLINE_EDIT_H
#define LAM_SURF_SPLINE_SPLINE_EDIT_H

#include "core/model.h"
#include "curve/curve.h"
#include "surf/surface.h"

enum { LAM_SPLINE_MAX_ORDER = 6 };

/* The derivative a times by u and b times by v is values[a * (order + 1) + b], for a + b <=
 * order <= LAM_SPLINE_MAX_ORDER; others are not set. values: (order + 1)^2. Allocates
 * nothing. */
void lam_spline_surface_derivatives(const lam_spline_surface *surface, double u, double v,
                                    int order, lam_vec3 *values);

/* The point with first and second derivatives. Allocates nothing. */
lam_jet lam_spline_surface_jet(const lam_spline_surface *surface, double u, double v);

/* The surface as a spline in one direction whose values are whole rows of homogeneous points
 * across it: dimension 4 x count across with weights, 3 x without. */
lam_bspline lam_spline_surface_net(lam_arena *arena, const lam_spline_surface *surface,
                                   int direction);

/* The surface with this net in one direction, and the knots of `like` across. */
lam_spline_surface lam_spline_surface_from_net(lam_arena *arena, const lam_spline_surface *like,
                                               int direction, lam_bspline net);

/* The same surface with one more knot t, strictly inside of the domain and not yet `degree`
 * times a knot there. */
lam_spline_surface lam_spline_surface_insert(lam_arena *arena, const lam_spline_surface *surface,
                                             int direction, double t);

/* The same surface with degrees raised to degree[2]; no lower than they are, at most
 * LAM_BASIS_MAX_DEGREE. */
lam_spline_surface lam_spline_surface_elevate(lam_arena *arena, const lam_spline_surface *surface,
                                              const int degree[2]);

/* The surface of one degree less in one direction: see lam_bspline_reduce, whose ends keep
 * their value and derivatives below order `ends`. Exact when the surface was elevated.
 * deviation: a bound on how far any point moves, m; may be NULL. Precondition: degree >= 2. */
lam_spline_surface lam_spline_surface_reduce(lam_arena *arena, const lam_spline_surface *surface,
                                             int direction, int ends, double *deviation);

/* Removes the inner knot t of one direction up to `times` times, as long as no point moves by
 * more than tolerance (m) in all. Changes the surface; returns how often the knot went. */
int lam_spline_surface_remove(lam_arena *arena, lam_spline_surface *surface, int direction,
                              double t, int times, double tolerance);

/* su(u) sv(v) x(u,v) for scalar splines (dimension 1) of the surface's domain: the product, of
 * the sums of the degrees (at most LAM_BASIS_MAX_DEGREE). */
lam_spline_surface lam_spline_surface_scale(lam_arena *arena, lam_bspline su, lam_bspline sv,
                                            const lam_spline_surface *surface);

/* The image under x -> frame.origin + x frame.axis[0] + y frame.axis[1] + z frame.axis[2], see
 * lam_spline_curve_map. */
lam_spline_surface lam_spline_surface_map(lam_arena *arena, const lam_spline_surface *surface,
                                          lam_pose frame);

/* The same surface over [low, high] in one direction. */
lam_spline_surface lam_spline_surface_move_domain(lam_arena *arena,
                                                  const lam_spline_surface *surface, int direction,
                                                  double low, double high);

/* The parameter line at t of one direction, as a curve along the other: direction 0 gives
 * x(t, .). */
lam_spline_curve lam_spline_surface_line(lam_arena *arena, const lam_spline_surface *surface,
                                         int direction, double t);

/* The part over [low, high] of one direction, with clamped ends. A surface is split by taking
 * two parts. */
lam_spline_surface lam_spline_surface_part(lam_arena *arena, const lam_spline_surface *surface,
                                           int direction, double low, double high);

/* The same surface, traveled backwards in one direction; its normal turns to the other side. */
lam_spline_surface lam_spline_surface_reverse(lam_arena *arena, const lam_spline_surface *surface,
                                              int direction);

/* u and v exchanged; the normal turns to the other side. */
lam_spline_surface lam_spline_surface_transpose(lam_arena *arena,
                                                const lam_spline_surface *surface);

/* The Bezier patches, count[0] x count[1], v running fastest, each over its part of the domain.
 * Sets count. */
const lam_spline_surface *lam_spline_surface_patches(lam_arena *arena,
                                                     const lam_spline_surface *surface,
                                                     int count[2]);

#endif
