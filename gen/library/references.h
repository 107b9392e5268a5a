/* What a design refers to outside itself: meshes beside it, a setting among the templates. */
#ifndef LAM_LIBRARY_REFERENCES_H
#define LAM_LIBRARY_REFERENCES_H

#include "design/design.h"

/* Adds a message for every file of the design that cannot be read and for a setting that does not
 * exist; make_surface: also what the surface finds wrong with its keys when they are taken
 * together, which may take as long as computing it, and which building finds anyway. The design
 * must have been parsed without errors. */
void lam_references_check(const lam_design *design, bool make_surface, lam_errors *errors);

/* The files beside the design that it names: meshes, points, curves, surfaces, and designs as
 * NAME.yaml. The design must have been parsed without errors. Returns how many, at most
 * LAM_REFERENCES. */
enum { LAM_REFERENCES = 8 };
int lam_references_list(lam_arena *arena, const lam_design *design,
                        const char *files[LAM_REFERENCES]);

#endif
