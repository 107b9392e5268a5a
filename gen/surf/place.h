/* Where a surface stands: keys that every surface accepts beside its own. */
#ifndef LAM_SURF_PLACE_H
#define LAM_SURF_PLACE_H

#include "core/error.h"
#include "core/key.h"

typedef struct lam_surface_place {
  double u[2], v[2]; /* ranges of the chart that the net uses; meaningful when given */
  bool u_given, v_given;
  double size; /* largest horizontal extent after rotation, meters; meaningful when given */
  bool size_given;
  double rotate[3]; /* about the x, y and z axis, in this order, radians */
  bool ground;      /* the lowest point is moved to z = 0 */
} lam_surface_place;

extern const lam_key lam_surface_place_keys[];

/* Adds what only shows when keys are taken together: a range from a larger to a smaller number. place: of the surface
 * in the design. */
void lam_surface_place_check(const lam_surface_place *surface, lam_place place, lam_errors *errors);

#endif
