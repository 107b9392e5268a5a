/* Models where they stand: about (0, 0, 0) instead of their local origin. For formats whose numbers
 * have enough digits (lam_format's in_place). Called by library/write. */
#ifndef LAM_FORMATS_IN_PLACE_H
#define LAM_FORMATS_IN_PLACE_H

#include "core/arena.h"
#include "core/model.h"

/* The model itself when its origin is (0, 0, 0); otherwise a copy in arena whose positions are
 * those of the world, and whose origin is (0, 0, 0). Maps, prints, records and sheets stay: they
 * are shared with the model. */
const lam_model *lam_model_in_place(lam_arena *arena, const lam_model *model);

#endif
