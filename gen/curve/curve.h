/* Spline curves, polynomial and rational: evaluation (curve.c) and exact changes (curve_edit.c).
 * All of it happens on homogeneous points (w x, w y, w z, w), so rational curves stay exactly
 * what they are (Piegl & Tiller, The NURBS Book, ch. 4 and 5). lam_spline_curve itself is a type
 * of core/model.h; the curves of keys, of lines of nets (mesh/line_curve.c) and of edges of
 * surfaces (surf/spline) are such curves.
 *
 * Preconditions everywhere: sound knots (lam_knots_problem returns NULL), positive weights or
 * NULL. Results are owned by the arena; they may share arrays with their arguments. */
#ifndef LAM_CURVE_CURVE_H
#define LAM_CURVE_CURVE_H

#include "core/model.h"
#include "curve/bspline/bspline.h"

/* Any parameterized curve over [from, to]. */
typedef struct lam_curve {
  /* The point and its derivatives up to `order` <= 3: values[0 .. order]. Pure. */
  void (*eval)(const void *data, double t, int order, lam_vec3 *values);
  const void *data;
  double from, to;
  int break_count;
  /* Ascending, inside (from, to): where the curve is not smooth; NULL when there are none. */
  const double *breaks;
} lam_curve;

/* The curve of a spline, which is kept by pointer. Breaks are its inner knots. */
lam_curve lam_curve_of_spline(lam_arena *arena, const lam_spline_curve *spline);
/* from, the breaks, to: break_count + 2 ascending numbers. */
const double *lam_curve_breakpoints(lam_arena *arena, const lam_curve *curve);

/* The point and its derivatives: values[0 .. order], order <= LAM_BASIS_MAX_DEGREE. Allocates
 * nothing. */
void lam_spline_curve_eval(const lam_spline_curve *curve, double t, int order, lam_vec3 *values);
/* Why the curve is not sound, as the end of a sentence ("has too few points for its degree"), or
 * NULL: its degree, count, weights and knots. For users of the kernel, and for tests. */
const char *lam_spline_curve_problem(const lam_spline_curve *curve);

/* The homogeneous points of the curve as a spline: dimension 4 with weights, 3 without (or 4 when
 * `rational`). Knots are shared. */
lam_bspline lam_spline_curve_net(lam_arena *arena, const lam_spline_curve *curve, bool rational);
/* The curve of a spline of dimension 3 or 4 (homogeneous, w > 0). Knots are shared. */
lam_spline_curve lam_spline_curve_from_net(lam_arena *arena, lam_bspline net);

/* The same curve with the knot t standing `multiplicity` times. */
lam_spline_curve lam_spline_curve_insert(lam_arena *arena, lam_spline_curve curve, double t,
                                         int multiplicity);
/* Removes the inner knot t up to `times` times, as long as the curve moves by at most tolerance
 * (meters) in all. Returns how often it went. For rational curves the bound is that of Piegl &
 * Tiller, eq. 5.30. */
int lam_spline_curve_remove(lam_arena *arena, lam_spline_curve *curve, double t, int times,
                            double tolerance);
/* The same curve with a higher degree, at most LAM_BASIS_MAX_DEGREE. */
lam_spline_curve lam_spline_curve_elevate(lam_arena *arena, lam_spline_curve curve, int degree);
/* The nearest curve of one degree less; preconditions as for lam_bspline_reduce. deviation (may
 * be NULL) is in meters for polynomial curves, for rational ones in homogeneous space. */
lam_spline_curve lam_spline_curve_reduce(lam_arena *arena, lam_spline_curve curve, int ends,
                                         double *deviation);
/* The part over [low, high] with clamped ends. A curve is split by taking two parts. */
lam_spline_curve lam_spline_curve_part(lam_arena *arena, lam_spline_curve curve, double low,
                                       double high);
/* The same curve, traveled backwards over the same domain. */
lam_spline_curve lam_spline_curve_reverse(lam_arena *arena, lam_spline_curve curve);
/* The same curve over [low, high], low < high. Points and weights are shared. */
lam_spline_curve lam_spline_curve_move_domain(lam_arena *arena, lam_spline_curve curve, double low,
                                              double high);
/* The Bezier pieces, as curves of their own over their parts of the domain. Sets count to their
 * number. */
const lam_spline_curve *lam_spline_curve_pieces(lam_arena *arena, lam_spline_curve curve,
                                                int *count);
/* s x for a scalar spline s (dimension 1) of the same domain: the curve of the points s(t) x(t). */
lam_spline_curve lam_spline_curve_scale(lam_arena *arena, lam_bspline s, lam_spline_curve curve);
/* The image under x -> frame.origin + x frame.axis[0] + y frame.axis[1] + z frame.axis[2]; axes
 * need not be unit vectors or at right angles. Knots and weights are shared. */
lam_spline_curve lam_spline_curve_map(lam_arena *arena, lam_spline_curve curve, lam_pose frame);

#endif
