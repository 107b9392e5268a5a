/* Surfaces that a program defines (lamella/surface.h), as kinds like all others. Called by
 * library/own_surfaces.c and by lam_surface_make. */
#ifndef LAM_SURF_DEFINED_H
#define LAM_SURF_DEFINED_H

#include "surf/surface.h"

/* The kind of a definition, which is copied, in arena. What is wrong with it is added to
 * errors, and NULL returned. Names that other kinds have are not looked for. */
const lam_surface_kind *lam_surface_kind_defined(lam_arena *arena,
                                                 const lam_surface_definition *definition,
                                                 lam_errors *errors);

/* Whether its derivatives agree with difference quotients at the middle of its rectangle, for
 * these values of its keys; a message otherwise. */
bool lam_surface_defined_check(const lam_surface_kind *kind, const double *numbers,
                               lam_location location, lam_errors *errors);

/* Its instance with the values of its keys: what lam_surface_kind.prepare gives for other
 * kinds. */
const void *lam_surface_defined_data(lam_arena *arena, const lam_surface_definition *definition,
                                     const double *numbers);

#endif
