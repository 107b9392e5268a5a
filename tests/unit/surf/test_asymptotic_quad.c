/* Surfaces on polynomial asymptotic quadrilaterals: quintic and quartic boundaries, and corner data
 * that are refused.
 */
#include "tests/unit/asymptotic_quad_fixture.h"

/* Corner data of Enneper's surface, catenoid, pseudosphere, free forms, and one to four straight
 * sides. Expected parameters, energies and points were computed independently (thesis 2.3 with its
 * misprints corrected). */
static void test_quintic(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "quintic.json"), *c, *expected;
  size_t i, k;
  assert_int_equal(json_array_size(cases), 12);
  json_array_foreach(cases, i, c) json_array_foreach(json_object_get(c, "expected"), k, expected)
      quad_check(f, c, expected, 5, 1e-8, 1e-9);
}

/* Curvatures are results here. Enneper's boundary and the symmetric one leave one parameter free.
 */
static void test_quartic(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "quartic.json"), *c, *expected;
  size_t i, k;
  assert_int_equal(json_array_size(cases), 3);
  json_array_foreach(cases, i, c) json_array_foreach(json_object_get(c, "expected"), k, expected) {
    lam_asymptotic_patch patch = quad_check(f, c, expected, 4, 1e-8, 1e-9);
    const json_t *middle = json_object_get(expected, "mid_points");
    for (int j = 0; middle && j < 4; j++)
      assert_near(
          lam_distance(patch.boundary.curve[j].points[2], quad_vector(json_array_get(middle, j))),
          0, 1e-9);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_quintic), QUAD_TEST(test_quartic)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
