/* The materials that parts can be made of: one table. Read by the rows of parts (fab/parts,
 * fab/lamella) through their `material` key, and by library/reference/sections.c, which lists
 * them. */
#ifndef LAM_FAB_MATERIAL_H
#define LAM_FAB_MATERIAL_H

#include "core/model.h"

/* NULL-terminated names in the order of lam_materials: the choices of a `material` key. */
extern const char *const lam_material_names[];
/* lam_material_count rows, in SI units; the value of a `material` key is an index into them. */
extern const lam_material lam_materials[];
extern const int lam_material_count;

#endif
