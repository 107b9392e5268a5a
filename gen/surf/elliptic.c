/* Jacobi's elliptic functions by the descending Landen transformation (Abramowitz & Stegun
 * 16.4, 17.6). Used by surf/kinds/delaunay.c and scherk.c.
 *
 * The means: a_0 = 1, b_0 = sqrt(1-m), c_0 = sqrt(m);
 *   a_{n+1} = (a_n + b_n)/2,  b_{n+1} = sqrt(a_n b_n),  c_{n+1} = (a_n - b_n)/2;
 *   K = pi / (2 a_N),  E/K = 1 - sum 2^(n-1) c_n^2.
 * The amplitude:
 *   phi_N = 2^N a_N x,  sin(2 phi_{n-1} - phi_n) = (c_n / a_n) sin phi_n,  am x = phi_0.
 * Jacobi's zeta function is Z(x) = sum_{n>=1} c_n sin phi_n, and the integral of dn^2 is
 * (E/K) x + Z(x). dn^2 is taken as cn^2 + (1-m) sn^2, a sum of positive terms. */
#include "surf/elliptic.h"
#include <float.h>
#include <math.h>

/* Means until c_n is below rounding: convergence is quadratic, so that few levels are needed. */
lam_elliptic lam_elliptic_make(double complement) {
  lam_elliptic e = {.complement = complement};
  double b = sqrt(complement), sum = 0, weight = 0.5;
  e.a[0] = 1;
  e.c[0] = sqrt(1 - complement);

  while (e.c[e.levels] > DBL_EPSILON * 0.01 && e.levels + 1 < LAM_ELLIPTIC_LEVELS) {
    double a = e.a[e.levels];
    sum += weight * e.c[e.levels] * e.c[e.levels];
    weight *= 2;
    e.levels++;
    e.a[e.levels] = (a + b) / 2;
    e.c[e.levels] = (a - b) / 2;
    b = sqrt(a * b);
  }

  e.quarter = M_PI_2 / e.a[e.levels];
  e.slope = 1 - sum;
  return e;
}

/* phi is brought down from level N to 0; zeta is summed on the way. */
lam_jacobi lam_jacobi_eval(const lam_elliptic *elliptic, double x) {
  /* x is brought to within a quarter period, by half turns that change signs only. */
  double half_turns = nearbyint(x / (2 * elliptic->quarter)),
         rest = x - half_turns * 2 * elliptic->quarter;

  double phi = ldexp(elliptic->a[elliptic->levels] * rest, elliptic->levels), zeta = 0;
  for (int n = elliptic->levels; n > 0; n--) {
    double s = sin(phi);
    zeta += elliptic->c[n] * s;
    phi = (phi + asin(elliptic->c[n] / elliptic->a[n] * s)) / 2;
  }

  double sign = fmod(half_turns, 2) == 0 ? 1 : -1, sn = sin(phi), cn = cos(phi);
  return (lam_jacobi){.sn = sign * sn,
                      .cn = sign * cn,
                      .dn = sqrt(cn * cn + elliptic->complement * sn * sn),
                      .epsilon = elliptic->slope * x + zeta};
}
