/* The torus x = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v), R > r; one line in
 * surfaces.c. The principal chart is isothermic: dq = r dv / (R + r cos v) gives tan(v/2) = k
 * tan(w q) with k = sqrt((R+r)/(R-r)), w = sqrt(R^2 - r^2) / (2r), and q has the period pi /
 * w. */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* The parameters of a row, and the data: R and r. */
typedef struct lam_torus {
  double ring, tube;
} lam_torus;

/* Only a check: the tube must leave a hole. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  const lam_torus *torus = params;
  (void)arena;
  if (!(torus->tube < torus->ring))
    lam_error_add(errors, location, "tube",
                  "tube %g is not smaller than ring %g; expected a torus with a hole", torus->tube,
                  torus->ring);
  return torus;
}

/* The meridian is a circle around (R, 0). */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_torus *t = data;
  double c = t->tube * cos(v), s = t->tube * sin(v);
  lam_jet_revolve((lam_meridian){.r = t->ring + c, .dr = -s, .ddr = -c, .z = s, .dz = c, .ddz = -s},
                  u, jet);
}

/* w of the principal chart. */
static double frequency(const lam_torus *t) {
  return sqrt((t->ring - t->tube) * (t->ring + t->tube)) / (2 * t->tube);
}

/* All of it; closed both ways. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  bool known = chart == LAM_CHART_NATURAL || chart == LAM_CHART_PRINCIPAL;
  double half = chart == LAM_CHART_PRINCIPAL ? M_PI_2 / frequency(data) : LAM_PI;
  return known &&
         lam_domain_give((lam_domain){{0, 2 * LAM_PI}, {-half, half}, {true, true}}, p, q, closed);
}

/* atan(k tan a) without a jump: a + atan((k-1) sin a cos a / (cos^2 a + k sin^2 a)). */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  const lam_torus *t = data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart == LAM_CHART_NATURAL) return;

  double k = sqrt((t->ring + t->tube) / (t->ring - t->tube)), a = frequency(t) * q, c = cos(a),
         s = sin(a);
  *v = 2 * (a + atan((k - 1) * s * c / (c * c + k * s * s)));
}

static const lam_key keys[] = {
    LAM_NUMBER_KEY(lam_torus, "ring", ring, "3", 1e-3, 1e6,
                   "Radius of the ring that the middle of the tube follows."),
    LAM_NUMBER_KEY(lam_torus, "tube", tube, "1", 1e-3, 1e6,
                   "Radius of the tube; smaller than ring."),
    {0}};

const lam_surface_kind lam_surface_torus = {
    .head = {.name = "torus",
             .title = "Torus",
             .doc = "A ring of circular section. Its outer half bulges (K > 0), its inner half is "
                    "a saddle (K < 0), and the top and bottom circles between them are flat in one "
                    "direction. Patches of it make roofs with repeated parts, because all "
                    "meridians are alike. Asymptotic nets exist on the inner half only. In the "
                    "principal chart the meshes are squares.",
             .equation = "x = ((ring + tube cos v) cos u, (ring + tube cos v) sin u, tube sin v)",
             .source = "do Carmo, Differential Geometry of Curves and Surfaces, 3-3",
             .keys = keys,
             .params_size = sizeof(lam_torus)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = locate};
