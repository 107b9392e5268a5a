/* Four curves as the sides of a surface: any order and direction, and what is said when they do not
 * meet. */
#include "curve_fixture.h"
#include "surf/spline/sides.h"
#include <string.h>

/* The sides v=0, u=0, v=1, u=1 of a square of size 10, each bent differently: a curve can be told
 * by its middle. */
static lam_sides square(void) {
  static const double quadratic[] = {0, 0, 0, 1, 1, 1}, cubic[] = {2, 2, 2, 2, 5, 5, 5, 5};
  static const double weights[] = {1, 3, 1}, equal[] = {2, 2, 2};
  static const lam_vec3 bottom[] = {{0, 0, 0}, {5, 0, 1}, {10, 0, 0}};
  static const lam_vec3 left[] = {{0, 0, 0}, {0, 3, 2}, {0, 7, 2}, {0, 10, 0}};
  static const lam_vec3 top[] = {{0, 10, 0}, {5, 10, 4}, {10, 10, 0}};
  static const lam_vec3 right[] = {{10, 0, 0}, {10, 5, 8}, {10, 10, 0}};
  return (lam_sides){.side = {{2, 3, quadratic, bottom, weights},
                              {3, 4, cubic, left, NULL},
                              {2, 3, quadratic, top, NULL},
                              {2, 3, quadratic, right, equal}}};
}

static lam_vec3 middle(const lam_sides *s, int i) { return point_at(&s->side[i], 0.5); }

static void check_square(const lam_sides *s) {
  /* weight 3 in the middle: (0 + 3 * 2/4 * 1 + 0) / (1/4 + 3/2 + 1/4) = 3/4 */
  near3(middle(s, 0), lam_v3(5, 0, 0.75), 1e-14);
  near3(middle(s, 1), lam_v3(0, 5, 1.5), 1e-14);
  near3(middle(s, 2), lam_v3(5, 10, 2), 1e-14);
  near3(middle(s, 3), lam_v3(10, 5, 4), 1e-14);
  for (int u = 0; u < 2; u++)
    for (int v = 0; v < 2; v++) {
      near3(point_at(&s->side[2 * v], u), lam_v3(10 * u, 10 * v, 0), 0);
      near3(point_at(&s->side[2 * u + 1], v), lam_v3(10 * u, 10 * v, 0), 0);
    }
}

static lam_sides joined(const lam_sides *given) {
  lam_sides sides;
  lam_sides_gap gap;
  assert_true(lam_sides_join(arena, given, &sides, &gap));
  return sides;
}

/* All 16 combinations of directions, listed around or as v=0, v=1, u=0, u=1. */
static void test_any_direction(void **state) {
  (void)state;
  lam_sides given = square(), turned;
  for (int way = 0; way < 16; way++) {
    for (int i = 0; i < 4; i++)
      turned.side[i] =
          way >> i & 1 ? lam_spline_curve_reverse(arena, given.side[i]) : given.side[i];
    memset(turned.across, 0, sizeof turned.across);
    lam_sides s = joined(&turned);
    check_square(&s);
    lam_spline_curve swap = turned.side[1];
    turned.side[1] = turned.side[2];
    turned.side[2] = swap;
    s = joined(&turned);
    check_square(&s);
  }
}

/* Whatever comes first is v = 0; the next that touches it is u = 0. Every order gives sides that
 * meet. */
static void test_any_order(void **state) {
  (void)state;
  lam_sides given = square();
  int orders = 0;
  for (int k = 0; k < 256; k++) {
    int order[] = {k & 3, k >> 2 & 3, k >> 4 & 3, k >> 6}, seen = 0;
    for (int i = 0; i < 4; i++) seen |= 1 << order[i];
    if (seen != 15) continue;
    orders++;
    lam_sides listed = {0};
    for (int i = 0; i < 4; i++) listed.side[i] = given.side[order[i]];
    lam_sides s = joined(&listed);
    int opposite = order[0] ^ 2, first = 1;
    if (order[first] == opposite) first = 2;
    lam_sides raw = joined(&given);
    near3(middle(&s, 0), middle(&raw, order[0]), 1e-14);
    near3(middle(&s, 1), middle(&raw, order[first]), 1e-14);
    near3(middle(&s, 2), middle(&raw, opposite), 1e-14);
    near3(middle(&s, 3), middle(&raw, order[first] ^ 2), 1e-14);
    for (int u = 0; u < 2; u++)
      for (int v = 0; v < 2; v++)
        near3(point_at(&s.side[2 * v], u), point_at(&s.side[2 * u + 1], v), 0);
  }
  assert_int_equal(orders, 24);
}

/* Domains become [0,1], ends clamped; equal weights go; nearly equal knots of opposite sides become
 * equal; derivatives across turn with their side. */
static void test_one_form(void **state) {
  (void)state;
  lam_sides given = square();
  const double a[] = {-1, -1, 0, 1, 2, 3, 3}, b[] = {0, 0, 0, 0.5 + 1e-14, 1, 1, 1};
  const lam_vec3 bottom[] = {
      {-2, 0, 0}, {2, 0, 0}, {6, 0, 0}, {14, 0, 0}}; /* ends at (0,0,0) and (10,0,0) */
  const lam_vec3 top[] = {{10, 10, 0}, {8, 10, 3}, {1, 10, 4}, {0, 10, 0}};
  const double vectors[] = {0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0};
  given.side[0] = (lam_spline_curve){2, 4, a, bottom, NULL};
  given.side[2] = (lam_spline_curve){2, 4, b, top, NULL};
  given.across[2] = (lam_bspline){2, 4, 3, b, vectors};
  lam_sides s = joined(&given);
  for (int i = 0; i < 4; i++) {
    const lam_spline_curve *c = &s.side[i];
    assert_null(lam_spline_curve_problem(c));
    for (int k = 0; k <= c->degree; k++)
      assert_true(c->knots[k] == 0 && c->knots[c->count + k] == 1);
  }
  assert_null(s.side[3].weights);
  assert_true(s.side[0].knots[3] == s.side[2].knots[3]);
  assert_true(s.side[0].knots[3] == s.across[2].knots[3]);
  assert_true(s.across[2].values[1] == 3 && s.across[2].values[10] == 1);
  near3(point_at(&s.side[2], 0), lam_v3(0, 10, 0), 0);
  near3(point_at(&s.side[0], 1), lam_v3(10, 0, 0), 0);
  assert_int_equal(s.across[0].count, 0);
}

/* An end that misses by .3 is named, with its distance; a miss by a hundred-millionth of the size
 * is closed. */
static void test_gaps(void **state) {
  (void)state;
  lam_sides given = square(), sides;
  lam_sides_gap gap;
  lam_vec3 off[] = {{0, 10, 0}, {5, 10, 4}, {10, 10, 0.3}};
  given.side[2].points = off;
  assert_false(lam_sides_join(arena, &given, &sides, &gap));
  near(gap.distance, 0.3, 1e-15);
  assert_int_equal(gap.curve[0], 2);
  assert_int_equal(gap.end[0], 1);
  assert_int_equal(gap.curve[1], 3);
  assert_int_equal(gap.end[1], 1);
  off[2].z = 1e-7;
  sides = joined(&given);
  near3(point_at(&sides.side[2], 1), lam_v3(10, 10, 0.5e-7), 1e-15);
  near3(point_at(&sides.side[3], 1), point_at(&sides.side[2], 1), 0);
  const lam_vec3 point[4] = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  for (int i = 0; i < 4; i++) given.side[i].points = point;
  assert_false(lam_sides_join(arena, &given, &sides, &gap));
  near(gap.distance, 0, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {TEST(test_any_direction), TEST(test_any_order),
                                     TEST(test_one_form), TEST(test_gaps)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
