#include "surf/place.h"

#define AT(member) offsetof(lam_surface_place, member)

const lam_key lam_surface_place_keys[] = {
    {.name = "u",
     .type = LAM_KEY_NUMBER,
     .offset = AT(u),
     .count = 2,
     .initial = "",
     .given_offset = AT(u_given),
     .doc = "The part of the surface that the net covers: from and to, in the first parameter of the parameterization "
            "that the net uses (an asymptotic net: asymptotic parameters). Left out: the surface's usual range."},
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
     .doc =
         "The larger of the net's extents along x and y, after the rotation: everything is scaled to it. Left out: the "
         "surface keeps its own units, taken as meters."},
    {.name = "rotate",
     .type = LAM_KEY_NUMBER,
     .unit = LAM_UNIT_ANGLE,
     .offset = AT(rotate),
     .count = 3,
     .initial = "[0, 0, 0]",
     .min = -2 * 3.14159265358979323846,
     .max = 2 * 3.14159265358979323846,
     .doc = "Turns the surface about the x axis, then the y axis, then the z axis."},
    {.name = "ground",
     .type = LAM_KEY_FLAG,
     .offset = AT(ground),
     .count = 1,
     .initial = "yes",
     .doc = "Moves the net up or down so that its lowest point stands on the ground, z = 0."},
    {.name = NULL},
};

static void check_range(const double range[2], bool given, const char *key, lam_place place, lam_errors *errors) {
  if (!given || range[0] < range[1]) return;
  lam_error_add(errors, place, key, "given [%.6g, %.6g]; expected the smaller number first, then a larger one",
                range[0], range[1]);
}

void lam_surface_place_check(const lam_surface_place *surface, lam_place place, lam_errors *errors) {
  check_range(surface->u, surface->u_given, "surface.u", place, errors);
  check_range(surface->v, surface->v_given, "surface.v", place, errors);
}
