/* What a design asks about where a surface stands and how large it is: the keys that every
 * surface accepts beside its own. Read by design/ and by net/trace, which turns them into a
 * lam_placement: how points are moved. */
#ifndef LAM_SURF_PLACEMENT_H
#define LAM_SURF_PLACEMENT_H

#include "core/error.h"
#include "core/key.h"

/* Filled by the parser from the table below. */
typedef struct lam_placement_keys {
  double u[2], v[2]; /* ranges of the chart that the net uses; meaningful when given */
  bool u_given, v_given;
  double size; /* largest horizontal extent after rotation, meters; meaningful when given */
  bool size_given;
  double rotate[3]; /* about the x, y and z axis, in this order, radians */
  bool ground;      /* the lowest point is moved to z = 0 */
} lam_placement_keys;

/* The rows of these keys; ends with a row without a name. */
extern const lam_key lam_placement_key_table[];

/* Adds to errors what only shows when keys are taken together: a range that runs from a larger
 * to a smaller number. location: of the surface in the design. */
void lam_placement_keys_check(const lam_placement_keys *keys, lam_location location,
                              lam_errors *errors);

#endif
