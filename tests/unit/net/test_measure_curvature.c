/* Curvatures of nets on surfaces whose curvatures are known in closed form, and distances to a
 * reference. */
#include "mesh/net_curvature.h"
#include "net_fixture.h"

static lam_measure measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, mesh->vertices, name);
}

/* All values of a measure differ from the expected one by at most the tolerance. */
#define assert_all(mesh, name, expected, tolerance)                                                \
  do {                                                                                             \
    lam_measure all_ = measured(f, mesh, name);                                                    \
    assert_true(all_.count > 0);                                                                   \
    assert_near(all_.min, expected, tolerance);                                                    \
    assert_near(all_.max, expected, tolerance);                                                    \
  } while (0)

static double step; /* of the parameters, per vertex */

/* Radius 2; u along the meridian, v along the parallel: the normal looks outward. Turned by .7
 * about the x axis. */
static lam_vec3 sphere(double i, double j) {
  double u = step * i - .6, v = step * j - .6;
  lam_vec3 p = lam_v3(2 * cos(u) * cos(v), 2 * cos(u) * sin(v), 2 * sin(u));
  p = lam_v3(p.y, p.x, p.z); /* outward */
  return lam_v3(p.x, cos(.7) * p.y - sin(.7) * p.z, sin(.7) * p.y + cos(.7) * p.z);
}

/* Radius 2, k = (-1/2, -1/2) seen from outside; halving the spacing divides the error by 8 nearly:
 * its worst is next to the boundary. */
static void a_sphere(void **state) {
  net_fixture *f = *state;
  double error[2];
  for (int i = 0; i < 2; i++) {
    step = .1 / (i + 1);
    lam_mesh mesh = net_grid(f->arena, 12 * (i + 1) + 1, 12 * (i + 1) + 1, sphere);
    lam_net net = net_built(f, &mesh);
    lam_vec3 *normals = LAM_NEW(f->arena, lam_vec3, mesh.vertex_count);
    lam_net_normals(&net, mesh.vertices, normals);
    double side =
        lam_dot(normals[mesh.vertex_count / 2], mesh.vertices[mesh.vertex_count / 2]) > 0 ? -1 : 1;
    lam_measure m = measured(f, &mesh, "mean_curvature");
    error[i] = fmax(fabs(m.min - side / 2), fabs(m.max - side / 2));
    assert_below(error[i], 1.2e-3);
    assert_all(&mesh, "gauss_curvature", .25, 1.2e-3);
    assert_all(&mesh, "curvature_ratio", 1, .01);
    assert_all(&mesh, "cotangent_mean_curvature", side / 2, 2e-3);
    assert_int_equal(measured(f, &mesh, "principal_deviation").count, 0); /* umbilics everywhere */
  }
  assert_below(error[1], error[0] / 7);
}

static double slope; /* of family 0 against the rulings */

static lam_vec3 cylinder(double i, double j) { /* radius 3 about the z axis */
  double a = step * (i * sin(slope) + j * cos(slope)),
         z = 3 * step * (i * cos(slope) - j * sin(slope));
  return lam_v3(3 * cos(a), 3 * sin(a), z);
}

/* Radius 3: k = (0, 1/3) by absolute value. A net whose families run at 45 degrees to the rulings
 * has them as bisectors; a net along the rulings is 45 degrees off. */
static void a_cylinder(void **state) {
  net_fixture *f = *state;
  static const double slopes[3] = {0, 45, 20}, deviations[3] = {45, 0, 25};
  step = .08;
  for (int i = 0; i < 3; i++) {
    slope = slopes[i] * net_pi / 180;
    lam_mesh mesh = net_grid(f->arena, 9, 11, cylinder);
    lam_measure m = measured(f, &mesh, "mean_curvature");
    double side = m.mean > 0 ? 1 : -1;
    assert_all(&mesh, "mean_curvature", side / 6, 2e-4);
    assert_all(&mesh, "gauss_curvature", 0, 1e-4);
    assert_all(&mesh, "curvature_ratio", 0, 1e-3);
    assert_all(&mesh, "cotangent_mean_curvature", side / 6, 1e-3);
    assert_all(&mesh, "principal_deviation", deviations[i], .05);
    assert_below(measured(f, &mesh, "gauss_image_area").max, 1e-8);
    if (i == 0) assert_all(&mesh, "angle_defect", 0, 1e-9); /* only there the faces are planar */
  }
}

static lam_vec3 saddle(double i, double j) { /* z = (.3 x^2 - .1 y^2) / 2 */
  double x = step * (i - 4), y = step * (j - 4);
  return lam_v3(x, y, (.3 * x * x - .1 * y * y) / 2);
}

/* At the origin k = (.3, -.1) along x and y: a polynomial of degree 2 is fitted exactly. */
static void a_saddle(void **state) {
  net_fixture *f = *state;
  step = .25;
  lam_mesh mesh = net_grid(f->arena, 9, 9, saddle);
  lam_net net = net_built(f, &mesh);
  lam_net_curvature c = lam_net_curvatures(f->arena, &net, mesh.vertices)[40];
  assert_int_equal(c.degree, 4);
  assert_near(c.k1, .3, 1e-12);
  assert_near(c.k2, -.1, 1e-12);
  assert_near(c.H, .1, 1e-12);
  assert_near(c.K, -.03, 1e-12);
  assert_near(fabs(c.direction[0].x), 1, 1e-12);
  assert_near(fabs(c.direction[1].y), 1, 1e-12);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  assert_near(lam_measure_values(lam_measure_find("curvature_ratio"), &in)[40], -1. / 3, 1e-12);
  assert_near(lam_measure_values(lam_measure_find("gauss_curvature"), &in)[40], -.03, 1e-12);
}

/* Torus of radii 3 and 1, closed: K = cos v / (3 + cos v), |H| = (3 + 2 cos v) / (2 (3 + cos v)).
 * The normals cover the sphere twice, with opposite signs. */
static void a_torus(void **state) {
  net_fixture *f = *state;
  int n = 144, m = 48;
  lam_mesh mesh = net_torus(f->arena, n, m, 3, 1);
  lam_net net = net_built(f, &mesh);
  const lam_net_curvature *c = lam_net_curvatures(f->arena, &net, mesh.vertices);
  double side = c[0].H > 0 ? 1 : -1;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double w = cos(2 * net_pi * j / m);
      assert_int_equal(c[i * m + j].degree, 4);
      assert_near(c[i * m + j].K, w / (3 + w), 6e-3);
      assert_near(c[i * m + j].H, side * (3 + 2 * w) / (2 * (3 + w)), 5e-3);
    }
  assert_near(measured(f, &mesh, "gauss_image_area_signed").max, 0, 1e-11);
  assert_near(measured(f, &mesh, "gauss_image_area").max, 8 * net_pi, .01 * 8 * net_pi);
}

/* A cube subdivided and blown up to the unit sphere: closed, with eight vertices of valence 3. The
 * normals cover the sphere once: 4 pi. */
static void a_closed_sphere_with_irregular_vertices(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_cube(f->arena);
  for (int i = 0; i < 4; i++) {
    lam_net net = net_built(f, &mesh);
    mesh = lam_net_catmull_clark(f->arena, &net);
  }
  for (int v = 0; v < mesh.vertex_count; v++) mesh.vertices[v] = lam_unit(mesh.vertices[v]);
  assert_int_equal(measured(f, &mesh, "mean_curvature").count, mesh.vertex_count);
  assert_all(&mesh, "mean_curvature", -1, 2e-3); /* faces are counterclockwise seen from outside */
  assert_all(&mesh, "gauss_curvature", 1, 4e-3);
  assert_near(measured(f, &mesh, "gauss_image_area").max, 4 * net_pi, 1e-9);
  assert_near(measured(f, &mesh, "gauss_image_area_signed").max, 4 * net_pi, 1e-9);
}

/* The corners of a cube lack 90 degrees each; a polynomial has too few vertices there. */
static void a_cube(void **state) {
  net_fixture *f = *state;
  lam_mesh cube = net_cube(f->arena);
  assert_all(&cube, "angle_defect", 90, 1e-12);
  assert_int_equal(measured(f, &cube, "mean_curvature").count, 0);
  assert_near(measured(f, &cube, "gauss_image_area").max, 4 * net_pi, 1e-12);
}

/* Diagonal nets of the unduloid with a neck of .4: |H| = 1 / 1.4. Both measures of H come nearer to
 * it as the net is refined. */
static void mean_curvature_of_an_unduloid(void **state) {
  net_fixture *f = *state;
  double off[2], cotangent[2];
  for (int i = 0; i < 2; i++) {
    lam_mesh mesh = net_sampled(f, "unduloid", "{}", LAM_CHART_DIAGONAL, 24 << i, 24 << i, 0);
    lam_measure m = measured(f, &mesh, "mean_curvature"),
                c = measured(f, &mesh, "cotangent_mean_curvature");
    off[i] = fabs(fabs(m.mean) - 1 / 1.4);
    cotangent[i] = fabs(fabs(c.mean) - 1 / 1.4);
  }
  assert_below(off[1], off[0] / 3);
  assert_below(cotangent[1], cotangent[0] / 3);
  assert_below(cotangent[1], .01);
}

/* A square of side 3 above the reference, a square of side 4 in the plane that reaches .5 further
 * on every side: every vertex is .3 away; the corners of the reference are sqrt(.3^2 + .5^2 + .5^2)
 * away from the net. */
static void distances_to_a_reference(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 4, 4, net_plane);
  for (int v = 0; v < mesh.vertex_count; v++) mesh.vertices[v].z = .3;
  lam_vec3 corners[4] = {{-.5, -.5, 0}, {3.5, -.5, 0}, {3.5, 3.5, 0}, {-.5, 3.5, 0}};
  int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  lam_trimesh reference = {4, corners, 2, triangles};
  lam_tree *tree = lam_tree_new(&reference, NULL);
  lam_arena_defer(f->arena, lam_tree_free, tree);
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  in.reference = tree;
  in.reference_mesh = &reference;
  static const char *const names[] = {"distance_to_reference", "distance_from_reference", NULL};
  int count;
  lam_measure *m = lam_net_measure(&in, names, &count);
  assert_near(m[0].min, .3, 1e-15);
  assert_near(m[0].max, .3, 1e-15);
  assert_int_equal(m[0].count, 16);
  assert_near(m[1].max, sqrt(.09 + .25 + .25), 1e-15);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(a_sphere),
      NET_TEST(a_cylinder),
      NET_TEST(a_saddle),
      NET_TEST(a_torus),
      NET_TEST(a_closed_sphere_with_irregular_vertices),
      NET_TEST(a_cube),
      NET_TEST(mean_curvature_of_an_unduloid),
      NET_TEST(distances_to_a_reference),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
