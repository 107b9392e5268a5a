/* Names of a design as identifiers of another language: OpenSCAD (formats/mesh/scad.c) and POV-Ray
 * (formats/pov/pov.c). */
#ifndef LAM_FORMATS_IDENTIFIER_H
#define LAM_FORMATS_IDENTIFIER_H

#include "core/text.h"

/* Adds name with everything but ASCII letters and digits written as _; a digit may come first. */
void lam_identifier_add(lam_text *out, const char *name);

#endif
