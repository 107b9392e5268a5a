/* Color scales of maps: colors that are evenly spaced to the eye, in print and without color too. */
#ifndef LAM_FORMATS_COLOR_SCALE_H
#define LAM_FORMATS_COLOR_SCALE_H

#include "core/model.h"
#include "core/text.h"

typedef struct lam_rgb {
  double r, g, b; /* linear light, 0 to 1 */
} lam_rgb;

/* Values from low to high. Diverging: low = -high, for values of both signs, pale at 0. Constant: all values agree
 * within 1e-9 of themselves. */
typedef struct lam_scale {
  double low, high;
  bool diverging, constant;
} lam_color_scale;

lam_color_scale lam_map_scale(const lam_map *map);
/* The color of a value; gray when the value is not finite. */
lam_rgb lam_color_of(const lam_color_scale *scale, double value);
/* As #rrggbb (sRGB). */
void lam_rgb_write(lam_text *out, lam_rgb color);

/* The t-th color of a scale, t in [0, 1]: dark violet to pale yellow, lightness linear in t; or blue over white to red.
 */
lam_rgb lam_ramp_sequential(double t);
lam_rgb lam_ramp_diverging(double t);

#endif
