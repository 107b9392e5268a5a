/* Pictures printed on surfaces: through the parameter lines, which draws them out, or through
 * the flattened surface, which hardly does when the surface is nearly developable (Li & Deng,
 * sec. 5). Called by the pipeline of design/. */
#ifndef LAM_SURF_FLATTEN_TEXTURE_H
#define LAM_SURF_FLATTEN_TEXTURE_H

#include "core/arena.h"
#include "core/model.h"

/* What is printed. */
typedef enum lam_motif {
  LAM_MOTIF_LETTER,
  LAM_MOTIF_CHECKER,

  /* No picture: every vertex has the color of the distortion around it, the ratio of singular
   * values, from 1 to the largest on any of the sheets. The picture is the color scale. */
  LAM_MOTIF_DISTORTION
} lam_motif;

/* In the order of the values; NULL-terminated. */
extern const char *const lam_motif_names[];

/* Where the vertices are on the picture. */
typedef enum lam_print_layout {
  LAM_PRINT_FLATTENING, /* from the flattened surface */
  /* From the parameters, over a rectangle with the mean lengths of opposite sides. */
  LAM_PRINT_PARAMETERS,
  /* Both, side by side, and in front of each the same print laid flat. */
  LAM_PRINT_COMPARE
} lam_print_layout;

/* In the order of the values; NULL-terminated. */
extern const char *const lam_print_layout_names[];

/* A square picture of size x size pixels, sRGB, 3 bytes each, rows from the top, owned by the
 * arena: the motif inside of the rectangle width x height in the middle (the letter B, nine
 * tenths of its shorter side), lengths as shares of the square. */
unsigned char *lam_motif_draw(lam_arena *arena, lam_motif motif, double width, double height,
                              int size);

/* The print on a grid of cells x cells of a spline surface. Owned by the arena. */
lam_print *lam_print_make(lam_arena *arena, const lam_spline_surface *surface, lam_motif motif,
                          lam_print_layout layout, int cells);

#endif
