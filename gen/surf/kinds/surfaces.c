/* The list of surfaces, for design/ and the library through lam_surfaces. To add one: write its
 * file, and add its line here. */
#include "surf/defined.h"
#include "surf/surface.h"

/* clang-format off */
#define SURFACES(row) \
  row(bezier) \
  row(bspline) \
  row(nurbs) \
  row(file) \
  row(least_area) \
  row(monge) \
  row(revolution) \
  row(molding) \
  row(enneper) \
  row(catenoid) \
  row(helicoid) \
  row(scherk) \
  row(hyperbolic_paraboloid) \
  row(constant_ratio) \
  row(pseudosphere) \
  row(unduloid) \
  row(nodoid) \
  row(sphere) \
  row(ellipsoid) \
  row(torus) \
  row(asymptotic_quad) \
  row(developable) \
  row(coons) \
  row(interpolation) \
  row(approximation)
/* clang-format on */

/* The same list expanded twice: declarations, then pointers to the heads. */
#define DECLARE(name) extern const lam_surface_kind lam_surface_##name;
SURFACES(DECLARE)

#define POINT(name) &lam_surface_##name.head,
static const lam_row_head *const rows[] = {SURFACES(POINT)};

const lam_registry lam_surfaces = {"surfaces", "surface", rows, sizeof rows / sizeof rows[0]};

const char *const lam_chart_names[] = {[LAM_CHART_NATURAL] = "natural",
                                       [LAM_CHART_ASYMPTOTIC] = "asymptotic",
                                       [LAM_CHART_PRINCIPAL] = "principal",
                                       [LAM_CHART_DIAGONAL] = "diagonal",
                                       [LAM_CHART_GEODESIC_PARALLEL] = "geodesic-parallel",
                                       [LAM_CHART_GEODESIC_POLAR] = "geodesic-polar",
                                       [LAM_CHART_ALL] = NULL};

/* A kind without prepare is evaluated from its parameters alone. */
lam_surface lam_surface_make(lam_arena *arena, const lam_row *row, lam_errors *errors) {
  const lam_surface_kind *kind =
      (const lam_surface_kind *)row->head; /* the head is a kind's first member */
  lam_surface surface = {kind, row->params};
  int before = errors->count;
  if (kind->definition && lam_surface_defined_check(kind, row->params, row->location, errors))
    surface.data = lam_surface_defined_data(arena, kind->definition, row->params);
  if (kind->prepare) surface.data = kind->prepare(arena, row->params, row->location, errors);
  if (errors->count > before) return (lam_surface){0};
  return surface;
}

/* From the chart to natural parameters, then the surface. */
lam_vec3 lam_surface_point(const lam_surface *surface, lam_chart chart, int sector, double p,
                           double q) {
  double u = p, v = q;
  lam_jet jet;

  if (chart != LAM_CHART_NATURAL) surface->kind->locate(surface->data, chart, sector, p, q, &u, &v);
  lam_surface_eval(surface, u, v, &jet);
  return jet.x;
}
