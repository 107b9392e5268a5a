/* Where far points get their local origin: by the rule in core/origin.h. */
#include "core/origin.h"
#include "tests/unit/asserts.h"

/* The origin of a square of the given side whose first corner is at (x, y, z). */
static lam_vec3 origin_of(double x, double y, double z, double side) {
  const lam_vec3 corners[2] = {{x, y, z}, {x + side, y + side, z}};
  return lam_local_origin(corners, 2);
}

static void assert_vector(lam_vec3 value, double x, double y, double z) {
  assert_near(value.x, x, 0);
  assert_near(value.y, y, 0);
  assert_near(value.z, z, 0);
}

static void near_points_stay(void **state) {
  (void)state;
  assert_vector(origin_of(-2, -2, 0, 4), 0, 0, 0);
  assert_vector(origin_of(0, 0, 0, 4000), 0, 0, 0);    /* 4 km that begin at the origin */
  assert_vector(origin_of(300, 300, 0, 4), 0, 0, 0);   /* 427 m away; 100 times 5.66 m is 566 */
  assert_vector(origin_of(10, 0, 0, .2), 0, 0, 0);     /* a desk model across the room */
  assert_vector(origin_of(5000, 5000, 0, 0), 0, 0, 0); /* a point has no extent */
  assert_vector(lam_local_origin(NULL, 0), 0, 0, 0);
}

/* Diagonals of 5.66 and .0566 m ask for multiples of 10 m and .1 m. */
static void far_points_are_moved(void **state) {
  (void)state;
  assert_vector(origin_of(10000, 5000, 0, 4), 10000, 5000, 0);
  assert_vector(origin_of(500123.4, 5000777.7, 812.3, 4), 500130, 5000780, 810);
  assert_vector(origin_of(6, 0, 0, .04), 6, 0, 0);
  assert_vector(origin_of(-20000, 3, 0, 4), -20000, 0, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(near_points_stay),
      cmocka_unit_test(far_points_are_moved),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
