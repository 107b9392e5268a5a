/* Lettering as single strokes, for lasers, plotters and knives: A-Z, a-z, 0-9, space and
 *   - . / ( ) + :
 * A character that the alphabet lacks is drawn as a box. Used for names on parts by fab/flat
 * (face, splice) and fab/parts (panels, flat pattern). */
#ifndef LAM_FAB_FLAT_LETTERING_H
#define LAM_FAB_FLAT_LETTERING_H

#include "fab/flat/path.h"

/* Width of a text whose capitals are `height` high, from the first stroke to the last, in
 * meters. */
double lam_lettering_width(const char *text, double height);
/* Adds the strokes of text to paths, on the layer LABEL or ENGRAVE. origin: left end of the
 * base line; angle: of the base line, from the x axis; height: of the capitals. Descenders
 * reach height/3 below the base line. */
void lam_lettering_add(lam_paths *paths, lam_layer layer, const char *text, lam_vec2 origin,
                       double angle, double height);
/* The characters that the alphabet has, as a string: for the tests
 * (tests/unit/fab/test_lettering.c). */
const char *lam_lettering_characters(void);

#endif
