/* Curves that are read: a reader of curves makes lines and arcs splines, cuts curves to a part,
 * checks and lists them with this header; surfaces and what curves share with them (the view of a
 * curve as a side) stand in spline.h. Writers of curves need spline.h alone. Used by the readers
 * of IGES, STEP, OBJ and JSON (formats/iges, formats/step, formats/mesh, surface_json.c). */
#ifndef LAM_FORMATS_SPLINE_CURVES_H
#define LAM_FORMATS_SPLINE_CURVES_H

#include "formats/format.h"
#include "formats/spline/spline.h"

/* Appends a curve; its arrays and the name are kept by pointer. family: 0, 1, or -1. The list,
 * {0} at first, is owned by the arena. */
void lam_curve_append(lam_arena *arena, lam_curve_list *list, const char *name, int family,
                      lam_spline_curve curve);
/* What makes numbers that were read unfit to be a curve, as the end of "it has ..."; NULL when
 * they are fit: what lam_spline_problem asks of surfaces. */
const char *lam_curve_problem(const lam_spline_curve *curve);

/* The straight line from a to b, over [0, 1]. */
lam_spline_curve lam_curve_line(lam_arena *arena, lam_vec3 a, lam_vec3 b);
/* center + cos t x + sin t y for t from `from` to `to` (radians), at most a turn, as a rational
 * quadratic: an arc of a circle when x and y are at right angles and as long as each other,
 * otherwise of an ellipse. from < to. The parameter of the curve is not t. */
lam_spline_curve lam_curve_arc(lam_arena *arena, lam_vec3 center, lam_vec3 x, lam_vec3 y,
                               double from, double to);
/* The part over [low, high], with clamped knots: the curve itself, its arrays shared, when it is
 * so already; otherwise a new one, owned by the arena. Precondition: low < high, in the domain. */
lam_spline_curve lam_curve_part(lam_arena *arena, const lam_spline_curve *curve, double low,
                                double high);
/* The part between the points of the curve that are nearest to a and b, in the curve's direction;
 * the whole curve when they are its ends, or one point. */
lam_spline_curve lam_curve_between(lam_arena *arena, const lam_spline_curve *curve, lam_vec3 a,
                                   lam_vec3 b);
/* Whether the curve lies on the boundary of a clamped surface, to a ten-thousandth of its size. */
bool lam_curve_is_border(lam_arena *arena, const lam_spline_curve *curve,
                         const lam_spline_surface *surface);

#endif
