/* Surfaces on asymptotic quadrilaterals of B-spline curves. */
#include "tests/unit/asymptotic_quad_fixture.h"

/* The angle between the surface normals on both sides of an inner knot, at its worst, in degrees.
 */
static double crease(const lam_spline_surface *s, int direction, double knot) {
  double worst = 0;
  for (int g = 1; g < 100; g++) {
    lam_vec3 normal[2];
    for (int side = 0; side < 2; side++) {
      lam_vec3 jet[3][3];
      double at = knot + (side ? 1e-9 : -1e-9), t = g / 100.0;
      quad_jet(s, direction ? t : at, direction ? at : t, jet);
      normal[side] = lam_cross(jet[1][0], jet[0][1]);
    }
    worst = fmax(worst, lam_angle(normal[0], normal[1]));
  }
  return worst * 180 / net_pi;
}

/* Cubic boundaries, whose torsion jumps at the knots: the 16 x 16 net is asymptotic along the
 * boundary and creases inside, by the computed angles. Quartic boundaries: the 14 x 14 net has no
 * crease. Expected values as in test_asymptotic_quad.c; the quartic's points come with the cases.
 */
static void test_spline_boundaries(void **state) {
  quad_fixture *f = *state;
  json_t *cases = quad_cases(f, "b_spline.json"), *c, *expected;
  size_t i, k;
  assert_int_equal(json_array_size(cases), 4);
  json_array_foreach(cases, i, c) json_array_foreach(json_object_get(c, "expected"), k, expected) {
    const char *id = json_string_value(json_object_get(c, "id"));
    lam_asymptotic_patch patch = quad_check(f, c, expected, k ? 4 : 3, 1e-8, 1e-9);
    const json_t *angles = json_object_get(expected, "crease"),
                 *points = json_object_get(expected, "boundary_points");
    for (int d = 0; d < 2; d++)
      for (int j = 0; j < 2; j++) {
        double angle = crease(&patch.surface, d,
                              quad_number(json_array_get(json_object_get(c, "knots"), d), j));
        double want = angles ? quad_number(angles, 2 * d + j) : 0;
        if (!(fabs(angle - want) <= 1e-5 + 1e-3 * want))
          fail_msg("%s: crease of %g deg, expected %g", id, angle, want);
      }
    for (int j = 0; points && j < 4; j++)
      for (int p = 0; p < 7; p++)
        assert_near(lam_distance(patch.boundary.curve[j].points[p],
                                 quad_vector(json_array_get(json_array_get(points, j), p))),
                    0, 1e-8);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {QUAD_TEST(test_spline_boundaries)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
