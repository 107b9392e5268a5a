/* Surfaces: x(u,v) with first and second derivatives over a rectangle of parameters. One kind
 * per file of surf/kinds; the list is surf/kinds/surfaces.c. Called by net/trace to lay nets on
 * them, by design/ to make and report them, by net/measures to compare nets with them. */
#ifndef LAM_SURF_SURFACE_H
#define LAM_SURF_SURFACE_H

#include "core/error.h"
#include "core/key.h"
#include "core/model.h"
#include <lamella/surface.h>

/* Parameterizations that a net may ask a surface for. NATURAL is the surface's own (u,v). In
 * the others the parameter lines have the named property. DIAGONAL are the diagonals of an
 * isothermic principal grid, a = (p+q)/2, b = (p-q)/2 in isothermic coordinates: lines of equal
 * normal curvature on surfaces of constant mean curvature. In the geodesic ones the lines of
 * the first parameter are geodesics, by arc length: at right angles to a curve, or through a
 * pole. */
typedef enum lam_chart {
  LAM_CHART_NATURAL,
  LAM_CHART_ASYMPTOTIC,
  LAM_CHART_PRINCIPAL,
  LAM_CHART_DIAGONAL,
  /* Of those that a surface may offer in closed form; the others are always traced
   * (net/trace/trace.h). */
  LAM_CHART_COUNT,
  LAM_CHART_GEODESIC_PARALLEL = LAM_CHART_COUNT,
  LAM_CHART_GEODESIC_POLAR,
  LAM_CHART_ALL
} lam_chart;

/* Names in the order of the values; NULL-terminated. */
extern const char *const lam_chart_names[];

/* The parameters of a surface that stands in a file: the design names the file, and who reads
 * files puts the surface in (surf/spline/surface_inputs.h) before it is made. */
typedef struct lam_surface_source {
  const char *file;
  int face;                          /* which of the file's surfaces, from 1 */
  const lam_spline_surface *surface; /* NULL: not read; its numbers need not be sound */
  const char *note; /* for the report: what of the file is not read; NULL: nothing */
} lam_surface_source;

/* Points that stand in a file: the design names it, and who reads files puts the points in,
 * with the numbers as they are written there. */
typedef struct lam_point_file {
  const char *file; /* NULL: none */
  int count;
  const lam_vec3 *points; /* NULL: not read */
} lam_point_file;

/* A row of the list of surfaces. `params` is the parameter struct that the parser filled from
 * head.keys; `data` is what prepare returned, or params without prepare. */
typedef struct lam_surface_kind {
  lam_row_head head;

  bool reads_file; /* its parameters are a lam_surface_source */

  /* The keys of its boundary in the parameters (surf/spline/sides_keys.h), whose curves may
   * stand in a file; NULL: it has none. */
  struct lam_sides_keys *(*sides)(void *params);

  /* The points in its parameters that may stand in a file; NULL: it has none. */
  lam_point_file *(*points)(void *params);

  /* Derives what evaluation needs from the parameters (may allocate). Returns NULL for "no
   * instance data". Adds to errors what only shows when keys are taken together. location: of
   * the surface in the design. May be NULL. */
  const void *(*prepare)(lam_arena *arena, const void *params, lam_location location,
                         lam_errors *errors);

  /* The jet at (u,v) of the natural parameterization. Pure. */
  void (*eval)(const void *data, double u, double v, lam_jet *jet);

  /* The default domain of the chart and whether it closes up in p and q; false: the surface has
   * no such chart. */
  bool (*domain)(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]);

  /* Natural parameters (u,v) of the chart point (p,q). Charts around a flat point are branched:
   * sector s counts quarter turns around it, with p, q >= 0 in every sector; s = 0 for all
   * other charts. May be NULL when only NATURAL exists. Pure. */
  void (*locate)(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                 double *v);

  /* The number of sectors around the chart's origin when the chart is branched there (6 for a
   * monkey saddle); 0 or a NULL function: not branched. */
  int (*sectors)(const void *data, lam_chart chart);

  /* The surface as a spline, in its own units and axes; NULL: it is none. */
  const lam_spline_surface *(*spline)(const void *data);

  /* How it was computed and what was measured of it, for the report (name is set); NULL:
   * nothing to tell. Measures must not come from the quadrature that was minimized with. */
  void (*report)(lam_arena *arena, const void *data, lam_stage *stage);
  const lam_surface_definition *definition; /* of a kind that a program added; NULL: built in */
} lam_surface_kind;

/* A surface that can be evaluated: a kind and its data, both kept by pointer. */
struct lam_surface {
  const lam_surface_kind *kind;
  const void *data;
};

/* The list of kinds: surf/kinds/surfaces.c. */
extern const lam_registry lam_surfaces;

/* The surface of a parsed row, with its data in the arena. Where errors are added the result
 * has kind == NULL. */
lam_surface lam_surface_make(lam_arena *arena, const lam_row *row, lam_errors *errors);

/* The jet in the natural parameterization. */
static inline void lam_surface_eval(const lam_surface *surface, double u, double v, lam_jet *jet) {
  surface->kind->eval(surface->data, u, v, jet);
}

/* The point at chart coordinates (p,q) of a sector (0 unless the chart is branched). */
lam_vec3 lam_surface_point(const lam_surface *surface, lam_chart chart, int sector, double p,
                           double q);

/* First and second fundamental forms and curvatures of a jet. Where the surface is singular
 * (|x_u x x_v| = 0) the normal is zero and the curvatures are NaN. */
typedef struct lam_curvature {
  lam_vec3 normal;
  double E, F, G, L, M, N;
  double K, H; /* Gaussian and mean curvature; H > 0 where the surface curves towards its normal */
  double k1, k2; /* principal curvatures, k1 >= k2 */
} lam_curvature;

/* Derivatives of any length; see surf/surface_curvature.c for the formulas. Pure. */
lam_curvature lam_jet_curvature(const lam_jet *jet);

#endif
