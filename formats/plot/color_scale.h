/* Color scales of maps. */
#ifndef LAM_FORMATS_PLOT_COLOR_SCALE_H
#define LAM_FORMATS_PLOT_COLOR_SCALE_H

#include "core/model.h"
#include "core/ramp.h"
#include "core/text.h"

/* Values from low to high. Diverging: low = -high, for values of both signs, pale at 0. Constant:
 * all values agree within 1e-9 of themselves. */
typedef struct lam_scale {
  double low, high;
  bool diverging, constant;
} lam_color_scale;

lam_color_scale lam_map_scale(const lam_map *map);
/* The color of a value; gray when the value is not finite. */
lam_rgb lam_color_of(const lam_color_scale *scale, double value);
/* As #rrggbb (sRGB). */
void lam_rgb_write(lam_text *out, lam_rgb color);

#endif
