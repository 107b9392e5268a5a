/* Surfaces on asymptotic quadrilaterals of rational quartic curves (thesis 2.4). */
#include "tests/unit/asymptotic_quad_fixture.h"

/* A projective image of Enneper's surface, a catenoid, a free roof. Expected values were computed
 * independently; the minimum over the four free parameters is known to about five digits of the
 * weights, and much better in its energy. */
static void test_rational(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "rational.json"), *c, *expected;
  size_t i, k;
  assert_int_equal(json_array_size(cases), 3);
  json_array_foreach(cases, i, c) json_array_foreach(json_object_get(c, "expected"), k, expected) {
    const char *id = json_string_value(json_object_get(c, "id"));
    lam_asymptotic_patch patch = quad_check(f, c, expected, 4, 1e-6, 1e-6);
    quad_assert_close(id, "boundary energy", patch.boundary.energy,
                      json_number_value(json_object_get(expected, "boundary_energy")), 1e-9);
    for (int j = 0; j < 4; j++) {
      const lam_quad_curve *curve = &patch.boundary.curve[j];
      for (int p = 0; p < 5; p++)
        quad_assert_close(id, "weight", curve->weights[p],
                          quad_number(json_array_get(json_object_get(expected, "weights"), j), p),
                          1e-5);
      assert_near(lam_distance(curve->points[2], quad_vector(json_array_get(
                                                     json_object_get(expected, "mid_points"), j))),
                  0, 1e-5);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_rational)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
