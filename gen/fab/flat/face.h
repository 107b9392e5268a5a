/* The face of a developed strip as a sheet of paper: where there is room to write, and writing.
 * Boxes are given in the strip's coordinates (fab/flat/axis.h): low..high along, bottom..top
 * across. Used by fab/flat/splice.c and fab/lamella/lamella_marks.c. */
#ifndef LAM_FAB_FLAT_FACE_H
#define LAM_FAB_FLAT_FACE_H

#include "fab/flat/axis.h"

typedef struct lam_face_box {
  double low, high, bottom, top;
} lam_face_box;

typedef struct lam_face {
  lam_arena *arena;
  const lam_axis *axis;
  double low, high; /* where the strip begins and ends along its axis */
  double height;    /* it reaches height/2 to both sides of the axis */
  double margin;    /* kept free along edges and between marks */
  int taken_count, taken_capacity;
  lam_face_box *taken; /* boxes where nothing more may be written */
} lam_face;

/* An empty face with a margin of 4 % of its height. axis is kept by pointer. */
lam_face lam_face_make(lam_arena *arena, const lam_axis *axis, double low, double high,
                       double height);
/* Takes a box: nothing more is written on it. */
void lam_face_take(lam_face *face, lam_face_box box);
/* True when box and the margin around it touch neither the edges nor what is taken. */
bool lam_face_is_free(const lam_face *face, lam_face_box box);

/* Finds a free box of this width and height, centered at one of the given heights across the
 * strip (tried in order), as near to `from` as there is one between from and to (from > to
 * searches backwards). A later center is taken only where it comes nearer by a quarter of the
 * width. The box is not taken yet. False when there is none. */
bool lam_face_find(const lam_face *face, double width, double height, double from, double to,
                   const double *centers, int center_count, lam_face_box *box);

/* The height of letters on a strip of a given height: a fifth of it, 20 mm at most; and the
 * factors, from 1 down, by which letters shrink until they fit. */
double lam_letter_height(double strip_height);
extern const double lam_letter_steps[];
extern const int lam_letter_step_count;

/* Adds a stroke to paths; its points are given in the strip's coordinates and bent with the
 * axis. */
void lam_face_stroke(const lam_face *face, lam_paths *paths, lam_layer layer, bool closed,
                     const lam_vec2 *points, int count);
/* Adds a text whose capitals are `height` high, bent with the axis; its base line begins at (s,
 * h). */
void lam_face_text(const lam_face *face, lam_paths *paths, lam_layer layer, const char *text,
                   double s, double h, double height);
/* Writes a name on LABEL, framed on ENGRAVE, as near to one end of the face as it fits at the
 * largest size, no further than the middle and six heights from the end; takes the frame.
 * centers: as in lam_face_find. False when it fits at no size; nothing is drawn then. */
bool lam_face_name(lam_face *face, lam_paths *paths, const char *name, bool at_start,
                   const double *centers, int center_count);

#endif
