/* The materials that parts can be made of: one list. */
#ifndef LAM_FAB_MATERIAL_H
#define LAM_FAB_MATERIAL_H

#include "core/model.h"

/* NULL-terminated names, for keys and messages, in the order of lam_materials. */
extern const char *const lam_material_names[];
extern const lam_material lam_materials[];
extern const int lam_material_count;

#endif
