/* Enneper's surface of order k; one line in surfaces.c. Weierstrass data g = w^k, eta = dw with
 * w = u + i v, m = 2k + 1:
 *   x = Re(w - w^m / m),  y = Im(w + w^m / m),  z = Re(2 w^(k+1) / (k+1)).
 * (The usual y with its sign changed: the same surface run through as conj(w), so that the
 * normal at w = 0 points up.) Its second form is II = 2k Re(w^(k-1) dw^2) and its first |dw|^2
 * (1 + |w|^2k)^2. For k = 1 the lines of u and v are curvature lines and their diagonals
 * asymptotic lines (the first chapter of the thesis has them exchanged).
 *
 * In the conformal parameter zeta with d zeta ~ w^((k-1)/2) dw the second form is Re(c d
 * zeta^2), c constant: w = e^(i phi) zeta^(2/(k+1)), with phi = 0 in the principal chart and
 * phi = pi / (2 (k+1)) in the asymptotic one. For k >= 2 the origin is a flat point and zeta
 * lives on a Riemann surface: one turn of w is (k+1)/2 turns of zeta, which are 2(k+1) sectors
 * of a quarter turn, zeta = (p + i q) i^s. */
#include "core/numbers.h"
#include "surf/surface_kind.h"
#include "core/complex_number.h"

/* The parameters of a row, and the data: the order k. */
typedef struct lam_enneper {
  int order;
} lam_enneper;

/* w to a small power, by multiplication. */
static complex double power(complex double w, int exponent) {
  complex double result = 1;
  for (; exponent > 0; exponent--) result *= w;
  return result;
}

/* A triple of analytic functions whose real parts are x, y, z. */
typedef struct lam_triple {
  complex double x, y, z;
} lam_triple;

/* The vector of the real parts. */
static lam_vec3 real_part(lam_triple f) { return lam_v3(creal(f.x), creal(f.y), creal(f.z)); }

/* The vector of the imaginary parts. */
static lam_vec3 imaginary_part(lam_triple f) { return lam_v3(cimag(f.x), cimag(f.y), cimag(f.z)); }

/* Re F(w) has the derivatives Re F' by u, -Im F' by v, Re F'' by uu, -Im F'' by uv and -Re F'' by
 * vv. */
static void eval(const void *data, double u, double v, lam_jet *jet) {
  int k = ((const lam_enneper *)data)->order, m = 2 * k + 1;
  complex double w = lam_complex(u, v), down = lam_complex(0, -1); /* Im F = Re(-i F) */

  complex double dg = power(w, k - 1), g = dg * w; /* dg: w^(k-1) */
  lam_triple f = {w - g * g * w / m, down * (w + g * g * w / m), 2 * g * w / (k + 1)};
  lam_triple df = {1 - g * g, down * (1 + g * g), 2 * g};
  lam_triple ddf = {-2 * k * g * dg, down * (2 * k * g * dg), 2 * k * dg};

  jet->x = real_part(f);
  jet->u = real_part(df);
  jet->v = lam_scale(imaginary_part(df), -1);
  jet->uu = real_part(ddf);
  jet->uv = lam_scale(imaginary_part(ddf), -1);
  jet->vv = lam_scale(jet->uu, -1);
}

/* Where two sheets first meet: r^(2k) = 2k + 1. The default charts reach three quarters of
 * it. */
static double default_reach(int k) { return 0.75 * pow(2 * k + 1, 0.5 / k); }

/* The square in the circle of that reach; one quarter of it where the chart is branched. */
static bool domain(const void *data, lam_chart chart, double p[2], double q[2], bool closed[2]) {
  int k = ((const lam_enneper *)data)->order;
  if (chart == LAM_CHART_DIAGONAL) return false;
  double side =
      chart == LAM_CHART_NATURAL ? default_reach(k) : pow(default_reach(k), 0.5 * (k + 1));
  side *= M_SQRT1_2;
  double low = chart == LAM_CHART_NATURAL || k == 1 ? -side : 0;
  return lam_domain_give((lam_domain){{low, side}, {low, side}, {false, false}}, p, q, closed);
}

/* Branched charts have 2 (k + 1) sectors. */
static int sectors(const void *data, lam_chart chart) {
  int k = ((const lam_enneper *)data)->order;
  bool has_sectors = k > 1 && (chart == LAM_CHART_ASYMPTOTIC || chart == LAM_CHART_PRINCIPAL);
  return has_sectors ? 2 * (k + 1) : 0;
}

/* For k = 1 the chart is a turn of the plane: with sector 0, p and q may have any sign. The
 * angle is counted in quarter turns so that the q-axis of a sector and the p-axis of the next
 * give the same bits. */
static void locate(const void *data, lam_chart chart, int sector, double p, double q, double *u,
                   double *v) {
  int k = ((const lam_enneper *)data)->order;
  if (chart == LAM_CHART_NATURAL) {
    *u = p;
    *v = q;
    return;
  }

  double quarters = atan2(q, p) / M_PI_2 + sector;
  if (quarters >= 2 * (k + 1)) quarters -= 2 * (k + 1);
  double phase = chart == LAM_CHART_ASYMPTOTIC ? 0.5 : 0;
  double angle = (quarters + phase) * LAM_PI / (k + 1), radius = pow(hypot(p, q), 2.0 / (k + 1));
  *u = radius * cos(angle);
  *v = radius * sin(angle);
}

static const lam_key keys[] = {LAM_INTEGER_KEY(lam_enneper, "order", order, "1", 1, 9,
                                               "Order k: the rim rises and falls k + 1 times; 1 is "
                                               "the classical saddle, 2 a monkey saddle."),
                               {0}};

const lam_surface_kind lam_surface_enneper = {
    .head = {.name = "enneper",
             .title = "Enneper's surface",
             .doc = "A minimal surface that looks like a saddle with k + 1 valleys and stands on "
                    "as many feet. Its asymptotic lines are orthogonal, so that straight lamellas "
                    "cross at right angles: the first choice for an asymptotic gridshell. For "
                    "order 1 the curvature lines are the lines of u and v and the asymptotic lines "
                    "their diagonals. For higher orders the middle is a flat point, where k + 1 "
                    "lines of each family meet: an irregular vertex of the net. The surface cuts "
                    "itself beyond |w| = (2k+1)^(1/(2k)); the default domain stays inside.",
             .equation = "x = Re(w - w^(2k+1)/(2k+1)), y = Im(w + w^(2k+1)/(2k+1)), z = Re(2 "
                         "w^(k+1)/(k+1)), w = u + iv",
             .source = "thesis ch. 1 (with its curvature and asymptotic lines exchanged); Dierkes "
                       "et al., Minimal Surfaces, 3.5",
             .keys = keys,
             .params_size = sizeof(lam_enneper)},
    .eval = eval,
    .domain = domain,
    .locate = locate,
    .sectors = sectors};
