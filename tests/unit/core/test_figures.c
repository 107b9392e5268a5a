/* Figures of best fit, color scales, solids cut by planes, and triangles, against numbers known by
 * hand. */
#include "core/numeric/dense.h"
#include "core/numeric/fit.h"
#include "core/ramp.h"
#include "core/solid/convex.h"
#include "core/solid/prism.h"
#include "core/solid/solid.h"
#include "core/solid/topology.h"
#include "tests/unit/mesh_fixture.h"

static int set_up(void **state) { return (*state = lam_arena_new()) == NULL; }
static int tear_down(void **state) {
  lam_arena_free(*state);
  return 0;
}

/* ---- fits ---- */

/* An orthonormal frame with rational entries. */
static const lam_vec3 frame[3] = {
    {2 / 3., -1 / 3., 2 / 3.}, {2 / 3., 2 / 3., -1 / 3.}, {-1 / 3., 2 / 3., 2 / 3.}};

static lam_vec3 in_frame(double x, double y, double z) {
  return lam_along(lam_along(lam_scale(frame[0], x), y, frame[1]), z, frame[2]);
}

/* The corners of a box of half sides a, b, c in any frame and order: deviations a, b, c. */
static void a_box_has_the_spread_of_its_sides(void **state) {
  (void)state;
  static const double sides[6][3] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3},
                                     {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
  for (int s = 0; s < 6; s++) {
    lam_vec3 points[8], center;
    double spread[3];
    for (int k = 0; k < 8; k++)
      points[k] = lam_add(lam_v3(5, -6, 7), in_frame(k & 1 ? sides[s][0] : -sides[s][0],
                                                     k & 2 ? sides[s][1] : -sides[s][1],
                                                     k & 4 ? sides[s][2] : -sides[s][2]));
    lam_vec3 normal = lam_fit_plane(points, 8, &center, spread);
    assert_near(lam_distance(center, lam_v3(5, -6, 7)), 0, 1e-14);
    for (int k = 0; k < 3; k++) assert_near(spread[k], k + 1, 1e-13);
    for (int k = 0; k < 3; k++)
      assert_near(fabs(lam_dot(normal, frame[k])), sides[s][k] < 1.5, 1e-13);
  }
}

/* sum value_k f_k f_k^T with the frame above has these eigenvalues, and f_k as eigenvectors. */
static void eigenvalues_of_a_known_matrix(void **state) {
  (void)state;
  static const double values[3] = {-2, 5, .5};
  double a[3][3] = {{0}}, value[3], vector[3][3];
  for (int k = 0; k < 3; k++) {
    const double f[3] = {frame[k].x, frame[k].y, frame[k].z};
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++) a[i][j] += values[k] * f[i] * f[j];
  }
  lam_eigen3(a, value, vector);
  for (int k = 0; k < 3; k++) {
    int found = 0;
    for (int i = 0; i < 3; i++) {
      if (!(fabs(value[i] - values[k]) < 1e-13)) continue;
      lam_vec3 v = lam_v3(vector[0][i], vector[1][i], vector[2][i]);
      assert_near(fabs(lam_dot(v, frame[k])), 1, 1e-13);
      found++;
    }
    assert_int_equal(found, 1);
  }
}

/* sum sigma_k f_k g_k^T with f the frame above and g = (f_2, -f_0, f_1): sigma descending, whatever
 * their order here; column k of v is g_k, of a v sigma_k f_k. Three columns need several rounds. */
static void singular_values_of_a_known_matrix(void **state) {
  (void)state;
  static const double sizes[3] = {.5, 3, 2};
  static const int descending[3] = {1, 2, 0};
  const lam_vec3 right[3] = {frame[2], lam_scale(frame[0], -1), frame[1]};
  double a[9] = {0}, sigma[3], v[9];
  for (int k = 0; k < 3; k++) {
    const double f[3] = {frame[k].x, frame[k].y, frame[k].z},
                 g[3] = {right[k].x, right[k].y, right[k].z};
    for (int i = 0; i < 9; i++) a[i] += sizes[k] * f[i / 3] * g[i % 3];
  }
  lam_singular_values(3, a, sigma, v);
  for (int k = 0; k < 3; k++) {
    int from = descending[k];
    lam_vec3 column = lam_v3(v[k], v[3 + k], v[6 + k]), image = lam_v3(a[k], a[3 + k], a[6 + k]);
    double sign = lam_dot(column, right[from]) > 0 ? 1 : -1;
    assert_near(sigma[k], sizes[from], 1e-14);
    assert_near(lam_distance(column, lam_scale(right[from], sign)), 0, 1e-13);
    assert_near(lam_distance(image, lam_scale(frame[from], sign * sigma[k])), 0, 1e-13);
  }
}

/* min 1/2 x^T h x + g^T x on x + 2 y - z = 4, x - y + 2 z = 1 with h = diag(2, 4, 6), g = (1, -2,
 * 3). On the line (2, 1, 0) + s (3, -3, -3) = (2 + 3 s, 1 - 3 s, -3 s) the energy (2 + 3 s)^2 +
 * 2 (1 - 3 s)^2 + 27 s^2 + (2 + 3 s) - 2 (1 - 3 s) - 9 s has the slope 108 s = 0. */
static void energy_on_a_line(void **state) {
  const double h[9] = {2, 0, 0, 0, 4, 0, 0, 0, 6}, g[3] = {1, -2, 3}, d[2] = {4, 1};
  const double c[6] = {1, 2, -1, 1, -1, 2}, offset[3] = {1, -2, 4};
  double x[3];
  assert_int_equal(lam_least_energy(*state, 3, h, g, 2, c, d, 1e-9, x), LAM_LEAST_FOUND);
  assert_near(x[0], 2, 1e-13);
  assert_near(x[1], 1, 1e-13);
  assert_near(x[2], 0, 1e-13);
  /* with g_z = 4 the slope is 108 s - 3: s = 1/36 */
  assert_int_equal(lam_least_energy(*state, 3, h, offset, 2, c, d, 1e-9, x), LAM_LEAST_FOUND);
  assert_near(x[0], 2 + 3 / 36., 1e-13);
  assert_near(x[1], 1 - 3 / 36., 1e-13);
  assert_near(x[2], -3 / 36., 1e-13);
}

/* ---- colors ---- */

typedef struct oklab {
  double lightness, chroma, hue;
} oklab;

/* From linear sRGB, with the matrices that Ottosson gives for this direction; hue in degrees. */
static oklab to_oklab(lam_rgb c) {
  double l = cbrt(.4122214708 * c.r + .5363325363 * c.g + .0514459929 * c.b),
         m = cbrt(.2119034982 * c.r + .6806995451 * c.g + .1073969566 * c.b),
         s = cbrt(.0883024619 * c.r + .2817188376 * c.g + .6299787005 * c.b);
  double a = 1.9779984951 * l - 2.4285922050 * m + .4505937099 * s,
         b = .0259040371 * l + .7827717662 * m - .8086757660 * s;
  return (oklab){.2104542553 * l + .7936177850 * m - .0040720468 * s, hypot(a, b),
                 atan2(b, a) * 180 / LAM_PI};
}

/* Lightness .28 to .92, hue from violet (300) to yellow (105), chroma .11 to .16 as far as a screen
 * shows it. The diverging scale: .95 in the middle to .48 at both ends, blue (255) and red (30). */
static void colors_have_the_lightness_and_hue_of_the_scale(void **state) {
  (void)state;
  for (int i = 0; i <= 10; i++) {
    double t = i / 10., hue = 300 - 195 * t, s = 2 * fabs(t - .5);
    oklab c = to_oklab(lam_ramp_sequential(t)), d = to_oklab(lam_ramp_diverging(t));
    assert_near(c.lightness, .28 + .64 * t, 1e-5);
    assert_near(remainder(c.hue - hue, 360), 0, .01);
    assert_below(c.chroma, .11 + .05 * t + 1e-5);
    assert_below(.06, c.chroma);
    assert_near(d.lightness, .95 - .47 * s, 1e-5);
    assert_below(d.chroma, .17 * s + 1e-5);
    if (i != 5) assert_near(remainder(d.hue - (i < 5 ? 255 : 30), 360), 0, .01);
  }
  assert_near(to_oklab(lam_ramp_sequential(0)).chroma, .11, 1e-5); /* shown as it is meant */
  assert_near(to_oklab(lam_ramp_sequential(1)).chroma, .16, 1e-5);
  assert_near(to_oklab(lam_ramp_diverging(1)).chroma, .17, 1e-5);
}

/* IEC 61966-2-1: 12.92 x up to .0031308, 1.055 x^(1/2.4) - .055 above. */
static void channels_follow_the_standard(void **state) {
  (void)state;
  static const struct {
    double linear;
    int value;
  } rows[] = {{-1, 0},   {0, 0},    {.001, 3}, {.003, 10}, {.0031, 10}, {.0045, 14}, {.01, 25},
              {.05, 63}, {.2, 124}, {.5, 188}, {.9, 243},  {1, 255},    {1.5, 255}};
  for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
    assert_int_equal(lam_srgb(rows[i].linear), rows[i].value);
}

/* ---- solids ---- */

/* A square of side 2 along z by 3, cut three times: half of it, a corner, an edge on the plane. */
static void a_prism_is_cut(void **state) {
  const lam_vec3 square[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  lam_convex solid = lam_convex_prism(*state, square, 4, lam_v3(0, 0, 3), 1e-9);
  lam_trimesh mesh = lam_convex_mesh(*state, &solid);
  assert_int_equal(mesh.vertex_count, 8);
  assert_int_equal(mesh.triangle_count, 12);
  assert_near(lam_trimesh_volume(&mesh), 12, 1e-14);
  assert_near(lam_trimesh_area(&mesh), 4 + 4 + 24, 1e-14);

  lam_convex_cut(&solid, lam_v3(0, 0, -1), lam_v3(0, 0, 1)); /* misses it */
  lam_convex_cut(&solid, lam_v3(9, 0, 0), lam_v3(-1, 0, 0));
  assert_int_equal(solid.face_count, 6);
  lam_convex_cut(&solid, lam_v3(1, 7, 0), lam_v3(0, 0, -5)); /* keeps what lies below z = 0 */
  assert_int_equal(lam_convex_mesh(*state, &solid).triangle_count > 4, false);

  /* above the plane z = 1: 2 x 2 x 2 */
  solid = lam_convex_prism(*state, square, 4, lam_v3(0, 0, 3), 1e-9);
  lam_convex_cut(&solid, lam_v3(5, 5, 1), lam_v3(0, 0, 2));
  mesh = lam_convex_mesh(*state, &solid);
  assert_near(lam_trimesh_volume(&mesh), 8, 1e-13);
  assert_int_equal(mesh.vertex_count, 8);

  /* without the corner x + y + (z - 1) < 1: a tetrahedron of legs 1 */
  lam_convex_cut(&solid, lam_v3(1, 0, 1), lam_v3(1, 1, 1));
  mesh = lam_convex_mesh(*state, &solid);
  assert_near(lam_trimesh_volume(&mesh), 8 - 1 / 6., 1e-13);
  assert_int_equal(mesh.vertex_count, 10);
  assert_int_equal(solid.face_count, 7);

  /* along the diagonal of the square, through two edges */
  solid = lam_convex_prism(*state, square, 4, lam_v3(0, 0, 3), 1e-9);
  lam_convex_cut(&solid, lam_v3(0, 0, 0), lam_v3(1, -1, 0));
  mesh = lam_convex_mesh(*state, &solid);
  assert_near(lam_trimesh_volume(&mesh), 6, 1e-13);
  assert_int_equal(mesh.vertex_count, 6);
  assert_int_equal(mesh.triangle_count, 8);
  int component[8], fan[8][3];
  lam_topology topology;
  assert_int_equal(lam_topology_make(&mesh, component, fan, &topology), LAM_OK);
  assert_true(topology.closed && topology.oriented && topology.components == 1);
}

/* A small hollow in a tetrahedron of legs 4 is a cavity; the same inverted box beside the
 * tetrahedron, though within its bounds, is a solid turned inside out. */
static void cavities_lie_inside(void **state) {
  lam_vec3 x[4] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  lam_trimesh outer = {4, x, 4, triangles};
  for (int k = 0; k < 64; k++) {
    lam_vec3 at = lam_v3(.2 + k % 4, .3 + k / 4 % 4, .3 + k / 16);
    lam_trimesh box = mesh_box(*state, at, lam_add(at, lam_v3(.05, .05, .05)));
    lam_trimesh hollow = mesh_inverted(*state, &box), pair = mesh_pair(*state, &outer, &hollow);
    lam_solid_facts facts;
    bool inside = at.x + at.y + at.z + .15 < 4;
    assert_int_equal(lam_solid_measure(&pair, false, &facts), LAM_OK);
    if (facts.oriented != inside)
      fail_msg("a hollow at %g %g %g is %s", at.x, at.y, at.z, inside ? "refused" : "accepted");
    assert_near(facts.volume, 64 / 6. - .05 * .05 * .05, 1e-13);
  }
}

static void nothing_is_not_closed(void **state) {
  (void)state;
  lam_topology topology;
  lam_trimesh none = {0};
  assert_int_equal(lam_topology_make(&none, NULL, NULL, &topology), LAM_OK);
  assert_false(topology.closed);
  assert_int_equal(topology.components, 0);
}

/* Two tetrahedra of legs 1, one moved up by h: common is the one of legs 1 - h. With a mirrored
 * twin beside it: nothing. */
static void common_volumes(void **state) {
  (void)state;
  lam_vec3 a[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, b[4];
  int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  lam_trimesh first = {4, a, 4, triangles}, second = {4, b, 4, triangles};
  for (int k = 0; k < 4; k++) {
    double h = .25 * k, volume;
    for (int i = 0; i < 4; i++) b[i] = lam_add(a[i], lam_v3(.3 * h, .2 * h, .5 * h));
    assert_int_equal(lam_prism_volume(&first, &second, &volume), LAM_OK);
    assert_near(volume, pow(1 - h, 3) / 6, 1e-14);
    assert_int_equal(lam_prism_volume(&second, &first, &volume), LAM_OK);
    assert_near(volume, pow(1 - h, 3) / 6, 1e-14);
  }
  double volume;
  for (int i = 0; i < 4; i++) b[i] = lam_add(a[i], lam_v3(1, 1, 0));
  assert_int_equal(lam_prism_volume(&first, &second, &volume), LAM_OK);
  assert_near(volume, 0, 0);
}

/* A frame that mirrors turns the triangles around: the volume stays positive. */
static void placed_triangles(void **state) {
  lam_trimesh box = mesh_box(*state, lam_v3(0, 0, 0), lam_v3(1, 2, 3));
  lam_pose pose = {{4, 5, 6}, {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};
  lam_trimesh placed = lam_trimesh_placed(*state, &box, &pose);
  assert_near(lam_trimesh_volume(&placed), 6, 1e-14);
  assert_near(lam_distance(placed.vertices[7], lam_v3(4 + 2, 5 + 1, 6 + 3)), 0, 1e-14);
  pose.axis[0] = lam_v3(0, -1, 0);
  placed = lam_trimesh_placed(*state, &box, &pose);
  assert_near(lam_trimesh_volume(&placed), 6, 1e-14);
  assert_near(lam_distance(placed.vertices[1], lam_v3(4, 5 - 1, 6)), 0, 1e-14);
}

/* Points closer than the tolerance to a multiple of it become one; triangles that lose a corner go.
 */
static void welding_has_a_tolerance(void **state) {
  lam_vec3 x[5] = {{0, 0, 0}, {1, 0, 0}, {1.04, -0.0, .03}, {0, 1, 0}, {-0.0, 1, 0}};
  int triangles[3][3] = {{0, 1, 3}, {0, 2, 4}, {1, 2, 3}};
  lam_trimesh mesh = {5, x, 3, triangles};
  lam_trimesh exact = lam_trimesh_weld(*state, &mesh, 0),
              rough = lam_trimesh_weld(*state, &mesh, .1);
  assert_int_equal(exact.vertex_count, 4); /* 0 and -0 are the same */
  assert_int_equal(exact.triangle_count, 3);
  assert_int_equal(rough.vertex_count, 3);
  assert_int_equal(rough.triangle_count, 2);
  assert_near(lam_distance(rough.vertices[1], x[1]), 0, 0); /* the first one stays as it is */
  assert_int_equal(rough.triangles[1][2], 2);
}

/* A triangle with legs of 3 and 4, 2 above a large square: all of it is 2 away; the square's corner
 * (10, 10) is the farthest from the triangle. */
static void distances_both_ways(void **state) {
  (void)state;
  lam_vec3 a[3] = {{0, 0, 2}, {3, 0, 2}, {0, 4, 2}},
           b[4] = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  int one[1][3] = {{0, 1, 2}}, two[2][3] = {{0, 1, 2}, {0, 2, 3}};
  lam_trimesh small = {3, a, 1, one}, large = {4, b, 2, two};
  double there, back;
  assert_int_equal(lam_solid_hausdorff(&small, &large, .5, &there, &back), LAM_OK);
  assert_near(there, 2, 1e-14);
  /* the foot of (10, 10) on the line 4 x + 3 y = 12: the distance is (70 - 12) / 5, its foot (10,
   * 10) - 58 / 25 (4, 3) = (.72, 3.04) lies on the edge */
  assert_near(back, hypot(58 / 5., 2), 1e-13);
  assert_int_equal(lam_solid_hausdorff(&small, &large, 0, &there, &back), LAM_BAD_INPUT);
}

/* A flat triangle over a pit of depth 1, which only samples inside the triangle see. */
static void samples_are_as_dense_as_asked(void **state) {
  (void)state;
  lam_vec3 flat[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
           valley[4] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}};
  int one[1][3] = {{0, 1, 2}}, three[3][3] = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  lam_trimesh top = {3, flat, 1, one}, pit = {4, valley, 3, three};
  double there, back, coarse;
  assert_int_equal(lam_solid_hausdorff(&top, &pit, .05, &there, &back), LAM_OK);
  assert_near(back, 1, 1e-14);
  assert_int_equal(lam_solid_hausdorff(&top, &pit, 100, &coarse, &back), LAM_OK);
  assert_near(coarse, 0, 1e-14); /* the corners alone */
  /* walls z = -x, z = -y, z = (x + y - 4) / 2: a point is x / sqrt 2, y / sqrt 2 and (4 - x - y) /
   * sqrt 6 from them; all are equal at x = y = 4 / (2 + sqrt 3) */
  assert_near(there, 4 / (2 + sqrt(3)) / sqrt(2), .05);
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, set_up, tear_down)

int main(void) {
  const struct CMUnitTest tests[] = {
      TEST(a_box_has_the_spread_of_its_sides),
      TEST(eigenvalues_of_a_known_matrix),
      TEST(singular_values_of_a_known_matrix),
      TEST(energy_on_a_line),
      TEST(colors_have_the_lightness_and_hue_of_the_scale),
      TEST(channels_follow_the_standard),
      TEST(a_prism_is_cut),
      TEST(cavities_lie_inside),
      TEST(nothing_is_not_closed),
      TEST(common_volumes),
      TEST(placed_triangles),
      TEST(welding_has_a_tolerance),
      TEST(distances_both_ways),
      TEST(samples_are_as_dense_as_asked),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
