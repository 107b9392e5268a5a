/* The keys that every surface of a design accepts beside those of its kind. The table is a row
 * of design/design_keys.c; design/parse.c calls the check. */
#include "surf/placement.h"
#include "core/numbers.h"

const lam_key lam_placement_key_table[] = {
    LAM_NUMBER_KEY(lam_placement_keys, "u", u, "", 0, 0,
                   "The part of the surface that the net covers: from and to, in the first "
                   "parameter of the parameterization that the net uses (an asymptotic net: "
                   "asymptotic parameters). Left out: the surface's usual range.",
                   LAM_GIVEN(lam_placement_keys, u_given)),
    LAM_NUMBER_KEY(lam_placement_keys, "v", v, "", 0, 0, "The same for the second parameter.",
                   LAM_GIVEN(lam_placement_keys, v_given)),
    LAM_LENGTH_KEY(lam_placement_keys, "size", size, "", 1e-4, 1e4,
                   "The larger of the net's extents along x and y, after the rotation: everything "
                   "is scaled to it. Left out: the surface keeps its own units, taken as meters.",
                   LAM_GIVEN(lam_placement_keys, size_given)),
    LAM_ANGLE_KEY(lam_placement_keys, "rotate", rotate, "[0, 0, 0]", -2 * LAM_PI, 2 * LAM_PI,
                  "Turns the surface about the x axis, then the y axis, then the z axis."),
    LAM_FLAG_KEY(lam_placement_keys, "ground", ground, "yes",
                 "Moves the net up or down so that its lowest point stands on the ground, z = 0."),
    {.name = NULL},
};

/* A range that is given must run from a smaller to a larger number. */
static void check_range(const double range[2], bool given, const char *key, lam_location location,
                        lam_errors *errors) {
  if (!given || range[0] < range[1]) return;
  lam_error_add(errors, location, key,
                "given [%.6g, %.6g]; expected the smaller number first, then a larger one",
                range[0], range[1]);
}

void lam_placement_keys_check(const lam_placement_keys *keys, lam_location location,
                              lam_errors *errors) {
  check_range(keys->u, keys->u_given, "surface.u", location, errors);
  check_range(keys->v, keys->v_given, "surface.v", location, errors);
}
