/* The hyperbolic paraboloid over a skew quadrilateral A, B, C, D; one line in surfaces.c.
 *   x(u,v) = (1-u)(1-v) A + u (1-v) B + u v C + (1-u) v D.
 * x_uu = x_vv = 0: both families of parameter lines are straight, hence asymptotic. */
#include "surf/surface_kind.h"

/* The parameters of a row: x, y, z of the four corners. */
typedef struct lam_hypar_keys {
  double corners[12];
  int unit;
} lam_hypar_keys;

/* The same surface as a polynomial, m. */
typedef struct lam_hypar {
  lam_vec3 origin, along, across, twist; /* x = origin + u along + v across + u v twist */
} lam_hypar;

/* The polynomial, and whether the corners span a volume. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_hypar_keys *keys = params;
  lam_hypar *s = LAM_NEW(arena, lam_hypar, 1);
  lam_vec3 corner[4];
  for (int i = 0; i < 4; i++) {
    const double *c = keys->corners + 3 * i;
    corner[i] = lam_scale(lam_v3(c[0], c[1], c[2]), lam_point_unit(keys->unit));
  }

  s->origin = corner[0];
  s->along = lam_sub(corner[1], corner[0]);
  s->across = lam_sub(corner[3], corner[0]);
  s->twist = lam_sub(lam_sub(corner[2], corner[3]), s->along);

  double size =
      fmax(fmax(lam_length(s->along), lam_length(s->across)), lam_distance(corner[2], corner[0]));
  double volume = lam_dot(lam_cross(s->along, s->across), lam_sub(corner[2], corner[0]));
  if (!(fabs(volume) > 1e-12 * size * size * size))
    lam_error_add(errors, location, "corners",
                  "the four corners lie in one plane; expected a skew quadrilateral");
  return s;
}

/* Horner's scheme, with x_v on the way. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_hypar *s = data;
  jet->u = lam_along(s->along, v, s->twist);
  jet->v = lam_along(s->across, u, s->twist);
  jet->x = lam_along(lam_along(s->origin, u, s->along), v, jet->v);
  jet->uu = jet->vv = lam_v3(0, 0, 0);
  jet->uv = s->twist;
}

/* The natural chart is the asymptotic one. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  (void)data;
  bool rulings = chart == LAM_CHART_NATURAL || chart == LAM_CHART_ASYMPTOTIC;
  return rulings && lam_domain_give((lam_domain){{0, 1}, {0, 1}, {false, false}}, p, q, closed);
}

static const lam_key keys[] = {
    LAM_NUMBER_KEY(
        lam_hypar_keys, "corners", corners, "[0, 0, 0,  1, 0, 1,  1, 1, 0,  0, 1, 1]", 0, 0,
        "x, y, z of the four corners, counterclockwise seen from the side of the normal."),
    LAM_CHOICE_KEY(lam_hypar_keys, "unit", unit, "m", lam_point_units,
                   "Unit of the numbers in corners."),
    {0}};

const lam_surface_kind lam_surface_hyperbolic_paraboloid = {
    .head = {.name = "hyperbolic-paraboloid",
             .title = "Hyperbolic paraboloid",
             .doc = "The saddle spanned by a skew quadrilateral, ruled by straight lines in two "
                    "ways: the classic of concrete shells, and the simplest asymptotic net, as the "
                    "straight rulings are asymptotic lines. The lamellas along them are straight "
                    "in space and only twist. It is not minimal: the rulings cross at right angles "
                    "only along two lines. It is a good start for a minimal surface with straight "
                    "edges.",
             .equation = "x = (1-u)(1-v) A + u (1-v) B + u v C + (1-u) v D",
             .source = "Pottmann et al., Architectural Geometry, 9",
             .keys = keys,
             .params_size = sizeof(lam_hypar_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = lam_locate_natural};
