/* Measures of nets that are uneven in every direction, where each number is known by hand or from
 * an independent program; the units of all measures. */
#include "net_fixture.h"

#include "mesh/net_curvature.h"
#include "net/measures/measure.h"

static lam_measure measured(net_fixture *f, const lam_mesh *mesh, const char *name) {
  lam_net net = net_built(f, mesh);
  return lam_net_measure_one(f->arena, &net, mesh->vertices, name);
}

/* ---- units ---- */

static lam_vec3 bumpy(double i, double j) {
  return lam_v3(i + .1 * sin(3 * i + j), 1.3 * j + .1 * cos(2 * i - j),
                .3 * sin(i) * cos(j) + .02 * i * i);
}
static lam_vec3 calm(double i, double j) { return lam_v3(i, 1.2 * j, .2 * sin(i)); }

static void scale_all(lam_vec3 *points, int count, double factor) {
  for (int i = 0; i < count; i++) points[i] = lam_scale(points[i], factor);
}

/* All measures of the bumpy net, its start, axis and reference enlarged by the factor. */
static const lam_measure *measured_enlarged(net_fixture *f, double factor) {
  lam_mesh mesh = net_grid(f->arena, 7, 8, bumpy), start = net_grid(f->arena, 7, 8, calm);
  lam_vec3 corners[4] = {{-2, -2, -1}, {9, -2, 0}, {9, 12, 1}, {-2, 12, 0}};
  int triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  lam_trimesh reference = {4, corners, 2, triangles};
  double axis[6] = {-3 * factor, 2 * factor, factor, .1, .2, 1};
  scale_all(mesh.vertices, 56, factor);
  scale_all(start.vertices, 56, factor);
  scale_all(corners, 4, factor);

  lam_tree *tree = lam_tree_new(&reference, NULL);
  lam_arena_defer(f->arena, lam_tree_free, tree);
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  in.reference = tree, in.reference_mesh = &reference;
  in.axis = axis, in.start = start.vertices, in.coverage = .5;

  lam_measure *all = LAM_NEW(f->arena, lam_measure, lam_measure_count);
  for (int i = 0; i < lam_measure_count; i++) {
    const lam_measure_kind *kind = lam_measures[i];
    all[i] =
        lam_measure_summary(kind, lam_measure_values(kind, &in), lam_measure_size(kind, in.net));
  }
  return all;
}

/* The power of the length in a unit. */
static int power_of_length(const char *unit) {
  static const struct {
    const char *unit;
    int power;
  } units[] = {{"", 0},  {LAM_UNIT_COUNT, 0}, {"deg", 0},  {"sr", 0},
               {"m", 1}, {"1/m", -1},         {"1/m2", -2}};
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if (strcmp(units[i].unit, unit) == 0) return units[i].power;
  fail_msg("%s is no unit", unit);
  return 0;
}

/* Twice the size: a measure in m doubles, one in 1/m2 is quartered, one without length stays. Only
 * what is iterated or sampled differs by more than rounding, and by less than 1e-6. */
static void values_scale_by_the_unit_that_is_named(void **state) {
  net_fixture *f = *state;
  const lam_measure *once = measured_enlarged(f, 1), *twice = measured_enlarged(f, 2);
  for (int i = 0; i < lam_measure_count; i++) {
    double factor = pow(2, power_of_length(once[i].unit)), size = fabs(once[i].max * factor);
    assert_int_equal(once[i].count, twice[i].count);
    if (strcmp(once[i].name, "surface_gauss_curvature") == 0) continue; /* it needs a surface */
    if (!once[i].count) fail_msg("%s has no value", once[i].name);
    assert_near_named(twice[i].max, once[i].max * factor, 1e-6 * size, once[i].name);
    assert_near_named(twice[i].mean, once[i].mean * factor, 1e-6 * size, once[i].name);
  }
}

/* ---- angles ---- */

static const int arms[4] = {7, 5, 1, 3}; /* +u, +v, -u, -v of the middle of a 3 x 3 grid */

/* A flat star with arms in these directions (degrees) from +u on. */
static lam_mesh star(net_fixture *f, const double degrees[4]) {
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  for (int k = 0; k < 4; k++) {
    double a = degrees[k] * net_pi / 180, length = 1 + .1 * k;
    mesh.vertices[arms[k]] = lam_add(mesh.vertices[4], lam_v3(length * cos(a), length * sin(a), 0));
  }
  return mesh;
}

/* Arms at 0, 80, 200 and 270 degrees: angles of 80, 120, 70 and 90. Opposite ones differ by 10 and
 * 30, all by 50. Along u 200 lie to the left and 160 to the right: 20 out of straight, along v 190
 * and 170: 10. The line along u turns by 20, along v by 10. Tangents at 10 and 85 degrees. The same
 * begun at each arm in turn. */
static void angles_of_an_uneven_star(void **state) {
  net_fixture *f = *state;
  static const double directions[8] = {0, 80, 200, 270, 360, 440, 560, 630};
  for (int k = 0; k < 4; k++) {
    lam_mesh mesh = star(f, directions + k);
    double along[2] = {k % 2 ? 10 : 20, k % 2 ? 20 : 10};
    assert_near(measured(f, &mesh, "opposite_angle").max, 30, 1e-12);
    assert_near(measured(f, &mesh, "angle_spread").max, 50, 1e-12);
    assert_near(measured(f, &mesh, "geodesic_error_u").max, along[0], 1e-12);
    assert_near(measured(f, &mesh, "geodesic_error_v").max, along[1], 1e-12);
    assert_near(measured(f, &mesh, "turning_angle_u").max, along[0], 1e-12);
    assert_near(measured(f, &mesh, "turning_angle_v").max, along[1], 1e-12);
    assert_near(measured(f, &mesh, "turning_angle").max, 20, 1e-12);
    assert_near(measured(f, &mesh, "crossing_angle").max, k % 2 ? 105 : 75, 1e-12);
    assert_near(measured(f, &mesh, "orthogonality").max, 15, 1e-12);
    assert_near(measured(f, &mesh, "angle_deviation").max, 15, 1e-12);
  }
}

/* A flat net whose middle line along u is (0, 0), (1, 0), (2, 0), (3, h), (4, h): rolled out it is
 * itself. Its chord is hypot(4, h) long, from which the points are 0, h, 2 h, h and 0 over that
 * away. Lines along v are straight; those of the border are not asked. The same with u and v
 * exchanged. */
static void a_line_rolled_out(void **state) {
  net_fixture *f = *state;
  double h = .3, length = 3 + hypot(1, h), chord = hypot(4, h);
  static const double off[5] = {0, 1, 2, 1, 0};
  for (int turn = 0; turn < 2; turn++) {
    lam_mesh mesh = net_grid(f->arena, turn ? 3 : 5, turn ? 5 : 3, net_plane);
    int along = turn ? 1 : 3, across = turn ? 5 : 1;
    for (int i = 0; i < 5; i++)
      for (int j = 0; j < 3; j++) {
        lam_vec3 x = lam_v3(i, j + (i > 2 ? h : 0), 0);
        mesh.vertices[along * i + across * j] = turn ? lam_v3(x.y, x.x, 0) : x;
      }
    lam_net net = net_built(f, &mesh);
    lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
    const char *name = turn ? "straightness_v" : "straightness_u";
    const double *values = lam_measure_values(lam_measure_find(name), &in);
    for (int i = 0; i < 5; i++) {
      assert_near(values[along * i + across], off[i] * h / chord / length, 1e-14);
      assert_true(values[along * i] == LAM_UNDEFINED);
    }
    assert_near(measured(f, &mesh, turn ? "straightness_u" : "straightness_v").max, 0, 1e-14);
  }
}

/* Arms that fall by 45 degrees around a flat star of right angles: each angle is 60 degrees, the
 * defect 120. With one arm level: two of 60 and two of 90, 60 are missing. */
static void angle_defects_of_stars(void **state) {
  net_fixture *f = *state;
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  for (int k = 0; k < 4; k++) mesh.vertices[arms[k]].z = -1;
  assert_near(measured(f, &mesh, "angle_defect").max, 120, 1e-12);
  mesh.vertices[arms[1]].z = 0;
  assert_near(measured(f, &mesh, "angle_defect").max, 60, 1e-12);
}

/* The roof over arms of 1 that rise by .3, .5, -.1 and .2, of four planes: the axis of best fit
 * misses one of the bisecting planes by .50185 degrees (independent program: inverse iteration). */
static void conicality_of_an_uneven_roof(void **state) {
  net_fixture *f = *state;
  static const double rise[4] = {.3, .5, -.1, .2};
  static const int corners[4] = {8, 2, 0, 6}; /* between arms k and k + 1 */
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  for (int k = 0; k < 4; k++) {
    mesh.vertices[arms[k]].z = rise[k];
    mesh.vertices[corners[k]].z = rise[k] + rise[(k + 1) % 4];
  }
  assert_near(measured(f, &mesh, "face_planarity").max, 0, 1e-15);
  assert_near(measured(f, &mesh, "conicality").max, .5018488916152486, 1e-9);
}

/* ---- stars of many arms ---- */

/* n faces in a plane around vertex 0. */
static lam_mesh fan(net_fixture *f, int n) {
  lam_mesh mesh = {2 * n + 1, LAM_NEW(f->arena, lam_vec3, 2 * n + 1), n, NULL};
  mesh.faces = (int(*)[4])lam_arena_alloc(f->arena, (size_t)n, sizeof *mesh.faces);
  for (int k = 0; k < 2 * n; k++)
    mesh.vertices[1 + k] = lam_v3(cos(k * net_pi / n), sin(k * net_pi / n), 0);
  for (int k = 0; k < n; k++) {
    const int face[4] = {0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % (2 * n)};
    memcpy(mesh.faces[k], face, sizeof face);
  }
  return mesh;
}

/* Their points are kept in arrays of 64, the vertex itself among them: planarity and spheres go as
 * far as 63 arms, cones as far as 64. */
static void stars_of_more_arms_than_there_is_room_for(void **state) {
  net_fixture *f = *state;
  static const char *const names[] = {"star_planarity", "star_sphericity", "star_curvature",
                                      "conicality"};
  static const int most[] = {63, 63, 63, 64};
  for (int i = 0; i < 4; i++)
    for (int more = 0; more < 2; more++) {
      lam_mesh mesh = fan(f, most[i] + more);
      lam_measure m = measured(f, &mesh, names[i]);
      assert_int_equal(m.count, 1 - more);
      if (!more) assert_near(m.max, 0, 1e-13);
    }
}

/* Three arms have a sphere and a cone always, and none of their own: a cube. */
static void stars_of_three_arms(void **state) {
  net_fixture *f = *state;
  lam_mesh cube = net_cube(f->arena);
  assert_int_equal(measured(f, &cube, "star_sphericity").count, 0);
  assert_int_equal(measured(f, &cube, "star_curvature").count, 0);
  assert_int_equal(measured(f, &cube, "curvature_spread").count, 0);
}

/* ---- curvature ---- */

/* H = .6998 at the middle: the gradient of the area of all triangles (differences) over twice their
 * Voronoi areas (through circumcenters; 6 of 12 triangles are obtuse). Independent program. */
static void cotangent_mean_curvature_of_an_uneven_star(void **state) {
  net_fixture *f = *state;
  static const lam_vec3 x[9] = {{0, .1, .2},    {-.2, 1, 0},   {.1, 2.1, -.1},
                                {1.1, -.1, .1}, {1, 1, .5},    {1.2, 1.9, .1},
                                {2.2, .1, -.2}, {1.9, 1.1, 0}, {2, 2.2, .3}};
  lam_mesh mesh = net_grid(f->arena, 3, 3, net_plane);
  memcpy(mesh.vertices, x, sizeof x);
  lam_measure m = measured(f, &mesh, "cotangent_mean_curvature");
  assert_int_equal(m.count, 1);
  assert_near(m.max, -.69981128, 1e-7); /* u x v looks up, the center lies below */
}

static double bends[2]; /* principal curvatures at the middle of a paraboloid */

static lam_vec3 paraboloid(double i, double j) {
  double x = .2 * (i - 4), y = .2 * (j - 4);
  return lam_v3(x, y, (bends[0] * x * x + bends[1] * y * y) / 2);
}

/* The value at the middle of a paraboloid along its axes; degree 2 is fitted exactly. */
static double at_the_middle(net_fixture *f, const char *name, double k1, double k2) {
  bends[0] = k1, bends[1] = k2;
  lam_mesh mesh = net_grid(f->arena, 9, 9, paraboloid);
  lam_net net = net_built(f, &mesh);
  lam_measuring in = lam_measuring_of(f->arena, &net, mesh.vertices);
  return lam_measure_values(lam_measure_find(name), &in)[40];
}

/* The smaller over the larger by absolute value, whichever comes first. Principal directions count
 * when the curvatures differ by a tenth of the larger one. A bend below 1e-9 over an edge (.2 m
 * here, a bit more on the average) is flat. */
static void curvatures_of_paraboloids(void **state) {
  net_fixture *f = *state;
  assert_near(at_the_middle(f, "curvature_ratio", .5, .2), .4, 1e-11);
  assert_near(at_the_middle(f, "curvature_ratio", .2, .5), .4, 1e-11);
  assert_near(at_the_middle(f, "curvature_ratio", .2, -.5), -.4, 1e-11);
  assert_near(at_the_middle(f, "curvature_ratio", -.2, -.5), .4, 1e-11);
  assert_near(at_the_middle(f, "mean_curvature", .5, .2), .35, 1e-12);
  assert_near(at_the_middle(f, "gauss_curvature", .5, .2), .1, 1e-12);

  assert_near(at_the_middle(f, "principal_deviation", .5, .2), 45, 1e-9);
  assert_near(at_the_middle(f, "principal_deviation", .5, .44), 45, 1e-9);
  assert_near(at_the_middle(f, "principal_deviation", -.44, -.5), 45, 1e-9);
  assert_true(at_the_middle(f, "principal_deviation", .5, .46) == LAM_UNDEFINED);
  assert_true(at_the_middle(f, "principal_deviation", -.46, -.5) == LAM_UNDEFINED);

  assert_near(at_the_middle(f, "curvature_ratio", 1e-8, 2e-8), .5, 1e-6);
  assert_true(at_the_middle(f, "curvature_ratio", 2e-9, 4.5e-9) == LAM_UNDEFINED);
  assert_true(at_the_middle(f, "principal_deviation", 0, 4.5e-9) == LAM_UNDEFINED);
}

/* ---- edges ---- */

/* A trapezoid with sides 3, sqrt 2, 2, 1, begun at each corner: one pair differs by 1, the other by
 * less. What is not a number stays so. */
static void opposite_sides_of_faces(void **state) {
  net_fixture *f = *state;
  static const lam_vec3 corners[4] = {{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  for (int turn = 0; turn < 4; turn++) {
    lam_mesh mesh = net_grid(f->arena, 2, 2, net_plane);
    for (int k = 0; k < 4; k++) mesh.vertices[mesh.faces[0][(k + turn) % 4]] = corners[k];
    double mean = (3 + sqrt(2) + 2 + 1) / 4;
    assert_near(measured(f, &mesh, "opposite_edge_difference").max, 1 / mean, 1e-15);
    assert_near(measured(f, &mesh, "edge_ratio").max, 3, 1e-15);
    mesh.vertices[mesh.faces[0][turn]].x = NAN;
    assert_true(isnan(measured(f, &mesh, "opposite_edge_difference").max));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      NET_TEST(values_scale_by_the_unit_that_is_named),
      NET_TEST(angles_of_an_uneven_star),
      NET_TEST(a_line_rolled_out),
      NET_TEST(angle_defects_of_stars),
      NET_TEST(conicality_of_an_uneven_roof),
      NET_TEST(stars_of_more_arms_than_there_is_room_for),
      NET_TEST(stars_of_three_arms),
      NET_TEST(cotangent_mean_curvature_of_an_uneven_star),
      NET_TEST(curvatures_of_paraboloids),
      NET_TEST(opposite_sides_of_faces),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
