/* Asymptotic quadrilaterals from corner data to the finished surface: chooses among the
 * boundaries and the tangents across them. Called by asymptotic_quad.c, complete.c, the
 * benchmark and the tests. */
#include "surf/asymptotic/quad_parts.h"

/* Rational, quartic (curvatures follow) or of least energy, as the form says. */
bool lam_quad_boundary_make(lam_arena *arena, const lam_quad_corners *corners, lam_quad_form form,
                            lam_location location, lam_errors *errors,
                            lam_quad_boundary *boundary) {
  const lam_quad_recipe *recipe = &lam_quad_recipes[form];
  *boundary = (lam_quad_boundary){.energy = 0};
  if (!lam_quad_corners_check(corners, form, location, errors)) return false;
  lam_quad_boundary_start(arena, corners, recipe, boundary);

  bool made;
  if (form == LAM_QUAD_BI13)
    made = lam_quad_boundary_rational(arena, corners, location, errors, boundary);
  else if (recipe->degree == 4 && !recipe->inner)
    made = lam_quad_boundary_quartic(arena, corners, location, errors, boundary);
  else
    made = lam_quad_boundary_least(arena, corners, location, errors, boundary);
  if (made) lam_quad_boundary_measure(boundary);
  return made;
}

/* The boundary, and a surface on it: rational, with tangents of least energy, or with those of
 * the thesis. */
bool lam_asymptotic_patch_make(lam_arena *arena, const lam_quad_corners *corners,
                               lam_quad_form form, lam_location location, lam_errors *errors,
                               lam_asymptotic_patch *patch) {
  const lam_quad_recipe *recipe = &lam_quad_recipes[form];
  int before = errors->count;
  if (!lam_quad_boundary_make(arena, corners, form, location, errors, &patch->boundary))
    return false;

  bool made;
  if (form == LAM_QUAD_BI13)
    made = lam_quad_patch_rational(arena, &patch->boundary, recipe, location, errors, patch);
  else if (recipe->free)
    made = lam_quad_patch_free(arena, &patch->boundary, recipe, location, errors, patch);
  else
    made = lam_quad_patch_fixed(arena, &patch->boundary, recipe, patch);

  if (!made && errors->count == before)
    lam_error_add(errors, location, "form",
                  "no inner points of least energy: the boundary is degenerate");
  return made;
}
