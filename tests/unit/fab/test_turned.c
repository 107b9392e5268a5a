/* Solids around an axis, and meshes that are filled triangle by triangle. */
#include "core/numbers.h"
#include "core/solid/triangles.h"
#include "fab/mesh_fill.h"
#include "fab/turned.h"
#include "fab/workshop.h"
#include "tests/unit/asserts.h"

/* The area of a regular polygon of 48 corners on the unit circle: 48/2 sin(2 pi/48). */
static double polygon(void) { return 24 * sin(2 * LAM_PI / 48); }

static void assert_sound(lam_arena *arena, const lam_trimesh *solid) {
  lam_part part = {.solid = *solid};
  assert_true(lam_part_is_sound(arena, &part));
}

static void assert_triangle(const lam_trimesh *mesh, int at, int a, int b, int c) {
  const int *t = mesh->triangles[at];
  if (t[0] != a || t[1] != b || t[2] != c)
    fail_msg("triangle %d is %d %d %d, expected %d %d %d", at, t[0], t[1], t[2], a, b, c);
}

/* A quad a b c d becomes a b c and a c d; a triangle is appended as it is. */
static void meshes_are_filled_in_order(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_trimesh mesh = lam_trimesh_empty(arena, 5, 3);
  assert_int_equal(mesh.vertex_count, 5);
  assert_int_equal(mesh.triangle_count, 0);
  for (int v = 0; v < 5; v++) assert_near(lam_length(mesh.vertices[v]), 0, 0);
  lam_trimesh_quad(&mesh, 4, 3, 2, 1);
  lam_trimesh_triangle(&mesh, 0, 2, 4);
  assert_int_equal(mesh.triangle_count, 3);
  assert_triangle(&mesh, 0, 4, 3, 2);
  assert_triangle(&mesh, 1, 4, 2, 1);
  assert_triangle(&mesh, 2, 0, 2, 4);
  lam_arena_free(arena);
}

/* Four sides with corners 1, 2, 3 and 4 from the axis at z = 5, closed by poles at 3 and 11. The
 * base has the area (1 2 + 2 3 + 3 4 + 4 1)/2 = 12, so the two pyramids have 12 (2 + 6)/3 = 32. */
static void two_pyramids_on_one_base(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const double angle[4] = {0, LAM_PI / 2, LAM_PI, 3 * LAM_PI / 2}, radius[4] = {1, 2, 3, 4};
  const double poles[2] = {3, 11};
  const lam_turned_line line = {5, radius};
  const lam_vec3 expected[6] = {{1, 0, 5},  {0, 2, 5}, {-3, 0, 5},
                                {0, -4, 5}, {0, 0, 3}, {0, 0, 11}};
  lam_trimesh mesh = lam_turned_solid(arena, angle, 4, &line, 1, poles);
  assert_int_equal(mesh.vertex_count, 6);
  assert_int_equal(mesh.triangle_count, 8);
  for (int v = 0; v < 6; v++) assert_near(lam_distance(mesh.vertices[v], expected[v]), 0, 1e-14);
  for (int k = 0; k < 4; k++) {
    assert_triangle(&mesh, 2 * k, 4, (k + 1) % 4, k);
    assert_triangle(&mesh, 2 * k + 1, 5, k, (k + 1) % 4);
  }
  assert_near(lam_trimesh_volume(&mesh), 32, 1e-12);
  assert_sound(arena, &mesh);
  lam_arena_free(arena);
}

/* A cube of side 2 (its corners sqrt(2) from the axis) under a roof 3 high: 8 + 4 3/3 = 12, less a
 * cone of the base 1 deep: 4/3. */
static void poles_close_the_first_and_the_last_line(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  const double angle[4] = {.25 * LAM_PI, .75 * LAM_PI, 1.25 * LAM_PI, 1.75 * LAM_PI};
  const double radius[4] = {sqrt(2), sqrt(2), sqrt(2), sqrt(2)}, poles[2] = {1, 5};
  const lam_turned_line lines[2] = {{0, radius}, {2, radius}};
  lam_trimesh mesh = lam_turned_solid(arena, angle, 4, lines, 2, poles);
  assert_int_equal(mesh.triangle_count, 16);
  assert_near(lam_trimesh_volume(&mesh), 12 - 4. / 3, 1e-12);
  assert_sound(arena, &mesh);
  lam_arena_free(arena);
}

/* Corners on circles of 0.3 m and 0.5 m, at heights of -+0.02 m; volume: polygon (R^2 - r^2) t. */
static void a_ring_has_a_rectangular_section(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_trimesh ring = lam_ring(arena, 0.3, 0.5, 0.04);
  int inner = 0, outer = 0, up = 0;
  assert_int_equal(ring.vertex_count, 4 * 48);
  assert_int_equal(ring.triangle_count, 8 * 48);
  for (int v = 0; v < ring.vertex_count; v++) {
    lam_vec3 x = ring.vertices[v];
    inner += fabs(hypot(x.x, x.y) - 0.3) < 1e-15;
    outer += fabs(hypot(x.x, x.y) - 0.5) < 1e-15;
    up += fabs(x.z - 0.02) < 1e-15;
    assert_near(fabs(x.z), 0.02, 1e-15);
  }
  assert_int_equal(inner, 2 * 48);
  assert_int_equal(outer, 2 * 48);
  assert_int_equal(up, 2 * 48);
  assert_near(ring.vertices[0].x, 0.3, 1e-15); /* corners begin on the x axis */
  assert_near(lam_trimesh_volume(&ring), polygon() * (0.25 - 0.09) * 0.04, 1e-15);
  assert_sound(arena, &ring);
  lam_arena_free(arena);
}

/* Sixteen bands from pole to pole, between polygons of radius R sin(pi i/16) at -R cos(pi i/16); a
 * frustum of height h has h/3 (a^2 + a b + b^2) times the polygon of the unit circle. */
static void a_ball_has_its_corners_on_the_sphere(void **state) {
  (void)state;
  lam_arena *arena = lam_arena_new();
  lam_trimesh ball = lam_ball(arena, 0.7);
  double volume = 0;
  assert_int_equal(ball.vertex_count, 15 * 48 + 2);
  for (int v = 0; v < ball.vertex_count; v++) assert_near(lam_length(ball.vertices[v]), 0.7, 1e-15);
  for (int i = 0; i < 16; i++) {
    double a = 0.7 * sin(LAM_PI * i / 16), b = 0.7 * sin(LAM_PI * (i + 1) / 16);
    double h = 0.7 * (cos(LAM_PI * i / 16) - cos(LAM_PI * (i + 1) / 16));
    volume += polygon() * h / 3 * (a * a + a * b + b * b);
  }
  assert_near(lam_trimesh_volume(&ball), volume, 1e-14);
  assert_near(volume, 4 * LAM_PI / 3 * 0.343, 0.03); /* nearly the ball */
  assert_sound(arena, &ball);
  lam_arena_free(arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(meshes_are_filled_in_order),
      cmocka_unit_test(two_pyramids_on_one_base),
      cmocka_unit_test(poles_close_the_first_and_the_last_line),
      cmocka_unit_test(a_ring_has_a_rectangular_section),
      cmocka_unit_test(a_ball_has_its_corners_on_the_sphere),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
