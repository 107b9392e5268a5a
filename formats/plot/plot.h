/* The panels of a plot and what they share; called by plot_svg.c. Boxes and sizes are in
 * millimeters on the page, y down. */
#ifndef LAM_FORMATS_PLOT_PLOT_H
#define LAM_FORMATS_PLOT_PLOT_H

#include "formats/plot/color_scale.h"

typedef struct lam_box {
  double x, y, width, height;
} lam_box;

/* The net seen from obliquely above, in parallel projection, farther faces first. A vertex colors
 * the quarter of each face next to it, an edge its line, a face itself. With a layout, half of
 * the box shows it in the same colors and at the same scale. The net has quads only. */
void lam_plot_view(lam_text *out, const lam_mesh *net, const lam_map *map,
                   const lam_color_scale *scale, lam_box box);
/* How many elements have which value, in bins of the scale's colors, with both axes; the box is
 * the plot area, labels stand outside it (15 mm below, 12 mm to the left, 6 mm above).
 * Precondition: a finite value, and a finite mean. */
void lam_plot_histogram(lam_text *out, const lam_map *map, const lam_color_scale *scale,
                        lam_box box);

/* A text at x, y, size mm high; anchor: start, middle or end. Markup characters are escaped. */
void lam_plot_text(lam_text *out, double x, double y, double size, const char *anchor,
                   const char *text);
/* A unit such as "m2" or "1/m3" with its last digit raised; other units as they are. May be new,
 * owned by arena. */
const char *lam_plot_unit(lam_arena *arena, const char *unit);
/* "vertices", "edges", "faces"; by lam_map_on. */
extern const char *const lam_map_elements[];

#endif
