/* Color scales of maps, for the plots beside it and formats/gltf/plot_gltf.c. */
#include "formats/plot/color_scale.h"

#include <math.h>

/* A scale with values of both signs reaches as far to either side, so that its middle is 0. */
lam_color_scale lam_map_scale(const lam_map *map) {
  bool shared = map->range[0] < map->range[1];
  lam_color_scale s = {map->summary.min, map->summary.max, false, false};
  if (shared) s.low = map->range[0], s.high = map->range[1];

  double size = fmax(fabs(s.low), fabs(s.high));
  s.constant = !(s.high - s.low > 1e-9 * size);
  s.diverging = !s.constant && s.low < 0 && s.high > 0;
  if (s.diverging) s.low = -size, s.high = size;
  return s;
}

/* A constant scale has one color, that of its middle. */
lam_rgb lam_color_of(const lam_color_scale *scale, double value) {
  if (!isfinite(value)) return (lam_rgb){.7, .7, .7};
  double t = scale->constant ? .5 : (value - scale->low) / (scale->high - scale->low);
  t = fmin(fmax(t, 0), 1);
  return scale->diverging ? lam_ramp_diverging(t) : lam_ramp_sequential(t);
}

void lam_rgb_write(lam_text *out, lam_rgb color) {
  lam_text_printf(out, "#%02x%02x%02x", (unsigned)lam_srgb(color.r), (unsigned)lam_srgb(color.g),
                  (unsigned)lam_srgb(color.b));
}
