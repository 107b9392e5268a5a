/* Color scales of maps: which value has which color. Used by the plots beside it and by
 * formats/gltf/plot_gltf.c. */
#ifndef LAM_FORMATS_PLOT_COLOR_SCALE_H
#define LAM_FORMATS_PLOT_COLOR_SCALE_H

#include "core/model.h"
#include "core/ramp.h"
#include "core/text.h"

/* Values from low to high. Diverging: low = -high, for values of both signs, pale at 0. Constant:
 * all values agree within 1e-9 of themselves. */
typedef struct lam_color_scale {
  double low, high;
  bool diverging, constant;
} lam_color_scale;

/* The scale of a map: from the range that it shares with others, if it has one, otherwise from
 * its own minimum to its maximum. */
lam_color_scale lam_map_scale(const lam_map *map);
/* The color of a value, in linear light; values beyond the ends have their colors, those that are
 * not finite are gray. */
lam_rgb lam_color_of(const lam_color_scale *scale, double value);
/* As #rrggbb (sRGB). */
void lam_rgb_write(lam_text *out, lam_rgb color);

#endif
