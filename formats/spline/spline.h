/* Spline surfaces as exchange formats want them: with clamped knots, so that their sides are the
 * curves of the first and last rows and columns of control points.
 *
 * Which header of this folder to use:
 *   spline.h  one surface and its four sides. A writer of surfaces: lam_spline_clamped, then
 *             lam_spline_side_of. A reader of surfaces: lam_spline_problem and lam_spline_append
 *   curves.h  curves that are read: a reader of curves makes, checks, cuts and lists them with it,
 *             and a reader of surfaces asks it whether a trimming curve lies on the boundary
 *   shell.h   all surfaces of a model at once: a writer whose surfaces share vertices and edges
 *             (formats/step/step.c)
 *
 * Used by the IGES and STEP writers, by every reader of surfaces, and by the other two headers. */
#ifndef LAM_FORMATS_SPLINE_SPLINE_H
#define LAM_FORMATS_SPLINE_SPLINE_H

#include "core/arena.h"
#include "core/model.h"
#include "formats/format.h"

/* The same surface over the same domain with degree + 1 equal knots at each end in both
 * directions; the surface itself when it is so already. Preconditions: sound knots
 * (lam_spline_problem), positive weights. What is new is owned by the arena, the rest is shared
 * with the surface. */
lam_spline_surface lam_spline_clamped(lam_arena *arena, const lam_spline_surface *surface);

/* The part of a curve over [low, high], low < high, in the domain, with clamped knots. Always
 * new, owned by the arena. For curves.c; readers call lam_curve_part. */
lam_spline_curve lam_spline_curve_cut(lam_arena *arena, const lam_spline_curve *curve, double low,
                                      double high);

/* A side of a clamped surface, a row or column of its control net; or a curve. Points to what it
 * is a side of: point i of it is points[first + i * stride], with the weight at the same place. */
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
/* The point at t, in the domain. The arena is used in between, and left as it was. */
lam_vec3 lam_spline_side_point(lam_arena *arena, const lam_spline_side *side, double t);
/* The same with the first derivative (to the left of t at the end of the domain). */
lam_vec3 lam_spline_side_slope(lam_arena *arena, const lam_spline_side *side, double t,
                               lam_vec3 *slope);
/* Whether points are the same to the precision of the files: a nanometer. */
bool lam_spline_meet(lam_vec3 a, lam_vec3 b);
/* Whether the side is only a point (the pole of a sphere). */
bool lam_spline_side_is_point(const lam_spline_side *side);
/* Whether opposite sides of one surface are one curve (the surface closes up): their points agree
 * to a nanometer and their weights to 1e-12 of themselves. */
bool lam_spline_sides_meet(const lam_spline_side *a, const lam_spline_side *b);

/* Appends a surface; its arrays and the note (may be NULL) are kept by pointer. The list, {0} at
 * first, is owned by the arena. */
void lam_spline_append(lam_arena *arena, lam_spline_list *list, const lam_spline_surface *surface,
                       const char *note);
/* The note for a surface of a face that is trimmed to a part of it, or of a file that places its
 * components, a sentence; NULL when neither is the case. */
const char *lam_spline_note(bool trimmed, bool placed);
/* What makes numbers that were read unfit to be a surface, for a message; NULL when they are fit:
 * degrees of 1 or more, more points than the degree, knots that do not decrease, finite points,
 * positive weights. */
const char *lam_spline_problem(const lam_spline_surface *surface);
/* The same for the degree and knots of direction d alone. */
const char *lam_spline_knots_problem(const lam_spline_surface *surface, int d);

#endif
