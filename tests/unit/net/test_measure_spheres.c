/* Measures of spherical stars and of edges, where their values are known by hand. */
#include "core/numbers.h"
#include "net_fixture.h"

static lam_measure measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, mesh->vertices, name);
}

/* An uneven grid on the sphere of radius 3 around (1, 2, 3); its normals point outwards. */
static lam_vec3 on_sphere(double i, double j) {
  double u = .2 * i + .02 * i * i, v = .15 * j + .05 * i - .01 * j * j;
  return lam_v3(1 + 3 * cos(v) * cos(u), 2 + 3 * cos(v) * sin(u), 3 + 3 * sin(v));
}

static void stars_on_a_sphere(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 5, 6, on_sphere);
  assert_below(measured(f, &mesh, "star_sphericity").max, 1e-14);
  lam_measure m = measured(f, &mesh, "star_curvature");
  assert_int_equal(m.count, 12);
  assert_near(m.max, -1. / 3, 1e-13); /* the center lies behind the normals */
  assert_near(m.mean, -1. / 3, 1e-13);
  assert_below(measured(f, &mesh, "curvature_spread").max, 1e-12);
  for (int k = 0; k < mesh.face_count; k++) { /* seen from inside */
    int swap = mesh.faces[k][1];
    mesh.faces[k][1] = mesh.faces[k][3];
    mesh.faces[k][3] = swap;
  }
  assert_near(measured(f, &mesh, "star_curvature").max, 1. / 3, 1e-13);
}

/* Arms of 1 in u rise by h, in v by g: inverted at the center they stand at h / (1 + h^2) and g /
 * (1 + g^2), so the sphere of best fit has the curvature k = h / (1 + h^2) + g / (1 + g^2) and its
 * center on the axis. */
static void a_star_off_its_sphere(void **state) {
  net_fixture *f = *state;
  double h = .3, g = -.1, k = h / (1 + h * h) + g / (1 + g * g);
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  mesh.vertices[1].z = mesh.vertices[7].z = h;
  mesh.vertices[3].z = mesh.vertices[5].z = g;
  assert_near(measured(f, &mesh, "star_curvature").max, k, 1e-14);
  double off_h = fabs(hypot(1, h - 1 / k) - 1 / k), off_g = fabs(hypot(1, g - 1 / k) - 1 / k);
  double edge = (hypot(1, h) + hypot(1, g)) / 2;
  assert_near(measured(f, &mesh, "star_sphericity").max, fmax(off_h, off_g) / edge, 1e-14);
}

static void the_spread_of_a_cylinder_with_a_flat_end(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh =
      net_grid(f->arena, 5, 3, net_plane); /* stars at i = 1, 2, 3; only the last is bent */
  mesh.vertices[12].z = mesh.vertices[13].z = mesh.vertices[14].z = .2;
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  double *k = lam_measure_values(lam_measure_find("star_curvature"), &in);
  assert_near(k[4], 0, 1e-15);
  assert_near(k[7], 0, 1e-15);
  assert_true(k[10] > .05);
  assert_near(measured(f, &mesh, "curvature_spread").max, k[10] * in.mean_edge, 1e-15);
  assert_true(k[0] == LAM_UNDEFINED);
}

/* Two great circles that cross at 60 degrees, with arms of unequal length: the circles through the
 * points are the great circles. The lines halfway between the edges are turned against them. */
static void the_angle_of_two_great_circles(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  static const double along[2] = {0, LAM_PI / 3};
  static const struct {
    int vertex, line;
    double arc;
  } arms[4] = {{7, 0, .5}, {5, 1, .7}, {1, 0, -.2}, {3, 1, -.4}};
  mesh.vertices[4] = lam_v3(0, 0, 1);
  for (int i = 0; i < 4; i++) {
    double a = along[arms[i].line], s = sin(arms[i].arc), c = cos(arms[i].arc);
    mesh.vertices[arms[i].vertex] = lam_v3(s * cos(a), s * sin(a), c);
  }
  assert_near(measured(f, &mesh, "circle_angle_deviation").max, 30, 1e-11);
  assert_true(fabs(measured(f, &mesh, "crossing_angle").max - 60) > .1);
  lam_mesh flat = net_grid(f->arena, 3, 3, net_plane); /* straight lines have no circle */
  assert_near(measured(f, &flat, "circle_angle_deviation").max, 0, 1e-12);
}

/* A trapezoid with sides 3, sqrt 2, 2, 1. */
static void sides_of_a_trapezoid(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 2, 2, net_plane);
  const int *face = mesh.faces[0];
  const lam_vec3 corner[4] = {{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  for (int k = 0; k < 4; k++) mesh.vertices[face[k]] = corner[k];
  double side[4] = {3, sqrt(2), 2, 1}, mean = (side[0] + side[1] + side[2] + side[3]) / 4,
         square = 0;
  for (int k = 0; k < 4; k++) square += (side[k] - mean) * (side[k] - mean) / 4;
  assert_near(measured(f, &mesh, "opposite_edge_difference").max, 1 / mean, 1e-15);
  assert_near(measured(f, &mesh, "edge_variation").max, sqrt(square) / mean, 1e-15);
}

static void not_a_number_is_not_hidden(void **state) {
  net_fixture *f = *state;
  static const char *const names[] = {"star_sphericity", "star_curvature", "curvature_spread",
                                      "circle_angle_deviation", "edge_variation"};
  for (int i = 0; i < 5; i++)
    for (int v = 1; v < 9; v += 2) { /* center's neighbors */
      lam_mesh mesh = net_grid(f->arena, 3, 3, on_sphere);
      mesh.vertices[v].x = NAN;
      if (!isnan(measured(f, &mesh, names[i]).max)) fail_msg("%s hides vertex %d", names[i], v);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(stars_on_a_sphere),
      NET_TEST(a_star_off_its_sphere),
      NET_TEST(the_spread_of_a_cylinder_with_a_flat_end),
      NET_TEST(the_angle_of_two_great_circles),
      NET_TEST(sides_of_a_trapezoid),
      NET_TEST(not_a_number_is_not_hidden),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
