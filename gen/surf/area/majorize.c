/* The iteration of Wu & Wang, step 5, on the whole surface. Called by area_solve.c, and patch by
 * patch by area_patches.c.
 *
 * I(x; x0) = integral (E G0 - 2 F F0 + G E0) / a0 is a quadratic form of the points. With the
 * factor 1/2 it is at least the area of x and equals that of x0 at x0, so its minimizer has no
 * larger area. Step: M d = -A'. */
#include "surf/area/area_parts.h"
#include <math.h>

/* The full step is always taken; it needs no line search. */
void lam_area_majorize(lam_arena *arena, const lam_area_form *form,
                       const lam_least_area_options *options, lam_vec3 *points,
                       lam_least_area_result *result) {
  lam_area_system system = lam_area_system_make(arena, form, 1);
  lam_vec3 *step = LAM_NEW(arena, lam_vec3, form->inner[0] * form->inner[1]);
  double scale = result->area, value = lam_area_vary(form, points);

  for (; result->iterations < options->most && !result->converged; result->iterations++) {
    double before = value;
    if (!lam_area_system_factor(&system, form, 0)) {
      result->reason = "the surface is degenerate";
      return;
    }

    lam_area_system_step(arena, &system, form->gradient, step);
    lam_area_move(form, points, 1, step, points);
    value = lam_area_vary(form, points);
    result->evaluations++;
    result->converged = options->enough > 0 ? value <= options->enough
                                            : before - value <= options->tolerance * scale;
  }

  if (result->converged) result->reason = lam_area_converged(options);
}
