/* What a design refers to outside itself: meshes beside it, a setting among the templates. */
#ifndef LAM_CLI_REFERENCES_H
#define LAM_CLI_REFERENCES_H

#include "design/design.h"

/* Adds a message for every file of the design that cannot be read and for a setting that does not exist, and what the
 * surface finds wrong with its keys when they are taken together. The design must have been parsed without errors. */
void lam_references_check(const lam_design *design, lam_errors *errors);

#endif
