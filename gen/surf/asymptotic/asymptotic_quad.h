/* Surfaces whose four boundary curves are asymptotic curves: the osculating planes of the
 * boundary are the tangent planes of the surface there (Wang's thesis, chapter 2; Wang, Zhu &
 * Li, J. Comput. Math. 37(5), 2019). For the kind of surface in asymptotic_quad.c, the skins of
 * asymptotic_skin.h, the benchmark and the tests.
 *
 * The boundary curves of x(u,v), 0 <= u, v <= 1, are numbered r1 = x(u,0), r2 = x(0,v), r3 =
 * x(u,1), r4 = x(1,v), here with the indices 0 to 3; the corners x(0,0), x(1,0), x(0,1), x(1,1)
 * have the indices 0 to 3. End 0 of a curve is at parameter 0, end 1 at parameter 1. Lengths are
 * in meters, curvatures in 1/m.
 *
 * The way: corner data -> lam_quad_boundary (curves that may be asymptotic) -> tangents across
 * the boundary, in its osculating planes -> a control net whose outer two rings are fixed, and
 * inner points of least thin-plate energy. lam_asymptotic_patch_make does all of it. Everything
 * is allocated in the caller's arena. */
#ifndef LAM_SURF_ASYMPTOTIC_ASYMPTOTIC_QUAD_H
#define LAM_SURF_ASYMPTOTIC_ASYMPTOTIC_QUAD_H

#include "core/error.h"
#include "core/model.h"
#include <stdbool.h>

/* What the boundary is made of and how the surface continues it. */
typedef enum lam_quad_form {
  LAM_QUAD_BI7,      /* quintic boundary; tangents of least energy */
  LAM_QUAD_BI11,     /* quintic boundary; thesis 2.3.3 */
  LAM_QUAD_BI6,      /* quartic boundary, curvatures are output; tangents of least energy */
  LAM_QUAD_BI8,      /* quartic boundary, curvatures are output; end of thesis 2.3.3 */
  LAM_QUAD_BI13,     /* rational quartic boundary; thesis 2.4 */
  LAM_QUAD_B_SPLINE, /* cubic B-spline boundary of 3 pieces, bi-quintic 16 x 16; thesis 2.5.
                        Creases by about one degree along the inner knots near the boundary: the
                        torsion of a cubic spline jumps there */
  LAM_QUAD_C1,       /* quartic C3 B-spline boundary of 3 pieces, bi-quintic 14 x 14: smooth */
  LAM_QUAD_FORM_COUNT
} lam_quad_form;
extern const char *const lam_quad_form_names[]; /* NULL-terminated */

/* Corner data. */
typedef struct lam_quad_corners {
  lam_vec3 corner[4];
  lam_vec3 tangent[4][2]; /* derivatives of the curves at their ends, along increasing parameter. A
                             straight side needs them along the chord; their length is not used
                             then */
  double curvature[4][2]; /* >= 0; not used by BI6 and BI8, nor for straight sides */
  int side[4][2];         /* +1: the curve bends into the patch, -1: away from it, 0: it is
                             straight. Both ends agree */
  double weight[4];       /* of the corners, for BI13; positive */
  double knots[2][2];     /* inner knots of r1, r3 and of r2, r4, for B_SPLINE and C1: 0 < first <
                             second < 1 */
} lam_quad_corners;

/* A boundary curve. */
typedef struct lam_quad_curve {
  int degree, count;
  const double *knots; /* count + degree + 1 */
  lam_vec3 *points;    /* count */
  double *weights;     /* count; NULL: all 1 */
  bool straight;
} lam_quad_curve;

typedef struct lam_quad_boundary {
  lam_quad_curve curve[4];
  /* The third point from an end is corner + slide E + cross X, with E the edge from the corner to
   * the second point and X the same edge of the other curve at the corner (lambda and mu of the
   * thesis). */
  double slide[4][2], cross[4][2];
  double curvature[4][2]; /* at the ends */
  double torsion[4][2];   /* at the ends; 0 for straight curves */
  double energy;          /* sum of the integrals of |r''|^2 (thesis, eq. 2.5) */
} lam_quad_boundary;

/* A finished surface. */
typedef struct lam_asymptotic_patch {
  lam_spline_surface surface;
  lam_quad_boundary boundary;
  double energy; /* m^2: integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2, as it was minimized
                    (thesis, eq. 2.8) */
} lam_asymptotic_patch;

/* What of the corner data is left out. */
typedef struct lam_quad_missing {
  bool sides;      /* follow from the tangents; a side whose tangents are along the chord is
                      straight */
  bool curvatures; /* chosen for least bending energy of the boundary */
  bool slopes;     /* vertical parts of the tangents, chosen with the curvatures for least
                      thin-plate energy of the bi-7 surface; the horizontal parts are given */
} lam_quad_missing;

/* Completes corner data in place. The energy is brought to a local minimum over what is left out,
 * with curvatures between exp(-5) and exp(5) over the chord. false, with an error, when nothing
 * completes the data. */
bool lam_quad_corners_complete(lam_arena *arena, lam_quad_corners *corners, lam_quad_form form,
                               lam_quad_missing missing, lam_location location, lam_errors *errors);

/* The surface of the form over the corner data. false: the data admit none; what is wrong is added
 * to errors, with the key of a design that it concerns. */
bool lam_asymptotic_patch_make(lam_arena *arena, const lam_quad_corners *corners,
                               lam_quad_form form, lam_location location, lam_errors *errors,
                               lam_asymptotic_patch *patch);

/* The boundary alone; false, with an error, when there is none. */
bool lam_quad_boundary_make(lam_arena *arena, const lam_quad_corners *corners, lam_quad_form form,
                            lam_location location, lam_errors *errors, lam_quad_boundary *boundary);

/* Position and first three derivatives of a curve at t, from its first to its last knot. */
void lam_quad_curve_eval(const lam_quad_curve *curve, double t, lam_vec3 jet[4]);

/* The greatest |k_n| / k of the four boundary curves in the surface, and the greatest sine of the
 * angle between its normal and their binormals, at `samples` parameters inside each; a straight
 * curve counts with |k_n| times the length of the curve, and not for the binormal. The knots of the
 * surface are stepped around. */
void lam_asymptotic_residuals(lam_arena *arena, const lam_spline_surface *surface,
                              const bool straight[4], int samples, double *ratio, double *sine);
/* Integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2 over the parameters, m^2, by a Gauss rule of `count`
 * nodes per span and direction. For any spline surface. */
double lam_thin_plate_energy(lam_arena *arena, const lam_spline_surface *surface, int count);

#endif
