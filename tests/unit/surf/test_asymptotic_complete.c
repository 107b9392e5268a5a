/* Corner data that were left out. */
#include "tests/unit/asymptotic_quad_fixture.h"

static double energy_of(quad_fixture *f, const lam_quad_corners *q) {
  lam_errors errors = {.arena = f->arena};
  lam_quad_boundary boundary;
  bool made =
      lam_quad_boundary_make(f->arena, q, LAM_QUAD_BI7, (lam_location){0}, &errors, &boundary);
  return made ? boundary.energy : INFINITY;
}

/* Curvatures left out: less energy than with the given ones, a minimum (no curvature moved by 1 %
 * lowers it), and the surface is asymptotic. Sides left out: those that the case gives, where the
 * tangents show them, which they do in these cases. */
static void test_completed(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "quintic.json"), *c;
  size_t number;
  json_array_foreach(cases, number, c) {
    const char *id = json_string_value(json_object_get(c, "id"));
    if (number > 5 || number == 3) continue; /* curved sides; the time of a unit test */
    lam_quad_corners given = quad_corners(c, json_object_get(c, "tangent_points"), 5), q = given;
    for (int i = 0; i < 4; i++)
      for (int e = 0; e < 2; e++) q.curvature[i][e] = q.side[i][e] = 0;
    lam_quad_missing missing = {.sides = true, .curvatures = true};
    assert_true(lam_quad_corners_complete(f->arena, &q, LAM_QUAD_BI7, missing, (lam_location){0},
                                          &f->errors));
    for (int i = 0; i < 4; i++)
      if (q.side[i][0] != given.side[i][0] || q.side[i][1] != given.side[i][1])
        fail_msg("%s: side of r%d is %d, expected %d", id, i + 1, q.side[i][0], given.side[i][0]);
    double least = energy_of(f, &q), before = energy_of(f, &given);
    if (!(least <= before * (1 + 1e-9)))
      fail_msg("%s: energy %.9g, with the given curvatures %.9g", id, least, before);
    for (int k = 0; k < 16; k++) {
      lam_quad_corners near = q;
      near.curvature[k / 4][k / 2 % 2] *= k % 2 ? 1.01 : 1 / 1.01;
      if (!(energy_of(f, &near) > least)) fail_msg("%s: curvature %d lowers the energy", id, k / 2);
    }
    lam_asymptotic_patch patch;
    assert_true(lam_asymptotic_patch_make(f->arena, &q, LAM_QUAD_BI7, (lam_location){0}, &f->errors,
                                          &patch));
    quad_assert_asymptotic(id, &patch.surface, &q, 1e-10);
  }
}

/* Slopes left out: a calmer surface than with the given ones, with the horizontal parts kept, and a
 * minimum. */
static void test_slopes(void **state) {
  quad_fixture *f = *state;
  const json_t *c = json_array_get(quad_cases(f, "quintic.json"), 3);
  lam_quad_corners given = quad_corners(c, json_object_get(c, "tangent_points"), 5), q = given;
  lam_asymptotic_patch before, after, near;
  assert_true(lam_quad_corners_complete(f->arena, &q, LAM_QUAD_BI7,
                                        (lam_quad_missing){.slopes = true}, (lam_location){0},
                                        &f->errors));
  assert_true(lam_asymptotic_patch_make(f->arena, &given, LAM_QUAD_BI7, (lam_location){0},
                                        &f->errors, &before));
  assert_true(
      lam_asymptotic_patch_make(f->arena, &q, LAM_QUAD_BI7, (lam_location){0}, &f->errors, &after));
  assert_true(after.energy < 0.99 * before.energy);
  for (int k = 0; k < 16; k++) {
    lam_vec3 *t = &q.tangent[k / 4][k / 2 % 2], kept = *t;
    assert_near(kept.x, given.tangent[k / 4][k / 2 % 2].x, 0);
    t->z += k % 2 ? 0.01 : -0.01;
    assert_true(lam_asymptotic_patch_make(f->arena, &q, LAM_QUAD_BI7, (lam_location){0}, &f->errors,
                                          &near));
    assert_true(near.energy > after.energy);
    *t = kept;
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_completed), QUAD_TEST(test_slopes)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
