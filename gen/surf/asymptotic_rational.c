#include "surf/asymptotic_parts.h"
bool lam_quad_boundary_rational(lam_arena *arena, const lam_quad_corners *corners, lam_place place, lam_errors *errors,
                                lam_quad_boundary *boundary) {
  (void)arena, (void)corners, (void)boundary;
  lam_error_add(errors, place, "form", "bi-13 not yet");
  return false;
}
bool lam_quad_patch_rational(lam_arena *arena, const lam_quad_boundary *boundary, const lam_quad_recipe *recipe,
                             lam_asymptotic_patch *patch) {
  (void)arena, (void)boundary, (void)recipe, (void)patch;
  return false;
}
