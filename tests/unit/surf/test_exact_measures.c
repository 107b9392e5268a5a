/* Measures of spline surfaces and of flat meshes against formulas: z = x^2 + x y - y^2 over a
 * rectangle, with a knot inside and a domain that is not the unit square. */
#include "core/arena.h"
#include "surf/area/least_area.h"
#include "surf/asymptotic/asymptotic_quad.h"
#include "surf/developable/developable.h"
#include "surf/flatten/flatten_parts.h"
#include "tests/unit/asserts.h"

/* The interval [low, high] of x that parameters between the ends of the knots are mapped to. */
typedef struct side {
  double low, high;
} side;

static double at_knot(side s, const double *knots, int count, int k) {
  return s.low + (s.high - s.low) * (knots[k] - knots[0]) / (knots[count - 1] - knots[0]);
}

/* Of degrees 2 and 3, exact by polar forms: the control point of knots a, b and c, d, e has
 * x = (a + b) / 2, y = (c + d + e) / 3, z = a b + x y - (c d + c e + d e) / 3. n and m control
 * points. */
static lam_spline_surface saddle(lam_arena *arena, side x, side y, double *u, int n, double *v,
                                 int m) {
  lam_spline_surface s = {.degree = {2, 3}, .count = {n, m}, .knots = {u, v}};
  lam_vec3 *points = LAM_NEW(arena, lam_vec3, n * m);
  s.points = points;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double a = at_knot(x, u, n + 3, i + 1), b = at_knot(x, u, n + 3, i + 2), k[3];
      for (int l = 0; l < 3; l++) k[l] = at_knot(y, v, m + 4, j + 1 + l);
      points[i * m + j] = lam_v3((a + b) / 2, (k[0] + k[1] + k[2]) / 3, 0);
      points[i * m + j].z = a * b + points[i * m + j].x * points[i * m + j].y -
                            (k[0] * k[1] + k[0] * k[2] + k[1] * k[2]) / 3;
    }
  return s;
}

/* 1 <= x <= 3 over 0 <= u <= 2, 1/2 <= y <= 1 over 1 <= v <= 3 with a knot at 2; or mirrored, so
 * that another corner is the bent one. */
static lam_spline_surface mirrored(lam_arena *arena, int which) {
  static double u[] = {0, 0, 0, 2, 2, 2}, v[] = {1, 1, 1, 1, 2, 3, 3, 3, 3};
  side x = which & 1 ? (side){3, 1} : (side){1, 3}, y = which & 2 ? (side){1, .5} : (side){.5, 1};
  return saddle(arena, x, y, u, 3, v, 5);
}

/* With z_x = 2 x + y, z_y = x - 2 y: W^2 = 1 + z_x^2 + z_y^2 = 1 + 5 (x^2 + y^2), K = -5 / W^4,
 * |x_u x x_v| = W / 4. */
static double square(double x, double y) { return 1 + 5 * (x * x + y * y); }

/* max |K| at (1, 1/2), where W^2 = 7.25, and the bound of that corner -L N / (E G - F^2) = 4 / W^4;
 * the mean over x = 1, 2, 3 and y = 1/2, 3/4, 1; W grows to sqrt(51) at (3, 1). Area and ||K||_2
 * over the unit square: the integral of W over 2 x 1/2, and the root of that of 25 / W^8, by
 * Simpson's rule with 400 x 400 steps, extrapolated (independent program). */
static const double saddle_area = 4.9196686984532, saddle_norm = .0226330207482;

static void what_is_left_of_the_curvature(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  double mean = 0;
  for (int i = 0; i < 9; i++) mean += 5 / pow(square(1 + i / 3, .5 + i % 3 * .25), 2) / 9;
  for (int k = 0; k < 4; k++) {
    lam_spline_surface s = mirrored(arena, k);
    lam_developable_measures m = lam_developable_measure(arena, &s, 20, 2);
    assert_near(m.max, 5 / (7.25 * 7.25), 1e-14);
    assert_near(m.mean, mean, 1e-14);
    assert_near(m.corner_bound, 4 / (7.25 * 7.25), 1e-14);
    assert_near(lam_developable_bound(arena, &s), 4 / (7.25 * 7.25), 1e-14);
    assert_near(m.least_ratio, sqrt(7.25 / 51), 1e-14);
    assert_near(m.area, saddle_area, 1e-10);
    assert_near(m.l2, saddle_norm, 1e-10);
  }
  lam_arena_free(arena);
}

/* The same area by both rules; the triangles are extrapolated from 4, 8 and 16 cells per span, of
 * which the error falls with the sixth power. */
static void areas_by_two_rules(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  for (int k = 0; k < 4; k++) {
    lam_spline_surface s = mirrored(arena, k);
    assert_near(lam_surface_area(arena, &s, 8), saddle_area, 1e-9);
    assert_near(lam_surface_area_triangles(arena, &s, 4), saddle_area, 1e-7);
  }
  lam_arena_free(arena);
}

/* One span along u, two along v: with one sample each at (2, 5/8) and (2, 7/8). H = 5 (y^2 - x y -
 * x^2) / W^3 for the normal upwards. */
static void mean_curvature_against_the_wanted_one(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_spline_surface s = mirrored(arena, 0);
  double off[2], largest, rms, wanted = -.3;
  long samples;
  for (int k = 0; k < 2; k++) {
    double x = 2, y = .625 + .25 * k;
    off[k] = fabs(5 * (y * y - x * y - x * x) / pow(square(x, y), 1.5) - wanted);
  }
  lam_surface_mean_curvature(arena, &s, wanted, 1, &largest, &rms, &samples);
  assert_int_equal(samples, 2);
  assert_near(largest, fmax(off[0], off[1]), 1e-14);
  assert_near(rms, sqrt((off[0] * off[0] + off[1] * off[1]) / 2), 1e-14);

  /* with two: at x = 3/2, 5/2 and y = 9/16, 11/16, 13/16, 15/16 */
  lam_surface_mean_curvature(arena, &s, 0, 2, &largest, &rms, &samples);
  double sum = 0, most = 0;
  for (int k = 0; k < 8; k++) {
    double x = 1.5 + k / 4, y = .5625 + .125 * (k % 4),
           H = 5 * (y * y - x * y - x * x) / pow(square(x, y), 1.5);
    sum += H * H / 8;
    most = fmax(most, fabs(H));
  }
  assert_int_equal(samples, 8);
  assert_near(largest, most, 1e-14);
  assert_near(rms, sqrt(sum), 1e-14);
  lam_arena_free(arena);
}

/* x_uu = 2, x_uv = 1/4, x_vv = -2/16 along z, over a domain of 2 x 2: 4 (4 + 2/16 + 1/64). */
static void thin_plate_energy(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_spline_surface s = mirrored(arena, 0);
  assert_near(lam_thin_plate_energy(arena, &s, 4), 16.5625, 1e-12);
  lam_arena_free(arena);
}

/* Over the unit square, 1 <= x <= 3 and 1/2 <= y <= 1. A side along x lies in a plane y = const:
 * the curve's curvature is 2 / (1 + z_x^2)^(3/2), its normal curvature 2 / (W (1 + z_x^2)), so that
 * both the ratio and the sine between e_y and the normal are sqrt(1 + z_x^2) / W; along y alike
 * with z_y. */
static double line_ratio(int i, double t) {
  double x = i % 2 ? 1 + 2 * (i / 2) : 1 + 2 * t, y = i % 2 ? .5 + .5 * t : .5 + .5 * (i / 2),
         slope = i % 2 ? x - 2 * y : 2 * x + y;
  return sqrt((1 + slope * slope) / square(x, y));
}

/* A side said to be straight: |k_n| times its speed, 2 or 1/2 times sqrt(1 + slope^2). */
static double chord_ratio(int i, double t) {
  double x = i % 2 ? 1 + 2 * (i / 2) : 1 + 2 * t, y = i % 2 ? .5 + .5 * t : .5 + .5 * (i / 2),
         slope = i % 2 ? x - 2 * y : 2 * x + y;
  return 2 / sqrt(square(x, y) * (1 + slope * slope)) * (i % 2 ? .5 : 2);
}

static void sides_against_asymptotic_curves(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 0, 0, 1, 1, 1, 1};
  lam_spline_surface s = saddle(arena, (side){1, 3}, (side){.5, 1}, u, 3, v, 4);
  for (int curved = 0; curved < 5; curved++) { /* one side after the other; 4: none */
    bool straight[4];
    double ratio, sine, expected = 0, angle = 0;
    for (int i = 0; i < 4; i++) straight[i] = i != curved;
    for (int i = 0; i < 4; i++)
      for (int k = 1; k <= 3; k++) {
        expected = fmax(expected, straight[i] ? chord_ratio(i, k / 4.) : line_ratio(i, k / 4.));
        if (!straight[i]) angle = fmax(angle, line_ratio(i, k / 4.));
      }
    lam_asymptotic_residuals(arena, &s, straight, 3, &ratio, &sine);
    assert_near(ratio, expected, 1e-13);
    assert_near(sine, angle, 1e-13);
  }
  lam_arena_free(arena);
}

/* Four points in the plane: edges of 3, 4, 5 and 1 that should be 2, 5, 5 and 2 long. Errors 1, -1,
 * 0, -1; strains 1/2, 1/5, 0, 1/2. Of the triangles one is left-handed, one right-handed, one has
 * no area: two are flips. */
static void strains_of_a_flat_mesh(void **state) {
  (void)state;
  static const lam_vec2 x[5] = {{1, 1}, {4, 1}, {4, 5}, {5, 5}, {7, 1}};
  static const int edges[4][2] = {{0, 1}, {1, 2}, {0, 2}, {2, 3}};
  static const int triangles[3][3] = {{0, 1, 2}, {1, 2, 3}, {0, 1, 4}};
  static const double lengths[4] = {2, 5, 5, 2};
  lam_flat_mesh mesh = {.vertex_count = 5,
                        .triangle_count = 3,
                        .triangles = triangles,
                        .edge_count = 4,
                        .edges = edges,
                        .lengths = lengths};
  lam_flattening flat = {.points = x};
  lam_flat_measure(&mesh, &flat);
  assert_near(flat.energy, 3, 1e-14);
  assert_near(flat.max_strain, .5, 1e-15);
  assert_near(flat.rms_strain, sqrt((.25 + .04 + 0 + .25) / 4), 1e-15);
  assert_int_equal(flat.flips, 2);
  mesh.edge_count = 0;
  lam_flat_measure(&mesh, &flat);
  assert_near(flat.rms_strain, 0, 0);
}

/* A square of side 2 turned by a quarter and moved, but for one corner that is (4, 0) off along the
 * target's x. About the means the corners of the target are (-+1, -+1); the points, turned back,
 * are those plus (3, 0) for one corner and (-1, 0) for the others. */
static void what_alignment_leaves(void **state) {
  (void)state;
  static const lam_vec2 target[4] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  lam_vec2 points[4];
  for (int i = 0; i < 4; i++) { /* (x, y) -> (7 - y, x - 3): a quarter to the left */
    lam_vec2 p = {target[i].x + (i == 2 ? 4 : 0), target[i].y};
    points[i] = (lam_vec2){7 - p.y, p.x - 3};
  }
  /* With deviations d_i = (3, 0) at (1, 1), else (-1, 0): sum p.q = 8 + sum d.q, sum p x q =
   * sum d x q. d.q: 3 - (-1 + 1 - 1) = 4; d x q = d_x q_y: 3 - (-1 - 1 + 1) = 4. The angle is
   * atan(4 / 12).
   * What remains: sum |p|^2 + |q|^2 - 2 hypot(12, 4) = (8 + 12 + 8) + 8 - 2 hypot(12, 4). */
  double left = lam_flat_align(4, target, points);
  assert_near(left, sqrt((28 + 8 - 2 * hypot(12, 4)) / 4), 1e-13);
  double sum = 0, c = 12 / hypot(12, 4), s = 4 / hypot(12, 4);
  for (int i = 0; i < 4; i++)
    sum += pow(points[i].x - target[i].x, 2) + pow(points[i].y - target[i].y, 2);
  assert_near(sqrt(sum / 4), left, 1e-13);
  /* corner (1, 1) + (3, 0) about the middle (1, 1), turned to the left by the angle */
  assert_near(points[2].x, 1 + c * 4 - s * 1, 1e-13);
  assert_near(points[2].y, 1 + s * 4 + c * 1, 1e-13);
}

/* Maps of known singular values: p = (2, 1), q = (-1, 3) to A p, A q with A = rows (3, 0), (0, 2),
 * then turned in space; and a shear by 3/2, of which the values are 2 and 1/2. */
static void singular_values_of_known_maps(void **state) {
  (void)state;
  lam_vec2 p = {2, 1}, q = {-1, 3};
  lam_vec3 across = {0, .6, .8};
  lam_vec2 s = lam_flat_stretch(p, q, lam_along(lam_v3(3 * 2, 0, 0), 2 * 1, across),
                                lam_along(lam_v3(3 * -1, 0, 0), 2 * 3, across));
  assert_near(s.x, 3, 1e-14);
  assert_near(s.y, 2, 1e-14);
  s = lam_flat_stretch(p, q, lam_along(lam_v3(2 + 1.5 * 1, 0, 0), 1, across),
                       lam_along(lam_v3(-1 + 1.5 * 3, 0, 0), 3, across));
  assert_near(s.x, 2, 1e-14);
  assert_near(s.y, .5, 1e-14);

  /* two triangles drawn out by 3 : 2 and by 3 : 1 */
  static const lam_vec2 flat[4] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  static const lam_vec3 x[4] = {{5, 0, 0}, {8, 0, 0}, {5, 0, 2}, {8, 0, 1}};
  static const int triangles[2][3] = {{0, 1, 2}, {1, 3, 2}};
  lam_flat_mesh mesh = {
      .vertex_count = 4, .vertices = x, .triangle_count = 1, .triangles = triangles};
  double ratio[2];
  assert_near(lam_flat_anisotropy(&mesh, flat, ratio), 1.5, 1e-14);
  /* the second: (0, 1) to (0, 0, 1) and (-1, 1) to (-3, 0, 2), so e1 = (3, 0, -1), e2 = (0, 0, 1):
   * squares of the values: (11 +- sqrt(121 - 36)) / 2 */
  mesh.triangle_count = 2;
  double expected = sqrt((11 + sqrt(85)) / (11 - sqrt(85)));
  assert_near(lam_flat_anisotropy(&mesh, flat, ratio), expected, 1e-13);
  assert_near(ratio[0], 1.5, 1e-14);
  assert_near(ratio[1], expected, 1e-13);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(what_is_left_of_the_curvature),
      cmocka_unit_test(areas_by_two_rules),
      cmocka_unit_test(mean_curvature_against_the_wanted_one),
      cmocka_unit_test(thin_plate_energy),
      cmocka_unit_test(sides_against_asymptotic_curves),
      cmocka_unit_test(strains_of_a_flat_mesh),
      cmocka_unit_test(what_alignment_leaves),
      cmocka_unit_test(singular_values_of_known_maps),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
