/* The surface of revolution with a constant ratio of principal curvatures,
 * k_meridian = -a k_parallel, radius 1 at the waist; one line in surfaces.c.
 *
 * With the slope angle psi of the meridian k_parallel = sin psi / r and k_meridian = d(sin
 * psi)/dr, so sin psi = r^-a. In the isothermic parameter v, dv = ds / r:
 *   r = cosh(a v)^(1/a),  dr/dv = r tanh(a v),  dz/dv = r sin psi = r^(1-a).
 * a = 1 is the catenoid. The asymptotic directions have a dv^2 = du^2: u = p + q,
 * v = (q - p) / sqrt(a), and p- and q-lines make the constant angle t with cot^2(t/2) = a, with
 * the parallel circle between them.
 *
 * z has no closed form for general a. It is tabled at even steps and the rest of a step is
 * integrated by Gauss-Legendre quadrature with 8 points. The integrand is analytic up to
 * pi/(2a) off the real axis, 6 half steps away or more, so the error of a step is of order (6 +
 * sqrt(6^2 - 1))^-16 ~ 1e-17. */
#include "core/numbers.h"
#include "surf/surface_kind.h"

/* Entries of the table; half the number of quadrature nodes, which are symmetric. */
enum { STEPS = 64, HALF_POINTS = 4 };

/* The parameters of a row: the angle t between the asymptotic lines, radians. */
typedef struct lam_constant_ratio_keys {
  double angle;
} lam_constant_ratio_keys;

/* What evaluation needs. */
typedef struct lam_constant_ratio {
  double a, step;
  double z[STEPS + 1]; /* z at multiples of step, v >= 0 */
} lam_constant_ratio;

/* ln r(v) without overflow: |v| + (ln(1 + exp(-2a|v|)) - ln 2) / a. */
static double log_radius(double a, double v) {
  return fabs(v) + (log1p(exp(-2 * a * fabs(v))) - M_LN2) / a;
}

/* dz/dv = r^(1-a). */
static double rise(double a, double v) { return exp((1 - a) * log_radius(a, v)); }

/* The rise from low to high; Gauss-Legendre. */
static double integrate(double a, double low, double high) {
  static const double x[HALF_POINTS] = {0.18343464249564980494, 0.52553240991632898582,
                                        0.79666647741362673959, 0.96028985649753623168};
  static const double w[HALF_POINTS] = {0.36268378337836198297, 0.31370664587788728734,
                                        0.22238103445337447054, 0.10122853629037625915};

  double middle = (low + high) / 2, half = (high - low) / 2, sum = 0;
  for (int i = 0; i < HALF_POINTS; i++)
    sum += w[i] * (rise(a, middle - half * x[i]) + rise(a, middle + half * x[i]));
  return half * sum;
}

/* z(v), odd in v: the table, further whole steps where it ends, and the rest of a step. */
static double height(const lam_constant_ratio *s, double v) {
  double distance = fabs(v);
  int index = distance < STEPS * s->step ? (int)(distance / s->step) : STEPS;
  double z = s->z[index], low = index * s->step;
  for (; distance - low > s->step; low += s->step) z += integrate(s->a, low, low + s->step);
  return copysign(z + integrate(s->a, low, distance), v);
}

/* a from the angle, and the table. Its step shrinks with a, as the distance of the integrand's
 * poles from the real axis does. */
static const void *prepare(lam_arena *arena, const void *params, lam_location location,
                           lam_errors *errors) {
  double cotangent = 1 / tan(((const lam_constant_ratio_keys *)params)->angle / 2);
  lam_constant_ratio *s = LAM_NEW(arena, lam_constant_ratio, 1);
  (void)location;
  (void)errors;
  s->a = cotangent * cotangent;
  s->step = 0.5 / fmax(1, s->a);
  for (int i = 0; i < STEPS; i++)
    s->z[i + 1] = s->z[i] + integrate(s->a, i * s->step, (i + 1) * s->step);
  return s;
}

/* r'' = r (tanh^2 + a (1 - tanh^2)), z'' = (1 - a) tanh z'. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  const lam_constant_ratio *s = data;
  double r = exp(log_radius(s->a, v)), t = tanh(s->a * v), dz = rise(s->a, v);
  lam_jet_revolve((lam_meridian){.r = r,
                                 .dr = r * t,
                                 .ddr = r * (t * t + s->a * (1 - t * t)),
                                 .z = height(s, v),
                                 .dz = dz,
                                 .ddz = (1 - s->a) * t * dz},
                  u, jet);
}

/* The default domain reaches twice the radius of the waist: cosh(a v) = 2^a. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  double a = ((const lam_constant_ratio *)data)->a, reach = acosh(pow(2, a)) / a,
         half = sqrt(a) * reach / 2;
  lam_domain rings = {{0, 2 * LAM_PI}, {-reach, reach}, {true, false}},
             net = {{-half, half}, {-half, half}, {false, false}};
  return chart != LAM_CHART_DIAGONAL &&
         lam_domain_give(chart == LAM_CHART_ASYMPTOTIC ? net : rings, p, q, closed);
}

/* The asymptotic chart; the principal one is the natural one. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  const lam_constant_ratio *s = data;
  (void)sector;
  *u = p;
  *v = q;
  if (chart != LAM_CHART_ASYMPTOTIC) return;
  *u = p + q;
  *v = (q - p) / sqrt(s->a);
}

static const lam_key keys[] = {
    LAM_ANGLE_KEY(lam_constant_ratio_keys, "angle", angle, "60 deg", LAM_PI / 9, LAM_PI * 8 / 9,
                  "Angle at which the asymptotic lines cross, with the ring between them; from 20 "
                  "to 160 degrees, 90 deg is the catenoid."),
    {0}};

const lam_surface_kind lam_surface_constant_ratio = {
    .head = {.name = "constant-ratio",
             .title = "Rotational surface of constant curvature ratio",
             .doc = "A waisted tower whose two principal curvatures have the same ratio "
                    "everywhere, so that its asymptotic lines cross at the same angle everywhere: "
                    "straight lamellas with one and the same skew joint. A sharp angle makes a "
                    "flared, nearly flat rim; a blunt one makes a slender, slowly opening stem. "
                    "Other shapes with this property have no formula: they come from optimization, "
                    "and this one is a good start for it.",
             .equation = "sin psi = r^-a, a = cot^2(angle/2): r = cosh(a v)^(1/a), dz/dv = r^(1-a)",
             .source = "thesis 3.2.4; Jimenez, Mueller, Pottmann, Discretizations of surfaces with "
                       "constant ratio of principal curvatures, 2020",
             .keys = keys,
             .params_size = sizeof(lam_constant_ratio_keys)},
    .prepare = prepare,
    .eval = eval,
    .domain = domain,
    .locate = locate};
