#include "surf/placement.h"
#include "core/numbers.h"

#define AT(member) offsetof(lam_placement_keys, member)

const lam_key lam_placement_key_table[] = {
    {.name = "u",
     .type = LAM_KEY_NUMBER,
     .offset = AT(u),
     .count = 2,
     .initial = "",
     .given_offset = AT(u_given),
     .doc = "The part of the surface that the net covers: from and to, in the first parameter of "
            "the parameterization "
            "that the net uses (an asymptotic net: asymptotic parameters). Left out: the surface's "
            "usual range."},
    {.name = "v",
     .type = LAM_KEY_NUMBER,
     .offset = AT(v),
     .count = 2,
     .initial = "",
     .given_offset = AT(v_given),
     .doc = "The same for the second parameter."},
    {.name = "size",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_LENGTH,
     .offset = AT(size),
     .count = 1,
     .initial = "",
     .min = 1e-4,
     .max = 1e4,
     .given_offset = AT(size_given),
     .doc = "The larger of the net's extents along x and y, after the rotation: everything is "
            "scaled to it. Left out: the "
            "surface keeps its own units, taken as meters."},
    {.name = "rotate",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_ANGLE,
     .offset = AT(rotate),
     .count = 3,
     .initial = "[0, 0, 0]",
     .min = -2 * LAM_PI,
     .max = 2 * LAM_PI,
     .doc = "Turns the surface about the x axis, then the y axis, then the z axis."},
    {.name = "ground",
     .type = LAM_KEY_FLAG,
     .offset = AT(ground),
     .count = 1,
     .initial = "yes",
     .doc = "Moves the net up or down so that its lowest point stands on the ground, z = 0."},
    {.name = NULL},
};

static void check_range(const double range[2], bool given, const char *key, lam_location location,
                        lam_errors *errors) {
  if (!given || range[0] < range[1]) return;
  lam_error_add(errors, location, key,
                "given [%.6g, %.6g]; expected the smaller number first, then a larger one",
                range[0], range[1]);
}

void lam_placement_keys_check(const lam_placement_keys *surface, lam_location location,
                              lam_errors *errors) {
  check_range(surface->u, surface->u_given, "surface.u", location, errors);
  check_range(surface->v, surface->v_given, "surface.v", location, errors);
}
