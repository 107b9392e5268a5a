/* Measures of angles at stars, of lines rolled out flat, of strips and of strains, where their
 * values are known by hand. */
#include "net/measures/measure.h"
#include "net_fixture.h"

static double summary(const lam_measuring *in, const char *name, long *count) {
  const lam_measure_kind *kind = lam_measure_find(name);
  assert_non_null(kind);
  lam_measure m =
      lam_measure_summary(kind, lam_measure_values(kind, in), lam_measure_size(kind, in->net));
  if (count) *count = m.count;
  return m.max;
}

static double measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh->vertices);
  return summary(&in, name, NULL);
}

static lam_vec3 toward(double degrees, double length) {
  return lam_v3(length * cos(degrees * net_pi / 180), length * sin(degrees * net_pi / 180), 0);
}

/* A flat star with arms at 0, 80, 190 and 260 degrees, of any lengths: angles of 80, 110, 70 and
 * 100 degrees. Opposite ones differ by 10, all by 40. Along u 190 degrees lie to the left and 170
 * to the right: 10 out of straight; along v 180 on both sides. The tangents halve 0 and 10, and 80
 * and 80 degrees: they cross at 75. */
static void angles_of_a_star(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  lam_vec3 center = mesh.vertices[4];
  mesh.vertices[7] = lam_add(center, toward(0, 1.2));
  mesh.vertices[5] = lam_add(center, toward(80, .9));
  mesh.vertices[1] = lam_add(center, toward(190, 1.1));
  mesh.vertices[3] = lam_add(center, toward(260, 1));
  assert_near(measured(f, &mesh, "opposite_angle"), 10, 1e-12);
  assert_near(measured(f, &mesh, "angle_spread"), 40, 1e-12);
  assert_near(measured(f, &mesh, "geodesic_error_u"), 10, 1e-12);
  assert_near(measured(f, &mesh, "geodesic_error_v"), 0, 1e-12);
  assert_near(measured(f, &mesh, "orthogonality"), 15, 1e-12);
}

/* A helix on a cylinder is a geodesic although it is curved: a skew grid of unit circles rolled up
 * stays straight when rolled out, and keeps r cos(alpha). */
static lam_vec3 helix(double i, double j) {
  return lam_v3(cos(.1 * i - .05 * j), sin(.1 * i - .05 * j), .07 * i + .1 * j);
}

static void lines_on_a_cylinder(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 9, 7, helix);
  static const double axis[6] = {0, 0, -3, 0, 0, 2};
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  in.axis = axis;
  static const char *const names[] = {
      "straightness_u",   "straightness_v",   "clairaut_u",     "clairaut_v",
      "geodesic_error_u", "geodesic_error_v", "opposite_angle", NULL};
  for (int i = 0; names[i]; i++) assert_near(summary(&in, names[i], NULL), 0, 2e-12);
  long count;
  summary(&in, "clairaut_u", &count);
  assert_int_equal(count, 7 * 5); /* inner vertices of inner lines */
}

/* The middle line of a flat 5 x 3 grid with its middle vertex moved sideways by h: it turns by a =
 * atan h, 2 a, a. Rolled out it is itself: h from its chord, over a length of 2 + 2 sqrt(1 + h^2).
 * About an axis through (0, 0), r cos(alpha) is the distance of the tangent: cos(a/2) - sin(a/2), 1
 * + h, cos(a/2) + 3 sin(a/2). */
static void a_line_with_a_kink(void **state) {
  net_fixture *f = *state;
  double h = .1, a = atan(h);
  lam_mesh mesh = net_grid(f->arena, 5, 3, net_plane);
  for (int i = 0; i < 5; i++) /* neighbors follow, so that the lines across stay straight */
    for (int j = 0; j < 3; j++) mesh.vertices[3 * i + j].y += i == 2 ? h : 0;
  static const double axis[6] = {0, 0, 0, 0, 0, 1};
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  in.axis = axis;
  assert_near(summary(&in, "straightness_u", NULL), h / (2 + 2 * sqrt(1 + h * h)), 1e-14);
  assert_near(summary(&in, "straightness_v", NULL), 0, 1e-14);
  assert_near(summary(&in, "geodesic_error_u", NULL), 2 * a * 180 / net_pi, 1e-12);
  double low = cos(a / 2) - sin(a / 2), high = cos(a / 2) + 3 * sin(a / 2);
  assert_near(summary(&in, "clairaut_u", NULL), high - low, 1e-14);
}

static lam_vec3 widening(double i, double j) {
  return lam_v3(i + .5 * (i > 1.5) + .01 * i * j, j, 0);
}

/* Edges along u between lines i and i + 1 are 1 + .01 j long, and 1.5 + .01 j between 1 and 2, j =
 * 0 to 3. */
static void lengths_in_strips(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 4, widening);
  assert_near(measured(f, &mesh, "edge_variation_u"), .03 / 1.015, 1e-14);
  assert_near(measured(f, &mesh, "spacing_u"), .5 * 3 / 3.5, 1e-14); /* the line j = 0: 1, 1.5, 1 */
  double edge = sqrt(1 + 9e-4); /* along v: sqrt(1 + (.01 i)^2) between all lines */
  assert_near(measured(f, &mesh, "edge_variation_v"),
              (edge - 1) * 4 / (1 + edge + sqrt(1 + 1e-4) + sqrt(1 + 4e-4)), 1e-14);
  assert_near(measured(f, &mesh, "spacing_v"), 0, 1e-14);
  lam_mesh ring = net_torus(f->arena, 12, 8, 3, 1); /* closed ladders: every edge once */
  lam_net net = net_built(f, &ring);
  lam_measuring in = lam_measuring_of(f->arena, &net, ring.vertices);
  long count;
  assert_near(summary(&in, "edge_variation_u", &count),
              4 * sin(net_pi / 12) * 8 / (8 * 6 * sin(net_pi / 12)), 1e-13);
  assert_int_equal(count, 96);
  assert_near(summary(&in, "edge_variation_v", NULL), 0, 1e-13);
}

/* Stretched by 2 percent along u; sheared by 1/10: the right angle becomes 90 - atan(1/10), half of
 * that is the shear.
 */
static void strains(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 5, net_plane);
  lam_net net = net_built(f, &mesh);
  lam_vec3 *after = LAM_NEW(f->arena, lam_vec3, 20);
  lam_measuring in = lam_measuring_of(f->arena, &net, after);
  in.start = mesh.vertices;
  for (int v = 0; v < 20; v++) after[v] = lam_v3(1.02 * mesh.vertices[v].x, mesh.vertices[v].y, 0);
  assert_near(summary(&in, "edge_strain", NULL), .02, 1e-14);
  assert_near(summary(&in, "shear_strain", NULL), 0, 1e-14);
  for (int v = 0; v < 20; v++)
    after[v] = lam_v3(mesh.vertices[v].x + .1 * mesh.vertices[v].y, mesh.vertices[v].y, 0);
  assert_near(summary(&in, "edge_strain", NULL), sqrt(1.01) - 1, 1e-14);
  assert_near(summary(&in, "shear_strain", NULL), atan(.1) / 2, 1e-14);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(angles_of_a_star),
      NET_TEST(lines_on_a_cylinder),
      NET_TEST(a_line_with_a_kink),
      NET_TEST(lengths_in_strips),
      NET_TEST(strains),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
