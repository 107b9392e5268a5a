/* Evaluation of tensor-product spline surfaces, rational or not, for every kind of surface that
 * is one (surf/kinds, surf/area, surf/asymptotic, surf/developable), for surf/flatten and
 * fab/parts. */
#ifndef LAM_SURF_SPLINE_SPLINE_SURFACE_H
#define LAM_SURF_SPLINE_SPLINE_SURFACE_H

#include "core/model.h"
#include "surf/surface.h"

/* A surface prepared for evaluation; read only. */
typedef struct lam_nurbs lam_nurbs;

/* Prepares a surface for evaluation; it is copied by value, its arrays are kept by pointer.
 * Preconditions: sound knots (lam_knots_problem), positive weights. Owned by the arena. */
const lam_nurbs *lam_nurbs_make(lam_arena *arena, const lam_spline_surface *surface);

/* The functions of a lam_surface_kind whose data is a lam_nurbs; see surf/surface.h. */

/* The jet at (u,v). Pure. */
void lam_nurbs_eval(const void *nurbs, double u, double v, lam_jet *jet);

/* The domain of the knots, and whether the surface closes up; false: chart is not NATURAL. */
bool lam_nurbs_domain(const void *nurbs, lam_chart chart, double p[2], double q[2], bool closed[2]);

/* The surface that it was made of; it lives as long as nurbs. */
const lam_spline_surface *lam_nurbs_spline(const void *nurbs);

/* The same three for kinds that compute their spline: data is a struct whose first member is a
 * const lam_nurbs *. */
void lam_held_nurbs_eval(const void *data, double u, double v, lam_jet *jet);
bool lam_held_nurbs_domain(const void *data, lam_chart chart, double p[2], double q[2],
                           bool closed[2]);
const lam_spline_surface *lam_held_nurbs_spline(const void *data);

#endif
