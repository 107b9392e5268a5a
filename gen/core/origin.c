/* Where far points get a local origin. Called by design/local_origin.c. */
#include "core/origin.h"

static const double times_extent = 100, far_away = 1000; /* the latter in meters */

/* The box of the points; its middle and its diagonal. */
static double extent_of(const lam_vec3 *points, int count, lam_vec3 *middle) {
  lam_vec3 low = points[0], high = points[0];
  for (int i = 1; i < count; i++) {
    lam_vec3 x = points[i];
    low = lam_v3(fmin(low.x, x.x), fmin(low.y, x.y), fmin(low.z, x.z));
    high = lam_v3(fmax(high.x, x.x), fmax(high.y, x.y), fmax(high.z, x.z));
  }
  *middle = lam_mix(low, high, .5);
  return lam_distance(low, high);
}

/* No negative zeros. */
static double rounded(double x, double step) { return nearbyint(x / step) * step + 0.; }

lam_vec3 lam_local_origin(const lam_vec3 *points, int count) {
  lam_vec3 middle, none = {0, 0, 0};
  if (count < 1) return none;

  double extent = extent_of(points, count, &middle), distance = lam_length(middle);
  bool moved = distance > times_extent * extent || (distance > far_away && distance > extent);
  if (!moved || !(extent > 0) || !isfinite(distance)) return none;

  double step = pow(10, ceil(log10(extent)));
  return lam_v3(rounded(middle.x, step), rounded(middle.y, step), rounded(middle.z, step));
}
