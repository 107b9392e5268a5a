/* The folder of templates: designs to start from, OpenSCAD modules, POV-Ray scenes. Called by
 * session.c, designs.c and reference/sections.c. Texts are owned by arena. */
#ifndef LAM_LIBRARY_TEMPLATES_H
#define LAM_LIBRARY_TEMPLATES_H

#include "core/arena.h"

/* The folder, without a slash at the end: $LAMELLA_TEMPLATES; or templates/ beside the build folder
 * that this code lies in (the shared library, or the program that it is linked into); or
 * share/lamella/templates beside the bin or lib folder that it is installed in. NULL when there is
 * none. */
const char *lam_template_dir(lam_arena *arena);
/* The names of the shipped designs (folder/designs/NAME.yaml, without the ending), NULL-terminated
 * and sorted; empty when there are none. folder: of the templates, or NULL. */
const char *const *lam_template_designs(lam_arena *arena, const char *folder);
/* The path of a shipped design's file. folder: of the templates; NULL: the current one. */
const char *lam_template_design_path(lam_arena *arena, const char *folder, const char *name);

#endif
