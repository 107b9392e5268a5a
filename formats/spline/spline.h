/* Spline surfaces as exchange formats want them: with clamped knots, so that their sides are the
 * curves of the first and last rows and columns of control points. */
#ifndef LAM_FORMATS_SPLINE_SPLINE_H
#define LAM_FORMATS_SPLINE_SPLINE_H

#include "core/arena.h"
#include "core/model.h"
#include "formats/format.h"

/* The same surface over the same domain with degree + 1 equal knots at each end in both directions;
 * the surface itself when it is so already. Preconditions: sound knots, positive weights. What is
 * new is owned by the arena. */
lam_spline_surface lam_spline_clamped(lam_arena *arena, const lam_spline_surface *surface);

/* The part of a curve over [low, high], low < high, with clamped knots. What is new is owned by the
 * arena. */
lam_spline_curve lam_spline_curve_cut(lam_arena *arena, const lam_spline_curve *curve, double low,
                                      double high);

/* A side of a clamped surface, a row or column of its control net; or a curve. */
typedef struct lam_spline_side {
  int degree, count;
  int first, stride;      /* of its points among the surface's */
  const double *knots;    /* count + degree + 1 */
  const lam_vec3 *points; /* of the surface or curve */
  const double *weights;  /* of the surface or curve; NULL: all 1 */
} lam_spline_side;

/* Side k of the counterclockwise boundary: v = 0, u = 1, v = 1, u = 0 (in parameters from 0 to 1).
 * Its curve runs with its parameter: sides 2 and 3 run against the boundary. */
lam_spline_side lam_spline_side_of(const lam_spline_surface *surface, int k);
/* A curve as if it were a side. */
lam_spline_side lam_spline_side_of_curve(const lam_spline_curve *curve);
/* The point at t, in the domain. The arena is used in between. */
lam_vec3 lam_spline_side_point(lam_arena *arena, const lam_spline_side *side, double t);
/* The same with the first derivative (to the left of t at the end of the domain). */
lam_vec3 lam_spline_side_slope(lam_arena *arena, const lam_spline_side *side, double t,
                               lam_vec3 *slope);
/* Whether places are the same to the precision of the files: a nanometer. */
bool lam_spline_meet(lam_vec3 a, lam_vec3 b);
/* Whether the side is only a point (the pole of a sphere). */
bool lam_spline_side_is_point(const lam_spline_side *side);
/* Whether opposite sides are one curve (the surface closes up). Precondition: of the same
 * direction. */
bool lam_spline_sides_meet(const lam_spline_side *a, const lam_spline_side *b);

/* Appends a surface; its arrays and the note (may be NULL) are kept by pointer. */
void lam_spline_append(lam_arena *arena, lam_spline_list *list, const lam_spline_surface *surface,
                       const char *note);
/* The note for a surface of a face that is trimmed to a part of it, or of a file that places its
 * components; NULL when neither is the case. */
const char *lam_spline_note(bool trimmed, bool placed);
/* What makes numbers that were read unfit to be a surface, for a message; NULL when they are fit:
 * degrees of 1 or more, more points than the degree, knots that do not decrease, finite points,
 * positive weights. */
const char *lam_spline_problem(const lam_spline_surface *surface);
/* The same for the degree and knots of direction d alone. */
const char *lam_spline_knots_problem(const lam_spline_surface *surface, int d);

#endif
