/* Spline curves that are read: lists, lines and arcs as splines, parts of curves. */
#ifndef LAM_FORMATS_SPLINE_CURVES_H
#define LAM_FORMATS_SPLINE_CURVES_H

#include "formats/format.h"
#include "formats/spline/spline.h"

/* Appends a curve; its arrays and the name are kept by pointer. */
void lam_curve_append(lam_arena *arena, lam_curve_list *list, const char *name, int family,
                      lam_spline_curve curve);
/* What makes numbers that were read unfit to be a curve, for a message; NULL when they are fit. */
const char *lam_curve_problem(const lam_spline_curve *curve);

/* The straight line from a to b, over [0, 1]. */
lam_spline_curve lam_curve_line(lam_arena *arena, lam_vec3 a, lam_vec3 b);
/* center + cos t x + sin t y for t from `from` to `to`, at most a turn, as a rational quadratic: an
 * arc of a circle when x and y are at right angles and as long as each other, otherwise of an
 * ellipse. from < to. */
lam_spline_curve lam_curve_arc(lam_arena *arena, lam_vec3 center, lam_vec3 x, lam_vec3 y,
                               double from, double to);
/* The part over [low, high], with clamped knots: the curve itself when it is so already.
 * Precondition: low < high, in the domain. */
lam_spline_curve lam_curve_part(lam_arena *arena, const lam_spline_curve *curve, double low,
                                double high);
/* The part between the places of the curve that are nearest to a and b, in the curve's direction;
 * the whole curve when they are its ends, or one place. */
lam_spline_curve lam_curve_between(lam_arena *arena, const lam_spline_curve *curve, lam_vec3 a,
                                   lam_vec3 b);
/* Whether the curve lies on the boundary of a clamped surface, to a ten-thousandth of its size. */
bool lam_curve_is_border(lam_arena *arena, const lam_spline_curve *curve,
                         const lam_spline_surface *surface);

#endif
