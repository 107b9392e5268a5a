/* The face of a developed strip as a sheet of paper: where there is room to write, and writing.
 * Places are boxes in the strip's coordinates (fab/axis.h): low..high along, bottom..top across. */
#ifndef LAM_FAB_FLAT_FACE_H
#define LAM_FAB_FLAT_FACE_H

#include "fab/flat/axis.h"

typedef struct lam_face_box {
  double low, high, bottom, top;
} lam_face_box;

typedef struct lam_face {
  lam_arena *arena;
  const lam_axis *axis;
  double low, high, height; /* the strip reaches from low to high along its axis, and height/2 to
                               both sides of it */
  double margin;            /* kept free along edges and between marks */
  int taken_count, taken_capacity;
  lam_face_box *taken; /* boxes where nothing more may be written */
} lam_face;

lam_face lam_face_make(lam_arena *arena, const lam_axis *axis, double low, double high,
                       double height);
void lam_face_take(lam_face *face, lam_face_box box);
/* True when box and the margin around it touch neither the edges nor what is taken. */
bool lam_face_is_free(const lam_face *face, lam_face_box box);

/* Finds a free place for a box of this width and height, centered at one of the given heights
 * across the strip (tried in order), as near to `from` as there is one between from and to (from >
 * to searches backwards). False when there is none. */
bool lam_face_find(const lam_face *face, double width, double height, double from, double to,
                   const double *centers, int center_count, lam_face_box *box);

/* The height of letters on a strip of a given height, and the steps by which they shrink until they
 * fit. */
double lam_letter_height(double strip_height);
extern const double lam_letter_steps[];
extern const int lam_letter_step_count;

/* Adds a stroke whose points are given in the strip's coordinates. */
void lam_face_stroke(const lam_face *face, lam_paths *paths, lam_layer layer, bool closed,
                     const lam_vec2 *points, int count);
/* Adds a text; its base line begins at (s, h). */
void lam_face_text(const lam_face *face, lam_paths *paths, lam_layer layer, const char *text,
                   double s, double h, double height);
/* Writes a name on LABEL, framed on ENGRAVE, as near to one end of the face as it fits at the
 * largest size; centers: as in lam_face_find. False when it fits at no size. */
bool lam_face_name(lam_face *face, lam_paths *paths, const char *name, bool at_start,
                   const double *centers, int center_count);

#endif
