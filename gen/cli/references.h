/* What a design refers to outside itself: meshes beside it, a setting among the templates. */
#ifndef LAM_CLI_REFERENCES_H
#define LAM_CLI_REFERENCES_H

#include "design/design.h"

/* Adds a message for every file of the design that cannot be read and for a setting that does not exist; make_surface:
 * also what the surface finds wrong with its keys when they are taken together, which may take as long as computing it,
 * and which building finds anyway. The design must have been parsed without errors. */
void lam_references_check(const lam_design *design, bool make_surface, lam_errors *errors);

#endif
