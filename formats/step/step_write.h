/* Entities of a STEP file, one after another; for step.c. Reals carry a decimal point and an
 * upper-case E: readers silently misread others. Functions that add an entity return its number. */
#ifndef LAM_FORMATS_STEP_STEP_WRITE_H
#define LAM_FORMATS_STEP_STEP_WRITE_H

#include "core/text.h"
#include "formats/spline/spline.h"

typedef struct lam_step_writer {
  lam_text *out;
  int last; /* number of the last entity; 0: none yet */
} lam_step_writer;

/* Begins an entity: what is added to `out` until lam_step_end is its text. */
int lam_step_begin(lam_step_writer *s);
void lam_step_end(lam_step_writer *s);
/* An entity of nothing but this text, without its number and semicolon. */
int lam_step_plain(lam_step_writer *s, const char *entity);
/* (#1,#2...) for every stride-th of `numbers`, count of them. */
void lam_step_references(lam_step_writer *s, const int *numbers, int count, int stride);
/* A UTF-8 string between quotes, in ASCII: quotes and backslashes are doubled, other letters
 * written by their code points. */
void lam_step_quoted(lam_step_writer *s, const char *string);

/* A CARTESIAN_POINT; p in meters, the file has millimeters. */
int lam_step_point(lam_step_writer *s, lam_vec3 p);
/* A B-spline curve or surface, rational when it has weights. points: the numbers of the control
 * points' entities, in the order of the points that the curve or surface is given by. Knots must
 * be clamped for the sides of a surface to be its curves. */
int lam_step_curve(lam_step_writer *s, const char *name, const lam_spline_side *curve,
                   const int *points);
int lam_step_surface(lam_step_writer *s, const lam_spline_surface *surface, const int *points);

#endif
